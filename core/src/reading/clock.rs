//! The app's clock and the book's: how one runs on the other.
//!
//! The book's time starts at nought, goes in whole steps and stands still while it sleeps; the app's may start
//! anywhere and never stands. An offset joins them; it is found anew after every step, so that a display that is
//! a little fast or slow moves the page by one step a picture, never by none and then by two.

use crate::book::Book;
use crate::grid::Grid;
use crate::real::Real;

/// Longest time one call may catch up, microseconds: eight frames at 60 Hz. What is owed beyond is dropped.
const LONGEST_US: u64 = 133_336;
/// Furthest a sample may be ahead of the book, microseconds.
const AHEAD_US: u64 = 1_000_000;
/// World steps one call takes at most.
const MOST_STEPS: u64 = 64;

/// From the app's clock to the book's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Clock {
    /// App's time minus book's time, once known.
    offset: Option<u64>,
    /// App's time at the last step.
    last_us: u64,
    /// Time the app has had and the book has not; below nought where the book is ahead.
    owed_us: i64,
    /// Book's time of the last sample.
    sampled_us: u64,
}

impl Clock {
    pub(super) const START: Self = Self { offset: None, last_us: 0, owed_us: 0, sampled_us: 0 };

    /// Time that passed does not count: the next call sets the offset.
    pub(super) fn forget(&mut self) {
        self.offset = None;
        self.owed_us = 0;
    }

    /// The book's time of a sample: never before the last one's, at once for a book that slept.
    pub(super) fn of_sample<R: Real, G: Grid>(&mut self, t_us: u64, book: &Book<R, G>) -> u64 {
        let now = book.now_us();
        if !book.needs_frame() {
            self.forget();
        }
        let there = t_us.wrapping_sub(*self.offset.get_or_insert(t_us.wrapping_sub(now)));
        // A clock that ran backwards gives a huge number: then the sample counts as of now.
        let there = if there > now.saturating_add(AHEAD_US) { now } else { there };
        self.sampled_us = there.max(self.sampled_us);
        self.sampled_us
    }

    /// Time that passed for the app since the last step, microseconds, and the world steps it is worth.
    pub(super) fn of_step(&mut self, now_us: u64, step_us: u32) -> (u64, u64) {
        let known = self.offset.is_some();
        let passed = now_us.saturating_sub(self.last_us).min(LONGEST_US);
        let passed = if known { passed } else { u64::from(step_us) };
        self.last_us = now_us;
        let step = i64::from(step_us.max(1));
        self.owed_us = self.owed_us.saturating_add_unsigned(passed);
        let steps = self.worth(passed as i64, step).clamp(0, MOST_STEPS as i64);
        self.owed_us = self.owed_us.saturating_sub(steps.saturating_mul(step)).clamp(-step, step);
        (passed, steps.unsigned_abs())
    }

    /// The steps a time is worth: about a whole number of them counts as that, until more than a step is owed.
    fn worth(&self, passed: i64, step: i64) -> i64 {
        let whole = passed.saturating_add(step / 2) / step;
        let off = passed.saturating_sub(whole.saturating_mul(step));
        if whole == 0 || off.abs() > step / 4 {
            return self.owed_us / step;
        }
        let left = self.owed_us.saturating_sub(whole.saturating_mul(step));
        whole + i64::from(left >= step) - i64::from(left <= -step)
    }

    /// The book has taken its steps: its time, and what it owes, is the app's now.
    pub(super) fn join<R: Real, G: Grid>(&mut self, book: &Book<R, G>) {
        let now = book.now_us().saturating_add_signed(self.owed_us);
        self.offset = Some(self.last_us.wrapping_sub(now));
    }
}
