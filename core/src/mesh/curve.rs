//! A polyline walked in steps of given length, so that what is drawn has the length paper has.
//!
//! Every step is measured straight from vertex to vertex, as the drawn edge is. Where the polyline ends
//! too early its last segment goes on; where it is too long the rest is left out. Source: Book Sec. 3.5,
//! "Segment length adaptation", which moves only the last vertex; the same where little has to be moved,
//! but a stretch longer than the last segment does not turn it round.

use super::columns;
use crate::real::{Num, V3};

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

    /// A walk from the first corner.
    pub(super) fn walk(&self) -> Walk<'_> {
        let knots = self.knots.get(..self.count).unwrap_or_default();
        let here = knots.first().copied().unwrap_or(Knot { p: V3([0.0; 3]), n: V3([0.0; 3]) });
        Walk { knots, here, onward: self.onward }
    }
}

/// Where a walk has come.
#[derive(Debug)]
pub(super) struct Walk<'a> {
    /// The corners from the last one passed on.
    knots: &'a [Knot],
    here: Knot,
    onward: V3<f32>,
}

impl Walk<'_> {
    /// Goes on to the first point of the polyline `step` away from here.
    pub(super) fn step(&mut self, step: f32) -> Knot {
        if step <= 0.0 {
            return self.here;
        }
        while let [_, next, _, ..] = self.knots {
            if (next.p - self.here.p).norm_sq() >= step * step {
                break;
            }
            self.knots = self.knots.get(1..).unwrap_or_default();
        }
        let (from, to) = match self.knots {
            [from, to, ..] => (*from, *to),
            _ => (self.here, Knot { p: self.here.p + self.onward, n: self.here.n }),
        };
        self.here = leave(self.here.p, step, from, to);
        self.here
    }
}

/// Where the ray from `from` through `to` leaves the ball of radius `step` around `centre`.
fn leave(centre: V3<f32>, step: f32, from: Knot, to: Knot) -> Knot {
    let (a, e) = (from.p - centre, to.p - from.p);
    let (ee, ae) = (e.norm_sq().larger(1e-20), a.dot(e));
    let inside = ae * ae - ee * (a.norm_sq() - step * step);
    let t = (inside.larger(0.0).root() - ae) / ee;
    let share = t.larger(0.0).smaller(1.0);
    Knot { p: from.p + e * t, n: unit(from.n * (1.0 - share) + to.n * share, from.n) }
}

/// Unit length, or `otherwise` where there is none.
#[inline(always)]
pub(super) fn unit(v: V3<f32>, otherwise: V3<f32>) -> V3<f32> {
    let sq = v.norm_sq();
    if sq > 1e-16 { v * (1.0 / sq.root()) } else { otherwise }
}
