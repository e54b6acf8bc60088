//! The quadratic model of everything beyond a crease, and how a crease is eliminated from it.
//!
//! The state of a segment is its twist `ξ`, its near crease's `ψ` and `c`; the controls are the next crease's. Twists
//! are about the world's origin, so `ξ_{j+1} = ξ_j + S_ψ δψ + S_c δc`: the dynamics are the identity, and one stage is
//! two products of a 6x6 matrix with a vector and a change of rank two. `d` is the start's own twist where the start is
//! free and the end is joined to it: then `ξ` is counted from the start's.
//!
//! Source: ours; Riccati's recursion for a chain. Checked by `tests/ribbon_derivatives.rs`.

use super::frame::{Six, dot6};
use crate::real::Real;

/// Value, to second order, of what lies beyond.
#[derive(Debug, Clone, Copy)]
pub struct Value<R> {
    /// By `ξ ξ`.
    pub xx: [Six<R>; 6],
    /// By `ξ c` and `ξ ψ`.
    pub xu: [Six<R>; 2],
    /// By `ψψ`, `ψc`, `cc`.
    pub uu: [R; 3],
    /// By `ξ`.
    pub x: Six<R>,
    /// By `ψ`, `c`.
    pub u: [R; 2],
    /// By `ξ d`.
    pub xd: [Six<R>; 6],
    /// By `ψ d`, `c d`.
    pub ud: [Six<R>; 2],
    /// By `d d`.
    pub dd: [Six<R>; 6],
    /// By `d`.
    pub d: Six<R>,
}

/// The rule that gives a crease's step from the state before it: `-(k + X ξ + U (ψ, c) + D d)`, row `ψ` then row `c`.
#[derive(Debug, Clone, Copy)]
pub struct Gain<R> {
    /// The constant part.
    pub k: [R; 2],
    /// By `ξ`.
    pub x: [Six<R>; 2],
    /// By the previous crease's `(ψ, c)`.
    pub u: [[R; 2]; 2],
    /// By `d`.
    pub d: [Six<R>; 2],
    /// `S_ψ`, `S_c`.
    pub axes: [Six<R>; 2],
    /// How `ψ` follows where `c` is held off its rule.
    pub lean: R,
}

/// What ties a crease to the state before it, beside the dynamics; row `ψ` then row `c`.
#[derive(Debug, Clone, Copy)]
pub struct Tie<R> {
    /// To `ξ` (and `d`).
    pub x: [Six<R>; 2],
    /// To the previous crease's `(ψ, c)`.
    pub u: [[R; 2]; 2],
    /// Own gradient.
    pub g: [R; 2],
    /// Own Hessian `ψψ`, `ψc`, `cc`, the shift included.
    pub h: [R; 3],
    /// Which of the two may move.
    pub free: [bool; 2],
    /// Whether `d` counts.
    pub drift: bool,
}

/// A crease's rows of the model: by itself, their right-hand sides, by `ξ`, by the crease before, by `d`.
struct Rows<R> {
    h: [R; 3],
    g: [R; 2],
    x: [Six<R>; 2],
    u: [[R; 2]; 2],
    d: [Six<R>; 2],
}

impl<R: Real> Gain<R> {
    /// No rule.
    pub const ZERO: Self = Self {
        k: [R::ZERO; 2],
        x: [[R::ZERO; 6]; 2],
        u: [[R::ZERO; 2]; 2],
        d: [[R::ZERO; 6]; 2],
        axes: [[R::ZERO; 6]; 2],
        lean: R::ZERO,
    };
    /// The step of the crease for a share of the whole, given what the state before it has become.
    #[inline]
    pub fn rule(&self, share: R, x: &Six<R>, u: [R; 2], d: Option<&Six<R>>) -> [R; 2] {
        let row = |i: usize| {
            let near = self.u[i][0] * u[0] + self.u[i][1] * u[1];
            let far = d.map_or(R::ZERO, |d| dot6(&self.d[i], d));
            -(self.k[i] * share + dot6(&self.x[i], x) + near + far)
        };
        [row(0), row(1)]
    }
    /// The step with `c`'s held within bounds, and the best `ψ` for it.
    #[inline]
    pub fn held(&self, step: [R; 2], [low, high]: [R; 2]) -> [R; 2] {
        let c = step[1].larger(low).smaller(high);
        [step[0] + self.lean * (c - step[1]), c]
    }
    /// The twist beyond the crease.
    #[inline]
    pub fn beyond(&self, x: &Six<R>, step: [R; 2]) -> Six<R> {
        let mut beyond = *x;
        for (b, (p, c)) in beyond.iter_mut().zip(self.axes[0].iter().zip(&self.axes[1])) {
            *b += *p * step[0] + *c * step[1];
        }
        beyond
    }
}

/// `Σ m_i x_i` over the rows of a symmetric matrix.
#[inline(always)]
fn times<R: Real>(m: &[Six<R>; 6], x: &Six<R>) -> Six<R> {
    let mut sum = [R::ZERO; 6];
    for (row, &f) in m.iter().zip(x) {
        add(&mut sum, row, f);
    }
    sum
}

#[inline(always)]
fn add<R: Real>(sum: &mut Six<R>, x: &Six<R>, f: R) {
    for (s, &x) in sum.iter_mut().zip(x) {
        *s += x * f;
    }
}

/// `m -= a pᵀ + b qᵀ`.
#[inline(always)]
fn take<R: Real>(m: &mut [Six<R>; 6], [a, b]: [&Six<R>; 2], [p, q]: [&Six<R>; 2]) {
    for (row, (&a, &b)) in m.iter_mut().zip(a.iter().zip(b)) {
        for (v, (&p, &q)) in row.iter_mut().zip(p.iter().zip(q)) {
            *v -= a * p + b * q;
        }
    }
}

/// `m += o`.
#[inline(always)]
pub fn plus<R: Real>(m: &mut [Six<R>; 6], o: &[Six<R>; 6]) {
    for (row, other) in m.iter_mut().zip(o) {
        add(row, other, R::one());
    }
}

impl<R: Real> Value<R> {
    /// Nothing beyond.
    pub const ZERO: Self = Self {
        xx: [[R::ZERO; 6]; 6],
        xu: [[R::ZERO; 6]; 2],
        uu: [R::ZERO; 3],
        x: [R::ZERO; 6],
        u: [R::ZERO; 2],
        xd: [[R::ZERO; 6]; 6],
        ud: [[R::ZERO; 6]; 2],
        dd: [[R::ZERO; 6]; 6],
        d: [R::ZERO; 6],
    };

    /// Eliminates a crease: from the value by the segment beyond it to the value by the one before it, and the rule for
    /// its step. Adds to `fall` how much the model falls to first order; `None` where the model has no minimum.
    ///
    /// # Cost
    ///
    /// About 500 multiply-adds, with `d` 1,100.
    #[inline(always)]
    pub fn eliminate(
        &mut self,
        axes: &[Six<R>; 2],
        tie: &Tie<R>,
        fall: &mut R,
        gain: &mut Gain<R>,
    ) -> Option<()> {
        let row = self.rows(axes, tie);
        let inverse = inverse(row.h)?;
        let solve = |a: R, b: R| [inverse[0] * a + inverse[1] * b, inverse[1] * a + inverse[2] * b];
        gain.k = solve(row.g[0], row.g[1]);
        *fall += row.g[0] * gain.k[0] + row.g[1] * gain.k[1];
        (gain.axes, gain.lean) = (*axes, inverse[1] / inverse[2]);
        for i in 0..6 {
            [gain.x[0][i], gain.x[1][i]] = solve(row.x[0][i], row.x[1][i]);
        }
        for s in 0..2 {
            [gain.u[0][s], gain.u[1][s]] = solve(row.u[0][s], row.u[1][s]);
        }
        if tie.drift {
            for i in 0..6 {
                [gain.d[0][i], gain.d[1][i]] = solve(row.d[0][i], row.d[1][i]);
            }
            self.reduce_drift(&row, gain);
        }
        self.reduce(&row, gain);
        Some(())
    }

    /// The crease's two rows of the model, the dynamics put in.
    #[inline(always)]
    fn rows(&self, axes: &[Six<R>; 2], tie: &Tie<R>) -> Rows<R> {
        let (two, o) = (R::of(2.0), R::ZERO);
        let ([sp, sc], [xp, xc]) = (axes, &self.xu);
        let [mp, mc] = [times(&self.xx, sp), times(&self.xx, sc)];
        let mut row = Rows {
            h: [
                dot6(sp, &mp) + two * dot6(sp, xp) + self.uu[0] + tie.h[0],
                dot6(sp, &mc) + dot6(sp, xc) + dot6(sc, xp) + self.uu[1] + tie.h[1],
                dot6(sc, &mc) + two * dot6(sc, xc) + self.uu[2] + tie.h[2],
            ],
            g: [dot6(sp, &self.x) + self.u[0] + tie.g[0], dot6(sc, &self.x) + self.u[1] + tie.g[1]],
            x: [mp, mc],
            u: tie.u,
            d: [[o; 6]; 2],
        };
        for (i, axis) in axes.iter().enumerate() {
            add(&mut row.x[i], &self.xu[i], R::one());
            add(&mut row.x[i], &tie.x[i], R::one());
            if tie.drift {
                row.d[i] = times(&self.xd, axis);
                add(&mut row.d[i], &self.ud[i], R::one());
                add(&mut row.d[i], &tie.x[i], R::one());
            }
            if !tie.free[i] {
                (row.g[i], row.u[i], row.x[i], row.d[i]) = (o, [o; 2], [o; 6], [o; 6]);
                (row.h[1], row.h[2 * i]) = (o, R::one());
            }
        }
        row
    }

    /// What is left by the state before the crease; that state's own terms come with its segment.
    #[inline(always)]
    fn reduce(&mut self, row: &Rows<R>, gain: &Gain<R>) {
        take(&mut self.xx, [&row.x[0], &row.x[1]], [&gain.x[0], &gain.x[1]]);
        for i in 0..6 {
            self.x[i] -= row.x[0][i] * gain.k[0] + row.x[1][i] * gain.k[1];
            for s in 0..2 {
                self.xu[s][i] = -(gain.x[0][i] * row.u[0][s] + gain.x[1][i] * row.u[1][s]);
            }
        }
        let cross = |s: usize, t: usize| -(row.u[0][s] * gain.u[0][t] + row.u[1][s] * gain.u[1][t]);
        self.uu = [cross(0, 0), cross(0, 1), cross(1, 1)];
        self.u = [0, 1].map(|s: usize| -(row.u[0][s] * gain.k[0] + row.u[1][s] * gain.k[1]));
    }

    fn reduce_drift(&mut self, row: &Rows<R>, gain: &Gain<R>) {
        let kd = [&gain.d[0], &gain.d[1]];
        take(&mut self.xd, [&row.x[0], &row.x[1]], kd);
        take(&mut self.dd, [&row.d[0], &row.d[1]], kd);
        for i in 0..6 {
            self.d[i] -= row.d[0][i] * gain.k[0] + row.d[1][i] * gain.k[1];
            for s in 0..2 {
                self.ud[s][i] = -(row.u[0][s] * gain.d[0][i] + row.u[1][s] * gain.d[1][i]);
            }
        }
    }
}

/// The inverse of a positive definite 2x2 matrix, or nothing.
fn inverse<R: Real>([a, b, c]: [R; 3]) -> Option<[R; 3]> {
    let rest = c - b * b / a;
    let positive = a > R::ZERO && c > R::ZERO && rest > c * R::of(8.0 * R::EPSILON);
    if !positive {
        return None;
    }
    let r = R::one() / rest;
    let q = -(b / a) * r;
    Some([R::one() / a - (b / a) * q, q, r])
}
