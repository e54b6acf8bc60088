//! The sparse matrix before it is factored: for each node the blocks to its seven earlier neighbours.
//!
//! A pair of nodes is stored at the later one. "Earlier" is the order of the unknowns: column by
//! column from the spine, tail to head.

use crate::grid::{Grid, Store};
use crate::real::{LANES, Lanes, Num, Real};

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

/// `S` by neighbour: `63` numbers a node, eight rows side by side.
#[derive(Debug, Clone)]
pub struct Stencil<R: Real, G: Grid>(G::Stencil<R>);

impl<R: Real, G: Grid> Stencil<R, G> {
    /// Zeros.
    pub const ZERO: Self = Self(<G::Stencil<R> as Store<R>>::ZERO);

    #[inline(always)]
    fn place(neighbour: usize, c: usize, d: usize, i: usize, k: usize) -> usize {
        LANES + (((neighbour * 3 + c) * 3 + d) * G::NX + i) * G::KP + k
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
    /// Adds a 3x3 block, eight rows at a time; `shift` moves the rows of the later node.
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
                let at = Self::place(neighbour, c, d, i, k).wrapping_add_signed(shift);
                let sum = R::Lanes::load(self.0.as_ref(), at) + value;
                sum.store(self.0.as_mut(), at);
            }
        }
    }
    /// Sets the three diagonal entries of a block, eight rows at a time, and clears the other six.
    #[inline(always)]
    pub fn set_scalar(&mut self, neighbour: usize, i: usize, k: usize, value: R::Lanes) {
        for c in 0..3 {
            for d in 0..3 {
                let v = if c == d { value } else { R::Lanes::zero() };
                v.store(self.0.as_mut(), Self::place(neighbour, c, d, i, k));
            }
        }
    }
    /// Zeros everywhere.
    pub fn clear(&mut self) {
        self.0.as_mut().fill(R::ZERO);
    }
    /// Calls `visit(row, column, value)` for every stored entry of the lower triangle between unknowns.
    pub fn entries(&self, mut visit: impl FnMut(usize, usize, R)) {
        let unknown = |i: usize, k: usize, c: usize| 3 * ((i - 1) * G::NZ + k) + c;
        for i in 1..G::NX {
            for k in 0..G::NZ {
                for (n, &(di, dk)) in NEIGHBOURS.iter().enumerate() {
                    let Some(j) = i.checked_sub(di).filter(|&j| j >= 1) else { continue };
                    let Some(l) = k.checked_add_signed(-dk).filter(|&l| l < G::NZ) else {
                        continue;
                    };
                    for c in 0..3 {
                        let last = if n == pair::SELF { c } else { 2 };
                        for d in 0..=last {
                            visit(unknown(i, k, c), unknown(j, l, d), self.at(n, c, d, i, k));
                        }
                    }
                }
            }
        }
    }
}
