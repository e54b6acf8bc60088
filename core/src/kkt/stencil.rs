//! The sparse matrix while it grows: for each node the blocks to its seven earlier neighbours.
//!
//! A pair of nodes is stored at the later one. "Earlier" is the order of the unknowns: column by
//! column from the spine, tail to head. A star adds to its own column and to those beside it, so three
//! columns are enough: [`Factor::take`](super::Factor::take) moves a finished one into the factor's panels.

use crate::grid::{Grid, Store};
use crate::real::{LANES, Lanes, Num, Real, V3};

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

/// The rows of `S` for three columns of nodes: `63` numbers a node. Where rows travel together they lie side
/// by side, entry by entry; where they travel alone the numbers of a node do.
#[derive(Debug, Clone)]
pub struct Stencil<R: Real, G: Grid>(G::Stencil<R>);

impl<R: Real, G: Grid> Stencil<R, G> {
    /// Zeros.
    pub const ZERO: Self = Self(<G::Stencil<R> as Store<R>>::ZERO);

    /// From an entry of a node to its next.
    const ENTRY: usize = if R::Lanes::WIDTH == 1 { 1 } else { G::KP };
    /// From a node's entries to those of the next in its column.
    const NODE: usize = if R::Lanes::WIDTH == 1 { ENTRIES } else { 1 };
    /// From the first number of a block to behind its last.
    const BLOCK: usize = 8 * Self::ENTRY + R::Lanes::WIDTH;

    #[inline(always)]
    fn place(neighbour: usize, c: usize, d: usize, i: usize, k: usize) -> usize {
        let entry = (neighbour * 3 + c) * 3 + d;
        LANES + i % COLUMNS * (ENTRIES * G::KP) + entry * Self::ENTRY + k * Self::NODE
    }
    /// The block of a pair for the rows that travel together; `shift` moves the rows of the later node.
    #[inline(always)]
    fn block(&mut self, neighbour: usize, i: usize, k: usize, shift: isize) -> Option<&mut [R]> {
        let at = Self::place(neighbour, 0, 0, i, k);
        let at = at.wrapping_add_signed(shift * Self::NODE as isize);
        self.0.as_mut().get_mut(at..at + Self::BLOCK)
    }
    /// The block between the later node `(i, k)` and a neighbour, line by line.
    #[inline(always)]
    pub fn lines(&self, neighbour: usize, i: usize, k: usize) -> [[R; 3]; 3] {
        let at = Self::place(neighbour, 0, 0, i, k);
        let block = self.0.as_ref().get(at..=at + 8 * Self::ENTRY).unwrap_or(&[]);
        let entry = |at: usize| block.get(at * Self::ENTRY).copied().unwrap_or(R::ZERO);
        core::array::from_fn(|c| core::array::from_fn(|d| entry(3 * c + d)))
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
        let Some(numbers) = self.block(neighbour, i, k, shift) else { return };
        add(numbers, Self::ENTRY, neighbour == pair::SELF, block);
    }
    /// Sets the three diagonal entries of a block for the rows that travel together.
    #[inline(always)]
    pub fn set_scalar(&mut self, neighbour: usize, i: usize, k: usize, value: R::Lanes) {
        let Some(numbers) = self.block(neighbour, i, k, 0) else { return };
        for c in 0..3 {
            value.store(numbers, 4 * c * Self::ENTRY);
        }
    }
    /// Adds `Σ_r later[r] · earlier[r]ᵀ`, as [`Stencil::add_block`] does.
    #[inline(always)]
    pub fn add_products(
        &mut self,
        neighbour: usize,
        i: usize,
        k: usize,
        shift: isize,
        later: &[V3<R::Lanes>; 3],
        earlier: &[V3<R::Lanes>; 3],
    ) {
        let Some(numbers) = self.block(neighbour, i, k, shift) else { return };
        let own = neighbour == pair::SELF;
        if R::Lanes::WIDTH > 1 {
            return add(numbers, Self::ENTRY, own, &products(later, earlier));
        }
        let Some(nine) = numbers.first_chunk_mut() else { return };
        if own {
            add_alone::<R, true>(nine, later, earlier);
        } else {
            add_alone::<R, false>(nine, later, earlier);
        }
    }
}

/// `Σ_r a[r] · b[r]ᵀ`.
#[inline(always)]
fn products<T: Num>(a: &[V3<T>; 3], b: &[V3<T>; 3]) -> [[T; 3]; 3] {
    let mut block = [[T::zero(); 3]; 3];
    for (a, b) in a.iter().zip(b) {
        for (line, &ac) in block.iter_mut().zip(&a.0) {
            for (slot, &bd) in line.iter_mut().zip(&b.0) {
                *slot = *slot + ac * bd;
            }
        }
    }
    block
}

/// Adds to a block of entries `entry` apart; of a node with itself only to the lower triangle.
#[inline(always)]
fn add<R: Real>(numbers: &mut [R], entry: usize, own: bool, block: &[[R::Lanes; 3]; 3]) {
    for (c, row) in block.iter().enumerate() {
        for (d, &value) in row.iter().enumerate().filter(|&(d, _)| !own || d <= c) {
            let at = (3 * c + d) * entry;
            (R::Lanes::load(numbers, at) + value).store(numbers, at);
        }
    }
}

/// Adds the products of one pair of nodes whose rows travel alone: one copy of the code for all fifteen.
#[inline(never)]
fn add_alone<R: Real, const OWN: bool>(
    numbers: &mut [R; 9],
    later: &[V3<R::Lanes>; 3],
    earlier: &[V3<R::Lanes>; 3],
) {
    add(numbers, 1, OWN, &products(later, earlier));
}
