//! Where rows and entries of the matrix lie in the panels of [`Factor`](super::Factor).

use crate::grid::{Grid, Panel};
use crate::real::LANES;

/// Where a panel lies in the factor.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// First stored column, a multiple of eight.
    pub(super) stored: usize,
    /// First column any of its rows touches.
    pub(super) first: usize,
    /// First column any of its second four rows touches.
    pub(super) second: usize,
    /// Its numbers: eight a column, its diagonal block last.
    pub(super) start: usize,
    pub(super) end: usize,
}

impl Place {
    #[inline(always)]
    pub(super) fn of<G: Grid>(p: usize) -> Self {
        let panel = G::PANELS.get(p).copied().unwrap_or(Panel { first: 0, second: 0, offset: 0 });
        let [first, second] = [panel.first, panel.second].map(usize::from);
        let stored = first / LANES * LANES;
        let start = panel.offset as usize * LANES;
        Self { stored, first, second, start, end: start + ((p + 1) * LANES - stored) * LANES }
    }
    /// Where the entry of a row of this panel in `column` is stored.
    #[inline(always)]
    pub(super) fn entry(&self, row: usize, column: usize) -> usize {
        self.start + (column - self.stored) * LANES + row % LANES
    }
    /// Where its diagonal block begins.
    #[inline(always)]
    pub(super) fn diagonal(&self) -> usize {
        self.end - LANES * LANES
    }
}

/// The unknown that is coordinate `c` of node `(i, k)`.
#[inline(always)]
pub(super) fn unknown<G: Grid>(i: usize, k: usize, c: usize) -> usize {
    3 * ((i - 1) * G::NZ + k) + c
}
