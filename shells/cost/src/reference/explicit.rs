//! A second method: the same forces, integrated explicitly. No matrix, no Newton, no line search; a leapfrog of the
//! second order in thousands of small steps, where the product takes implicit steps of the first order.

use crate::axes::Config;
use crate::scene::{Lone, Look, Sim, Stage};
use dogleaf_core::grid::Grid;
use dogleaf_core::state::Field;
use dogleaf_core::step::StepReport;
use dogleaf_core::step::assemble::assemble;
use dogleaf_core::step::matrix::NoMatrix;

/// A leaf that falls by forces alone. Multipliers are `C/δ`, as at the end of the product's Newton steps.
pub(super) struct Explicit<G: Grid> {
    lone: Lone<f64, G>,
    pull: Field<f64, G>,
    nothing: Field<f64, G>,
    h: f64,
    keep: f64,
    started: bool,
}

impl<G: Grid> Explicit<G> {
    /// A stage's leaf, to be stepped so often a second.
    pub(super) fn boxed(stage: &Stage, config: &Config, rate: u32) -> Box<Self> {
        let h = 1.0 / f64::from(rate);
        Box::new(Self {
            pull: Field::ZERO,
            nothing: Field::ZERO,
            h,
            keep: (-stage.damping_per_s * h).exp(),
            started: false,
            lone: Lone::new(stage, config),
        })
    }
}

impl<G: Grid> Sim for Explicit<G> {
    /// Velocities stand half a step behind positions; the first step is half as long a pull.
    fn step(&mut self, t_s: f64) -> StepReport {
        self.lone.lead(t_s - self.h);
        let Lone { sheet, leaf, ask, .. } = &mut self.lone;
        assemble(sheet, leaf, &self.nothing, ask, &mut NoMatrix, &mut self.pull);
        let (share, keep) = if self.started { (self.h, self.keep) } else { (0.5 * self.h, 1.0) };
        self.started = true;
        for (i, k) in Field::<f64, G>::nodes().filter(|(i, _)| *i > 0) {
            let v = leaf.v.at(i, k) * keep - self.pull.at(i, k) * (share / sheet.mass.at(i, k));
            leaf.v.set(i, k, v);
            leaf.x.set(i, k, leaf.x.at(i, k) + v * self.h);
        }
        StepReport::default()
    }

    fn look(&self) -> Option<Look> {
        self.lone.look()
    }

    fn edge(&self) -> Option<f64> {
        self.lone.edge()
    }

    fn bytes(&self) -> usize {
        size_of::<Self>()
    }
}

/// Steps a second that are stable on a grid: the stiffest edge of the finest grid swings fastest.
pub(super) fn rate<G: Grid>() -> u32 {
    let fine = ((G::NX - 1) as f64 / 10.0).max((G::NZ - 1) as f64 / 7.0);
    30_720 * (fine * fine).ceil() as u32
}
