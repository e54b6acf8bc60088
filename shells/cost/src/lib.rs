//! What accuracy costs in time: every dial of the step turned, errors measured against references that agree, costs
//! counted, and all of it shown on one page. The library behind `dogleaf cost`.
//!
//! ```text
//! axes ─► scene ─► run ─► errors ┐
//!            └► reference ───────┴► cost ─► pareto ─► page, json
//! ```

pub mod axes;
pub mod scene;
pub mod resample;
pub mod run;
pub mod errors;
pub mod judge;
pub mod reference;
pub mod cost;
pub mod pareto;
pub mod claims;
pub mod ribbon;
pub mod peers;
pub mod report;
pub mod study;
pub mod text;
pub mod page;

/// Why there is no report.
#[derive(Debug, thiserror::Error)]
pub enum CostError {
    /// An axis nobody knows.
    #[error("`{0}` is no axis: grid, newton, step, real, form, search, passes, delta, mesh")]
    Axis(String),
    /// A level its axis does not have.
    #[error("--{axis}: `{word}` is no level of it")]
    Level {
        /// The axis.
        axis: &'static str,
        /// What stood there.
        word: String,
    },
    /// A scene nobody knows.
    #[error("`{0}` is no scene: turn, fall, release, peek")]
    Scene(String),
    /// The oracle has no elimination order for this grid.
    #[error("the seed's equations have no pattern for {0}")]
    NoPattern(axes::GridName),
    /// The core refuses a spec.
    #[error(transparent)]
    Spec(#[from] dogleaf_core::scene::SpecError),
    /// A file of peers that is none.
    #[error("{file}: {reason}")]
    Peers {
        /// Its name.
        file: String,
        /// What is wrong with it.
        reason: String,
    },
}
