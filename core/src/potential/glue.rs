//! `V_glue`: the glue at the binding holds the blocks' first edges upright.
//!
//! ```text
//! c = ⟨n, d⟩ / l      V = w (c - 1)²      ∂V/∂x_1 = 2 w (c - 1) n / l      ∂²V ≈ 2 w n nᵀ / l²
//! ```
//!
//! `n` is the unit normal of the binding edge, `d = x_1 - x_0` the first edge and `l` its rest
//! length: the hard length row keeps `‖d‖ = l`, so dividing by the constant is the seed's
//! normalisation without its second derivatives. The Hessian is then exact, and semidefinite.
//!
//! Source: Book Eq. 11. Checked by `tests/derivatives.rs`.

use crate::real::{Num, V2};

/// Value and derivatives with respect to the edge's free node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Glue<T> {
    /// `V`.
    pub value: T,
    /// `∂V/∂x_1`.
    pub gradient: V2<T>,
    /// `∂²V/∂x_1²` as `[xx, xy, yy]`.
    pub hessian: [T; 3],
}

/// Evaluates the glue of one block.
#[inline(always)]
pub fn edge<T: Num>(d: V2<T>, n: V2<T>, rest: T, w: T) -> Glue<T> {
    let s = n * (T::one() / rest);
    let gap = s.dot(d) - T::one();
    let two_w = T::of(2.0) * w;
    Glue {
        value: w * gap * gap,
        gradient: s * (two_w * gap),
        hessian: [two_w * s.0[0] * s.0[0], two_w * s.0[0] * s.0[1], two_w * s.0[1] * s.0[1]],
    }
}
