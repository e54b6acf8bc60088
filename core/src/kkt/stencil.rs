//! The sparse matrix while it grows: for each node the blocks to its seven earlier neighbours.
//!
//! A pair of nodes is stored at the later one. "Earlier" is the order of the unknowns: column by
//! column from the spine, tail to head. A star adds to its own column and to those beside it, so three
//! columns are enough: [`Factor::take`](super::Factor::take) moves a finished one into the factor's panels.

use crate::grid::{Grid, Store};
use crate::real::{LANES, Lanes, Real};

/// Steps `(di, dk)` from a node back to the earlier node of a pair; the first is the node itself.
pub const NEIGHBOURS: [(usize, isize); 7] =
    [(0, 0), (0, 1), (0, 2), (1, -1), (1, 0), (1, 1), (2, 0)];

/// Which of [`NEIGHBOURS`] a pair is. One constant a pair keeps the assembly readable.
pub mod pair {
    /// The node itself.
    pub const SELF: usize = 0;
    /// One row towards the tail.
    pub const ROW: usize = 1;
    /// Two rows towards the tail.
    pub const ROW2: usize = 2;
    /// One column towards the spine, one row towards the head.
    pub const HEADWARD: usize = 3;
    /// One column towards the spine.
    pub const COLUMN: usize = 4;
    /// One column towards the spine, one row towards the tail.
    pub const TAILWARD: usize = 5;
    /// Two columns towards the spine.
    pub const COLUMN2: usize = 6;
}

/// Numbers a node has: seven neighbours of nine.
const ENTRIES: usize = 63;
/// Columns kept.
const COLUMNS: usize = 3;

/// The rows of `S` for three columns of nodes: `63` numbers a node, rows of a column side by side.
#[derive(Debug, Clone)]
pub struct Stencil<R: Real, G: Grid>(G::Stencil<R>);

impl<R: Real, G: Grid> Stencil<R, G> {
    /// Zeros.
    pub const ZERO: Self = Self(<G::Stencil<R> as Store<R>>::ZERO);

    #[inline(always)]
    fn place(neighbour: usize, c: usize, d: usize, i: usize, k: usize) -> usize {
        LANES + (((i % COLUMNS * 7 + neighbour) * 3 + c) * 3 + d) * G::KP + k
    }
    /// Entry between coordinate `c` of the later node `(i, k)` and `d` of its neighbour.
    #[inline(always)]
    pub fn at(&self, neighbour: usize, c: usize, d: usize, i: usize, k: usize) -> R {
        self.0.as_ref().get(Self::place(neighbour, c, d, i, k)).copied().unwrap_or(R::ZERO)
    }
    /// Adds to one entry.
    #[inline(always)]
    pub fn add(&mut self, neighbour: usize, c: usize, d: usize, i: usize, k: usize, value: R) {
        if let Some(slot) = self.0.as_mut().get_mut(Self::place(neighbour, c, d, i, k)) {
            *slot += value;
        }
    }
    /// Zeros in the rows of column `i`.
    #[inline(always)]
    pub fn clear(&mut self, i: usize) {
        let start = Self::place(0, 0, 0, i, 0);
        if let Some(column) = self.0.as_mut().get_mut(start..start + ENTRIES * G::KP) {
            column.fill(R::ZERO);
        }
    }
    /// Adds a 3x3 block for the rows that travel together; `shift` moves the rows of the later node. Of a
    /// node with itself only the lower triangle is kept.
    #[inline(always)]
    pub fn add_block(
        &mut self,
        neighbour: usize,
        i: usize,
        k: usize,
        shift: isize,
        block: &[[R::Lanes; 3]; 3],
    ) {
        for (c, row) in block.iter().enumerate() {
            for (d, &value) in row.iter().enumerate() {
                if neighbour == pair::SELF && d > c {
                    continue;
                }
                let at = Self::place(neighbour, c, d, i, k).wrapping_add_signed(shift);
                let sum = R::Lanes::load(self.0.as_ref(), at) + value;
                sum.store(self.0.as_mut(), at);
            }
        }
    }
    /// Sets the three diagonal entries of a block for the rows that travel together.
    #[inline(always)]
    pub fn set_scalar(&mut self, neighbour: usize, i: usize, k: usize, value: R::Lanes) {
        for c in 0..3 {
            value.store(self.0.as_mut(), Self::place(neighbour, c, c, i, k));
        }
    }
}
