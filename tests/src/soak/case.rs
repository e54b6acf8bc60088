//! One case of the soak: what is drawn for it, how it is played, and what is wrong with what came of it.

use super::draw::{World, percent, view};
use super::hands::gesture;
use crate::gesture::{Rng, Scene};
use crate::watch::{Watch, fault};
use dogleaf_core::Book;
use dogleaf_core::book::InputError;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Sample, View};
use dogleaf_core::real::Real;
use dogleaf_core::step::{StepReport, StepStatus};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Seconds a reader's book may take to rest once it is let go.
pub const REST_S: f64 = 4.0;
/// Seconds after which any book is put to rest, and one more.
const PATIENCE_S: f64 = 21.0;
/// Stretch a gesture should stay under; what lies beyond for good has collapsed.
pub const STRETCHED: f64 = 0.15;
/// Seconds a pose may be kept, one step after the other, before the leaf counts as lost.
const KEPT_S: f64 = 1.0;

/// A case: one book and what is done to it.
#[derive(Debug, Clone)]
pub struct Case {
    /// Which of the soak's cases.
    pub number: u64,
    /// What kind of world.
    pub world: World,
    /// The book.
    pub scene: Scene,
    /// Gestures and their names; the times of each count from its start.
    pub gestures: Vec<(&'static str, Vec<Sample>)>,
    /// Before which gestures the book is let come to rest.
    pub waits: Vec<bool>,
    /// In the middle of this gesture the reader looks from elsewhere.
    pub looks: Option<(usize, View)>,
    rng: Rng,
}

/// What is told of a played case to whoever keeps it.
pub trait Scribe<R: Real> {
    /// A sample was handed over.
    fn input(&mut self, _sample: &Sample) {}
    /// The reader looks from elsewhere.
    fn look(&mut self, _view: &View) {}
    /// A step was taken.
    fn step(&mut self, _book: &mut Book<R, G11x8>) {}
}

/// Nobody keeps it.
#[derive(Debug)]
pub struct Nobody;

impl<R: Real> Scribe<R> for Nobody {}

/// What came of a case.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    /// What kind of world.
    pub world: World,
    /// World steps taken.
    pub steps: u64,
    /// All work together.
    pub work: StepReport,
    /// Steps by status.
    pub statuses: [u64; 6],
    /// Largest stretch of each gesture.
    pub stretches: Vec<f64>,
    /// Seconds from the last sample to rest.
    pub rest_s: f64,
    /// Pictures with a number that is none.
    pub nans: u64,
    /// The leaf stayed out of shape for good.
    pub collapsed: bool,
    /// What is wrong.
    pub faults: Vec<String>,
}

impl Case {
    /// The case of a seed and a number.
    pub fn new(seed: u64, number: u64) -> Self {
        let mut rng = Rng::new(Rng::new(seed).bits() ^ Rng::new(!number).bits());
        let world = World::draw(&mut rng);
        let scene = world.scene(&mut rng);
        let eye = scene.eye();
        let count = 1 + rng.bits() % 4;
        let gestures: Vec<_> = (0..count).map(|_| gesture(&mut rng, &eye)).collect();
        let waits = gestures.iter().map(|_| percent(&mut rng, 50)).collect();
        let looks = percent(&mut rng, 10)
            .then(|| ((rng.bits() % count) as usize, view(&mut rng, &scene)))
            .filter(|(_, view)| view.check().is_ok());
        Self { number, world, scene, gestures, waits, looks, rng }
    }

    fn wild(&self) -> bool {
        self.world == World::Wild
    }

    /// Plays the case; a panic is one more fault.
    pub fn run_safely<R: Real>(&self) -> Outcome {
        let run = AssertUnwindSafe(|| self.run::<R>(&mut Nobody));
        catch_unwind(run).unwrap_or_else(|_| Outcome {
            world: self.world,
            faults: vec!["it panicked".into()],
            // Else a soak of nothing but panics would never end.
            steps: 1,
            ..Outcome::default()
        })
    }

    /// Plays the case.
    pub fn run<R: Real>(&self, scribe: &mut impl Scribe<R>) -> Outcome {
        let mut book = match self.scene.open::<R, G11x8>() {
            Ok(book) => book,
            Err(error) => {
                let faults = vec![error.to_string()];
                return Outcome { world: self.world, steps: 1, faults, ..Outcome::default() };
            }
        };
        let mut play = Play { case: self, rng: self.rng.clone(), out: Outcome::default(), kept: 0 };
        play.out.world = self.world;
        for n in 0..self.gestures.len() {
            play.gesture(n, &mut book, scribe);
        }
        play.end(&book);
        play.out
    }
}

/// A case being played.
struct Play<'a> {
    case: &'a Case,
    rng: Rng,
    out: Outcome,
    /// Steps in a row in which the pose was kept.
    kept: u32,
}

impl Play<'_> {
    fn step_s(&self) -> f64 {
        f64::from(self.case.scene.world.step_us) * 1e-6
    }

    /// One gesture, and what comes after it until the next.
    fn gesture<R: Real>(
        &mut self,
        n: usize,
        book: &mut Book<R, G11x8>,
        scribe: &mut impl Scribe<R>,
    ) {
        let samples = &self.case.gestures[n].1;
        let mut seen = Watch { folded: self.case.wild(), ..Watch::default() };
        let start = book.now_us();
        let due = |s: &Sample| Sample { t_us: s.t_us + start, ..*s };
        let mut next = 0;
        while next < samples.len() {
            let batch = if percent(&mut self.rng, 3) { self.rng.bits() % 9 } else { 1 };
            let until = book.now_us() + batch * u64::from(self.case.scene.world.step_us);
            while next < samples.len() && due(&samples[next]).t_us <= until {
                let sample = due(&samples[next]);
                scribe.input(&sample);
                // A shell keeps what finds no room, above all the letting go.
                if book.input(sample) == Err(InputError::Full) {
                    break;
                }
                next += 1;
            }
            self.look(n, next, book, scribe);
            (0..batch).for_each(|_| self.step(book, &mut seen, scribe));
        }
        let last = n + 1 == self.case.gestures.len();
        let wait_s = match (last || self.case.waits[n], !self.case.wild()) {
            (false, _) => self.rng.within(0.0, 1.2),
            (true, true) => REST_S + 2.0,
            (true, false) => PATIENCE_S,
        };
        let rest_s = self.wait(wait_s, book, &mut seen, scribe);
        if last || self.case.waits[n] {
            self.judge_rest(rest_s, book);
        }
        self.out.stretches.push(seen.air.worst);
        self.out.faults.extend(seen.complaint.iter().cloned());
        self.out.work.add(&seen.work);
        for (sum, n) in self.out.statuses.iter_mut().zip(seen.statuses) {
            *sum += u64::from(n);
        }
    }

    fn look<R: Real>(
        &mut self,
        n: usize,
        next: usize,
        book: &mut Book<R, G11x8>,
        scribe: &mut impl Scribe<R>,
    ) {
        let half = self.case.gestures[n].1.len() / 2;
        if let Some((at, view)) = &self.case.looks
            && *at == n
            && next == half
            && book.look(view).is_ok()
        {
            scribe.look(view);
        }
    }

    /// Steps until the book sleeps, or the time is over. Answers seconds until it slept.
    fn wait<R: Real>(
        &mut self,
        most_s: f64,
        book: &mut Book<R, G11x8>,
        seen: &mut Watch,
        scribe: &mut impl Scribe<R>,
    ) -> Option<f64> {
        let most = (most_s / self.step_s()).ceil() as u32;
        for n in 0..most {
            if !book.needs_frame() {
                return Some(f64::from(n) * self.step_s());
            }
            self.step(book, seen, scribe);
        }
        (!book.needs_frame()).then_some(f64::from(most) * self.step_s())
    }

    fn judge_rest<R: Real>(&mut self, rest_s: Option<f64>, book: &Book<R, G11x8>) {
        let most = if !self.case.wild() { REST_S } else { PATIENCE_S };
        match rest_s {
            Some(s) if s <= most => self.out.rest_s = self.out.rest_s.max(s),
            Some(s) => {
                self.out.rest_s = self.out.rest_s.max(s);
                self.out.faults.push(format!("at rest only after {s:.2} s"));
            }
            None => {
                self.out.rest_s = f64::INFINITY;
                self.out.faults.push("not at rest in time".into());
            }
        }
        self.out.collapsed |= book.stretch().max().wide() > STRETCHED;
    }

    fn step<R: Real>(
        &mut self,
        book: &mut Book<R, G11x8>,
        seen: &mut Watch,
        scribe: &mut impl Scribe<R>,
    ) {
        let report = book.step();
        scribe.step(book);
        self.out.steps += u64::from(report.steps);
        seen.see(book, &report);
        if let Some(over) = excess(&report, &self.case.scene) {
            self.out.faults.push(over);
        }
        if fault(book).is_some_and(|what| what.contains("not finite")) {
            self.out.nans += 1;
        }
        let kept = matches!(report.status, StepStatus::Held | StepStatus::Recovered);
        self.kept = if kept { self.kept + 1 } else { 0 };
        if f64::from(self.kept) * self.step_s() > KEPT_S && book.held().is_none() {
            self.out.collapsed = true;
        }
    }

    /// What is wrong with the book when all is over.
    fn end<R: Real>(&mut self, book: &Book<R, G11x8>) {
        self.out.faults.extend(fault(book));
        if self.out.collapsed {
            self.out.faults.push("collapsed for good".into());
        }
        self.out.faults.dedup();
    }
}

/// More work in one step than is allowed.
fn excess(report: &StepReport, scene: &Scene) -> Option<String> {
    let settings = scene.fidelity.settings();
    // Each substep once, or once and then in four parts.
    let solves = settings.substeps + 4 * report.parted.min(settings.substeps);
    let (newton, passes) = (solves * settings.newton, solves * settings.passes);
    let over = report.newton_steps > newton
        || report.parted > settings.substeps
        || report.passes > passes
        || report.cuts > settings.trials * report.newton_steps
        || report.steps > 1;
    over.then(|| format!("more work than is allowed: {report:?}"))
}
