//! A polyline walked in steps of given length, so that what is drawn has the length paper has.
//!
//! Where the polyline ends too early its last segment goes on; where it is too long the rest is left
//! out. The little by which chords are shorter than the way along is given to the last segment. Source:
//! Book Sec. 3.5, "Segment length adaptation", which moves only the last vertex; the same where little
//! has to be moved, but a stretch longer than the last segment does not turn it round.

use super::columns;
use crate::real::{Eight, Lanes, Num, Real, V3};
use crate::scene::units::WIDTH;

/// Corners of a polyline at most: those of the longest row, or of a block's curve.
const MOST: usize = columns::MOST;

/// A corner with its normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Knot {
    pub(super) p: V3<f32>,
    pub(super) n: V3<f32>,
}

/// A corner of a polyline and the segment that leads to it.
#[derive(Debug, Clone, Copy)]
struct Corner {
    knot: Knot,
    /// Length of the segment.
    length: f32,
    /// Corners offered since the one before, this one included.
    offered: usize,
}

/// A polyline that only goes forward.
#[derive(Debug)]
pub(super) struct Polyline {
    corners: [Corner; MOST],
    count: usize,
    /// Corners dropped after the last one kept.
    dropped: usize,
}

impl Polyline {
    pub(super) fn new() -> Self {
        let knot = Knot { p: V3([0.0; 3]), n: V3([0.0; 3]) };
        let corner = Corner { knot, length: 0.0, offered: 1 };
        Self { corners: [corner; MOST], count: 0, dropped: 0 }
    }

    pub(super) fn clear(&mut self) {
        self.count = 0;
        self.dropped = 0;
    }

    fn corners(&self) -> &[Corner] {
        self.corners.get(..self.count).unwrap_or_default()
    }

    /// Adds a corner unless it lies behind the last one, seen along `forward`, or ahead by less than the
    /// share `least` of `forward`: on the hollow side of a sharp bend a thick offset stops or runs back.
    pub(super) fn push(&mut self, knot: Knot, forward: V3<f32>, least: f32) {
        let mut length = 0.0;
        if let Some(last) = self.corners().last() {
            let way = knot.p - last.knot.p;
            if way.dot(forward) <= least * forward.norm_sq() {
                self.dropped += 1;
                return;
            }
            length = norm(way);
        }
        let corner = Corner { knot, length, offered: self.dropped + 1 };
        if let Some(slot) = self.corners.get_mut(self.count) {
            *slot = corner;
            self.count += 1;
            self.dropped = 0;
        }
    }

    /// The vertices of a row that was offered a corner for each: they stay near their corners, moved along
    /// the row by a share that grows with the distance from the spine. Corners dropped on the way share
    /// what lies between their neighbours; those at the end get `tail` each.
    pub(super) fn fitted(&self, tail: f32) -> impl Iterator<Item = (f32, Knot)> {
        let inner = self.corners().iter().skip(1);
        let (length, columns) = inner
            .fold((tail * self.dropped as f32, self.dropped), |(length, columns), c| {
                (length + c.length, columns + c.offered)
            });
        let scale = WIDTH as f32 / length.larger(1e-6);
        let steps = Steps {
            corners: self.corners().get(1..).unwrap_or_default(),
            left: 0,
            step: 0.0,
            tail: tail * scale,
            scale,
        };
        self.pace(columns, core::iter::once(0.0).chain(steps.take(columns)))
    }

    /// The vertices of a row at given steps: share of the width at each, and the place; the normal is not
    /// of unit length.
    ///
    /// The straight distances between them add up to the width of a page, whatever the polyline's length.
    pub(super) fn pace(
        &self,
        columns: usize,
        steps: impl Iterator<Item = f32>,
    ) -> impl Iterator<Item = (f32, Knot)> {
        let mut walk = Walk { corners: self.corners(), gone: 0.0 };
        let mut sum = 0.0;
        let mut from = walk.step(0.0).p;
        steps.enumerate().map(move |(n, step)| {
            let mut to = walk.step(step);
            let chord = norm(to.p - from);
            if n == columns {
                let rest = WIDTH as f32 - sum;
                to.p = from + (to.p - from) * (rest / chord.larger(1e-9));
                sum = WIDTH as f32;
            } else {
                sum += chord;
            }
            from = to.p;
            (sum / WIDTH as f32, to)
        })
    }
}

/// Steps from corner to corner as offered.
#[derive(Debug)]
struct Steps<'a> {
    corners: &'a [Corner],
    /// Steps to go to the next corner.
    left: usize,
    step: f32,
    tail: f32,
    scale: f32,
}

impl Iterator for Steps<'_> {
    type Item = f32;

    fn next(&mut self) -> Option<f32> {
        if self.left == 0 {
            let Some((corner, rest)) = self.corners.split_first() else { return Some(self.tail) };
            self.corners = rest;
            self.left = corner.offered;
            self.step = corner.length * self.scale;
            if corner.offered > 1 {
                self.step /= corner.offered as f32;
            }
        }
        self.left -= 1;
        Some(self.step)
    }
}

/// Where a walk has come.
#[derive(Debug)]
struct Walk<'a> {
    /// The corners from the last one passed on.
    corners: &'a [Corner],
    /// How far beyond it.
    gone: f32,
}

impl Walk<'_> {
    /// Goes on by `step`, measured along the polyline; straight on beyond its end.
    fn step(&mut self, step: f32) -> Knot {
        self.gone += step;
        while let [_, next, rest @ ..] = self.corners {
            if self.gone <= next.length || rest.is_empty() {
                break;
            }
            self.gone -= next.length;
            self.corners = self.corners.get(1..).unwrap_or_default();
        }
        match self.corners {
            [from, to, ..] => {
                let (from, length) = (from.knot, to.length.larger(1e-12));
                let t = self.gone / length;
                let n = from.n + (to.knot.n - from.n) * t.smaller(1.0);
                Knot { p: from.p + (to.knot.p - from.p) * t, n }
            }
            [only] => Knot { p: only.knot.p + V3([self.gone, 0.0, 0.0]), n: only.knot.n },
            [] => Knot { p: V3([self.gone, 0.0, 0.0]), n: V3([0.0; 3]) },
        }
    }
}

/// Square root, correctly rounded: by the vector unit where there is one, as in [`Lanes`].
#[inline(always)]
fn root(x: f32) -> f32 {
    if cfg!(any(target_feature = "sse2", target_feature = "neon", target_feature = "simd128")) {
        let eight = <<f32 as Real>::Eight as Lanes<f32>>::all(x);
        let [first, ..] = Eight::array(Num::root(eight));
        first
    } else {
        x.root()
    }
}

/// Length.
#[inline(always)]
pub(super) fn norm(v: V3<f32>) -> f32 {
    root(v.norm_sq())
}

/// Unit length, or `otherwise` where there is none.
#[inline(always)]
pub(super) fn unit(v: V3<f32>, otherwise: V3<f32>) -> V3<f32> {
    let sq = v.norm_sq();
    if sq > 1e-16 { v * (1.0 / root(sq)) } else { otherwise }
}
