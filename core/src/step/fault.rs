//! Faults of a solve, planted by tests. Feature `faults`.

use crate::grid::Grid;
use crate::kkt::solve::Unknowns;
use crate::real::Real;

/// What goes wrong, and when.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Faults {
    /// Solves that still succeed before one yields no numbers.
    pub(crate) solve_in: Option<u32>,
    /// Searches that still succeed before one finds nothing better.
    pub(crate) search_in: Option<u32>,
    searching: bool,
}

impl Faults {
    /// Nothing goes wrong.
    pub(crate) const NONE: Self = Self { solve_in: None, search_in: None, searching: false };

    /// What a failed factorisation leaves behind.
    pub(super) fn spoil<R: Real, G: Grid>(&mut self, unknowns: &mut Unknowns<R, G>) {
        if due(&mut self.solve_in) {
            unknowns.numbers_mut().fill(R::of(f64::NAN));
        }
        self.searching = due(&mut self.search_in);
    }

    /// Whether this search is the one that finds nothing.
    pub(super) fn no_better(&self) -> bool {
        self.searching
    }
}

fn due(left: &mut Option<u32>) -> bool {
    match left {
        Some(0) => {
            *left = None;
            true
        }
        Some(n) => {
            *n -= 1;
            false
        }
        None => false,
    }
}
