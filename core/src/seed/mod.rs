//! The seed's own form of the step: the whole book in one system, an oracle for hosts. Feature `seed`.
//!
//! ```text
//! [ H   Jᵀ  ] [dx]     [ ∇Φ + Jᵀλ ]      Φ = ‖x - x̃‖²_M / 2h² + V(x)
//! [ J  -δ I ] [dλ] = - [ C         ]      H = M/h² + ∇²V (+ Σ λ_l ∇²C_l)
//! ```
//!
//! This is Eq. 3 times `M/h²`, which makes it symmetric; `δ` only lets a factorisation without pivoting
//! pass the flat leaf, where the DOG rows lose rank. Unknown are all nodes of the leaf (the spine column
//! without Z), the midline's fifteen nodes and the two ends of the boards; every row of Eq. 5 has its
//! multiplier. Contact acts only after the step, by projection, as Sec. 3.4 has it.
//!
//! | symbol | here |
//! |---|---|
//! | x | [`Pose`], numbered by `number` |
//! | λ | in [`Solver`], from zero in every step |
//! | H, J | emitted by `assemble`, `midline`, `rows`, [`curvature`], stored by [`Matrix`] |
//! | DF⁻¹ | [`Factor`]: `LDLᵀ`, up-looking, on slots fixed when the solver is first used |
//!
//! Source: Book Sec. 3.1-3.4; the merit is RHS19's. Checked by `tests/seed_agrees.rs`.
//!
//! # Hard case
//!
//! With the exact `∇²V` (the default, as in the seed) compressed edges make `H` indefinite. Steps are then
//! cut or refused by the line search, and the report says so.

mod assemble;
mod book;
pub mod curvature;
mod factor;
mod grid;
mod matrix;
mod merit;
mod midline;
mod model;
mod number;
mod pose;
mod rows;
mod settings;
#[rustfmt::skip]
mod slots;
mod step;

pub use book::SeedBook;
pub use factor::Factor;
pub use grid::{Cell, SeedGrid, Table};
pub use matrix::Matrix;
pub use model::Model;
pub use pose::Pose;
pub use settings::SeedSettings;
pub use step::Solver;
