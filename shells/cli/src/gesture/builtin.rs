//! The gestures every reader makes.

use super::path::{Desk, Stroke, ease, over};
use dogleaf_core::hand::{Phase, Sample};

/// Where a finger takes a leaf's tail corner, and where it lays it down.
const CORNER: ([f64; 2], [f64; 2]) = ([0.93, 0.86], [-0.90, 0.78]);
/// The middle of the fore-edge, a little below.
const EDGE: ([f64; 2], [f64; 2]) = ([0.94, 0.25], [-0.92, 0.25]);
/// How far a finger rises on the screen at the spine, in widths.
const LIFT: f64 = 0.35;

const START_US: u64 = 100_000;

fn stroke(time_us: u64) -> Stroke {
    Stroke { start_us: START_US, time_us, leaves: 0, end: Phase::Up }
}

/// The tail corner carried over the spine in 1.2 seconds: what `dogleaf turn` does.
pub(crate) fn corner_turn(desk: &Desk) -> Vec<Sample> {
    stroke(1_200_000).along(desk, |t| over(CORNER.0, CORNER.1, LIFT, ease(t)))
}

/// The fore-edge carried over in two seconds.
pub(crate) fn slow_turn(desk: &Desk) -> Vec<Sample> {
    stroke(2_000_000).along(desk, |t| over(EDGE.0, EDGE.1, LIFT, ease(t)))
}

/// A seventh of a second, let go at full speed well before the spine.
pub(crate) fn flick(desk: &Desk) -> Vec<Sample> {
    stroke(140_000).along(desk, |t| over(EDGE.0, [0.15, 0.15], 0.1, t * t))
}

/// Lifted to look beneath, held, and put back.
pub(crate) fn peek_and_put_back(desk: &Desk) -> Vec<Sample> {
    stroke(2_400_000).along(desk, |t| {
        let there = ease((t / 0.35).min(1.0)) * ease(((1.0 - t) / 0.40).min(1.0));
        over(CORNER.0, [0.30, 0.70], LIFT, there)
    })
}

/// Five leaves at once, in a second and a half.
pub(crate) fn stack(desk: &Desk) -> Vec<Sample> {
    let stroke = Stroke { leaves: 5, ..stroke(1_500_000) };
    stroke.along(desk, |t| over(EDGE.0, EDGE.1, LIFT, ease(t)))
}

/// The end of a bookmark that hangs out at the tail, carried over the page and out beyond its fore-edge.
pub(crate) fn pull_bookmark(desk: &Desk) -> Vec<Sample> {
    stroke(1_800_000).along(desk, |t| {
        let t = ease(t);
        [1.3 * t, 1.04 - 0.8 * t, 0.12 * (4.0 * t * (1.0 - t)).min(1.0)]
    })
}
