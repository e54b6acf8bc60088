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
use std::sync::Arc;
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

/// What looks on while a turn is played.
trait Beside {
    /// Whether a sample is not the book's.
    fn takes(&mut self, _: &Turning, _: &Sample) -> bool {
        false
    }
    /// After every step, which took so many microseconds; step 0 is the book before anything.
    fn stepped(
        &mut self,
        step: u64,
        book: &mut Turning,
        report: &StepReport,
        micros: f64,
    ) -> Result<(), CliError>;
    /// Whether it goes on when the book rests.
    fn moves(&self) -> bool {
        false
    }
}

/// The first time: its shots and figures, the bookmark beside it, and which samples were the book's.
struct Filmed<'a> {
    ribbon: Option<u32>,
    indices: &'a Arc<[u16]>,
    film: Film,
    figures: Figures,
    sewn: Sewn,
    given: Vec<Sample>,
}

impl Beside for Filmed<'_> {
    fn takes(&mut self, book: &Turning, sample: &Sample) -> bool {
        let taken = self.sewn.takes(book, sample);
        if !taken {
            self.given.push(*sample);
        }
        taken
    }
    fn stepped(
        &mut self,
        step: u64,
        book: &mut Turning,
        report: &StepReport,
        micros: f64,
    ) -> Result<(), CliError> {
        self.figures.take(book, report, micros);
        if let Some(place) = self.ribbon {
            self.sewn.follow(step, book, place)?;
        }
        if step.is_multiple_of(STEPS_A_FRAME) {
            self.film.add(self.sewn.beside(book_shot(book, self.indices)?));
        }
        if step == 0 {
            self.film.hold(STILL);
        }
        Ok(())
    }
    fn moves(&self) -> bool {
        self.sewn.moves()
    }
}

/// Again: the least time of each step.
struct Timed<'a>(std::slice::IterMut<'a, f64>);

impl Beside for Timed<'_> {
    fn stepped(
        &mut self,
        _: u64,
        _: &mut Turning,
        report: &StepReport,
        micros: f64,
    ) -> Result<(), CliError> {
        if report.newton_steps > 0 {
            self.0.next().into_iter().for_each(|least| *least = least.min(micros));
        }
        Ok(())
    }
}

impl Play {
    /// Plays the turn: once for its shots and figures, and again for the times of its steps.
    pub(super) fn run(&self, samples: &[Sample]) -> Result<(Film, Figures), CliError> {
        let mut book = Box::new(Turning::EMPTY);
        let mut filmed = Filmed {
            ribbon: self.ribbon,
            indices: &book_indices::<G11x8>()?,
            film: Film::default(),
            figures: Figures { simulated: self.simulated(), ..Figures::default() },
            sewn: Sewn::default(),
            given: Vec::new(),
        };
        self.steps(&mut book, samples, &mut filmed)?;
        let Filmed { indices, mut film, mut figures, sewn, given, .. } = filmed;
        film.add(sewn.beside(book_shot(&book, indices)?));
        film.hold(STILL);
        figures.ribbon = sewn.figures(&book);
        for _ in 1..RUNS {
            self.steps(&mut book, &given, &mut Timed(figures.micros.iter_mut()))?;
        }
        Ok((film, figures))
    }

    /// Opens the book and steps it until everything is at rest.
    fn steps(
        &self,
        book: &mut Turning,
        samples: &[Sample],
        beside: &mut impl Beside,
    ) -> Result<(), CliError> {
        let world = WorldSpec::default();
        book.open(&self.book, &self.paper, &world, &self.view, self.fidelity)?;
        book.handle(self.handling)?;
        beside.stepped(0, book, &StepReport::default(), 0.0)?;
        let last_us = samples.last().map_or(0, |s| s.t_us).min(LONGEST_US);
        let mut left = samples.iter().peekable();
        for step in 1.. {
            let until = book.now_us() + u64::from(world.step_us);
            while let Some(sample) = left.next_if(|s| s.t_us <= until) {
                if !beside.takes(book, sample) {
                    // A full queue loses a move, which the next one makes good.
                    let _ = book.input(*sample);
                }
            }
            let start = Instant::now();
            let report = book.step();
            beside.stepped(step, book, &report, start.elapsed().as_nanos() as f64 * 1e-3)?;
            let rest = left.peek().is_none() && !book.needs_frame() && !beside.moves();
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
