//! What accuracy is bought.

use super::error::{SpecError, within};

/// Four settings on the curve of error against time, from the cheapest to the most exact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fidelity {
    /// One step a frame, one collision pass: for the slowest machines.
    Draft,
    /// One step a frame, as the seed.
    #[default]
    Standard,
    /// Two steps a frame, two Newton steps each: a quarter of the error of four single ones.
    Fine,
    /// Sixteen steps a frame, two Newton steps each: a reference, not for readers.
    Reference,
}

impl Fidelity {
    /// Every fidelity with its name.
    pub const ALL: [(&'static str, Self); 4] = [
        ("draft", Self::Draft),
        ("standard", Self::Standard),
        ("fine", Self::Fine),
        ("reference", Self::Reference),
    ];

    /// What it means for one internal step.
    pub fn settings(self) -> Settings {
        let (substeps, newton, passes) = match self {
            Self::Draft => (1, 1, 1),
            Self::Standard => (1, 1, 3),
            Self::Fine => (2, 2, 3),
            Self::Reference => (16, 2, 3),
        };
        Settings { substeps, newton, passes, ..Settings::STANDARD }
    }
}

/// The dials behind a [`Fidelity`]. `dogleaf cost` turns each by itself and shows what it buys.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Steps the world's step is cut into, 1 to 64.
    pub substeps: u32,
    /// Newton steps in each at most, 1 to 50.
    pub newton: u32,
    /// No further Newton step once no coordinate moved by more than this, model units; 0 takes them all.
    pub tolerance: f64,
    /// Line-search trials at most, up to 30; none takes every full step unseen.
    pub trials: u32,
    /// Collision passes after each step, at most 3.
    pub passes: u32,
    /// Dual regularisation `δ`, 1e-12 to 1.
    pub delta: f64,
    /// Solves with the same factor after each Newton step, against the gradient at the new pose: up to 5 with
    /// the feature `seed`, else none.
    pub refinements: u32,
}

impl Settings {
    /// Those of [`Fidelity::Standard`].
    pub const STANDARD: Self = Self {
        substeps: 1,
        newton: 1,
        tolerance: 0.0,
        trials: 20,
        passes: 3,
        delta: 1e-6,
        refinements: 0,
    };

    /// Refuses what no step could use.
    ///
    /// # Errors
    ///
    /// The first dial out of its range.
    pub fn check(&self) -> Result<(), SpecError> {
        within("settings.substeps", f64::from(self.substeps), 1.0, 64.0)?;
        within("settings.newton", f64::from(self.newton), 1.0, 50.0)?;
        within("settings.tolerance", self.tolerance, 0.0, 1.0)?;
        within("settings.trials", f64::from(self.trials), 0.0, 30.0)?;
        within("settings.passes", f64::from(self.passes), 0.0, 3.0)?;
        within("settings.delta", self.delta, 1e-12, 1.0)?;
        let refinements = if cfg!(feature = "seed") { 5.0 } else { 0.0 };
        within("settings.refinements", f64::from(self.refinements), 0.0, refinements)
    }
}

/// Which equations are solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Formulation {
    /// Condensed, positive definite, contact inside the solve.
    #[default]
    Condensed,
    /// The seed's own: full KKT, post-step projection only. Feature `seed`.
    Seed,
}
