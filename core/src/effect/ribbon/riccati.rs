//! The quadratic model of everything beyond a crease, and how a crease is eliminated from it.
//!
//! The state of a segment is eight numbers, as many as travel together: its twist `ξ`, its near crease's `ψ` and `c`; the
//! controls are the next crease's. Twists are about the world's origin, so `ξ_{j+1} = ξ_j + S_ψ δψ + S_c δc`: the dynamics
//! are the identity, and one stage is two products of an 8x8 matrix with a vector and a change of rank two. `d` is the
//! start's own twist where the start is free and the end is joined to it: then `ξ` is counted from the start's.
//!
//! Source: ours; Riccati's recursion for a chain. Checked by `tests/ribbon_derivatives.rs`.

use super::frame::{Six, dot6};
use crate::real::{Eight, LANES, Lanes, Num, Real};

/// Where `ψ` is in a state; before it is `ξ`.
pub const PSI: usize = 6;
/// Where `c` is in a state.
pub const C: usize = 7;

/// Value, to second order, of what lies beyond, over the state `z = (ξ, ψ, c)`.
#[derive(Debug, Clone, Copy)]
pub struct Value<R: Real> {
    /// By `z z`, row by row.
    pub zz: [R::Eight; LANES],
    /// By `z`.
    pub z: R::Eight,
    /// By `z d`; of a row the first six count.
    pub zd: [R::Eight; LANES],
    /// By `d d`; of a row the first six count.
    pub dd: [R::Eight; 6],
    /// By `d`; the first six count.
    pub d: R::Eight,
}

/// The rule that gives a crease's step from the state before it: `-(k + Z z + D d)`, row `ψ` then row `c`.
#[derive(Debug, Clone, Copy)]
pub struct Gain<R> {
    /// The constant part.
    pub k: [R; 2],
    /// By the state before.
    pub z: [[R; LANES]; 2],
    /// By `d`.
    pub d: [Six<R>; 2],
    /// `S_ψ`, `S_c`.
    pub axes: [Six<R>; 2],
    /// How `ψ` follows where `c` is held off its rule.
    pub lean: R,
}

/// A segment's own model, and what its next crease adds to that: its axes, how it is tied to the state before it beside
/// the dynamics, its own terms. Row `ψ` then row `c`.
#[derive(Debug, Clone, Copy)]
pub struct Part<R> {
    /// Hessian of the segment by its state, row by row.
    pub zz: [[R; LANES]; LANES],
    /// Gradient by its state.
    pub z: [R; LANES],
    /// How the crease moves the state beyond it: `S_ψ` and a one for its `ψ`, `S_c` and a one for its `c`.
    pub axes: [[R; LANES]; 2],
    /// What ties the crease to the state (and by its twist to `d`).
    pub tie: [[R; LANES]; 2],
    /// The crease's own gradient.
    pub g: [R; 2],
    /// Its own Hessian `ψψ`, `ψc`, `cc`, the shift included.
    pub h: [R; 3],
    /// Which of the two may move.
    pub free: [bool; 2],
}

impl<R: Real> Part<R> {
    /// Nothing of its own, and a crease that does nothing.
    pub const ZERO: Self = {
        let (o, l, none) = (R::ZERO, R::ONE, [R::ZERO; LANES]);
        Self {
            zz: [none; LANES],
            z: none,
            axes: [[o, o, o, o, o, o, l, o], [o, o, o, o, o, o, o, l]],
            tie: [none; 2],
            g: [o; 2],
            h: [o; 3],
            free: [true; 2],
        }
    };
}

/// A crease's rows of the model: by itself, their right-hand sides, by the state before, by `d`.
struct Rows<R: Real> {
    h: [R; 3],
    g: [R; 2],
    z: [R::Eight; 2],
    d: [R::Eight; 2],
}

impl<R: Real> Gain<R> {
    /// No rule.
    pub const ZERO: Self = Self {
        k: [R::ZERO; 2],
        z: [[R::ZERO; LANES]; 2],
        d: [[R::ZERO; 6]; 2],
        axes: [[R::ZERO; 6]; 2],
        lean: R::ZERO,
    };
    /// The step of the crease for a share of the whole, given what the state before it has become.
    #[inline(always)]
    pub fn rule(&self, share: R, x: &Six<R>, [psi, c]: [R; 2], d: Option<&Six<R>>) -> [R; 2] {
        let [p, q, r, s, t, u] = *x;
        let row = |i: usize| {
            let z = &self.z[i];
            let near = self.k[i] * share + (z[PSI] * psi + z[C] * c);
            let far = d.map_or(R::ZERO, |d| dot6(&self.d[i], d));
            let turn = z[0] * p + (z[1] * q + z[2] * r);
            -((near + far) + (turn + (z[3] * s + (z[4] * t + z[5] * u))))
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

/// Six numbers and two.
#[inline(always)]
pub fn state<R: Real>(x: &Six<R>, [psi, c]: [R; 2]) -> [R; LANES] {
    let [p, q, r, s, t, u] = *x;
    [p, q, r, s, t, u, psi, c]
}

/// The same number in all lanes.
#[inline(always)]
fn all<R: Real>(x: R) -> R::Eight {
    <R::Eight as Lanes<R>>::all(x)
}

/// What changes along both axes change in the gradient.
#[inline(always)]
fn along<R: Real>(m: &[R::Eight; LANES], [s, t]: &[[R; LANES]; 2]) -> [R::Eight; 2] {
    let mut sum = [m[PSI], m[C]];
    for (row, (&s, &t)) in m.iter().zip(s.iter().zip(t)).take(PSI) {
        sum = [sum[0] + *row * all::<R>(s), sum[1] + *row * all::<R>(t)];
    }
    sum
}

/// `a pᵀ + b qᵀ`, a row of it.
#[inline(always)]
fn row<R: Real>([a, b]: [R; 2], [p, q]: [R::Eight; 2]) -> R::Eight {
    p * all::<R>(a) + q * all::<R>(b)
}

impl<R: Real> Value<R> {
    /// Nothing beyond.
    #[inline]
    pub fn zero() -> Self {
        let o = R::Eight::zero();
        Self { zz: [o; LANES], z: o, zd: [o; LANES], dd: [o; 6], d: o }
    }

    /// Takes a joint's gradient and Hessian by the end's twist for what lies beyond.
    pub fn join(&mut self, x: &Six<R>, xx: &[Six<R>; 6]) {
        let at = |x: &Six<R>| R::Eight::from_array(state(x, [R::ZERO; 2]));
        self.z = at(x);
        self.zz.iter_mut().zip(xx).for_each(|(m, xx)| *m = at(xx));
    }

    /// Eliminates a crease: from the value by the segment beyond it to the value by the one before it, that one's own
    /// model added, and the rule for its step. Adds to `fall` how much the model falls to first order; `None` where the
    /// model has no minimum. Where `drift`, `d` counts.
    ///
    /// # Cost
    ///
    /// About 600 multiply-adds, with `d` 1,200; eight at a time where the target can.
    #[inline(never)]
    pub fn eliminate(
        &mut self,
        part: &Part<R>,
        drift: bool,
        fall: &mut R,
        gain: &mut Gain<R>,
    ) -> Option<()> {
        let rows = self.rows(part, drift);
        let inverse = inverse(rows.h)?;
        let [p, q, r] = inverse;
        let k = [p * rows.g[0] + q * rows.g[1], q * rows.g[0] + r * rows.g[1]];
        *fall += rows.g[0] * k[0] + rows.g[1] * k[1];
        (gain.k, gain.axes, gain.lean) = (k, part.axes.map(six), q / r);
        let solve = |[a, b]: [R::Eight; 2]| {
            let [p, q, r] = inverse.map(all::<R>);
            [a * p + b * q, a * q + b * r]
        };
        let (z, before_z) = (solve(rows.z), rows.z.map(Eight::array));
        gain.z = z.map(Eight::array);
        let pair = |k: usize| [before_z[0][k], before_z[1][k]];
        for (k, (m, own)) in self.zz.iter_mut().zip(&part.zz).enumerate() {
            let old = if k < PSI { before::<R>(*m) } else { R::Eight::zero() };
            *m = old - row::<R>(pair(k), z) + R::Eight::from_array(*own);
        }
        self.z = before::<R>(self.z) - row::<R>(k, rows.z) + R::Eight::from_array(part.z);
        if drift {
            self.eliminate_drift(part, &rows, (k, inverse), gain);
        }
        Some(())
    }

    /// The crease's two rows of the model, the dynamics put in.
    #[inline(always)]
    fn rows(&self, part: &Part<R>, drift: bool) -> Rows<R> {
        let (one, o, none) = (R::one(), R::ZERO, R::Eight::zero());
        let axes = part.axes.map(R::Eight::from_array);
        let z = along::<R>(&self.zz, &part.axes);
        let h = [(axes[0] * z[0]).sum(), (axes[0] * z[1]).sum(), (axes[1] * z[1]).sum()];
        let tie = part.tie.map(R::Eight::from_array);
        let mut rows = Rows {
            h: [h[0] + part.h[0], h[1] + part.h[1], h[2] + part.h[2]],
            g: [(axes[0] * self.z).sum() + part.g[0], (axes[1] * self.z).sum() + part.g[1]],
            z: [before::<R>(z[0]) + tie[0], before::<R>(z[1]) + tie[1]],
            d: [none; 2],
        };
        if drift {
            let d = along::<R>(&self.zd, &part.axes);
            rows.d = [d[0] + before::<R>(tie[0]), d[1] + before::<R>(tie[1])];
        }
        for i in 0..2 {
            if !part.free[i] {
                (rows.g[i], rows.z[i], rows.d[i]) = (o, none, none);
                (rows.h[1], rows.h[2 * i]) = (o, one);
            }
        }
        rows
    }

    /// The same for what depends on `d`, in which a segment's own model is as in `ξ`.
    fn eliminate_drift(
        &mut self,
        part: &Part<R>,
        rows: &Rows<R>,
        (k, [p, q, r]): ([R; 2], [R; 3]),
        gain: &mut Gain<R>,
    ) {
        let [p, q, r] = [p, q, r].map(all::<R>);
        let d = [rows.d[0] * p + rows.d[1] * q, rows.d[0] * q + rows.d[1] * r];
        gain.d = d.map(|d| six(d.array()));
        let (rz, rd) = (rows.z.map(Eight::array), rows.d.map(Eight::array));
        for (k, (m, own)) in self.zd.iter_mut().zip(&part.zz).enumerate() {
            let old = if k < PSI { *m } else { R::Eight::zero() };
            let own = before::<R>(R::Eight::from_array(*own));
            *m = old - row::<R>([rz[0][k], rz[1][k]], d) + own;
        }
        for (k, (m, own)) in self.dd.iter_mut().zip(&part.zz).enumerate() {
            let own = before::<R>(R::Eight::from_array(*own));
            *m = *m - row::<R>([rd[0][k], rd[1][k]], d) + own;
        }
        self.d = self.d - row::<R>(k, rows.d) + before::<R>(R::Eight::from_array(part.z));
    }

    /// Adds the model of a segment that no crease was eliminated before.
    pub fn add(&mut self, part: &Part<R>, drift: bool) {
        for (m, own) in self.zz.iter_mut().zip(&part.zz) {
            *m = *m + R::Eight::from_array(*own);
        }
        self.z = self.z + R::Eight::from_array(part.z);
        if drift {
            for (k, own) in part.zz.iter().enumerate() {
                let own = before::<R>(R::Eight::from_array(*own));
                self.zd[k] = self.zd[k] + own;
                if let Some(m) = self.dd.get_mut(k) {
                    *m = *m + own;
                }
            }
            self.d = self.d + before::<R>(R::Eight::from_array(part.z));
        }
    }
}

/// The part by `ξ` alone.
#[inline(always)]
fn before<R: Real>(z: R::Eight) -> R::Eight {
    let [p, q, r, s, t, u, ..] = z.array();
    R::Eight::from_array([p, q, r, s, t, u, R::ZERO, R::ZERO])
}

/// The first six.
#[inline(always)]
pub fn six<R: Real>([p, q, r, s, t, u, ..]: [R; LANES]) -> Six<R> {
    [p, q, r, s, t, u]
}

/// The inverse of a positive definite 2x2 matrix, or nothing.
#[inline(always)]
fn inverse<R: Real>([a, b, c]: [R; 3]) -> Option<[R; 3]> {
    let slope = b / a;
    let rest = c - b * slope;
    let positive = a > R::ZERO && c > R::ZERO && rest > c * R::of(8.0 * R::EPSILON);
    if !positive {
        return None;
    }
    let r = R::one() / rest;
    let q = -slope * r;
    Some([R::one() / a - slope * q, q, r])
}
