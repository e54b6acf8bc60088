//! The tent: where on its way over the spine a held node is wanted. Source: Book Fig. 7.
//!
//! The finger's ray says where on the screen; the tent says how high. From the block's top it rises in
//! a straight line to its peak over the binding and falls to the other block. It stays below the arc
//! the node could reach, so a target never asks the impossible. Where the ray meets the tent too near the
//! reader for the sheet to follow, the target comes down along the ray: lower, but still under the finger.

use super::view::Ray;
use crate::real::{Real, V3};

/// Peak of the tent over the binding, as a share of the node's distance from the spine.
const PEAK: f64 = 0.75;
/// How far out a target may be where the sheet has not lain, as a share of that distance.
const REACH: f64 = 0.95;
/// Halvings that find how low a target must be to lie within the rope.
const HALVINGS: u32 = 6;
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
    /// Where the node lay when it was taken: paper reaches where it has been.
    pub lain: V3<R>,
}

/// A target on or below a tent, and whether the finger asked for another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aim<R> {
    /// The target.
    pub at: V3<R>,
    /// What lies under the finger is out of the sheet's reach.
    pub clamped: bool,
}

impl<R: Real> Tent<R> {
    /// How far out the tent reaches on the side of `x`: less over a thick block, where its foot stands high;
    /// but always to where the node has lain.
    pub fn reach(&self, x: R) -> R {
        let foot = self.foot(-R::of(1.0)).larger(self.foot(R::of(1.0)));
        let taut = self.radius * R::of(TAUT);
        let rope = (taut * taut - foot * foot).larger(R::ZERO).root();
        let anywhere = rope.smaller(self.radius * R::of(REACH));
        let lain = self.lain.0[0] - self.root;
        if (x < R::ZERO) == (lain < R::ZERO) { anywhere.larger(lain.magnitude()) } else { anywhere }
    }
    /// Height of the tent's foot on the side of `x`, within what the leaf can reach.
    fn foot(&self, x: R) -> R {
        let [left, right] = self.floor;
        let floor = if x < R::ZERO { left } else { right };
        floor.smaller(self.radius * R::of(HIGHEST_FOOT))
    }
    fn peak(&self) -> R {
        self.radius * R::of(PEAK)
    }
    /// How far a target at `x`, `y` may stray towards the tail (`+Z`) and the head.
    ///
    /// Paper does not stretch: no corner of the spine may come to lie further from the node than it is
    /// along the leaf, `√(radius² + end²)`. Straying towards one end takes the node from the other.
    pub fn sideways(&self, x: R, y: R) -> [R; 2] {
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
        let out = (x.magnitude() / self.reach(x)).smaller(R::of(1.0));
        self.foot(x) * out + self.peak() * (R::of(1.0) - out)
    }

    /// The place under a ray that the sheet can follow to: on the tent, or as little below it as it must be.
    pub fn aim(&self, ray: &Ray<R>) -> Aim<R> {
        let Some(on) = self.meet(ray) else { return Aim { at: self.lain, clamped: true } };
        if self.allows(on) {
            return Aim { at: on, clamped: false };
        }
        let x = on.0[0] - self.root;
        let low =
            ray.meet(V3([R::ZERO, self.foot(x), R::ZERO]), V3([R::ZERO, R::of(1.0), R::ZERO]));
        let Some(mut good) = low.filter(|&p| self.allows(p)) else {
            return Aim { at: self.nearest(on), clamped: true };
        };
        let mut bad = on;
        for _ in 0..HALVINGS {
            let middle = (good + bad) * R::of(0.5);
            if self.allows(middle) { good = middle } else { bad = middle }
        }
        Aim { at: good, clamped: false }
    }

    /// Where a ray from above meets the tent.
    fn meet(&self, ray: &Ray<R>) -> Option<V3<R>> {
        let one = R::of(1.0);
        let slope = |side: R| {
            let fall = (self.foot(side) - self.peak()) / self.reach(side) * side;
            let top = V3([self.root, self.peak(), R::ZERO]);
            let met = ray.meet(top, V3([-fall, one, R::ZERO]))?;
            ((met.0[0] - self.root) * side >= R::ZERO).then_some(met)
        };
        let met = slope(one).or_else(|| slope(-one))?;
        let x = met.0[0] - self.root;
        if x.magnitude() <= self.reach(x) {
            return Some(met);
        }
        ray.meet(V3([R::ZERO, self.foot(x), R::ZERO]), V3([R::ZERO, one, R::ZERO]))
    }

    /// Whether the sheet can have its node there.
    fn allows(&self, p: V3<R>) -> bool {
        let (x, dz) = (p.0[0] - self.root, p.0[2] - self.lain.0[2]);
        let [tail, head] = self.sideways(x, p.0[1]);
        x.magnitude() <= self.reach(x) && dz <= tail && dz >= -head
    }

    /// The place nearest to one beyond reach that the sheet can follow to.
    pub fn nearest(&self, p: V3<R>) -> V3<R> {
        let asked = p.0[0] - self.root;
        let limit = self.reach(asked);
        let x = asked.smaller(limit).larger(-limit);
        // A leaf caught in the air may have been above the tent.
        let y = p.0[1].smaller(self.height(x).larger(self.lain.0[1])).larger(self.foot(x));
        let [tail, head] = self.sideways(x, y);
        let dz = (p.0[2] - self.lain.0[2]).smaller(tail).larger(-head);
        V3([self.root + x, y, self.lain.0[2] + dz])
    }
}
