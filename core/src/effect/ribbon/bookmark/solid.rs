//! What of the book is solid to a ribbon: blocks and boards as prisms, a leaf in the air as a curtain.

use super::curve::{Edge, Foot, foot};
use crate::collision::profile::FAN;
use crate::grid::Grid;
use crate::real::{Real, V2, V3};
use crate::state::Field;
use crate::state::strip::BLOCK;

/// Corners of a prism's outline: the fan, the edges, and the way down at its end.
const CORNERS: usize = FAN + BLOCK + 1;
/// Further than anything of a book, metres.
pub(super) const FAR: f64 = 1e3;
/// A prism's outer end goes down so far, metres.
const DOWN: f64 = 1.0;
/// What is further than this from a body is told no more exactly than that, metres.
const NEAR: f64 = 2e-3;
/// Shorter than this has no direction, metres.
const NOTHING: f64 = 1e-9;
/// Deeper than this behind a curtain is not behind it, metres: it was gone around.
const DEEPEST: f64 = 0.04;

/// Everything below an outline, from head to tail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prism<R> {
    /// Outline from the binding outwards, metres, outward coordinates.
    edges: [Edge<R>; CORNERS - 1],
    /// Its innermost and its outermost place, and its highest.
    inner: R,
    outer: R,
    top: R,
    /// Which way outwards is, along X.
    sign: R,
    /// From its middle to head and tail.
    half: R,
}

impl<R: Real> Prism<R> {
    /// Nothing.
    pub const NONE: Self = Self {
        edges: [Edge::NONE; CORNERS - 1],
        inner: R::ZERO,
        outer: R::ZERO,
        top: R::ZERO,
        sign: R::ZERO,
        half: R::ZERO,
    };

    /// Below these corners; behind the last it goes straight down.
    pub fn new(corners: impl IntoIterator<Item = V2<R>>, sign: f64, half: R) -> Self {
        let mut last = V2::zero();
        let mut points = [None; CORNERS];
        for (place, p) in points.iter_mut().take(CORNERS - 1).zip(corners) {
            (*place, last) = (Some(p), p);
        }
        let end = last - V2([R::ZERO, R::of(DOWN)]);
        let points = points.map(|p| p.unwrap_or(end));
        let mut edges = [Edge::NONE; CORNERS - 1];
        for (edge, [a, b]) in edges.iter_mut().zip(points.array_windows::<2>()) {
            *edge = Edge::between(*a, *b);
        }
        let [inner, top] = points
            .iter()
            .fold([end.0[0], end.0[1]], |[x, y], p| [x.smaller(p.0[0]), y.larger(p.0[1])]);
        Self { edges, inner, outer: end.0[0], top, sign: R::of(sign), half }
    }

    /// The foot on its outline, outward coordinates; `None` where there is no such body.
    pub fn foot(&self, p: V3<R>) -> Option<Foot<R>> {
        let there = self.half > R::ZERO;
        let outward = V2([p.0[0] * self.sign, p.0[1]]);
        let foot = there.then(|| foot(self.edges.iter().copied(), outward)).flatten()?;
        // Before its start there is nothing of it, however low.
        let distance = if foot.outside { foot.distance.magnitude() } else { foot.distance };
        let flip = if distance == foot.distance { R::one() } else { -R::one() };
        Some(Foot { distance, normal: foot.normal * flip, ..foot })
    }

    /// Direction of the book frame from one in outward coordinates.
    pub fn turned(&self, n: V2<R>) -> V3<R> {
        V3([n.0[0] * self.sign, n.0[1], R::ZERO])
    }

    /// Distance and normal of a point of the book frame; of one that is far away, no more than the distance of a box.
    pub fn above(&self, p: V3<R>) -> (R, V3<R>) {
        let x = p.0[0] * self.sign;
        let beyond =
            [p.0[1] - self.top, self.inner - x, x - self.outer, p.0[2].magnitude() - self.half];
        let beyond = beyond.into_iter().fold(-R::of(FAR), |m, x| m.larger(x));
        if beyond > R::of(NEAR) {
            return (beyond, V3::zero());
        }
        let Some(foot) = self.foot(p) else { return (R::of(FAR), V3::zero()) };
        let (d, n) = (foot.distance, self.turned(foot.normal));
        let side = if p.0[2] < R::ZERO { -R::one() } else { R::one() };
        both((d, n), (p.0[2] * side - self.half, V3([R::ZERO, R::ZERO, side])))
    }

    /// Whether a point lies between head and tail, and not beyond its outer end.
    pub fn spans(&self, p: V3<R>) -> bool {
        p.0[2].magnitude() < self.half && p.0[0] * self.sign < self.outer
    }
}

/// Distance to what two solids that meet squarely have in common, from the distances to them.
fn both<R: Real>((d, n): (R, V3<R>), (e, m): (R, V3<R>)) -> (R, V3<R>) {
    if d > R::ZERO && e > R::ZERO {
        let far = (d * d + e * e).root();
        return (far, (n * d + m * e) * (R::one() / far));
    }
    if d > e { (d, n) } else { (e, m) }
}

/// The leaf in the air, metres, and on which of its sides the ribbon is.
#[derive(Debug, Clone)]
pub struct Curtain<R: Real, G: Grid> {
    nodes: Field<R, G>,
    /// One if the ribbon is on the side of the left page; nothing if there is no leaf.
    side: R,
    /// From its middle to head and tail.
    half: R,
    /// Nearer than this to the head there is no contact: the leaf's foot closes over the ribbon there.
    head: R,
}

impl<R: Real, G: Grid> Curtain<R, G> {
    /// None.
    pub const NONE: Self = Self { nodes: Field::ZERO, side: R::ZERO, half: R::ZERO, head: R::ZERO };

    /// There is no leaf.
    pub fn clear(&mut self) {
        self.side = R::ZERO;
    }

    /// A leaf of this height, scaled to metres.
    pub fn hang(&mut self, x: &Field<R, G>, metres: R, side: f64, half: R, head: R) {
        for (i, k) in Field::<R, G>::nodes() {
            self.nodes.set(i, k, x.at(i, k) * metres);
        }
        (self.side, self.half, self.head) = (R::of(side), half, head);
    }

    /// Signed distance to it at its level along the binding, and the gradient's direction; `None` where there is no leaf.
    ///
    /// # Accuracy
    ///
    /// Rows are taken to stand at their rest places along the binding: exact for a leaf that is bent about the spine.
    pub fn above(&self, p: V3<R>) -> Option<(R, V3<R>)> {
        self.seen(p).map(|(over, _)| over)
    }

    /// The same of a solid behind it that ends `rim` inside its edges: who is deep behind it comes out at the nearest edge,
    /// and nowhere does a small step make a large difference.
    pub fn solid(&self, p: V3<R>, rim: R) -> Option<(R, V3<R>)> {
        let (over, [foot, from, to]) = self.seen(p)?;
        if over.0 >= rim {
            return Some(over);
        }
        let (o, l) = (R::ZERO, R::one());
        let [head, tail] = [self.head - self.half - p.0[2], p.0[2] - self.half];
        let end = if head > tail { (head, V3([o, o, -l])) } else { (tail, V3([o, o, l])) };
        let [inner, outer] = [from - foot, to - foot].map(|way| (way.norm(), way));
        let (far, way) = if inner.0 < outer.0 { inner } else { outer };
        let [x, y] = (way * (l / far.larger(R::of(NOTHING)))).0;
        let over = both(over, (end.0 + rim, end.1));
        Some(both(over, (rim - far, V3([x, y, o]))))
    }

    /// Distance and direction; the foot, and where the row ends.
    fn seen(&self, p: V3<R>) -> Option<((R, V3<R>), [V2<R>; 3])> {
        if self.side == R::ZERO || p.0[2].magnitude() > self.half || p.0[2] < self.head - self.half
        {
            return None;
        }
        let rows = R::of((G::NZ - 1) as f64);
        let at = ((self.half - p.0[2]) * rows / (self.half + self.half)).wide();
        let k = (at as usize).min(G::NZ - 2);
        let t = R::of(at) - R::of(k as f64);
        let row = |i: usize| {
            let (a, b) = (self.nodes.at(i, k).xy(), self.nodes.at(i, k + 1).xy());
            a + (b - a) * t
        };
        let edges = (1..G::NX).map(|i| Edge::between(row(i - 1), row(i)));
        let foot = foot(edges, p.xy()).filter(|f| !f.outside)?;
        let d = foot.distance * self.side;
        if d < -R::of(DEEPEST) {
            return None;
        }
        let lean = |i: usize| self.nodes.at(i, k).xy() - self.nodes.at(i, k + 1).xy();
        let (a, b) = (lean(foot.edge), lean((foot.edge + 1).min(G::NX - 1)));
        let slope = (a + (b - a) * foot.share) * (rows / (self.half + self.half));
        let n = foot.normal * self.side;
        let g = V3([n.0[0], n.0[1], -n.dot(slope)]);
        let steep = R::one() / g.norm();
        let to = row(foot.edge) + (row((foot.edge + 1).min(G::NX - 1)) - row(foot.edge)) * foot.share;
        Some(((d * steep, g * steep), [to, row(0), row(G::NX - 1)]))
    }
}
