//! The same leaf stepped by the seed's full KKT matrix: midline and multipliers are unknowns beside it.

use super::lone::Lone;
use super::{Look, Sim, Stage};
use crate::axes::Config;
use dogleaf_core::real::{Real, V2};
use dogleaf_core::scene::units::WIDTH;
use dogleaf_core::seed::{Model, Pose, SeedGrid, SeedSettings, Solver};
use dogleaf_core::state::strip::{BLOCK, Fibre};
use dogleaf_core::step::StepReport;

/// Length of the binding edge that the midline needs, model units; the leaf hangs at its middle.
const BINDING: f64 = 1.0;

/// The seed's solver on a lone leaf. The blocks lie flat and are laid again after every step: they cost what
/// they cost in the seed, and move nothing.
struct SeedLone<R: Real, G: SeedGrid> {
    lone: Lone<R, G>,
    settings: SeedSettings,
    solver: Solver<R, G>,
    pose: Pose<R, G>,
    velocity: Pose<R, G>,
}

pub(super) fn boxed<R: Real, G: SeedGrid>(stage: &Stage, config: &Config) -> Box<dyn Sim> {
    let settings = config.seed().unwrap_or_default();
    Box::new(SeedLone::<R, G> {
        lone: Lone::new(stage, config),
        settings,
        solver: Solver::ZERO,
        pose: Pose::ZERO,
        velocity: Pose::ZERO,
    })
}

impl<R: Real, G: SeedGrid> SeedLone<R, G> {
    /// The leaf into the seed's pose, the midline flat beside it.
    fn load(&mut self) {
        self.pose.leaf.copy_from(&self.lone.leaf.x);
        self.velocity.leaf.copy_from(&self.lone.leaf.v);
        let edge = WIDTH / (BLOCK - 1) as f64;
        for (side, block) in self.pose.blocks.iter_mut().enumerate() {
            let sign = if side == 0 { -1.0 } else { 1.0 };
            for (j, p) in block.iter_mut().enumerate() {
                *p = V2([R::of(sign * (0.5 * BINDING + edge * j as f64)), R::ZERO]);
            }
        }
    }
}

/// A block: as heavy as a leaf, stiff enough to stay where it is.
fn block<R: Real>() -> Fibre<R> {
    let edge = WIDTH / (BLOCK - 1) as f64;
    Fibre { edge: R::of(edge), mass: R::of(0.13), bend: R::of(7.0), glue: R::of(600.0) }
}

impl<R: Real, G: SeedGrid> Sim for SeedLone<R, G> {
    fn step(&mut self, t_s: f64) -> StepReport {
        let mut report = StepReport::default();
        self.lone.lead(t_s);
        self.load();
        let model = Model {
            sheet: &self.lone.sheet,
            leaf: &self.lone.leaf,
            ask: self.lone.ask,
            active: true,
            q: R::of(0.5),
            binding: R::of(BINDING),
            blocks: [block(), block()],
            centre: R::of(0.13),
            board: None,
        };
        self.solver.step(&model, &self.settings, &mut self.pose, &self.velocity, &mut report);
        let rate = R::of(1.0) / self.lone.ask.h;
        let (x, before) = (self.pose.leaf.raw(), self.lone.leaf.x.raw());
        for ((v, &x), &b) in self.lone.leaf.v.raw_mut().iter_mut().zip(x).zip(before) {
            *v = (x - b) * rate;
        }
        self.lone.leaf.x.copy_from(&self.pose.leaf);
        report.steps = 1;
        report
    }

    fn look(&self) -> Option<Look> {
        self.lone.look()
    }

    fn edge(&self) -> Option<f64> {
        self.lone.edge()
    }

    fn bytes(&self) -> usize {
        self.lone.bytes() + size_of::<Solver<R, G>>() + 2 * size_of::<Pose<R, G>>()
    }
}
