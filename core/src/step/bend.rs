//! Bending of the leaf: its differences, and their pull on the nodes they name.

use super::constant::row_share;
use crate::grid::Grid;
use crate::potential::bending;
use crate::real::{Lanes, Num, Real, V3};
use crate::state::{Field, Leaf, Sheet};

/// Adds to the gradient `own` and the bending of column `i`, `2 s_n L` at each node its differences name,
/// and the twist of the cells before it.
#[inline(always)]
pub(super) fn bend<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    i: usize,
    k: usize,
    own: V3<R::Lanes>,
    g: &mut Field<R, G>,
) {
    let (a, b) = (sheet.across.rows(i, k), sheet.along.rows(i, k));
    let chi = R::Lanes::all(sheet.cross);
    let (lx, lz) = differences(sheet, &leaf.x, i, k);
    let (px, pz) = (lx + lz * chi, lz + lx * chi);
    let two = R::Lanes::of(2.0);
    let own = own + bending::gradient(px, two * a) + bending::gradient(pz, two * b);
    let (across, along) = (bending::gradient(px, -a), bending::gradient(pz, -b));
    let cell = bending::gradient(cell_twist(sheet, &leaf.x, i, k), sheet.twist.rows(i - 1, k));
    g.add_rows(i - 1, k, 1, -cell);
    g.add_rows(i, k, 1, along + cell);
    g.add_rows(i - 1, k, 0, across + cell);
    g.add_rows(i, k, 0, own - cell);
    if i + 1 < G::NX {
        g.add_rows(i + 1, k, 0, across);
    }
    g.add_rows(i, k, -1, along);
}

/// `T` of the cells between columns `i - 1` and `i`.
#[inline(always)]
pub(super) fn cell_twist<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    x: &Field<R, G>,
    i: usize,
    k: usize,
) -> V3<R::Lanes> {
    let corners = [x.rows(i - 1, k, 0), x.rows(i, k, 0), x.rows(i - 1, k, 1), x.rows(i, k, 1)];
    bending::mixed(corners, sheet.twist.rows(i - 1, k))
}

/// `L_x` and `L_z` of column `i`; a difference a node lacks has coefficient zero.
#[inline(always)]
pub(super) fn differences<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    x: &Field<R, G>,
    i: usize,
    k: usize,
) -> (V3<R::Lanes>, V3<R::Lanes>) {
    let x0 = x.rows(i, k, 0);
    let front = if i + 1 < G::NX { x.rows(i + 1, k, 0) } else { x0 };
    let across = bending::second(x0, front, x.rows(i - 1, k, 0), sheet.across.rows(i, k));
    (across, bending::second(x0, x.rows(i, k, 1), x.rows(i, k, -1), sheet.along.rows(i, k)))
}

/// The clamp: half a cell of bending between the held tangent and the first edge.
pub(super) fn hinge<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    tangent: V3<R>,
    g: &mut Field<R, G>,
) {
    for k in 0..G::NZ {
        let (l, c) = hinge_laplacian(sheet, &leaf.x, tangent, k);
        g.set(1, k, g.at(1, k) + bending::gradient(l, -c));
    }
}

/// `L` at the clamped spine, with the node the tangent implies behind it; and its coefficient.
pub(super) fn hinge_laplacian<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    x: &Field<R, G>,
    tangent: V3<R>,
    k: usize,
) -> (V3<R>, R) {
    let c = sheet.hinge * row_share(sheet, k);
    let x0 = x.at(0, k);
    (bending::second(x0, x.at(1, k), x0 - tangent * sheet.spacing[0], c), c)
}
