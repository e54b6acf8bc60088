//! Which unknown and which row of C has which number.
//!
//! Unknowns: the leaf column by column from the spine, each tail to head (the spine column X and Y, the
//! others X, Y, Z); the left block from the binding outwards, the right block, the centre of the binding,
//! the ends of the left and the right board. Rows: stars in the order of their nodes, lengths, binding, fix.

use crate::grid::Grid;
use crate::state::strip::BLOCK;

/// Rows of `C_iso2D`: six edges a block, the binding edge, two boards.
pub(super) const LENGTHS: usize = 2 * (BLOCK - 1) + 3;

/// A node's first unknown, and how many it has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Node {
    pub(super) at: usize,
    pub(super) dims: usize,
}

/// Node `(i, k)` of the leaf.
pub(super) fn leaf<G: Grid>(i: usize, k: usize) -> Node {
    match i.checked_sub(1) {
        None => Node { at: 2 * k, dims: 2 },
        Some(i) => Node { at: 2 * G::NZ + 3 * (i * G::NZ + k), dims: 3 },
    }
}

/// Unknowns of the leaf.
pub(super) fn leaf_unknowns<G: Grid>() -> usize {
    3 * G::NX * G::NZ - G::NZ
}

/// Node `j` of a block, from the binding outwards; node 0 is the binding's end `b_1` or `b_2`.
pub(super) fn block<G: Grid>(side: usize, j: usize) -> Node {
    Node { at: leaf_unknowns::<G>() + 2 * (BLOCK * side + j), dims: 2 }
}

/// The fifteenth node of the midline, in the middle of the binding edge.
pub(super) fn centre<G: Grid>() -> Node {
    Node { at: leaf_unknowns::<G>() + 4 * BLOCK, dims: 2 }
}

/// The free end of a board.
pub(super) fn board<G: Grid>(side: usize) -> Node {
    Node { at: leaf_unknowns::<G>() + 4 * BLOCK + 2 + 2 * side, dims: 2 }
}

/// The first row of `C_DOG`: also the count of unknowns.
pub(super) fn stars<G: Grid>() -> usize {
    leaf_unknowns::<G>() + 4 * BLOCK + 6
}

/// The first row of `C_iso2D`.
pub(super) fn lengths<G: Grid>() -> usize {
    stars::<G>() + 3 * (G::NX - 2) * (G::NZ - 2)
}

/// The first row of `C_binding`: those of the spine column, then those of the centre, which is bound at one half.
pub(super) fn binding<G: Grid>() -> usize {
    lengths::<G>() + LENGTHS
}

/// The first of the two rows of `C_fix`.
pub(super) fn fix<G: Grid>() -> usize {
    binding::<G>() + 2 * G::NZ + 2
}
