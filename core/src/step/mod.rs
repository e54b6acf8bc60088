//! One implicit step, Eq. 2-4.
//!
//! Minimise `Φ(x) = ‖x - x̃‖²_M / 2h² + V(x)` subject to `C(x) = 0`, one Newton step from the last
//! positions with `λ = 0`, multipliers regularised by `-δ I` and eliminated:
//!
//! ```text
//! S dx = -(g + Jᵀ C / δ)     S = H + Jᵀ J / δ     λ = (C + J dx) / δ
//! ```
//!
//! `S` is positive definite also where the DOG rows lose rank (the flat leaf). Then a merit line
//! search, and the collision pass decides the velocities.

pub mod ask;
pub mod constant;
mod bend;
#[cfg(feature = "faults")]
mod fault;
pub mod assemble;
pub mod leaf;
pub mod matrix;
pub mod merit;
pub mod report;
mod star;
pub mod strip;

pub use ask::Ask;
pub use leaf::Solver;
pub use report::{StepReport, StepStatus};
