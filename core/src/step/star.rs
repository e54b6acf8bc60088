//! The star round a node, for the rows that travel together.

use crate::constraint::dog::Star;
use crate::grid::Grid;
use crate::real::{Real, V3};
use crate::state::Field;

/// The stars of column `i`: centre and neighbours `x⁺, z⁺, x⁻, z⁻`.
#[inline(always)]
pub(super) fn star<R: Real, G: Grid>(x: &Field<R, G>, i: usize, k: usize) -> Star<R::Lanes> {
    Star::new(
        x.rows(i, k, 0),
        [x.rows(i + 1, k, 0), x.rows(i, k, 1), x.rows(i - 1, k, 0), x.rows(i, k, -1)],
    )
}

/// The three rows of a star, by its five nodes `x⁺, z⁺, x⁻, z⁻, centre`.
pub(super) struct Rows<T> {
    /// The residuals.
    pub(super) values: [T; 3],
    /// For each node its three derivatives, one a row.
    pub(super) nodes: [[V3<T>; 3]; 5],
}

/// The rows of the stars of column `i`, scaled by `scales`. One copy of the code: the assembly and the multipliers
/// both ask for them.
#[inline(never)]
pub(super) fn rows<R: Real, G: Grid>(
    x: &Field<R, G>,
    i: usize,
    k: usize,
    scales: &[R::Lanes; 3],
) -> Rows<R::Lanes> {
    let [fore, head, spine] = star(x, i, k).rows(*scales);
    let values = [fore.value, head.value, spine.value];
    let rows = [fore.gradient, head.gradient, spine.gradient];
    let none = V3::zero();
    // By the centre it is minus the sum of those by the arms that a row names.
    let centre = rows.map(|[a, b, c]| none - a - b - c);
    // Row by row `x⁺ z⁺ x⁻`, `z⁺ x⁻ z⁻`, `x⁻ z⁻ x⁺`.
    let [[f0, h0, s0], [h1, s1, t1], [s2, t2, f2]] = rows;
    let nodes = [[f0, none, f2], [h0, h1, none], [s0, s1, s2], [none, t1, t2], centre];
    Rows { values, nodes }
}
