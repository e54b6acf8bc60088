//! What a run cost: time, instructions, bytes, counts.

mod callgrind;

pub use callgrind::{Counts, Probe, available, count, instructions};

use crate::run::Trajectory;
use serde::Serialize;

/// Costs of one run. Per picture means per sixtieth of a second.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Cost {
    /// Least, lower quartile, median and upper quartile of a step's time, microseconds.
    pub step_us: [f64; 4],
    /// Median time a picture, microseconds.
    pub frame_us: f64,
    /// Instructions a step, counted, not timed; nothing where no counter is at hand.
    pub step_instructions: Option<u64>,
    /// Instructions a picture.
    pub frame_instructions: Option<f64>,
    /// Factorisations a picture.
    pub factorisations: f64,
    /// Line-search cuts of the whole run.
    pub cuts: u32,
    /// Bytes of state and workspace.
    pub bytes: usize,
}

/// Pictures a second that a cost is told for.
const PICTURES: f64 = 60.0;

impl Cost {
    /// What a run cost; instructions are added later.
    pub fn of(run: &Trajectory) -> Self {
        let mut us = run.step_us.clone();
        us.sort_by(f64::total_cmp);
        let at = |share: f64| {
            let last = us.len().saturating_sub(1);
            us.get((share * last as f64).round() as usize).copied().unwrap_or_default()
        };
        let pictures = run.step_us.len() as f64 * PICTURES / f64::from(run.rate.max(1));
        Self {
            step_us: [at(0.0), at(0.25), at(0.5), at(0.75)],
            frame_us: at(0.5) * f64::from(run.rate) / PICTURES,
            factorisations: f64::from(run.work.newton_steps) / pictures.max(1e-9),
            cuts: run.work.cuts,
            bytes: run.bytes,
            ..Self::default()
        }
    }

    /// Adds counted instructions of a run with so many steps and Newton steps at a rate.
    pub fn counted(&mut self, run: &Trajectory, counts: Counts) {
        let [steps, newton] = [run.step_us.len() as f64, f64::from(run.work.newton_steps)];
        let whole = steps * counts.step + newton * counts.newton;
        self.step_instructions = Some((whole / steps.max(1.0)).round() as u64);
        self.frame_instructions = Some(whole * f64::from(run.rate) / (steps.max(1.0) * PICTURES));
    }

    /// What a plot puts on its axis of costs.
    pub fn axis(&self) -> f64 {
        self.frame_instructions.unwrap_or(self.frame_us)
    }
}
