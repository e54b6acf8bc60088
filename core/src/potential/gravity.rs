//! `V_gravity`: weight. Source: Book Eq. 12. Checked by `tests/derivatives.rs`.

use crate::real::{Num, V3};

/// `V = -m a·x`; the Hessian is zero.
///
/// `a` is the acceleration of free fall as a vector: `(0, -g, 0)` gives the seed's `g m y`.
#[inline(always)]
pub fn value<T: Num>(m: T, a: V3<T>, x: V3<T>) -> T {
    -(m * a.dot(x))
}

/// `∂V/∂x = -m a`.
#[inline(always)]
pub fn gradient<T: Num>(m: T, a: V3<T>) -> V3<T> {
    -(a * m)
}
