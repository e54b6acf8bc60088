//! The physics of a turn: every step timed, every second one kept as a shot.

use super::FPS;
use super::sewn::{self, Sewn};
use crate::bench::times;
use crate::error::CliError;
use crate::picture::{Film, book_indices, book_shot};
use dogleaf_core::Book;
use dogleaf_core::event::Event;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Sample, View};
use dogleaf_core::scene::{BookSpec, Cover, Fidelity, Handling, PaperSpec, WorldSpec};
use dogleaf_core::step::StepReport;
use std::time::Instant;

/// Steps of the physics to a frame of the animation.
const STEPS_A_FRAME: u64 = 60 / FPS as u64;
/// Frames the book lies still before and after: 0.3 s.
const STILL: u32 = 9;
/// Longest gesture shown, and longest wait for rest after it, microseconds.
const LONGEST_US: u64 = 60_000_000;
const REST_US: u64 = 10_000_000;

/// What is played.
#[derive(Debug)]
pub(super) struct Play {
    pub(super) book: BookSpec,
    pub(super) paper: PaperSpec,
    pub(super) view: View,
    pub(super) fidelity: Fidelity,
    pub(super) handling: Handling,
    /// Leaves on the left of a bookmark.
    pub(super) ribbon: Option<u32>,
}

/// What is told of it.
#[derive(Debug, Default)]
pub(super) struct Figures {
    /// Steps in which something was computed.
    pub(super) steps: u32,
    /// Microseconds of each step with a leaf in the air.
    micros: Vec<f64>,
    stretch_max: f64,
    sum_max: f64,
    sum_sq: f64,
    pub(super) total: StepReport,
    /// Page the book is open at in the end, if a leaf came to the other side.
    pub(super) committed: Option<u32>,
    pub(super) simulated: Vec<&'static str>,
    pub(super) ribbon: Option<sewn::Figures>,
}

/// Times the turn is played: of a step's times the least is told, for the machine can only add to it.
const RUNS: u32 = 5;

impl Figures {
    fn take(&mut self, book: &mut Turning, report: &StepReport, micros: f64) {
        self.steps += report.steps;
        self.total.add(report);
        if report.newton_steps > 0 {
            let stretch = book.stretch();
            let (max, rms) = (f64::from(stretch.max()), f64::from(stretch.rms()));
            self.micros.push(micros);
            self.stretch_max = self.stretch_max.max(max);
            self.sum_max += max;
            self.sum_sq += rms * rms;
        }
        while let Some(event) = book.take_event() {
            match event {
                Event::Committed { page } => self.committed = Some(page),
                Event::Cancelled => self.committed = None,
                Event::Lifted { .. } | Event::Held { .. } | Event::Asleep => {}
            }
        }
    }

    /// Median and 99th percentile.
    pub(super) fn step_us(&self) -> [f64; 2] {
        let figures = times::figures(&self.micros);
        [figures.median, figures.p99]
    }

    /// Largest, mean of each step's largest, root mean square over all steps and edges.
    pub(super) fn stretch(&self) -> [f64; 3] {
        let n = self.micros.len().max(1) as f64;
        [self.stretch_max, self.sum_max / n, (self.sum_sq / n).sqrt()]
    }
}

/// The book that is turned: what shells run.
type Turning = Book<f32, G11x8>;

impl Play {
    /// Plays the turn: once for its shots and figures, and again for the times of its steps.
    pub(super) fn run(&self, samples: &[Sample]) -> Result<(Film, Figures), CliError> {
        let mut book = Box::new(Turning::EMPTY);
        let indices = book_indices::<G11x8>()?;
        let mut film = Film::default();
        let mut figures = Figures { simulated: self.simulated(), ..Figures::default() };
        let mut sewn = Sewn::default();
        self.steps(&mut book, samples, |step, book, report, micros| {
            figures.take(book, report, micros);
            if let Some(place) = self.ribbon {
                sewn.follow(step, book, place)?;
            }
            if step % STEPS_A_FRAME == 0 {
                film.add(sewn.beside(book_shot(book, &indices)?));
            }
            if step == 0 {
                film.hold(STILL);
            }
            Ok(())
        })?;
        film.add(sewn.beside(book_shot(&book, &indices)?));
        film.hold(STILL);
        figures.ribbon = sewn.figures(&book);
        for _ in 1..RUNS {
            let mut known = figures.micros.iter_mut();
            self.steps(&mut book, samples, |_, _, report, micros| {
                if report.newton_steps > 0 {
                    known.next().into_iter().for_each(|least| *least = least.min(micros));
                }
                Ok(())
            })?;
        }
        Ok((film, figures))
    }

    /// Opens the book and steps it until everything is at rest; step 0 is the book before anything.
    fn steps(
        &self,
        book: &mut Turning,
        samples: &[Sample],
        mut each: impl FnMut(u64, &mut Turning, &StepReport, f64) -> Result<(), CliError>,
    ) -> Result<(), CliError> {
        let world = WorldSpec::default();
        book.open(&self.book, &self.paper, &world, &self.view, self.fidelity)?;
        book.handle(self.handling)?;
        each(0, book, &StepReport::default(), 0.0)?;
        let last_us = samples.last().map_or(0, |s| s.t_us).min(LONGEST_US);
        let mut left = samples.iter().peekable();
        for step in 1.. {
            let until = book.now_us() + u64::from(world.step_us);
            while let Some(sample) = left.next_if(|s| s.t_us <= until) {
                // A full queue loses a move, which the next one makes good.
                let _ = book.input(*sample);
            }
            let start = Instant::now();
            let report = book.step();
            each(step, book, &report, start.elapsed().as_nanos() as f64 * 1e-3)?;
            let rest = left.peek().is_none() && !book.needs_frame();
            if rest || book.now_us() > last_us + REST_US {
                break;
            }
        }
        Ok(())
    }

    fn simulated(&self) -> Vec<&'static str> {
        let mut parts = vec!["leaf", "page blocks"];
        if self.book.cover == Cover::Hard {
            parts.push("boards");
        }
        if self.ribbon.is_some() {
            parts.push("ribbon");
        }
        parts.push("contact");
        parts
    }
}
