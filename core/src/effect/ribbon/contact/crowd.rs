//! Many ribbons: one after the other, each against the others where they are by then.
//!
//! While one moves the rest stand still, so each step only lowers its own energy and the barriers it shares, and the sum
//! over all never grows: there is nothing to iterate. What is pushed answers when its turn comes, within the same step.
//!
//! Source: ours; the seed solves all alone and corrects positions afterwards (Ribbon Alg. 1). Checked by
//! `tests/ribbon_chains.rs`.

use super::near::{Counts, Near};
use super::surface::Surface;
use crate::effect::ribbon::{Report, Ribbon, Status};
use crate::real::Real;

/// What a step of many ribbons cost, and how it ended for each.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Summary<R> {
    /// Ribbons that converged.
    pub converged: u32,
    /// Whose iterations were used up.
    pub capped: u32,
    /// That stalled.
    pub stalled: u32,
    /// That were held where they were.
    pub held: u32,
    /// Loops that could not be closed.
    pub open: u32,
    /// Newton iterations of all.
    pub iterations: u32,
    /// Trials of all that a contact on the way shortened.
    pub limited: u32,
    /// The most pairs that one had.
    pub pairs: u32,
    /// The most segments of others that one had near.
    pub others: u32,
    /// Things that found no room.
    pub crowded: u32,
    /// The widest gap of a loop.
    pub gap: R,
}

impl<R: Real> Summary<R> {
    /// Adds one ribbon's.
    fn take(&mut self, report: &Report<R>, counts: &Counts) {
        match report.status {
            Status::Converged => self.converged += 1,
            Status::Capped => self.capped += 1,
            Status::Stalled => self.stalled += 1,
            Status::Held => self.held += 1,
            Status::Open => self.open += 1,
        }
        self.iterations += report.iterations;
        self.limited += counts.limited;
        self.crowded += counts.crowded;
        (self.pairs, self.others) = (self.pairs.max(counts.pairs), self.others.max(counts.others));
        self.gap = self.gap.larger(report.gap);
    }
}

/// Lets `h` seconds pass for all. The surface of `near` is in the coordinates of each, so all share one origin where there
/// is a surface.
///
/// # Cost
///
/// A step of each, and a comparison of boxes for every segment with every ribbon.
///
/// # Hard case
///
/// A ribbon with more near it than fits into `near` stands still for this step, and is counted as held and crowded.
pub fn step_all<R: Real, S: Surface<R>, const N: usize, const O: usize, const K: usize>(
    ribbons: &mut [Ribbon<R, N>],
    h: f64,
    near: &mut Near<R, S, N, O, K>,
) -> Summary<R> {
    step_each(ribbons, h, near, |_, ribbon, near, _| ribbon.step_touching(h, &(), near))
}

/// [`step_all`] with a step of the caller's: it gets a ribbon's number, the ribbon, what is near it, and the ribbons before
/// and after it, in which order they were added to that.
pub fn step_each<R: Real, S: Surface<R>, const N: usize, const O: usize, const K: usize>(
    ribbons: &mut [Ribbon<R, N>],
    h: f64,
    near: &mut Near<R, S, N, O, K>,
    mut step: impl FnMut(
        usize,
        &mut Ribbon<R, N>,
        &mut Near<R, S, N, O, K>,
        [&[Ribbon<R, N>]; 2],
    ) -> Report<R>,
) -> Summary<R> {
    let mut summary = Summary { gap: R::ZERO, ..Summary::default() };
    for i in 0..ribbons.len() {
        let Some((before, rest)) = ribbons.split_at_mut_checked(i) else { break };
        let Some((ribbon, after)) = rest.split_first_mut() else { break };
        near.begin(ribbon, h);
        before.iter().chain(after.iter()).for_each(|o| near.add(o));
        let report =
            if near.full() { ribbon.hold() } else { step(i, ribbon, near, [before, after]) };
        summary.take(&report, &near.counts);
    }
    summary
}
