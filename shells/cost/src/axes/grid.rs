//! Grids by name, and the way from a name to its type.

use core::fmt;

/// A grid the core has a pattern for: nodes from spine to fore-edge by nodes from tail to head.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub enum GridName {
    /// 6 by 5.
    G6x5,
    /// 8 by 6.
    G8x6,
    /// 11 by 8.
    #[default]
    G11x8,
    /// 12 by 9.
    G12x9,
    /// 16 by 12.
    G16x12,
    /// 22 by 16.
    G22x16,
    /// 32 by 24.
    G32x24,
}

/// Evaluates an expression with a type that stands for the named grid.
macro_rules! with_grid {
    ($grid:expr, $g:ident => $body:expr) => {
        $crate::axes::with_grid!(@ $grid, $g => $body; G6x5 G8x6 G11x8 G12x9 G16x12 G22x16 G32x24)
    };
    (@ $grid:expr, $g:ident => $body:expr; $($name:ident)+) => {
        match $grid {
            $($crate::axes::GridName::$name => {
                type $g = dogleaf_core::grid::$name;
                $body
            })+
        }
    };
}
pub(crate) use with_grid;

impl GridName {
    /// All of them, coarse to fine.
    pub const ALL: [Self; 7] = [
        Self::G6x5,
        Self::G8x6,
        Self::G11x8,
        Self::G12x9,
        Self::G16x12,
        Self::G22x16,
        Self::G32x24,
    ];

    /// Nodes across and along.
    pub fn size(self) -> [usize; 2] {
        use dogleaf_core::grid::Grid;
        with_grid!(self, G => [G::NX, G::NZ])
    }

    /// Unknown coordinates.
    pub fn unknowns(self) -> usize {
        use dogleaf_core::grid::Grid;
        with_grid!(self, G => G::UNKNOWNS)
    }

    /// The grid with this name.
    pub fn of(text: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|g| g.to_string() == text)
    }
}

impl fmt::Display for GridName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [nx, nz] = self.size();
        write!(f, "{nx}x{nz}")
    }
}
