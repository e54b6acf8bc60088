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
    /// Which of the pushed corners each is.
    places: [u16; MOST],
    count: usize,
    /// Corners pushed, dropped ones included.
    pushed: usize,
    /// Direction to go on in where there are too few corners.
    onward: V3<f32>,
}

impl Polyline {
    pub(super) fn new() -> Self {
        let nothing = Knot { p: V3([0.0; 3]), n: V3([0.0; 3]) };
        Self {
            knots: [nothing; MOST],
            places: [0; MOST],
            count: 0,
            pushed: 0,
            onward: V3([1.0, 0.0, 0.0]),
        }
    }

    pub(super) fn clear(&mut self) {
        self.count = 0;
        self.pushed = 0;
    }

    /// Adds a corner unless it lies behind the last one, seen along `forward`, or ahead by less than the
    /// share `least` of `forward`: on the hollow side of a sharp bend a thick offset stops or runs back.
    pub(super) fn push(&mut self, knot: Knot, forward: V3<f32>, least: f32) {
        let place = self.pushed;
        self.pushed += 1;
        let last = self.count.checked_sub(1).and_then(|n| self.knots.get(n));
        let least = least * forward.norm_sq();
        if last.is_some_and(|last| (knot.p - last.p).dot(forward) <= least) {
            return;
        }
        if let (Some(slot), Some(mark)) =
            (self.knots.get_mut(self.count), self.places.get_mut(self.count))
        {
            *slot = knot;
            *mark = place as u16;
            self.count += 1;
            self.onward = forward;
        }
    }

    fn corners(&self) -> impl Iterator<Item = (V3<f32>, usize)> + Clone {
        let places = self.places.iter().map(|&n| usize::from(n));
        self.knots.iter().map(|k| k.p).zip(places).take(self.count)
    }

    /// The way from corner to corner as pushed, where those dropped share what lies between their
    /// neighbours; `tail` for those dropped at the end.
    fn ways(&self, tail: f32) -> impl Iterator<Item = f32> + Clone {
        let last = self.corners().last().map_or(0, |(_, n)| n);
        let pairs = self.corners().zip(self.corners().skip(1));
        let inner = pairs.flat_map(|((a, m), (b, n))| {
            core::iter::repeat_n((b - a).norm() / (n - m).max(1) as f32, n - m)
        });
        inner.chain(core::iter::repeat_n(tail, self.pushed.saturating_sub(last + 1)))
    }

    /// The vertices of a row that has a corner for each: they stay near their corners, moved along the
    /// row by a share that grows with the distance from the spine.
    pub(super) fn fitted(&self, tail: f32) -> impl Iterator<Item = (f32, Knot)> {
        let length = self.ways(tail).fold(0.0, |sum, way| sum + way);
        let scale = WIDTH as f32 / length.larger(1e-6);
        let steps = core::iter::once(0.0).chain(self.ways(tail).map(move |way| way * scale));
        self.pace(self.pushed.saturating_sub(1), steps)
    }

    /// The vertices of a row at given steps: share of the width at each, and the place.
    ///
    /// The straight distances between them add up to the width of a page, whatever the polyline's length.
    pub(super) fn pace(
        &self,
        columns: usize,
        steps: impl Iterator<Item = f32>,
    ) -> impl Iterator<Item = (f32, Knot)> {
        let knots = self.knots.get(..self.count).unwrap_or_default();
        let nothing = Knot { p: V3([0.0; 3]), n: V3([0.0; 3]) };
        let here = knots.first().copied().unwrap_or(nothing);
        let mut walk = Walk { knots, here, onward: self.onward };
        let mut gone = 0.0;
        steps.enumerate().map(move |(n, step)| {
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
        while let [_, next, ..] = self.knots {
            let away = next.p - self.here.p;
            let length = away.norm();
            if left <= length {
                let share = left / length.larger(1e-9);
                let n = self.here.n + (next.n - self.here.n) * share;
                self.here = Knot { p: self.here.p + away * share, n: unit(n, next.n) };
                return self.here;
            }
            left -= length;
            self.onward = unit(away, self.onward);
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
