//! The star round a node, for the rows that travel together.

use crate::constraint::dog::Star;
use crate::grid::Grid;
use crate::real::{Num, Real, V3};
use crate::state::Field;

/// The stars of column `i`: centre and neighbours `x⁺, z⁺, x⁻, z⁻`.
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
