//! Chains in the plane of the midline: a page block (seven nodes) and a board of the cover (two).
//!
//! Each side of the book has its own, in outward coordinates: `x` grows from the centre of the binding
//! to the fore-edge on either side, `y` up. So left and right are the same numbers, and mirror each
//! other to the last bit. Node 0 is an end of the binding edge and never moves.

use crate::real::{Real, V2};

/// Nodes of a page block: seven a side, the innermost being the end of the binding; with the
/// binding's fixed centre between the sides they make the midline's fifteen.
pub const BLOCK: usize = 7;
/// Nodes of a board.
pub const BOARD: usize = 2;

/// A chain of `N` nodes, the first held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip<R, const N: usize> {
    /// Positions, outward.
    pub x: [V2<R>; N],
    /// Velocities.
    pub v: [V2<R>; N],
    /// Direction of the last push of each node.
    pub pushed: [V2<R>; N],
    /// Where along it the node was left.
    pub offset: [R; N],
    /// One where that contact acts in the next solve.
    pub holding: [R; N],
}

impl<R: Real, const N: usize> Strip<R, N> {
    /// Nothing.
    pub const ZERO: Self = Self {
        x: [V2([R::ZERO; 2]); N],
        v: [V2([R::ZERO; 2]); N],
        pushed: [V2([R::ZERO; 2]); N],
        offset: [R::ZERO; N],
        holding: [R::ZERO; N],
    };

    /// Lies flat outwards from the binding's end at `from`, at rest.
    pub fn lay(&mut self, from: R, length: R) {
        *self = Self::ZERO;
        for (j, x) in self.x.iter_mut().enumerate() {
            *x = V2([from + length * R::of(j as f64 / (N - 1) as f64), R::ZERO]);
        }
    }
    /// Largest speed.
    pub fn fastest(&self) -> R {
        self.v.iter().fold(R::ZERO, |m, v| m.larger(v.norm_sq())).root()
    }
    /// Stops where it is.
    pub fn stop(&mut self) {
        self.v = [V2([R::ZERO; 2]); N];
    }
}

/// What a chain is made of, in model units, for one leaf's share of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fibre<R> {
    /// Rest length of an edge.
    pub edge: R,
    /// Mass of an inner node; the last has half.
    pub mass: R,
    /// Laplacian coefficient at inner nodes.
    pub bend: R,
    /// Weight of the glue.
    pub glue: R,
}

impl<R: Real> Fibre<R> {
    /// Nothing.
    pub const ZERO: Self = Self { edge: R::ZERO, mass: R::ZERO, bend: R::ZERO, glue: R::ZERO };
}
