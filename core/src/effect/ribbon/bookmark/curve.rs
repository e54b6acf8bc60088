//! How far a point of a plane is from a line of straight edges, and on which side.

use crate::real::{Real, V2};

/// An edge shorter than this has no direction.
const NOTHING: f64 = 1e-9;

/// A straight edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge<R> {
    /// Where it begins.
    pub from: V2<R>,
    /// To where it ends.
    pub way: V2<R>,
    /// One over its squared length; nothing for one without a direction.
    pub inverse: R,
}

impl<R: Real> Edge<R> {
    /// Nothing.
    pub const NONE: Self = Self { from: V2([R::ZERO; 2]), way: V2([R::ZERO; 2]), inverse: R::ZERO };

    /// Between two points.
    #[inline(always)]
    pub fn between(from: V2<R>, to: V2<R>) -> Self {
        let way = to - from;
        let sq = way.norm_sq();
        let inverse = if sq > R::of(NOTHING * NOTHING) { R::one() / sq } else { R::ZERO };
        Self { from, way, inverse }
    }
}

/// The foot of a point on a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Foot<R> {
    /// Signed distance: positive to the left of the way the line goes.
    pub distance: R,
    /// Unit direction in which it grows.
    pub normal: V2<R>,
    /// The edge, and the share of it before the foot.
    pub edge: usize,
    /// See `edge`.
    pub share: R,
    /// The point lies before the line's start or behind its end.
    pub outside: bool,
}

/// What is known of the nearest edge so far.
#[derive(Clone, Copy)]
struct Best<R> {
    sq: R,
    /// How squarely the edge is seen.
    square: R,
    away: V2<R>,
    edge: Edge<R>,
    n: usize,
    t: R,
}

/// The nearest foot; `None` where the line has no edges.
///
/// # Cost
///
/// A dozen operations an edge, one root.
///
/// # Hard case
///
/// At a corner both edges are equally near: the one that the point is seen from more squarely decides on the side.
pub fn foot<R: Real>(edges: impl Iterator<Item = Edge<R>>, p: V2<R>) -> Option<Foot<R>> {
    let mut best: Option<Best<R>> = None;
    let (mut first, mut last) = (usize::MAX, 0);
    for (n, edge) in edges.enumerate().filter(|(_, e)| e.inverse > R::ZERO) {
        (first, last) = (first.min(n), n);
        let v = p - edge.from;
        let t = v.dot(edge.way) * edge.inverse;
        let away = v - edge.way * t.larger(R::ZERO).smaller(R::one());
        let sq = away.norm_sq();
        if best.as_ref().is_some_and(|b| sq > b.sq * R::of(1.0 + 8.0 * R::EPSILON)) {
            continue;
        }
        let cross = away.dot(edge.way.left());
        let square = cross * cross * edge.inverse;
        let nearer = best
            .as_ref()
            .is_none_or(|b| sq < b.sq * R::of(1.0 - 8.0 * R::EPSILON) || square > b.square);
        if nearer {
            best = Some(Best { sq, square, away, edge, n, t });
        }
    }
    let b = best?;
    let (d, normal) = (b.sq.root(), b.edge.way.left());
    let side = if b.away.dot(normal) < R::ZERO { -R::one() } else { R::one() };
    let normal =
        if d > R::of(NOTHING) { b.away * (side / d) } else { normal * b.edge.inverse.root() };
    let outside = (b.t < R::ZERO && b.n == first) || (b.t > R::one() && b.n == last);
    let share = b.t.larger(R::ZERO).smaller(R::one());
    Some(Foot { distance: d * side, normal, edge: b.n, share, outside })
}
