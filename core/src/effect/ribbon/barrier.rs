//! Neighbouring rulings must not meet: a primal-dual log barrier on `|c_{j+1} - c_j| ≤ limit`, ends included.
//!
//! ```text
//! -μ (ln(1-u) + ln(1+u))      u = (c_{j+1} - c_j)/limit      z± (1 ∓ u) = μ
//! ```
//!
//! Source: Ribbon Eq. 1; the seed has box bounds and a Lagrangian for the sum. Primal-dual as in textbooks.
//! Checked by `tests/ribbon_derivatives.rs`.

use super::elementary::logarithm;
use crate::real::{Num, Real};

/// A trial keeps at least this share of its distance to a limit.
const KEPT: f64 = 0.005;
/// Duals stay within this factor of `μ/s`.
const SPREAD: f64 = 1e6;

/// Gradient and curvature by `Δc`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wall<R> {
    /// Slope.
    pub slope: R,
    /// Curvature, from the duals.
    pub curve: R,
}

/// `Σ ln` of many numbers of `(0, 1]`, a logarithm for some dozen of them.
#[derive(Debug, Clone, Copy)]
pub struct Logs<R> {
    product: R,
    sum: R,
}

impl<R: Real> Logs<R> {
    /// Of no numbers.
    pub fn none() -> Self {
        Self { product: R::one(), sum: R::ZERO }
    }
    /// Takes one more.
    #[inline]
    pub fn take(&mut self, x: R) {
        self.product *= x;
        if self.product < R::of(1e-20) {
            self.sum += logarithm(self.product);
            self.product = R::one();
        }
    }
    /// The sum.
    pub fn sum(&self) -> R {
        self.sum + logarithm(self.product)
    }
}

/// `(1-u)(1+u)`, what the barrier takes the logarithm of; not positive outside.
#[inline]
pub fn room<R: Real>(spread: R, limit: R) -> R {
    let u = spread / limit;
    (R::one() - u) * (R::one() + u)
}

/// Slope and curvature of a cell's barrier.
#[inline(always)]
pub fn wall<T: Num>(spread: T, limit: T, mu: T, dual: [T; 2]) -> Wall<T> {
    let (over, under) = (limit - spread, limit + spread);
    let (over, under) = (T::one() / over, T::one() / under);
    Wall { slope: mu * (over - under), curve: (dual[0] * over + dual[1] * under) / limit }
}

/// The largest share of a step that stays inside.
#[inline]
pub fn longest<R: Real>(spread: R, step: R, limit: R) -> R {
    let away = if step > R::ZERO { limit - spread } else { limit + spread };
    let (keep, size) = (R::of(1.0 - KEPT), step.magnitude());
    if size > away * keep { away * keep / size } else { R::one() }
}

/// Between what a crease's slope may step, so that no distance to a limit shrinks to less than is kept of it: its
/// difference to the slope before, which has stepped by `before`, and the reach that the end leaves it.
#[inline]
pub fn bounds<R: Real>(spread: R, before: R, limit: R, c: R, reach: R) -> [R; 2] {
    let most = R::of(1.0 - KEPT);
    let low = (before - (limit + spread) * most).larger(-(reach + c) * most);
    let high = (before + (limit - spread) * most).smaller((reach - c) * most);
    [low, high]
}

/// The duals after a step, given the spread before and after it: Newton's, held near `μ/s`.
#[inline]
pub fn duals<R: Real>(dual: [R; 2], before: R, after: R, limit: R, mu: R) -> [R; 2] {
    let (u, v) = (before / limit, after / limit);
    let side = |z: R, old: R, new: R| {
        let wish = (mu + z * (old - new)) / old;
        let (low, high) = (mu / (new * R::of(SPREAD)), mu * R::of(SPREAD) / new);
        wish.larger(low).smaller(high)
    };
    [side(dual[0], R::one() - u, R::one() - v), side(dual[1], R::one() + u, R::one() + v)]
}
