//! The condensed matrix of the leaf and its factor, on a pattern fixed when the program is built.
//!
//! Eliminating the multipliers of the regularised Eq. 3-4 leaves `S dx = r` with
//! `S = H + JᵀJ/δ`: symmetric, positive definite, and coupling only nodes at most two steps apart.
//!
//! [`stencil`] holds three columns of `S` by neighbour, as they are assembled; [`factor`] takes them into
//! panels of eight rows and replaces these by the Cholesky factor; [`solve`] does the two substitutions.

pub mod factor;
mod one;
mod place;
pub mod solve;
pub mod stencil;
mod tile;

pub use factor::Factor;
pub use stencil::Stencil;
