//! A polyline walked in steps of given length, so that what is drawn has the length paper has.
//!
//! Where the polyline ends too early its last segment goes on; where it is too long the rest is left
//! out. The little by which chords are shorter than the way along is given to the last segment. Source:
//! Book Sec. 3.5, "Segment length adaptation", which moves only the last vertex; the same where little
//! has to be moved, but a stretch longer than the last segment does not turn it round.

use super::columns;
use crate::real::{Num, V3};
use crate::scene::units::WIDTH;

/// Corners of a polyline at most: those of the longest row, or of a block's curve.
const MOST: usize = columns::MOST;

/// A corner with its normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Knot {
    pub(super) p: V3<f32>,
    pub(super) n: V3<f32>,
}

/// A polyline that only goes forward.
#[derive(Debug)]
pub(super) struct Polyline {
    knots: [Knot; MOST],
    count: usize,
    /// Direction to go on in where there are too few corners.
    onward: V3<f32>,
}

impl Polyline {
    pub(super) fn new() -> Self {
        let nothing = Knot { p: V3([0.0; 3]), n: V3([0.0; 3]) };
        Self { knots: [nothing; MOST], count: 0, onward: V3([1.0, 0.0, 0.0]) }
    }

    pub(super) fn clear(&mut self) {
        self.count = 0;
    }

    /// Adds a corner unless it lies behind the last one, seen along `forward`: on the hollow side of a
    /// sharp bend a thick offset runs back for a while.
    pub(super) fn push(&mut self, knot: Knot, forward: V3<f32>) {
        let last = self.count.checked_sub(1).and_then(|n| self.knots.get(n));
        if last.is_some_and(|last| (knot.p - last.p).dot(forward) <= 0.0) {
            return;
        }
        if let Some(slot) = self.knots.get_mut(self.count) {
            *slot = knot;
            self.count += 1;
            self.onward = forward;
        }
    }

    /// The vertices of a row: share of the width at each, and the corner.
    ///
    /// The straight distances between them add up to the width of a page, whatever the polyline's length.
    pub(super) fn pace(&self, columns: usize) -> impl Iterator<Item = (f32, Knot)> {
        let knots = self.knots.get(..self.count).unwrap_or_default();
        let nothing = Knot { p: V3([0.0; 3]), n: V3([0.0; 3]) };
        let here = knots.first().copied().unwrap_or(nothing);
        let mut walk = Walk { knots, here, onward: self.onward };
        let mut gone = 0.0;
        columns::steps(columns).enumerate().map(move |(n, step)| {
            let from = walk.here;
            let mut to = walk.step(step);
            let chord = (to.p - from.p).norm();
            if n == columns {
                let rest = WIDTH as f32 - gone;
                to.p = from.p + (to.p - from.p) * (rest / chord.larger(1e-9));
                gone = WIDTH as f32;
            } else {
                gone += chord;
            }
            (gone / WIDTH as f32, to)
        })
    }
}

/// Where a walk has come.
#[derive(Debug)]
struct Walk<'a> {
    /// The corners from the last one passed on.
    knots: &'a [Knot],
    here: Knot,
    onward: V3<f32>,
}

impl Walk<'_> {
    /// Goes on by `step`, measured along the polyline.
    fn step(&mut self, step: f32) -> Knot {
        let mut left = step;
        while let [_, next, rest @ ..] = self.knots {
            let away = next.p - self.here.p;
            let length = away.norm();
            if left <= length || rest.is_empty() {
                let share = left / length.larger(1e-9);
                let n = self.here.n + (next.n - self.here.n) * share.smaller(1.0);
                self.here = Knot { p: self.here.p + away * share, n: unit(n, next.n) };
                if length <= 0.0 {
                    self.here.p = self.here.p + self.onward * left;
                }
                return self.here;
            }
            left -= length;
            self.here = *next;
            self.knots = self.knots.get(1..).unwrap_or_default();
        }
        self.here.p = self.here.p + self.onward * left;
        self.here
    }
}

/// Unit length, or `otherwise` where there is none.
#[inline(always)]
pub(super) fn unit(v: V3<f32>, otherwise: V3<f32>) -> V3<f32> {
    let sq = v.norm_sq();
    if sq > 1e-16 { v * (1.0 / sq.root()) } else { otherwise }
}
