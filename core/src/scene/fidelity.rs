//! What accuracy is bought.

/// Four settings on the curve of error against time, from the cheapest to the most exact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fidelity {
    /// One step a frame, one collision pass: for the slowest machines.
    Draft,
    /// One step a frame, as the seed.
    #[default]
    Standard,
    /// Four steps a frame.
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
            Self::Fine => (4, 1, 3),
            Self::Reference => (16, 2, 3),
        };
        Settings { substeps, newton, passes }
    }
}

/// The numbers behind a [`Fidelity`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Settings {
    /// Steps the world's step is cut into.
    pub substeps: u32,
    /// Newton steps in each.
    pub newton: u32,
    /// Collision passes after each, at most.
    pub passes: u32,
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
