//! Grids: how many nodes a leaf has, and everything that follows from it, fixed when the program is built.
//!
//! A grid is a type; its sizes, its arrays and the pattern of its factor stand in `slots.rs`, which
//! `cargo ci slots` generates. Node `(i, k)` is the `i`-th from the spine, the `k`-th from the tail.
//!
//! Rows of a column lie side by side, padded to whole lanes, so that eight of them travel together.

#[rustfmt::skip]
mod slots;

pub use slots::{G6x5, G8x6, G11x8, G12x9, G16x12, G22x16, G32x24};

use crate::real::{LANES, Real};
use core::fmt::Debug;

/// Eight rows of the factor: stored column by column from the first one they touch to the diagonal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Panel {
    /// First column any of its rows touches; the column of its eight is the first stored.
    pub first: u16,
    /// First column any of the second four of its rows touches, at most its own first row.
    pub second: u16,
    /// Vectors of eight stored before this panel.
    pub offset: u32,
}

/// An array of a size fixed by a grid, usable in constants.
pub trait Store<R>: AsRef<[R]> + AsMut<[R]> + Clone + Debug {
    /// All zeros.
    const ZERO: Self;
}

impl<R: Real, const N: usize> Store<R> for [R; N] {
    const ZERO: Self = [R::ZERO; N];
}

/// Sizes and pattern of one grid. Implemented by `cargo ci slots` only.
pub trait Grid: Copy + Debug + Default + PartialEq + Send + Sync + 'static {
    /// Nodes from spine to fore-edge.
    const NX: usize;
    /// Nodes from tail to head.
    const NZ: usize;
    /// Rows padded to whole lanes.
    const KP: usize;
    /// Unknowns padded to whole panels.
    const ROWS: usize;
    /// Vectors of eight in the factor.
    const VECTORS: usize;
    /// The pattern of the factor.
    const PANELS: &'static [Panel];
    /// One number a node.
    type Scalars<R: Real>: Store<R>;
    /// Three numbers a node.
    type Vectors<R: Real>: Store<R>;
    /// Seven neighbours of nine numbers for the nodes of three columns: the matrix while it grows.
    type Stencil<R: Real>: Store<R>;
    /// The matrix, then its factor.
    type Factor<R: Real>: Store<R>;
    /// One number an unknown.
    type Unknowns<R: Real>: Store<R>;

    /// Unknown coordinates: the column at the spine is held.
    const UNKNOWNS: usize = 3 * Self::NZ * (Self::NX - 1);
}

/// Place of node `(i, k)` among scalars.
#[inline(always)]
pub(crate) fn scalar_at<G: Grid>(i: usize, k: usize) -> usize {
    LANES + i * G::KP + k
}

/// Place of coordinate `c` of node `(i, k)` among vectors.
#[inline(always)]
pub(crate) fn vector_at<G: Grid>(i: usize, c: usize, k: usize) -> usize {
    LANES + (3 * i + c) * G::KP + k
}
