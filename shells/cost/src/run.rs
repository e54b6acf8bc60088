//! From a scene and a configuration to a trajectory: what was seen, and what every step took.

use crate::resample::{POINTS, resample};
use crate::scene::{Look, Sim};
use dogleaf_core::step::StepReport;
use std::time::Instant;

/// Pictures a second that are compared.
pub const PICTURES: u32 = 30;

/// What was seen of a run.
#[derive(Debug, Clone, Default)]
pub struct Trajectory {
    /// Seconds of every picture.
    pub times: Vec<f64>,
    /// Places of the material points in every picture, page widths; empty where no leaf was in the air.
    pub pictures: Vec<Vec<[f64; 3]>>,
    /// Kinetic and potential energy in every picture, model units.
    pub energy: Vec<[f64; 2]>,
    /// Largest edge stretch of all pictures; mean of each one's largest; root mean square.
    pub stretch: [f64; 3],
    /// Largest star-angle defect, radians.
    pub star: f64,
    /// Deepest place inside a block, thicknesses; negative: none.
    pub depth: f64,
    /// When the fore-edge was above the spine.
    pub vertical_s: Option<f64>,
    /// When the leaf had come to lie.
    pub settled_s: Option<f64>,
    /// All work together.
    pub work: StepReport,
    /// Microseconds of every step.
    pub step_us: Vec<f64>,
    /// Calls a second: each takes one step, or a book's substeps.
    pub rate: u32,
    /// Bytes of state, workspace and mesh.
    pub bytes: usize,
}

/// How a scene is watched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Watch {
    /// Calls a second.
    pub rate: u32,
    /// Seconds watched at most.
    pub seconds: f64,
    /// A mesh is made for every picture at 60 a second.
    pub mesh: bool,
    /// The scene ends when the leaf lies.
    pub until_settled: bool,
}

/// Plays a scene.
pub fn play(sim: &mut dyn Sim, watch: Watch) -> Trajectory {
    let mut seen = Trajectory {
        rate: watch.rate,
        depth: f64::NEG_INFINITY,
        bytes: sim.bytes(),
        ..Trajectory::default()
    };
    let steps = (watch.seconds * f64::from(watch.rate)).round() as u32;
    let mut sums = Sums::default();
    let mut edge = sim.edge();
    for n in 1..=steps {
        let t_s = f64::from(n) / f64::from(watch.rate);
        let start = Instant::now();
        let report = sim.step(t_s);
        if watch.mesh {
            seen.bytes = sim.bytes() + sim.mesh();
        }
        let took = start.elapsed().as_secs_f64() * 1e6;
        // A sleeping book takes no steps, and none of its time is a step's.
        if report.steps > 0 {
            seen.step_us.push(took);
        }
        seen.work.add(&report);
        let now = sim.edge();
        seen.crossing(edge, now, t_s);
        edge = now;
        if (n * PICTURES).is_multiple_of(watch.rate) {
            seen.take(t_s, sim.look().as_ref(), &mut sums);
        }
        if watch.until_settled && sim.settled() {
            seen.settled_s = Some(t_s);
            break;
        }
    }
    seen.stretch = sums.figures();
    seen
}

impl Trajectory {
    /// The moment between two steps at which the fore-edge passed over the spine.
    fn crossing(&mut self, before: Option<f64>, now: Option<f64>, t_s: f64) {
        let (Some(a), Some(b), None) = (before, now, self.vertical_s) else { return };
        if (a > 0.0) != (b > 0.0) {
            self.vertical_s = Some(t_s - b / (b - a) / f64::from(self.rate));
        }
    }

    fn take(&mut self, t_s: f64, look: Option<&Look>, sums: &mut Sums) {
        self.times.push(t_s);
        let Some(look) = look else {
            self.pictures.push(Vec::new());
            self.energy.push([0.0; 2]);
            return;
        };
        self.pictures.push(resample(&look.nodes, look.size));
        self.energy.push(look.energy);
        self.star = self.star.max(look.star);
        self.depth = self.depth.max(look.depth);
        sums.take(look.stretch);
    }

    /// Every picture holds finite numbers only.
    pub fn finite(&self) -> bool {
        self.pictures.iter().flatten().flatten().all(|c| c.is_finite())
            && self.pictures.iter().any(|p| p.len() == POINTS)
    }
}

/// Stretch over many pictures.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    worst: f64,
    max: f64,
    squares: f64,
    count: f64,
}

impl Sums {
    fn take(&mut self, [max, rms]: [f64; 2]) {
        self.worst = self.worst.max(max);
        self.max += max;
        self.squares += rms * rms;
        self.count += 1.0;
    }
    fn figures(&self) -> [f64; 3] {
        let count = self.count.max(1.0);
        [self.worst, self.max / count, (self.squares / count).sqrt()]
    }
}
