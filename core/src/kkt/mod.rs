//! The condensed matrix of the leaf and its factor, on a pattern fixed when the program is built.
//!
//! Eliminating the multipliers of the regularised Eq. 3-4 leaves `S dx = r` with
//! `S = H + JᵀJ/δ`: symmetric, positive definite, and coupling only nodes at most two steps apart.
//!
//! [`stencil`] holds `S` by neighbour, as it is assembled; [`factor`] copies it into panels of eight
//! rows and replaces it by its Cholesky factor; [`solve`] does the two substitutions.

pub mod factor;
pub mod solve;
pub mod stencil;

pub use factor::Factor;
pub use stencil::Stencil;
