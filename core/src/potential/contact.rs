//! `V_contact`: what the last collision pass pushed away stays away during the next solve.
//!
//! Without it the solve drives nodes deep into a block and the pass after it drags them back: that,
//! not the net, is what stretches the seed's leaf. Source: ours. Checked by `tests/derivatives.rs`.

use crate::real::{Num, V2};

/// `V = w (n·x - o)²`: `n` the unit direction of the push, `o` where it left the node.
#[inline(always)]
pub fn value<T: Num>(x: V2<T>, n: V2<T>, o: T, w: T) -> T {
    let d = n.dot(x) - o;
    w * d * d
}

/// `∂V/∂x = 2 w (n·x - o) n`.
#[inline(always)]
pub fn gradient<T: Num>(x: V2<T>, n: V2<T>, o: T, w: T) -> V2<T> {
    n * (T::of(2.0) * w * (n.dot(x) - o))
}

/// `∂²V/∂x² = 2 w n nᵀ` as `[xx, xy, yy]`.
#[inline(always)]
pub fn hessian<T: Num>(n: V2<T>, w: T) -> [T; 3] {
    let s = n * (T::of(2.0) * w);
    [s.0[0] * n.0[0], s.0[0] * n.0[1], s.0[1] * n.0[1]]
}
