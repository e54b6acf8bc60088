//! A place on the paper: three neighbouring nodes and a weight for each.
//!
//! The hand pulls at a node; what must stay under the finger is the paper the finger touched.

use super::view::Ray;
use crate::grid::Grid;
use crate::real::{Real, V3};
use crate::state::{Field, Fnv, Leaf};

/// Shortest determinant of a triangle that is not seen edge on, as a share of the ray's length.
const EDGE_ON: f64 = 1e-6;

/// A place on a leaf, moving with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place<R> {
    corners: [(usize, usize); 3],
    weights: [R; 3],
}

impl<R: Real> Place<R> {
    /// The place a ray meets first; beside the leaf, its node nearest to the ray.
    ///
    /// # Cost
    ///
    /// Two triangles a cell: some 6,000 operations at 11x8, once a press.
    pub fn under<G: Grid>(leaf: &Leaf<R, G>, ray: &Ray<R>) -> Self {
        let mut first: Option<(R, Self)> = None;
        for i in 0..G::NX - 1 {
            for k in 0..G::NZ - 1 {
                let [a, b, c, d] = [(i, k), (i + 1, k), (i, k + 1), (i + 1, k + 1)];
                for corners in [[a, b, c], [d, c, b]] {
                    let Some((depth, weights)) = meet(leaf, corners, ray) else { continue };
                    if first.is_none_or(|(least, _)| depth < least) {
                        first = Some((depth, Self { corners, weights }));
                    }
                }
            }
        }
        first.map_or_else(|| Self::nearest(leaf, ray), |(_, place)| place)
    }

    fn nearest<G: Grid>(leaf: &Leaf<R, G>, ray: &Ray<R>) -> Self {
        let mut best = ((0, 0), R::of(1e30));
        for (i, k) in Field::<R, G>::nodes() {
            let d = ray.distance_sq(leaf.x.at(i, k));
            if d < best.1 {
                best = ((i, k), d);
            }
        }
        Self::at(best.0)
    }

    /// A node.
    pub fn at(node: (usize, usize)) -> Self {
        Self { corners: [node; 3], weights: [R::of(1.0), R::ZERO, R::ZERO] }
    }

    /// Where it is now.
    pub fn on<G: Grid>(&self, leaf: &Leaf<R, G>) -> V3<R> {
        let [a, b, c] = self.corners.map(|(i, k)| leaf.x.at(i, k));
        let [u, v, w] = self.weights;
        a * u + b * v + c * w
    }

    /// Adds it to a state hash.
    pub fn digest(&self, hash: &mut Fnv) {
        for (i, k) in self.corners {
            hash.word(i as u64 | (k as u64) << 16);
        }
        self.weights.iter().for_each(|&w| hash.real(w));
    }
}

/// How far along the ray, in its own lengths, it meets a triangle, and the weights of the corners there.
fn meet<R: Real, G: Grid>(
    leaf: &Leaf<R, G>,
    corners: [(usize, usize); 3],
    ray: &Ray<R>,
) -> Option<(R, [R; 3])> {
    let [a, b, c] = corners.map(|(i, k)| leaf.x.at(i, k));
    let (p, q, from) = (b - a, c - a, ray.from - a);
    let across = ray.along.cross(q);
    let det = p.dot(across);
    if det * det <= R::of(EDGE_ON * EDGE_ON) * ray.along.norm_sq() {
        return None;
    }
    let v = from.dot(across) / det;
    let turned = from.cross(p);
    let w = ray.along.dot(turned) / det;
    let depth = q.dot(turned) / det;
    let u = R::of(1.0) - v - w;
    let inside = u >= R::ZERO && v >= R::ZERO && w >= R::ZERO;
    (inside && depth > R::ZERO).then_some((depth, [u, v, w]))
}
