//! The outline of one page block as the leaf meets it.
//!
//! A block's midline is its underside. Its top is the curve at distance `thickness` above it: a fan of
//! directions around the end of the binding, from towards the other side to the first edge's normal,
//! then the edges shifted along their normals. Outward coordinates, as [`Strip`].

use crate::real::{Real, V2};
use crate::state::strip::{BLOCK, Strip};

/// Corrections of a chord's length when a leaf is laid.
const CORRECTIONS: u32 = 12;
/// Steps the fan is drawn in.
pub const FAN: usize = 6;

/// One edge of a midline, ready for distance tests.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment<R> {
    /// Inner end.
    pub from: V2<R>,
    /// Unit direction outwards.
    pub along: V2<R>,
    /// Unit normal, upwards.
    pub normal: V2<R>,
    /// Length.
    pub length: R,
}

/// A block's midline with its normals and the thickness above it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profile<R> {
    /// Edges from the binding outwards.
    pub segments: [Segment<R>; BLOCK - 1],
    /// Thickness of the block.
    pub thickness: R,
}

impl<R: Real> Profile<R> {
    /// The outline of a block.
    pub fn new(block: &Strip<R, BLOCK>, thickness: R) -> Self {
        let mut segments =
            [Segment { from: V2::zero(), along: V2::zero(), normal: V2::zero(), length: R::ZERO };
                6];
        for (s, [from, to]) in segments.iter_mut().zip(block.x.array_windows::<2>()) {
            let e = *to - *from;
            let length = e.norm().larger(R::of(1e-6));
            let along = e * (R::of(1.0) / length);
            *s = Segment { from: *from, along, normal: along.left(), length };
        }
        Self { segments, thickness }
    }

    /// Height of the midline's highest point.
    pub fn top(&self) -> R {
        self.segments.iter().fold(R::ZERO, |top, s| {
            let end = s.from + s.along * s.length;
            top.larger(s.from.0[1]).larger(end.0[1])
        })
    }

    /// Where the top, `above` the midline, begins at the binding.
    pub fn root(&self, above: R) -> V2<R> {
        self.segments[0].from - V2([above, R::ZERO])
    }

    /// Corner points of the curve `above` the midline: the fan, then one a node.
    pub fn outline(&self, above: R) -> [V2<R>; FAN + BLOCK] {
        let mut points = [V2::zero(); FAN + BLOCK];
        let pivot = self.segments[0].from;
        let first = self.segments[0].normal;
        for (n, p) in points.iter_mut().enumerate().take(FAN + 1) {
            *p = pivot + fan(first, R::of(n as f64 / FAN as f64)) * above;
        }
        for (p, [a, b]) in points.iter_mut().skip(FAN + 1).zip(self.segments.array_windows::<2>()) {
            *p = b.from + mitre(a.normal, b.normal) * above;
        }
        if let (Some(last), Some(s)) = (points.last_mut(), self.segments.last()) {
            *last = s.from + s.along * s.length + s.normal * above;
        }
        points
    }

    /// The point at distance `s` along the curve `above` the midline; straight on beyond its end.
    pub fn surface(&self, above: R, s: R) -> V2<R> {
        walk(&self.outline(above), s)
    }
}

/// Direction at share `t` of the fan from `(-1, 0)` to `to`: the chord, normalised. Spreads a quarter
/// turn evenly enough for drawing and needs no trigonometry.
pub fn fan<R: Real>(to: V2<R>, t: R) -> V2<R> {
    let from = V2([-R::of(1.0), R::ZERO]);
    let d = from * (R::of(1.0) - t) + to * t;
    let length = d.norm();
    if length > R::of(1e-3) { d * (R::of(1.0) / length) } else { V2([R::ZERO, R::of(1.0)]) }
}

/// The direction between two unit normals, long enough to keep the distance to both edges.
fn mitre<R: Real>(a: V2<R>, b: V2<R>) -> V2<R> {
    let sum = a + b;
    let scale = R::of(2.0) / sum.norm_sq().larger(R::of(1.0));
    sum * scale
}

/// Places `count` steps of length `step` along a polyline, chord by chord: each is exactly `step` from the last.
///
/// Paper laid over a rounded gutter spans it by straight edges; measured along the curve they would start compressed.
pub fn stride<R: Real, const N: usize>(
    points: &[V2<R>; N],
    step: R,
) -> impl Iterator<Item = V2<R>> + '_ {
    let start = points.first().copied().unwrap_or(V2::zero());
    let mut at = (start, R::ZERO);
    core::iter::once(start).chain(core::iter::repeat_with(move || {
        let mut s = at.1 + step;
        let mut next = walk(points, s);
        for _ in 0..CORRECTIONS {
            s += step - (next - at.0).norm();
            next = walk(points, s);
        }
        at = (next, s);
        next
    }))
}

/// The point at distance `s` along a polyline; straight on beyond its end.
pub fn walk<R: Real>(points: &[V2<R>], s: R) -> V2<R> {
    let mut left = s;
    let mut end = (V2::zero(), V2::zero());
    for pair in points.windows(2) {
        let [a, b] = pair else { continue };
        let e = *b - *a;
        let length = e.norm();
        if length <= R::of(1e-9) {
            continue;
        }
        if left <= length {
            return *a + e * (left / length);
        }
        left -= length;
        end = (*b, e * (R::of(1.0) / length));
    }
    end.0 + end.1 * left
}
