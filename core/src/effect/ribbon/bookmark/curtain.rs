//! The leaf in the air as a curtain: how far is a point from it, and what is solid behind it.

use super::curve::{Edge, foot};
use super::ground::ROUNDED;
use super::solid::both;
use crate::grid::Grid;
use crate::real::{Real, V2, V3};
use crate::state::Field;

/// Deeper than this behind a curtain is not behind it, metres: it was gone around.
const DEEPEST: f64 = 0.04;
/// Shorter than this has no direction, metres.
const NOTHING: f64 = 1e-9;

/// The leaf in the air, metres, and on which of its sides the ribbon is.
#[derive(Debug, Clone)]
pub struct Curtain<R: Real, G: Grid> {
    nodes: Field<R, G>,
    /// One if the ribbon is on the side of the left page; nothing if there is no leaf.
    side: R,
    /// From its middle to head and tail.
    half: R,
    /// Nearer than this to the head it gives way: the leaf's foot closes over the ribbon there.
    head: R,
    /// It reaches so far beyond its edges, and that as a share of its outermost edge.
    rounded: R,
    beyond: R,
    /// The cosine of its steepest lean against the binding.
    lean: R,
}

/// What a point sees of a curtain.
struct Seen<R> {
    /// Distance and direction.
    over: (R, V3<R>),
    foot: V2<R>,
    /// Where its row begins and ends.
    ends: [V2<R>; 2],
}

impl<R: Real, G: Grid> Curtain<R, G> {
    /// None.
    pub const NONE: Self = Self {
        nodes: Field::ZERO,
        side: R::ZERO,
        half: R::ZERO,
        head: R::ZERO,
        rounded: R::ZERO,
        beyond: R::ZERO,
        lean: R::ZERO,
    };

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
        let last = (self.nodes.at(G::NX - 1, 0) - self.nodes.at(G::NX - 2, 0)).norm();
        self.rounded = R::of(ROUNDED);
        self.beyond = self.rounded / last.larger(self.rounded);
        let mut steepest = R::ZERO;
        for (i, k) in Field::<R, G>::nodes().filter(|&(_, k)| k > 0) {
            steepest = steepest.larger(self.slope(i, k - 1).norm_sq());
        }
        self.lean = R::one() / (R::one() + steepest).root();
    }

    /// Rows between head and tail, for each metre.
    fn rows(&self) -> R {
        R::of((G::NZ - 1) as f64) / (self.half + self.half)
    }

    /// How a column leans behind a row.
    fn slope(&self, i: usize, k: usize) -> V2<R> {
        (self.nodes.at(i, k).xy() - self.nodes.at(i, k + 1).xy()) * self.rows()
    }

    /// The row at a level: the one before it, and its points by column, the last a little beyond the leaf's edge.
    fn row(&self, z: R) -> (usize, impl Fn(usize) -> V2<R>) {
        let at = ((self.half - z) * self.rows()).wide();
        let k = (at as usize).min(G::NZ - 2);
        let t = R::of(at) - R::of(k as f64);
        let place = move |i: usize| {
            let (a, b) = (self.nodes.at(i, k).xy(), self.nodes.at(i, k + 1).xy());
            a + (b - a) * t
        };
        let last = place(G::NX - 1) + (place(G::NX - 1) - place(G::NX - 2)) * self.beyond;
        (k, move |i| if i + 1 < G::NX { place(i) } else { last })
    }

    /// There is a leaf at that level, or so little beyond it as it is rounded.
    fn spans(&self, z: R) -> bool {
        self.side != R::ZERO && z.magnitude() <= self.half + self.rounded
    }

    /// Signed distance to it at its level along the binding, and the gradient's direction; `None` where there is no leaf.
    ///
    /// # Accuracy
    ///
    /// Rows are taken to stand at their rest places along the binding: exact for a leaf that is bent about the spine.
    pub fn above(&self, p: V3<R>) -> Option<(R, V3<R>)> {
        let z = p.0[2];
        let there = z <= self.half && z >= self.head - self.half;
        let seen = self.seen(p).filter(|_| there)?;
        let [_, end] = seen.ends;
        ((end - seen.foot).norm_sq() > self.rounded * self.rounded).then_some(seen.over)
    }

    /// The same of a solid behind it, whose faces lie `rim` inside its rounded edges: who is deep behind it comes out at
    /// the nearest face, and nowhere does a small step make a large difference. At the head it is chamfered.
    pub fn solid(&self, p: V3<R>, rim: R) -> Option<(R, V3<R>)> {
        let Seen { over, foot, ends } = self.seen(p)?;
        if over.0 >= rim {
            return Some(over);
        }
        let (o, l, z) = (R::ZERO, R::one(), p.0[2]);
        let corner = R::of(core::f64::consts::FRAC_1_SQRT_2);
        let back = self.head - self.half - z;
        let chamfer = ((over.0 + back) * corner, (over.1 - V3([o, o, l])) * corner);
        let over = if chamfer.0 > over.0 { chamfer } else { over };
        let side = if z < o { -l } else { l };
        let over = both(over, (z * side - self.half - self.rounded + rim, V3([o, o, side])));
        let [inner, outer] = ends.map(|end| (end - foot, (end - foot).norm()));
        let (way, far) = if inner.1 < outer.1 { inner } else { outer };
        let [x, y] = (way * (l / far.larger(R::of(NOTHING)))).0;
        Some(both(over, (rim - far, V3([x, y, o]))))
    }

    /// No more than how far it is to that solid: a ribbon's vertex needs no other look at it before it has gone so far.
    pub fn away(&self, p: V3<R>) -> R {
        let z = p.0[2];
        if self.side == R::ZERO {
            return R::of(f64::INFINITY);
        }
        if !self.spans(z) {
            return z.magnitude() - self.half - self.rounded;
        }
        let (_, row) = self.row(z);
        let found = foot(edges::<R, G>(&row), p.xy());
        let d = found.map_or(R::ZERO, |f| f.distance * self.side);
        let behind = if d < R::ZERO { -d - R::of(DEEPEST) } else { d };
        behind.larger(R::ZERO) * self.lean
    }

    fn seen(&self, p: V3<R>) -> Option<Seen<R>> {
        if !self.spans(p.0[2]) {
            return None;
        }
        let (k, row) = self.row(p.0[2]);
        let found = foot(edges::<R, G>(&row), p.xy()).filter(|f| !f.outside)?;
        let d = found.distance * self.side;
        if d < -R::of(DEEPEST) {
            return None;
        }
        let i = found.edge.min(G::NX - 2);
        let (a, b) = (self.slope(i, k), self.slope(i + 1, k));
        let n = found.normal * self.side;
        let g = V3([n.0[0], n.0[1], -n.dot(a + (b - a) * found.share)]);
        let steep = R::one() / g.norm();
        let foot = row(i) + (row(i + 1) - row(i)) * found.share;
        Some(Seen { over: (d * steep, g * steep), foot, ends: [row(0), row(G::NX - 1)] })
    }
}

fn edges<R: Real, G: Grid>(row: impl Fn(usize) -> V2<R>) -> impl Iterator<Item = Edge<R>> {
    let mut before = row(0);
    (1..G::NX).map(move |i| {
        let from = core::mem::replace(&mut before, row(i));
        Edge::between(from, before)
    })
}
