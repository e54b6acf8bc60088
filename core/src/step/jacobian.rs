//! Rows of the stars: their derivatives, kept for the multipliers.

use crate::constraint::dog::Star;
use crate::grid::{Grid, Store};
use crate::real::{LANES, Lanes, Num, Real, V3};
use crate::state::Field;

/// Derivatives of the three rows of every star, scaled by `1/√δ`, with their residuals.
#[derive(Debug, Clone)]
pub struct Jacobian<R: Real, G: Grid>(G::Jacobian<R>);

/// Numbers a star keeps: three rows of three arms of three coordinates, then three residuals.
const STAR: usize = 36;

impl<R: Real, G: Grid> Jacobian<R, G> {
    /// Zeros.
    pub const ZERO: Self = Self(<G::Jacobian<R> as Store<R>>::ZERO);

    #[inline(always)]
    fn place(i: usize, k: usize, n: usize) -> usize {
        (i * G::KP + k) * STAR + n * LANES
    }
    #[inline(always)]
    pub(super) fn set(
        &mut self,
        i: usize,
        k: usize,
        r: usize,
        gradient: &[V3<R::Lanes>; 3],
        residual: R::Lanes,
    ) {
        for (a, g) in gradient.iter().enumerate() {
            for (c, &value) in g.0.iter().enumerate() {
                value.store(self.0.as_mut(), Self::place(i, k, (r * 3 + a) * 3 + c));
            }
        }
        residual.store(self.0.as_mut(), Self::place(i, k, 27 + r));
    }
    /// Row `r` of the stars of column `i`: by its three arms, and its residual.
    #[inline(always)]
    pub fn row(&self, i: usize, k: usize, r: usize) -> ([V3<R::Lanes>; 3], R::Lanes) {
        let load = |n| R::Lanes::load(self.0.as_ref(), Self::place(i, k, n));
        let arm = |a: usize| {
            V3([load((r * 3 + a) * 3), load((r * 3 + a) * 3 + 1), load((r * 3 + a) * 3 + 2)])
        };
        ([arm(0), arm(1), arm(2)], load(27 + r))
    }
}

/// The star of eight rows of column `i`: centre and neighbours `x⁺, z⁺, x⁻, z⁻`.
#[inline(always)]
pub(super) fn star<R: Real, G: Grid>(x: &Field<R, G>, i: usize, k: usize) -> Star<R::Lanes> {
    Star::new(
        x.rows(i, k, 0),
        [x.rows(i + 1, k, 0), x.rows(i, k, 1), x.rows(i - 1, k, 0), x.rows(i, k, -1)],
    )
}

/// Derivatives by the five nodes `x⁺, z⁺, x⁻, z⁻, centre` from those by the three arms a row names.
#[inline(always)]
pub(super) fn spread<T: Num>(nodes: &mut [V3<T>; 5], named: [usize; 3], gradient: &[V3<T>; 3]) {
    let mut centre = V3::zero();
    for (&n, &g) in named.iter().zip(gradient) {
        if let Some(slot) = nodes.get_mut(n) {
            *slot = g;
        }
        centre = centre - g;
    }
    nodes[4] = centre;
}
