//! A turn nobody's finger makes: for a key, a button, a screen reader. It is made of samples like any other.

use super::step::Tape;
use super::{Reading, Refusal};
use crate::grid::Grid;
use crate::hand::{Phase, Sample};
use crate::real::{Real, V3};
use crate::scene::Direction;
use crate::scene::units::WIDTH;

/// The finger's number: no real one has it.
pub(super) const ID: u8 = 255;
/// How long it drags, microseconds, and in how many samples.
const DRAG_US: u64 = 320_000;
const SAMPLES: u64 = 40;
/// From where to where, in widths from the spine; how high on the way; how far down, in half heights.
const FROM: f64 = 0.93;
const TO: f64 = -0.75;
const LIFT: f64 = 0.30;
const DOWN: f64 = 0.35;

/// A turn under way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Auto {
    from_right: bool,
    leaves: u16,
    start_us: u64,
    /// Samples handed over so far.
    given: u64,
    last: (i32, i32),
}

impl<R: Real, G: Grid> Reading<R, G> {
    /// Turns leaves on, or back.
    ///
    /// # Errors
    ///
    /// [`Refusal::Busy`] while a leaf is in the air; [`Refusal::NoSuchPage`] at either end; [`Refusal::Paused`].
    pub fn turn(&mut self, forward: bool, leaves: u16) -> Result<(), Refusal> {
        if self.paused {
            return Err(Refusal::Paused);
        }
        if self.book.leaf().is_some() || self.auto.is_some() || self.down != 0 {
            return Err(Refusal::Busy);
        }
        let ltr = self.book.spec().direction == Direction::Ltr;
        let from_right = forward == ltr;
        let there = self.book.binding().leaves;
        if there.get(usize::from(from_right)).is_none_or(|&n| n == 0) {
            return Err(Refusal::NoSuchPage);
        }
        self.clock.forget();
        let start_us = self.book.now_us();
        let leaves = leaves.max(1);
        self.auto = Some(Auto { from_right, leaves, start_us, given: 0, last: (0, 0) });
        Ok(())
    }

    /// Hands over the samples that are due before the book's time is `until`.
    pub(super) fn lead(&mut self, until_us: u64, tape: &mut impl Tape) {
        let Some(mut auto) = self.auto else { return };
        for n in auto.given..=SAMPLES {
            let t_us = auto.start_us.saturating_add(n * DRAG_US / SAMPLES);
            if t_us > until_us {
                break;
            }
            let (x, y) = self.place(&auto, n);
            let phase = match n {
                0 => Phase::Down,
                SAMPLES => Phase::Up,
                _ => Phase::Move,
            };
            let leaves = if n == 0 { auto.leaves } else { 0 };
            let _ = self.feed(Sample { t_us, id: ID, phase, x, y, leaves }, tape);
            auto.given = n + 1;
            auto.last = (x, y);
        }
        self.auto = (auto.given <= SAMPLES).then_some(auto);
    }

    /// Where the finger is seen at sample `n`: over the spine, on a way that rises as the leaf does.
    fn place(&self, auto: &Auto, n: u64) -> (i32, i32) {
        let t = R::of(n as f64 / SAMPLES as f64);
        let out = R::of(FROM) + R::of(TO - FROM) * t;
        let sign = R::of(if auto.from_right { WIDTH } else { -WIDTH });
        let [left, right] = self.book.binding().thickness();
        let lift = R::of(LIFT * WIDTH) * (R::of(1.0) - out * out).larger(R::ZERO);
        let height = R::of(self.book.units().length(self.book.spec().height_m) * 0.5 * DOWN);
        let seen = self.book.camera().project(V3([sign * out, left.larger(right) + lift, height]));
        let [x, y] = seen.unwrap_or(self.book.camera().centre);
        ((x * R::of(256.0)).wide() as i32, (y * R::of(256.0)).wide() as i32)
    }

    /// A real finger takes over: the leaf is let go where it is.
    pub(super) fn stop_auto(&mut self, tape: &mut impl Tape) {
        let Some(auto) = self.auto.take() else { return };
        if auto.given > 0 {
            let (x, y) = auto.last;
            let t_us = self.book.now_us();
            let up = Sample { t_us, id: ID, phase: Phase::Cancel, x, y, leaves: 0 };
            let _ = self.feed(up, tape);
        }
    }
}
