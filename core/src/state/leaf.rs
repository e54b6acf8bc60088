//! The active leaf: its net of nodes, what it is made of, and what last touched it.

use super::field::{Field, Heights, groups};
use crate::grid::Grid;
use crate::real::{Lanes, Real, V2, V3};

/// What a leaf is made of, in model units: set once for a book, read by every step.
#[derive(Debug, Clone)]
pub struct Sheet<R: Real, G: Grid> {
    /// Distance between neighbours across and along the leaf.
    pub spacing: [R; 2],
    /// Mass of each node.
    pub mass: Heights<R, G>,
    /// Laplacian coefficient of the arms across, `√w / l`, nothing where a node lacks one of them.
    pub across: Heights<R, G>,
    /// Laplacian coefficient of the arms along.
    pub along: Heights<R, G>,
    /// Coefficient of the mixed difference over the cell whose first corner is the node.
    pub twist: Heights<R, G>,
    /// `χ`: one for the seed's squared Laplacian, zero for a plate.
    pub cross: R,
    /// `1/√δ` where a node has four arms, else nothing: the weight of its three DOG rows.
    pub star: Heights<R, G>,
    /// Dual regularisation.
    pub delta: R,
    /// Weights of the isometry objective for edges across and along.
    pub isometry: [R; 2],
    /// Weight of the held node.
    pub position: R,
    /// Weight of in-solve contact.
    pub contact: R,
    /// Laplacian coefficient of the hinge at a clamped spine: half a cell, so `√2` of an inner one.
    pub hinge: R,
}

impl<R: Real, G: Grid> Sheet<R, G> {
    /// Nothing: to be filled in place.
    pub const ZERO: Self = Self {
        spacing: [R::ZERO; 2],
        mass: Heights::ZERO,
        across: Heights::ZERO,
        along: Heights::ZERO,
        twist: Heights::ZERO,
        cross: R::ZERO,
        star: Heights::ZERO,
        delta: R::ZERO,
        isometry: [R::ZERO; 2],
        position: R::ZERO,
        contact: R::ZERO,
        hinge: R::ZERO,
    };

    /// Inverse products of rest lengths that scale the three DOG rows.
    #[inline(always)]
    pub fn row_scales(&self) -> [R; 3] {
        let [a, b] = self.spacing;
        let (wide, tall) = (R::of(1.0) / (a * b * a), R::of(1.0) / (b * a * b));
        [wide, tall, wide]
    }
}

/// How the spine column is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Root<R> {
    /// Hinged: the column's place is given, the leaf turns about it freely. Eq. 7.
    Hinge,
    /// Clamped: the leaf also leaves the column along this unit direction.
    Clamp(V3<R>),
}

/// The node the hand holds and where it wants it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grab<R> {
    /// Column and row of the node.
    pub node: (usize, usize),
    /// Target `p` of Eq. 14.
    pub target: V3<R>,
    /// How firmly, in weights `w_pos` of the sheet.
    pub firm: R,
}

/// Positions, velocities, and the contacts of the last collision pass.
#[derive(Debug, Clone)]
pub struct Leaf<R: Real, G: Grid> {
    /// Positions.
    pub x: Field<R, G>,
    /// Velocities.
    pub v: Field<R, G>,
    /// Per node `(n_x, n_y, o)`: direction of the last push and where along it the node was left.
    pub pushed: Field<R, G>,
    /// Weight of that contact in the next solve: nothing where the node was not pushed.
    pub holding: Heights<R, G>,
}

impl<R: Real, G: Grid> Leaf<R, G> {
    /// Nothing: to be laid down in place.
    pub const ZERO: Self =
        Self { x: Field::ZERO, v: Field::ZERO, pushed: Field::ZERO, holding: Heights::ZERO };

    /// Lays column after column at the places given, at rest; columns without a place go to the origin.
    pub fn lay(&mut self, spacing: [R; 2], places: impl IntoIterator<Item = V2<R>>) {
        let middle = R::of(0.5 * (G::NZ - 1) as f64);
        let mut places = places.into_iter();
        for i in 0..G::NX {
            let place = places.next().unwrap_or_default();
            for k in 0..G::NZ {
                let z = (middle - R::of(k as f64)) * spacing[1];
                self.x.set(i, k, V3([place.0[0], place.0[1], z]));
            }
        }
        self.v.clear();
        self.pushed.clear();
        self.holding.clear();
    }

    /// Becomes another.
    pub fn copy_from(&mut self, other: &Self) {
        self.x.copy_from(&other.x);
        self.v.copy_from(&other.v);
        self.pushed.copy_from(&other.pushed);
        self.holding.copy_from(&other.holding);
    }

    /// Largest speed of any node.
    pub fn fastest(&self) -> R {
        let sq = groups::<R, G>().flat_map(|k| (0..G::NX).map(move |i| (i, k)));
        sq.fold(R::ZERO, |m, (i, k)| m.larger(self.v.rows(i, k, 0).norm_sq().largest())).root()
    }

    /// Extremes and root mean square of `length / rest - 1` over the edges.
    pub fn stretch(&self, spacing: [R; 2]) -> Stretch<R> {
        let mut s = Stretch { largest: R::ZERO, smallest: R::ZERO, sum_sq: R::ZERO, edges: 0 };
        for (i, k) in Field::<R, G>::nodes() {
            let here = self.x.at(i, k);
            if i + 1 < G::NX {
                s.take((self.x.at(i + 1, k) - here).norm() / spacing[0]);
            }
            if k + 1 < G::NZ && i > 0 {
                s.take((self.x.at(i, k + 1) - here).norm() / spacing[1]);
            }
        }
        s
    }
}

/// How far the edges are from their rest length.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Stretch<R> {
    /// Largest `length / rest - 1`.
    pub largest: R,
    /// Smallest, negative where an edge is compressed.
    pub smallest: R,
    sum_sq: R,
    edges: u32,
}

impl<R: Real> Stretch<R> {
    fn take(&mut self, ratio: R) {
        let strain = ratio - R::of(1.0);
        self.largest = self.largest.larger(strain);
        self.smallest = self.smallest.smaller(strain);
        self.sum_sq += strain * strain;
        self.edges += 1;
    }
    /// Largest magnitude.
    pub fn max(&self) -> R {
        self.largest.larger(-self.smallest)
    }
    /// Root mean square over all edges.
    pub fn rms(&self) -> R {
        (self.sum_sq / R::of(f64::from(self.edges.max(1)))).root()
    }
}
