//! How a finger and a page meet: what is a choice of the reader's app, not of the paper.

use super::error::{SpecError, within};

/// How much of the book is seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pages {
    /// Both open pages: a press takes up the leaf it lands on.
    #[default]
    Spread,
    /// The page that is turned next: a drag away from the spine pulls the one before it back.
    Single,
}

/// How a finger and a page meet.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Handling {
    /// How hard a hand pulls from anywhere on its leash, in times the pull at its end: 0 lets the page swing
    /// on a spring as the seed's does, [`Handling::FINGER`]'s keeps it under a finger. At most 100.
    pub grip: f64,
    /// How much of the book is seen.
    pub pages: Pages,
}

impl Handling {
    /// The seed's: a spring.
    pub const SPRING: Self = Self { grip: 0.0, pages: Pages::Spread };
    /// What a touch screen wants: the paper stays under the finger.
    ///
    /// # Accuracy
    ///
    /// With [`Fidelity::Fine`](super::Fidelity): see `tests/finger.rs`. A firm hand stretches the sheet more: on
    /// average by a quarter.
    pub const FINGER: Self = Self { grip: 16.0, pages: Pages::Spread };

    /// Refuses what no hand could do.
    ///
    /// # Errors
    ///
    /// `handling.grip` out of range.
    pub fn check(&self) -> Result<(), SpecError> {
        within("handling.grip", self.grip, 0.0, 100.0)
    }
}
