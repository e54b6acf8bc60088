//! `V_pos`: the hand pulls the node it holds. Source: Book Eq. 14. Checked by `tests/derivatives.rs`.
//!
//! The pull grows with the distance without limit; [`hand`](crate::hand) keeps the target near.

use crate::real::{Num, V3};

/// `V = w ‖x - p‖²`.
#[inline(always)]
pub fn value<T: Num>(x: V3<T>, p: V3<T>, w: T) -> T {
    w * (x - p).norm_sq()
}

/// `∂V/∂x = 2 w (x - p)`.
#[inline(always)]
pub fn gradient<T: Num>(x: V3<T>, p: V3<T>, w: T) -> V3<T> {
    (x - p) * (T::of(2.0) * w)
}

/// The factor of `I` in `∂²V/∂x² = 2 w I`.
#[inline(always)]
pub fn hessian<T: Num>(w: T) -> T {
    T::of(2.0) * w
}
