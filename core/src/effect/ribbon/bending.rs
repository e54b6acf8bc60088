//! Bending of a cell and the cost of slanted rulings: value, gradient and Hessian in `(ψ, c)` of both its creases.
//!
//! ```text
//! V = D w/(4L) A(q) (m_j (1+c_j²) ψ_j² + m_{j+1} (1+c_{j+1}²) ψ_{j+1}²) + β c_j²      q = w (c_{j+1} - c_j)/(2L)
//! ```
//!
//! Every inner crease is bent half in the cell before it and half in the one beyond. `A = 1` is the seed's energy,
//! Sadowsky's; `A = atanh(q)/q` is Wunderlich's. `m` is one, but near a
//! clamp, see [`Strip::weight`].
//!
//! Source: Ribbon Sec. 4 (whose `β` is in joules; ours is a share of the stiffness, so it refines with the mesh).
//! Checked by `tests/ribbon_derivatives.rs`.

use super::elementary::hyperbolic;
use super::joint::Crease;
use super::strip::Strip;
use crate::real::{Num, Real};

/// Index of a crease's numbers in [`Bent`]: the near crease's `ψ` and `c`, then the far one's.
pub const PSI: usize = 0;
/// See [`PSI`].
pub const C: usize = 1;

/// Gradient and Hessian of a cell by `(ψ_j, c_j, ψ_{j+1}, c_{j+1})`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bent<R> {
    /// Gradient.
    pub g: [R; 4],
    /// Hessian.
    pub h: [[R; 4]; 4],
}

fn factor<R: Real>(strip: &Strip<R>, spread: R) -> [R; 3] {
    if strip.wunderlich {
        let slope = strip.half / strip.cell;
        let [a, b, c] = hyperbolic(spread * slope);
        [a, b * slope, c * slope * slope]
    } else {
        [R::one(), R::ZERO, R::ZERO]
    }
}

/// The energy.
#[inline]
pub fn energy<R: Real>(strip: &Strip<R>, j: usize, a: Crease<R>, b: Crease<R>) -> R {
    let [factor, ..] = factor(strip, b.c - a.c);
    let square = |x: Crease<R>| (R::one() + x.c * x.c) * x.psi * x.psi;
    let both = strip.weight(j) * square(a) + strip.weight(j + 1) * square(b);
    R::of(0.5) * strip.stiff * factor * both + strip.slope * a.c * a.c
}

/// What a cell's bending is made from, of one cell or of several side by side.
#[derive(Debug, Clone, Copy)]
pub struct Bend<T> {
    /// Wunderlich's factor and its derivatives by `Δc`, times half of the stiffness.
    pub factor: [T; 3],
    /// What its creases weigh.
    pub weight: [T; 2],
    /// `β`, twice.
    pub slope: T,
}

impl<R: Real> Bend<R> {
    /// Of cell `j`.
    #[inline(always)]
    pub fn of(strip: &Strip<R>, j: usize, spread: R) -> Self {
        let half = R::of(0.5) * strip.stiff;
        Self {
            factor: factor(strip, spread).map(|f| f * half),
            weight: [strip.weight(j), strip.weight(j + 1)],
            slope: R::of(2.0) * strip.slope,
        }
    }
}

/// Its derivatives.
#[inline]
pub fn derivatives<R: Real>(strip: &Strip<R>, j: usize, a: Crease<R>, b: Crease<R>) -> Bent<R> {
    Bend::of(strip, j, b.c - a.c).derivatives(a, b)
}

impl<T: Num> Bend<T> {
    /// The derivatives of its energy.
    #[inline(always)]
    pub fn derivatives(&self, a: Crease<T>, b: Crease<T>) -> Bent<T> {
        let Self { factor: [f0, f1, f2], weight, slope } = *self;
        let (one, two, four, o) = (T::one(), T::of(2.0), T::of(4.0), T::zero());
        // Of each crease: its square, slopes by ψ and c, curvatures ψψ, ψc, cc.
        let parts = |x: Crease<T>, m: T| {
            let (k, psi) = ((one + x.c * x.c) * m, x.psi);
            let sq = psi * psi * m;
            [k * psi * psi, two * k * psi, two * x.c * sq, two * k, four * x.c * psi * m, two * sq]
        };
        let ([s0, p0, c0, pp0, pc0, cc0], [s1, p1, c1, pp1, pc1, cc1]) =
            (parts(a, weight[0]), parts(b, weight[1]));
        let sum = s0 + s1;
        let (pc, cp) = (f0 * pc0 - f1 * p0, f1 * p0);
        let (qc, qd) = (-(f1 * p1), f0 * pc1 + f1 * p1);
        let cc = f0 * cc0 - two * f1 * c0 + f2 * sum + slope;
        let cd = f1 * (c0 - c1) - f2 * sum;
        let dd = f0 * cc1 + two * f1 * c1 + f2 * sum;
        Bent {
            g: [f0 * p0, f0 * c0 - f1 * sum + slope * a.c, f0 * p1, f0 * c1 + f1 * sum],
            h: [[f0 * pp0, pc, o, cp], [pc, cc, qc, cd], [o, qc, f0 * pp1, qd], [cp, cd, qd, dd]],
        }
    }
}

impl<T: Num> Bent<T> {
    /// Makes the Hessian [`rough`] by a share.
    #[inline(always)]
    pub fn roughen(&mut self, rough: &[[T; 4]; 4], share: T) {
        for (h, rough) in self.h.iter_mut().flatten().zip(rough.iter().flatten()) {
            *h = *h + (*rough - *h) * share;
        }
    }
}

/// The Hessian with what could make it indefinite cut back: `ψc` to what its neighbours bear where `c² > 1/3`, and
/// Wunderlich's factor as if it stood still but for its own curvature.
pub fn rough<R: Real>(strip: &Strip<R>, j: usize, a: Crease<R>, b: Crease<R>) -> [[R; 4]; 4] {
    Bend::of(strip, j, b.c - a.c).rough(a, b)
}

impl<T: Num> Bend<T> {
    /// As [`rough`].
    #[inline(always)]
    pub fn rough(&self, a: Crease<T>, b: Crease<T>) -> [[T; 4]; 4] {
        let ([f, _, curve], o, two) = (self.factor, T::zero(), T::of(2.0));
        let part = |x: Crease<T>, weight: T| {
            let (m, k) = (two * f * weight, T::one() + x.c * x.c);
            let most = k.root();
            let lean = (two * x.c).larger(-most).smaller(most);
            [m * k, m * x.psi * lean, m * x.psi * x.psi, k * x.psi * x.psi * weight]
        };
        let ([pp, pc, cc, s], [qq, qd, dd, t]) = (part(a, self.weight[0]), part(b, self.weight[1]));
        let apart = curve * (s + t);
        let own = cc + self.slope + apart;
        [[pp, pc, o, o], [pc, own, o, -apart], [o, o, qq, qd], [o, -apart, qd, dd + apart]]
    }
}
