//! `V_bending`: a leaf and a block resist being bent.
//!
//! Two second differences cross at a node, and a mixed one spans each cell:
//!
//! ```text
//! L_x = a (2 x_0 - x⁺ - x⁻)   L_z = b (2 x_0 - z⁺ - z⁻)   T = c (x_00 - x_10 - x_01 + x_11)
//! V = ‖L_x‖² + ‖L_z‖² + 2 χ ⟨L_x, L_z⟩ + ‖T‖²
//! ∂V/∂x_n = 2 s_n (L_x + χ L_z) for a node of the first, and so on
//! ∂²V/∂x_n∂x_m = 2 s_n s_m I within one difference, 2 χ s_n s_m I between the two
//! ```
//!
//! `s_0 = 2a`, `s_± = -a`. The seed has `χ = 1`, no `T`, and `a = √w / l_x`, `b = √w / l_z`: the DOG
//! Laplacian. Its square is the mean curvature's, so a saddle costs nothing but what the DOG rows ask;
//! near the flat state those are of second order and a stiff leaf would sag by a quarter too much.
//! Paper in physical units therefore has the plate's energy, `χ = 0` with `T`: the same on every
//! cylinder, whichever way it is bent, and positive on every saddle.
//!
//! Source: Book Eq. 10; RHS18b for the DOG Laplacian; the plate's form is ours. Border nodes bend along
//! the border, else a free corner hangs on two springs and flops. Checked by `tests/derivatives.rs`.

use crate::real::{Num, V3};

/// `c (2 x_0 - x⁺ - x⁻)`.
#[inline(always)]
pub fn second<T: Num>(x0: V3<T>, plus: V3<T>, minus: V3<T>, c: T) -> V3<T> {
    ((x0 - plus) + (x0 - minus)) * c
}

/// `c (x_00 - x_10 - x_01 + x_11)`.
#[inline(always)]
pub fn mixed<T: Num>([x00, x10, x01, x11]: [V3<T>; 4], c: T) -> V3<T> {
    ((x00 - x10) + (x11 - x01)) * c
}

/// `V` of one node's two differences.
#[inline(always)]
pub fn value<T: Num>(lx: V3<T>, lz: V3<T>, chi: T) -> T {
    lx.norm_sq() + lz.norm_sq() + T::of(2.0) * chi * lx.dot(lz)
}

/// `∂V/∂x_n = 2 s_n L` for a node with coefficient `s_n`; `L` already holds its share of the other.
#[inline(always)]
pub fn gradient<T: Num>(l: V3<T>, s: T) -> V3<T> {
    l * (T::of(2.0) * s)
}

/// The factor of `I` in `∂²V/∂x_n∂x_m = 2 s_n s_m I`.
#[inline(always)]
pub fn hessian<T: Num>(s_n: T, s_m: T) -> T {
    T::of(2.0) * s_n * s_m
}
