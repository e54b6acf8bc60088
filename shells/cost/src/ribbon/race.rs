//! Newton's method and the seed's Algorithm 2 on the same steps: iterations and time to the same share of the way.
//!
//! The gap of an objective `f` is `(f - f*)/(f_0 - f*)`, `f*` being the better of the two ends. Steps that either does
//! not bring to the gap are counted, and left out of the times.

use super::algorithm::{Answer, algorithm_2};
use super::lbfgsb::Limits;
use super::scenes::{Floor, Long, Scene};
use super::unknowns::{Unknowns, set_out};
use dogleaf_core::effect::ribbon::Settings;
use serde::Serialize;
use std::time::Instant;

/// The gap raced to.
pub const GAP: f64 = 1e-6;
/// Violation of a row, as a share of its limit, that still counts as arrived.
const VIOLATION: f64 = 1e-6;

/// The objective after so many microseconds.
#[derive(Debug, Clone, Copy)]
struct Mark {
    us: f64,
    objective: f64,
}

/// What a race came to.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Race {
    /// The scene.
    pub scene: &'static str,
    /// Steps raced.
    pub steps: u32,
    /// Steps that Newton brings to the gap.
    pub newton_arrives: u32,
    /// Steps that Algorithm 2 brings to the gap.
    pub seed_arrives: u32,
    /// Steps that both bring there.
    pub both_arrive: u32,
    /// Iterations to the gap, mean over the steps that both bring there.
    pub newton_iterations: f64,
    /// As above, of all inner solves.
    pub seed_iterations: f64,
    /// Microseconds to the gap, mean over the same steps.
    pub newton_us: f64,
    /// As above.
    pub seed_us: f64,
    /// `seed_us / newton_us`.
    pub ratio: f64,
    /// As `ratio`, over all steps that Newton brings to the gap: where Algorithm 2 does not come there, what it had
    /// spent when it gave up.
    pub at_least: f64,
    /// Steps whose better end is Newton's by more than the gap, and the seed's.
    pub better: [u32; 2],
    /// Microseconds of one iteration of each.
    pub iteration_us: [f64; 2],
    /// Microseconds of all steps that Newton brings to the gap: its own, Algorithm 2's.
    #[serde(skip)]
    spent: [f64; 2],
}

/// Races on every `every`th step of a scene; Newton's steps are the ones that are kept.
pub fn race(mut scene: Scene, every: u32) -> Race {
    let mut race = Race { scene: scene.name, ..Race::default() };
    for step in 0..scene.steps {
        scene.ask(step);
        if step % every == every - 1 {
            race.one(&scene);
        }
        scene.ribbon.step_under(scene.h, &scene.floor);
    }
    race.mean();
    race
}

impl Race {
    fn one(&mut self, scene: &Scene) {
        let newton = best_of(|| newton(&scene.ribbon, scene.h, &scene.floor));
        let f0 = newton[0].objective;
        let known = least(&newton);
        let (seed, _) = seed(&scene.ribbon, scene.h, &scene.floor, known, &Limits::default());
        let best = known.min(least(&seed));
        let arrives =
            |marks: &[Mark]| marks.iter().position(|m| m.objective - best <= GAP * (f0 - best));
        let (ours, theirs) = (arrives(&newton), arrives(&seed));
        self.steps += 1;
        self.newton_arrives += u32::from(ours.is_some());
        self.seed_arrives += u32::from(theirs.is_some());
        let wins = |a: f64, b: f64| u32::from(b - a > GAP * (f0 - best));
        self.better[0] += wins(known, least(&seed));
        self.better[1] += wins(least(&seed), known);
        if let Some(a) = ours {
            let gave_up = seed.iter().map(|m| m.us).fold(0.0, f64::max);
            self.spent[0] += newton[a].us;
            self.spent[1] += theirs.map_or(gave_up, |b| seed[b].us);
        }
        if let (Some(a), Some(b)) = (ours, theirs) {
            self.both_arrive += 1;
            self.newton_iterations += a as f64;
            self.seed_iterations += b as f64 + 1.0;
            self.newton_us += newton[a].us;
            self.seed_us += seed[b].us;
        }
    }

    fn mean(&mut self) {
        let both = f64::from(self.both_arrive.max(1));
        self.iteration_us = [
            self.newton_us / self.newton_iterations.max(1.0),
            self.seed_us / self.seed_iterations.max(1.0),
        ];
        self.at_least = self.spent[1] / self.spent[0].max(1e-9);
        self.ratio = self.seed_us / self.newton_us.max(1e-9);
        self.newton_iterations /= both;
        self.seed_iterations /= both;
        self.newton_us /= both;
        self.seed_us /= both;
    }
}

fn least(marks: &[Mark]) -> f64 {
    marks.iter().map(|m| m.objective).fold(f64::INFINITY, f64::min)
}

/// The faster of three runs that do the same: the machine can only make one slower.
fn best_of(run: impl Fn() -> Vec<Mark>) -> Vec<Mark> {
    let [a, b, c] = [run(), run(), run()];
    let end = |m: &Vec<Mark>| m.last().map_or(f64::INFINITY, |m| m.us);
    [b, c].into_iter().fold(a, |best, next| if end(&next) < end(&best) { next } else { best })
}

/// The core's own solver as it is fastest, to rounding.
fn newton(ribbon: &Long, h: f64, floor: &Floor) -> Vec<Mark> {
    let mut copy = Box::new(ribbon.clone());
    copy.settings =
        Settings { iterations: 300, tolerance: 1e-9, thorough: false, ..Settings::EXACT };
    let mut marks = Vec::with_capacity(301);
    let start = Instant::now();
    copy.step_watched(h, floor, |objective, _| {
        marks.push(Mark { us: start.elapsed().as_nanos() as f64 * 1e-3, objective });
    });
    marks
}

/// The seed's, until it is as low as `known` or has given up.
fn seed(ribbon: &Long, h: f64, floor: &Floor, known: f64, limits: &Limits) -> (Vec<Mark>, Answer) {
    let mut copy = Box::new(ribbon.clone());
    let ask = copy.ask.clone();
    let mut marks = Vec::with_capacity(4096);
    let start = Instant::now();
    set_out(&mut copy, h);
    let mut unknowns = Unknowns::new(copy.body(), ask, floor);
    let answer = algorithm_2(&mut unknowns, limits, |objective, violation| {
        if violation <= VIOLATION {
            marks.push(Mark { us: start.elapsed().as_nanos() as f64 * 1e-3, objective });
        } else {
            marks.push(Mark { us: 0.0, objective: f64::INFINITY });
        }
        objective > known
    });
    (marks, answer)
}

/// Algorithm 2 on one step as the seed ends it: relative falls below so many times the spacing of `f64`.
pub fn as_the_seed(scene: &Scene, factor: f64) -> (Answer, f64) {
    let limits = Limits { factor, ..Limits::default() };
    let never = f64::NEG_INFINITY;
    let start = Instant::now();
    let (_, answer) = seed(&scene.ribbon, scene.h, &scene.floor, never, &limits);
    (answer, start.elapsed().as_secs_f64())
}
