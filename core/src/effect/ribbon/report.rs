//! What a solve is allowed, what it cost and how it ended.

use crate::real::Real;

/// Limits of one solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Newton iterations at most.
    pub iterations: u32,
    /// Converged when no crease has moved by more than this in a full step, radians (and slope).
    pub tolerance: f64,
    /// Converged when the loop's joint is closed this well: radians, and share of the length.
    pub closure: f64,
    /// Line-search trials of one iteration at most.
    pub trials: u32,
    /// Shifts tried in one iteration at most.
    pub shifts: u32,
    /// Last barrier parameter, as a share of the crease stiffness.
    pub barrier: f64,
    /// Where the model has no minimum, the best of several that have is followed rather than the first: fewer iterations,
    /// and fewer steps that use them up, for up to twice the time.
    pub thorough: bool,
}

impl Settings {
    /// For a step: what the eye can tell.
    pub const STEP: Self = Self {
        iterations: 60,
        tolerance: 1e-4,
        closure: 1e-6,
        trials: 12,
        shifts: 24,
        barrier: 1e-9,
        thorough: false,
    };
    /// For rest shapes, and as an oracle.
    pub const EXACT: Self = Self {
        iterations: 1000,
        tolerance: 1e-9,
        closure: 1e-11,
        trials: 20,
        shifts: 24,
        barrier: 1e-13,
        thorough: true,
    };
}

/// How a solve ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Status {
    /// To tolerance.
    #[default]
    Converged,
    /// The iterations were used up; the best point is kept.
    Capped,
    /// No trial lowered the merit; the best point is kept.
    Stalled,
    /// Something was not a number; the last good state was kept, at rest.
    Held,
    /// A loop could not be closed: contact or rulings at their bounds are in the way. The best point is kept.
    Open,
}

/// Counts of one solve.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Report<R> {
    /// How it ended.
    pub status: Status,
    /// Newton iterations.
    pub iterations: u32,
    /// Factorisations.
    pub factorisations: u32,
    /// Evaluations of the merit.
    pub trials: u32,
    /// What was minimised, joules, without barrier and joint.
    pub objective: R,
    /// The last fall to first order, joules.
    pub fall: R,
    /// The largest step of a crease in the last iteration.
    pub size: R,
    /// How far the loop is from closed.
    pub gap: R,
}

impl<R: Real> Report<R> {
    /// No work.
    pub const NONE: Self = Self {
        status: Status::Converged,
        iterations: 0,
        factorisations: 0,
        trials: 0,
        objective: R::ZERO,
        fall: R::ZERO,
        size: R::ZERO,
        gap: R::ZERO,
    };

    /// This answer, with an earlier solve's work added.
    #[must_use]
    pub fn after(self, earlier: &Self) -> Self {
        Self {
            iterations: self.iterations.saturating_add(earlier.iterations),
            factorisations: self.factorisations.saturating_add(earlier.factorisations),
            trials: self.trials.saturating_add(earlier.trials),
            ..self
        }
    }
}
