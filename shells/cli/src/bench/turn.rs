//! The turn that is measured: a recorded slow turn of the default book, step by step.

use super::alloc;
use crate::error::CliError;
use crate::gesture::builtin;
use crate::gesture::path::Desk;
use crate::run::Work;
use crate::scene::PICTURE;
use dogleaf_core::Book;
use dogleaf_core::grid::Grid;
use dogleaf_core::hand::{Sample, View};
use dogleaf_core::real::Real;
use dogleaf_core::scene::{BookSpec, Fidelity, PaperSpec, WorldSpec};
use dogleaf_core::state::Fnv;
use dogleaf_core::step::StepReport;
use std::time::Instant;

/// Steps a turn may take before it is given up.
const MOST_STEPS: usize = 1200;

/// A book and the samples that turn its leaf.
pub(super) struct Turn<R: Real, G: Grid> {
    book: Box<Book<R, G>>,
    samples: Vec<Sample>,
}

/// What one turn came to.
pub(super) struct Played {
    /// Time of every step with a leaf in the air.
    pub(super) micros: Vec<f64>,
    pub(super) counts: Work,
    pub(super) allocations: u64,
    /// State at the end.
    pub(super) hash: u64,
    /// All states on the way.
    pub(super) trail: u64,
}

impl<R: Real, G: Grid> Turn<R, G> {
    pub(super) fn new() -> Self {
        let spec = BookSpec::default();
        let desk = Desk::new(&view(&spec), &spec, &PaperSpec::default());
        let samples = builtin::slow_turn(&desk);
        Self { book: Box::new(Book::EMPTY), samples }
    }

    /// Opens the book anew.
    fn open(&mut self) -> Result<(), CliError> {
        let spec = BookSpec::default();
        let (paper, world) = (PaperSpec::default(), WorldSpec::default());
        Ok(self.book.open(&spec, &paper, &world, &view(&spec), Fidelity::Standard)?)
    }

    /// Plays the turn to its end; `before` sees the book before every step.
    pub(super) fn steps(
        &mut self,
        mut before: impl FnMut(&Book<R, G>),
        mut after: impl FnMut(&Book<R, G>, &StepReport, f64),
    ) -> Result<(), CliError> {
        self.open()?;
        let step_us = u64::from(WorldSpec::default().step_us);
        let mut samples = self.samples.iter().peekable();
        for _ in 0..MOST_STEPS {
            let until = self.book.now_us() + step_us;
            while let Some(sample) = samples.next_if(|s| s.t_us <= until) {
                // A full queue would only lose a move.
                let _ = self.book.input(*sample);
            }
            before(&self.book);
            let start = Instant::now();
            let report = self.book.step();
            let micros = start.elapsed().as_nanos() as f64 * 1e-3;
            after(&self.book, &report, micros);
            if samples.peek().is_none() && !self.book.needs_frame() {
                break;
            }
        }
        Ok(())
    }

    /// Plays the turn and times it.
    pub(super) fn play(&mut self) -> Result<Played, CliError> {
        let mut micros = Vec::with_capacity(MOST_STEPS);
        let (mut total, mut trail, mut hash) = (StepReport::default(), Fnv::default(), 0);
        let mut allocations = 0;
        let counted = std::cell::Cell::new(0);
        self.steps(
            |_| counted.set(alloc::count()),
            |book, report, time| {
                allocations += alloc::count() - counted.get();
                total.add(report);
                hash = book.state_hash();
                trail.word(hash);
                if report.newton_steps > 0 {
                    micros.push(time);
                }
            },
        )?;
        Ok(Played { micros, counts: (&total).into(), allocations, hash, trail: trail.value() })
    }
}

fn view(spec: &BookSpec) -> View {
    View::reading(spec.width_m, spec.height_m, PICTURE[0], PICTURE[1])
}
