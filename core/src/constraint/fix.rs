//! `C_fix`: the centre of the binding edge stays where it is.
//!
//! ```text
//! C = (b_1 + b_2) / 2 - p      ∂C/∂b_1 = ∂C/∂b_2 = 1/2
//! ```
//!
//! Source: Book Eq. 8. The product's step holds both ends of the binding edge instead, because a
//! spine that may turn about its centre throws the leaf out for books open near an end; see
//! `ARCHITECTURE.md`, "The spine". Checked by `tests/derivatives.rs`.

use crate::real::{Num, V2};

/// Residual.
#[inline(always)]
pub fn residual<T: Num>(b1: V2<T>, b2: V2<T>, p: V2<T>) -> V2<T> {
    (b1 + b2) * T::of(0.5) - p
}

/// Derivative of either coordinate by either end.
#[inline(always)]
pub fn gradient<T: Num>() -> T {
    T::of(0.5)
}
