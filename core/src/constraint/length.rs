//! `C_iso2D`: edges of the midline and of the cover keep their length.
//!
//! ```text
//! C = (‖x_i - x_j‖² - r) / r      ∂C/∂x_i = 2 (x_i - x_j) / r      ∂C/∂x_j its negative
//! ```
//!
//! Divided by the squared rest length `r`, so that the row is a pure number like the others.
//! Source: Book Eq. 6. Checked by `tests/derivatives.rs`.

use crate::real::{Num, V2};

/// Residual and derivative by the first node; by the second it is opposite.
#[inline(always)]
pub fn row<T: Num>(e: V2<T>, rest_sq: T) -> (T, V2<T>) {
    let s = T::one() / rest_sq;
    ((e.norm_sq() - rest_sq) * s, e * (T::of(2.0) * s))
}
