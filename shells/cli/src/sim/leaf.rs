//! A lone leaf as a scene.

use super::{Energy, LeafNodes, Pose, Recording, Sim};
use crate::error::CliError;
use crate::picture::{Shot, sheet_shot};
use crate::scene::Scene;
use dogleaf_core::LoneLeaf;
use dogleaf_core::grid::Grid;
use dogleaf_core::hand::Sample;
use dogleaf_core::real::Real;
use dogleaf_core::scene::{Fidelity, LeafSpec};
use dogleaf_core::step::StepReport;

/// Slower than this, model units/s, a hanging leaf is still: a six-thousandth of its width in a second.
const STILL: f64 = 2e-3;
/// How long it has to be, microseconds: a swinging leaf is still, too, when it turns.
const STILL_US: u64 = 500_000;

struct LeafSim<R: Real, G: Grid> {
    lone: LoneLeaf<R, G>,
    /// When it last moved.
    moved_us: u64,
    thickness_m: f32,
}

/// Lays the leaf of a scene.
pub(super) fn build<R: Real, G: Grid>(
    scene: &Scene,
    spec: &LeafSpec,
    fidelity: Fidelity,
) -> Result<Box<dyn Sim>, CliError> {
    let mut sim = Box::new(LeafSim {
        lone: LoneLeaf::<R, G>::EMPTY,
        moved_us: 0,
        thickness_m: (scene.paper.thickness_mm * 1e-3) as f32,
    });
    sim.lone.open(spec, &scene.paper, &scene.world, fidelity)?;
    Ok(sim)
}

impl<R: Real, G: Grid> Sim for LeafSim<R, G> {
    fn input(&mut self, _: Sample) -> bool {
        false
    }

    fn step(&mut self) -> StepReport {
        let report = self.lone.step();
        if self.lone.leaf().fastest().wide() > STILL {
            self.moved_us = self.lone.now_us();
        }
        report
    }

    fn now_us(&self) -> u64 {
        self.lone.now_us()
    }

    fn resting(&self) -> bool {
        self.lone.now_us() >= self.moved_us + STILL_US
    }

    fn pose(&mut self) -> Pose {
        let lone = &self.lone;
        Pose {
            hash: format!("{:016x}", lone.state_hash()),
            leaf: Some(LeafNodes::of(lone.leaf(), lone.units())),
            midline: None,
            ribbons: Vec::new(),
            stretch: lone.stretch().into(),
            energy: Energy::of(lone.energy(), lone.units()),
            events: Vec::new(),
        }
    }

    fn shot(&self) -> Result<Shot, CliError> {
        let nodes = LeafNodes::of(self.lone.leaf(), self.lone.units());
        Ok(sheet_shot(&nodes, self.thickness_m))
    }

    fn record(&mut self) -> Result<(), CliError> {
        Err(CliError::Call("a recording is of a book; this scene has a lone leaf".into()))
    }

    fn recording(&mut self) -> Result<Recording, CliError> {
        Ok(Recording::default())
    }

    fn bytes(&self) -> usize {
        size_of_val(&self.lone)
    }
}
