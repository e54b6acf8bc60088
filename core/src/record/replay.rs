//! Replaying a recording: the same calls, and the hashes side by side.

use super::error::RecordError;
use super::read::{Reader, Record};
use crate::book::Book;
use crate::grid::Grid;
use crate::real::Real;
use crate::step::StepReport;
use core::fmt;
use core::ops::ControlFlow;

/// The first step whose hash is another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Divergence {
    /// Which step; the first is 0.
    pub step: u32,
    /// The recording's hash.
    pub expected: u64,
    /// The book's hash.
    pub found: u64,
}

impl fmt::Display for Divergence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { step, expected, found } = self;
        write!(f, "step {step} diverges: recorded {expected:016x}, replayed {found:016x}")
    }
}

/// How a replay went.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Verdict {
    /// World steps taken.
    pub steps: u32,
    /// The first step that diverged; nothing where all hashes are equal.
    pub diverged: Option<Divergence>,
    /// The book's hash at the end.
    pub final_hash: u64,
    /// Samples the book refused to queue: as many as when it was recorded, unless it diverged.
    pub refused: u32,
    /// Whether this very build made the recording. Another one may rightly diverge.
    pub same_build: bool,
}

/// One step of a replay, for whoever watches.
#[derive(Debug)]
pub struct Compared<'b, R: Real, G: Grid> {
    /// Which step; the first is 0.
    pub step: u32,
    /// The recording's hash.
    pub expected: u64,
    /// The book's hash.
    pub found: u64,
    /// What the step cost and how it went.
    pub report: StepReport,
    /// The book after the step.
    pub book: &'b Book<R, G>,
}

/// Opens `book` as the recording was opened and takes it through all of it, also beyond a divergence.
///
/// # Errors
///
/// A recording of other numbers, another grid or other equations; the book is then unchanged.
pub fn replay<R: Real, G: Grid>(
    reader: &Reader<'_>,
    book: &mut Book<R, G>,
) -> Result<Verdict, RecordError> {
    replay_with(reader, book, |_| ControlFlow::Continue(()))
}

/// As [`replay`], with someone who sees every step and may stop.
///
/// # Errors
///
/// As [`replay`].
pub fn replay_with<R: Real, G: Grid>(
    reader: &Reader<'_>,
    book: &mut Book<R, G>,
    mut watch: impl FnMut(&Compared<'_, R, G>) -> ControlFlow<()>,
) -> Result<Verdict, RecordError> {
    let header = reader.header();
    header.fits::<R, G>()?;
    header.setup.open(book)?;
    let mut verdict = Verdict {
        steps: 0,
        diverged: None,
        final_hash: book.state_hash(),
        refused: 0,
        same_build: header.same_build(),
    };
    for record in reader.records() {
        match record? {
            Record::Input(sample) => verdict.refused += u32::from(book.input(sample).is_err()),
            Record::Look(view) => book.look(&view)?,
            Record::Step { hash } => {
                let seen = step(verdict.steps, hash, book);
                verdict.take(&seen);
                if watch(&seen).is_break() {
                    break;
                }
            }
        }
    }
    Ok(verdict)
}

fn step<R: Real, G: Grid>(step: u32, expected: u64, book: &mut Book<R, G>) -> Compared<'_, R, G> {
    let report = book.step();
    Compared { step, expected, found: book.state_hash(), report, book }
}

impl Verdict {
    fn take<R: Real, G: Grid>(&mut self, seen: &Compared<'_, R, G>) {
        let &Compared { step, expected, found, .. } = seen;
        self.steps = step.saturating_add(1);
        self.final_hash = found;
        if self.diverged.is_none() && expected != found {
            self.diverged = Some(Divergence { step, expected, found });
        }
    }
}
