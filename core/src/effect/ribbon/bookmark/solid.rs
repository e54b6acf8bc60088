//! What of the book lies still and is solid to a ribbon: blocks and boards as prisms.

use super::curve::{Edge, Foot, foot};
use crate::collision::profile::FAN;
use crate::real::{Real, V2, V3};
use crate::state::strip::BLOCK;

/// Corners of a prism's outline: the way up to its start, the fan, the edges, and the way down at its end.
const CORNERS: usize = FAN + BLOCK + 2;
/// Further than anything of a book, metres.
pub(super) const FAR: f64 = 1e3;
/// A prism goes down so far at both its ends, metres.
const DOWN: f64 = 1.0;
/// What is further than this from a body is told no more exactly than that, metres.
const NEAR: f64 = 2e-3;

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

    /// Below these corners; before the first and behind the last it goes straight down.
    pub fn new(corners: impl IntoIterator<Item = V2<R>>, sign: f64, half: R) -> Self {
        let (mut last, down) = (V2::zero(), V2([R::ZERO, R::of(DOWN)]));
        let mut points = [None; CORNERS];
        let [start, places @ ..] = &mut points;
        for (place, p) in places.iter_mut().take(CORNERS - 2).zip(corners) {
            *start = start.or(Some(p - down));
            (*place, last) = (Some(p), p);
        }
        let end = last - down;
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
        there.then(|| foot(self.edges.iter().copied(), outward)).flatten()
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

    /// How far a point lies within head, tail and its outer end; negative beyond.
    pub fn within(&self, p: V3<R>) -> R {
        (self.half - p.0[2].magnitude()).smaller(self.outer - p.0[0] * self.sign)
    }
}

/// Distance to what two solids that meet squarely have in common, from the distances to them.
pub(super) fn both<R: Real>((d, n): (R, V3<R>), (e, m): (R, V3<R>)) -> (R, V3<R>) {
    if d > R::ZERO && e > R::ZERO {
        let far = (d * d + e * e).root();
        return (far, (n * d + m * e) * (R::one() / far));
    }
    if d > e { (d, n) } else { (e, m) }
}
