//! The world around the book: gravity, air, time.

use super::error::{SpecError, within};

/// Gravity, damping and the internal step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorldSpec {
    /// Acceleration of free fall, m/s², book frame: Y points up out of the open book.
    pub gravity: [f64; 3],
    /// Rate at which air takes speed, 1/s. A rate, so that behaviour does not change with the step.
    pub damping_per_s: f64,
    /// Internal step, microseconds.
    pub step_us: u32,
    /// Seed of every random choice.
    pub seed: u64,
}

impl Default for WorldSpec {
    fn default() -> Self {
        Self::TABLE
    }
}

impl WorldSpec {
    /// A table on the earth, at sixty steps a second.
    pub const TABLE: Self =
        Self { gravity: [0.0, -9.81, 0.0], damping_per_s: 1.2, step_us: 16_667, seed: 1 };

    /// Refuses what no step could take.
    ///
    /// # Errors
    ///
    /// The first field out of range: gravity up to 1000 m/s², damping up to 1000 /s, step 100 µs to 0.1 s.
    pub fn check(&self) -> Result<(), SpecError> {
        for g in self.gravity {
            within("world.gravity", g, -1000.0, 1000.0)?;
        }
        within("world.damping_per_s", self.damping_per_s, 0.0, 1000.0)?;
        within("world.step_us", f64::from(self.step_us), 100.0, 100_000.0)
    }
}
