//! `C_binding`: the leaf's spine column sits at its place `q` on the binding edge.
//!
//! ```text
//! C = x_i - ((1 - q) b_1 + q b_2)      ∂C/∂x_i = 1,  ∂C/∂b_1 = -(1 - q),  ∂C/∂b_2 = -q
//! ```
//!
//! per coordinate X and Y; Z never moves. The product's step eliminates these rows: it writes the
//! place into the column. Source: Book Eq. 7. Checked by `tests/derivatives.rs`.

use crate::real::{Num, V2};

/// The place `q` on the binding edge from `b_1` (left) to `b_2` (right).
#[inline(always)]
pub fn place<T: Num>(b1: V2<T>, b2: V2<T>, q: T) -> V2<T> {
    b1 * (T::one() - q) + b2 * q
}

/// Residual of one node.
#[inline(always)]
pub fn residual<T: Num>(x: V2<T>, b1: V2<T>, b2: V2<T>, q: T) -> V2<T> {
    x - place(b1, b2, q)
}

/// Derivatives of either coordinate by the node, by `b_1` and by `b_2`.
#[inline(always)]
pub fn gradient<T: Num>(q: T) -> [T; 3] {
    [T::one(), q - T::one(), -q]
}

/// Where the leaf is bound: leaves to its left, plus half of those it stands for, over all leaves.
///
/// `q = (left + held / 2) / all`, in `[0, 1]`; one half for a book without leaves.
pub fn progress(left: u32, held: u32, all: u32) -> f64 {
    if all == 0 {
        0.5
    } else {
        ((f64::from(left) + 0.5 * f64::from(held)) / f64::from(all)).larger(0.0).smaller(1.0)
    }
}
