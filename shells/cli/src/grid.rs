//! Which grid a scene asks for, and the way from its name to its type.

use std::fmt;

/// A grid the core has a pattern for: nodes from spine to fore-edge by nodes from tail to head.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum GridName {
    G6x5,
    G8x6,
    #[default]
    G11x8,
    G12x9,
    G16x12,
    G22x16,
    G32x24,
}

/// Evaluates an expression with a type that stands for the named grid.
macro_rules! with_grid {
    ($grid:expr, $g:ident => $body:expr) => {
        with_grid!(@ $grid, $g => $body; G6x5 G8x6 G11x8 G12x9 G16x12 G22x16 G32x24)
    };
    (@ $grid:expr, $g:ident => $body:expr; $($name:ident)+) => {
        match $grid {
            $($crate::grid::GridName::$name => {
                type $g = dogleaf_core::grid::$name;
                $body
            })+
        }
    };
}
pub(crate) use with_grid;

impl GridName {
    /// All of them, coarse to fine.
    pub(crate) const ALL: [Self; 7] = [
        Self::G6x5,
        Self::G8x6,
        Self::G11x8,
        Self::G12x9,
        Self::G16x12,
        Self::G22x16,
        Self::G32x24,
    ];

    /// Nodes across and along.
    pub(crate) fn size(self) -> [usize; 2] {
        use dogleaf_core::grid::Grid;
        with_grid!(self, G => [G::NX, G::NZ])
    }

    /// The grid of this size.
    pub(crate) fn of(size: [f64; 2]) -> Option<Self> {
        Self::ALL.into_iter().find(|g| g.size().map(|n| n as f64) == size)
    }
}

impl fmt::Display for GridName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [nx, nz] = self.size();
        write!(f, "{nx}x{nz}")
    }
}
