//! What is asked: a book or a lone leaf, its paper, the world, and how exact it shall be. All in SI units.
//!
//! A spec is plain data. [`BookSpec::check`] and its sisters refuse a bad one before any state exists.

pub mod book;
pub mod error;
pub mod fidelity;
pub mod handling;
pub mod paper;
pub mod units;
pub mod world;

pub use book::{BookSpec, Cover, Direction, LeafSpec};
pub use error::SpecError;
pub use fidelity::{Fidelity, Formulation, Settings};
pub use handling::{Handling, Pages};
pub use paper::{PaperSpec, Preset, Weights};
pub use units::Units;
pub use world::WorldSpec;
