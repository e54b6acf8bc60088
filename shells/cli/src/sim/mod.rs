//! What a scene becomes: a book or a lone leaf on some grid and scalar, ribbons, or both, behind one face.

mod band;
mod book;
mod leaf;
mod pose;
mod ribbon;
mod strands;

pub(crate) use pose::{Energy, EventName, LeafNodes, Pose, RibbonWork, Rims, Strain};
pub(crate) use strands::{Bundle, StrandFound, replay as replay_strands};

use crate::error::CliError;
use crate::grid::with_grid;
use crate::picture::Shot;
use crate::scene::{Body, Scene};
use dogleaf_core::hand::Sample;
use dogleaf_core::record::{RecordError, Sink};
use dogleaf_core::scene::Fidelity;
use dogleaf_core::step::StepReport;

/// Which scalar the core runs on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub(crate) enum RealName {
    /// What shells and firmware run.
    #[default]
    F32,
    /// The oracle.
    F64,
}

impl RealName {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }
}

/// A recording in memory.
#[derive(Debug, Default)]
struct Bytes(Vec<u8>);

impl Sink for Bytes {
    fn put(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        self.0.extend_from_slice(bytes);
        Ok(())
    }
}

/// A finished recording.
#[derive(Debug, Default)]
pub(crate) struct Recording {
    pub(crate) bytes: Vec<u8>,
    pub(crate) steps: u32,
    /// Nothing had to be left out.
    pub(crate) complete: bool,
}

/// A scene that can be run.
pub(crate) trait Sim {
    /// Hands over a sample; false if it was refused.
    fn input(&mut self, sample: Sample) -> bool;
    /// One world step.
    fn step(&mut self) -> StepReport;
    /// Time inside, microseconds.
    fn now_us(&self) -> u64;
    /// Nothing moves any more, or so slowly that no figure changes.
    fn resting(&self) -> bool;
    /// Everything a frame of output says; takes the events out.
    fn pose(&mut self) -> Pose;
    /// The meshes of this pose.
    fn shot(&self) -> Result<Shot, CliError>;
    /// Keeps a recording from now on.
    fn record(&mut self) -> Result<(), CliError>;
    /// The recording kept.
    fn recording(&mut self) -> Result<Recording, CliError>;
    /// Bytes of the state and its workspace.
    fn bytes(&self) -> usize;
}

/// Builds what a scene asks for.
pub(crate) fn build(
    scene: &Scene,
    real: RealName,
    fidelity: Fidelity,
) -> Result<Box<dyn Sim>, CliError> {
    let body = body(scene, real, fidelity)?;
    match (body, real) {
        (Some(sim), _) if scene.ribbons.is_empty() => Ok(sim),
        (beside, RealName::F32) => ribbon::build::<f32>(scene, beside, fidelity),
        (beside, RealName::F64) => ribbon::build::<f64>(scene, beside, fidelity),
    }
}

/// The book or the leaf, where there is one.
fn body(
    scene: &Scene,
    real: RealName,
    fidelity: Fidelity,
) -> Result<Option<Box<dyn Sim>>, CliError> {
    let sim = with_grid!(scene.grid, G => match (scene.body, real) {
        (Body::Book(spec), RealName::F32) => book::build::<f32, G>(scene, &spec, fidelity),
        (Body::Book(spec), RealName::F64) => book::build::<f64, G>(scene, &spec, fidelity),
        (Body::Leaf(spec), RealName::F32) => leaf::build::<f32, G>(scene, &spec, fidelity),
        (Body::Leaf(spec), RealName::F64) => leaf::build::<f64, G>(scene, &spec, fidelity),
        (Body::Nothing, _) => return Ok(None),
    });
    sim.map(Some)
}

/// Samples and time on their way into a scene: each sample just before the step it belongs to.
#[derive(Debug)]
pub(crate) struct Feed<'a> {
    samples: &'a [Sample],
    step_us: u32,
    owed_us: u32,
}

impl<'a> Feed<'a> {
    pub(crate) fn new(samples: &'a [Sample], step_us: u32) -> Self {
        Self { samples, step_us, owed_us: 0 }
    }

    /// Everything was handed over.
    pub(crate) fn done(&self) -> bool {
        self.samples.is_empty()
    }

    /// Lets a frame pass, step by step; what is less than a step waits for the next frame.
    pub(crate) fn advance(&mut self, sim: &mut dyn Sim, dt_us: u32) -> StepReport {
        let mut report = StepReport::default();
        self.owed_us += dt_us;
        while self.owed_us >= self.step_us {
            self.owed_us -= self.step_us;
            let until_us = sim.now_us() + u64::from(self.step_us);
            report.refused += self.hand_over(sim, until_us);
            report.add(&sim.step());
        }
        report
    }

    fn hand_over(&mut self, sim: &mut dyn Sim, until_us: u64) -> u32 {
        let due = self.samples.iter().take_while(|s| s.t_us <= until_us).count();
        let (now, later) = self.samples.split_at(due);
        self.samples = later;
        now.iter().filter(|s| !sim.input(**s)).count() as u32
    }
}
