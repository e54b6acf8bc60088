//! `V_iso3D`: keeps the edges of the leaf at their rest length.
//!
//! A DOG may grow and shrink while it stays developable and has too few unknowns to forbid that by
//! hard rows, so length is asked for softly, edge by edge.
//!
//! | symbol | here | meaning |
//! |---|---|---|
//! | x_i - x_j | `e` | the edge |
//! | ‖x_i⁰ - x_j⁰‖² | `rest_sq` | squared rest length |
//! | w_iso3D | `w` | weight |
//!
//! Source: Book Eq. 13. Checked by `tests/derivatives.rs`.

use crate::real::{Num, V3};

/// Value and derivatives of one edge with respect to its first node; the second's are opposite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge<T> {
    /// `V`.
    pub value: T,
    /// `∂V/∂x_i`; `∂V/∂x_j` is its negative.
    pub gradient: V3<T>,
    /// `∂²V/∂x_i²`, rows; the mixed block is its negative.
    pub hessian: [[T; 3]; 3],
}

/// Value only, for the merit function.
#[inline(always)]
pub fn value<T: Num>(e: V3<T>, rest_sq: T, w: T) -> T {
    let t = e.norm_sq() - rest_sq;
    w * t * t
}

/// Evaluates one edge `e = x_i - x_j`.
///
/// ```text
/// V = w t²    t = e·e - r    ∂V = 4 w t e    ∂²V = 8 w e eᵀ + 4 w max(t, 0) I
/// ```
///
/// # Hard case
///
/// The exact Hessian has `4 w t I`: indefinite across a compressed edge. `max(t, 0)` drops that part there:
/// semidefinite, exact on a stretched edge, an upper bound on a compressed one. Pass `exact` to keep the
/// sign (an oracle's need).
#[inline(always)]
pub fn edge<T: Num>(e: V3<T>, rest_sq: T, w: T, exact: bool) -> Edge<T> {
    let t = e.norm_sq() - rest_sq;
    let (w4, w8) = (T::of(4.0) * w, T::of(8.0) * w);
    let diagonal = w4 * if exact { t } else { t.larger(T::zero()) };
    let s = e * w8;
    let outer = |a: T| [a * e.0[0], a * e.0[1], a * e.0[2]];
    let [mut x, mut y, mut z] = [outer(s.0[0]), outer(s.0[1]), outer(s.0[2])];
    x[0] = x[0] + diagonal;
    y[1] = y[1] + diagonal;
    z[2] = z[2] + diagonal;
    Edge { value: w * t * t, gradient: e * (w4 * t), hessian: [x, y, z] }
}
