//! The tent: where on its way over the spine a held node is wanted. Source: Book Fig. 7.
//!
//! A drag on the screen says how far across; the tent says how high. From the block's top it rises in
//! a straight line to its peak over the binding and falls to the other block. It stays below the arc
//! the node could reach, so a target never asks the impossible.

use crate::real::Real;

/// Peak of the tent over the binding, as a share of the node's distance from the spine.
const PEAK: f64 = 0.75;
/// How far out a target may be, as a share of that distance.
const REACH: f64 = 0.95;
/// How far along the binding a target may leave the node's own place, as a share of that distance.
const SIDEWAYS: f64 = 0.35;
/// Highest foot of the tent, as a share of the node's distance: in a book thicker than its pages are wide.
const HIGHEST_FOOT: f64 = 0.9;
/// How taut the leaf may be drawn, as a share of its own length.
const TAUT: f64 = 0.985;

/// A tent for one held node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tent<R> {
    /// X of the leaf's spine column.
    pub root: R,
    /// Distance of the node from it, along the leaf.
    pub radius: R,
    /// Height of the tops of the left and right block where the tent meets them.
    pub floor: [R; 2],
    /// Distance along the leaf from the node's row to the tail and to the head.
    pub ends: [R; 2],
}

impl<R: Real> Tent<R> {
    /// How far out the tent reaches on either side: less over a thick block, where its foot stands high.
    pub fn reach(&self) -> R {
        let [left, right] = [self.foot(-R::of(1.0)), self.foot(R::of(1.0))];
        let foot = left.larger(right);
        let taut = self.radius * R::of(TAUT);
        let rope = (taut * taut - foot * foot).larger(R::ZERO).root();
        rope.smaller(self.radius * R::of(REACH))
    }
    /// Height of the tent's foot on the side of `x`, within what the leaf can reach.
    fn foot(&self, x: R) -> R {
        let [left, right] = self.floor;
        let floor = if x < R::ZERO { left } else { right };
        floor.smaller(self.radius * R::of(HIGHEST_FOOT))
    }
    /// How far a target at `x` may stray towards the tail (`+Z`) and the head.
    ///
    /// Paper does not stretch: no corner of the spine may come to lie further from the node than it is
    /// along the leaf, `√(radius² + end²)`. Straying towards one end takes the node from the other.
    pub fn sideways(&self, x: R) -> [R; 2] {
        let y = self.height(x);
        let across_sq = x * x + y * y;
        let share = R::of(TAUT * TAUT);
        let limit = |far: R| {
            let left_sq = share * (self.radius * self.radius + far * far) - across_sq;
            (left_sq.larger(R::ZERO).root() - far)
                .larger(R::ZERO)
                .smaller(self.radius * R::of(SIDEWAYS))
        };
        let [tail, head] = self.ends;
        [limit(head), limit(tail)]
    }
    /// Height at `x`, which is measured from the root.
    pub fn height(&self, x: R) -> R {
        let out = (x.magnitude() / self.reach()).smaller(R::of(1.0));
        let peak = self.radius * R::of(PEAK);
        self.foot(x) * out + peak * (R::of(1.0) - out)
    }
}
