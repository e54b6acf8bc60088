//! Ray to node: the node nearest the ray among those one segment in from the border.
//!
//! On the border itself a pull makes creases. Source: Book Sec. 3.3.

use super::view::Ray;
use crate::grid::Grid;
use crate::real::{Real, V3};
use crate::state::{Field, Leaf};

/// Nodes nearer the spine than this share of the width cannot be held: they could hardly move.
const LEAST_COLUMN: usize = 4;

/// The node to hold and its squared distance to the ray.
pub fn pick<R: Real, G: Grid>(leaf: &Leaf<R, G>, ray: &Ray<R>) -> ((usize, usize), R) {
    let mut best = ((G::NX - 2, 1), R::of(1e30));
    for (i, k) in Field::<R, G>::nodes().filter(|&(i, k)| holdable::<G>(i, k)) {
        let d = ray.distance_sq(leaf.x.at(i, k));
        if d < best.1 {
            best = ((i, k), d);
        }
    }
    best
}

/// One segment in from fore-edge, tail or head, and not close to the spine.
fn holdable<G: Grid>(i: usize, k: usize) -> bool {
    let inner = (1..G::NX - 1).contains(&i) && (1..G::NZ - 1).contains(&k);
    let ring = i == G::NX - 2 || k == 1 || k == G::NZ - 2;
    inner && ring && i * LEAST_COLUMN >= G::NX
}

/// The node in from the fore-edge that is as far along the binding as where a ray meets its height.
pub fn level_with<R: Real, G: Grid>(leaf: &Leaf<R, G>, ray: &Ray<R>) -> (usize, usize) {
    let column = G::NX - 2;
    let up = V3([R::ZERO, R::of(1.0), R::ZERO]);
    let z = ray.meet(leaf.x.at(column, 0), up).map_or(R::ZERO, |p| p.0[2]);
    let mut best = (1, R::of(1e30));
    for k in 1..G::NZ - 1 {
        let d = (leaf.x.at(column, k).0[2] - z).magnitude();
        if d < best.1 {
            best = (k, d);
        }
    }
    (column, best.0)
}
