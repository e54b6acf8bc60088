//! Where a lone leaf plays: its paper, how it is held, where it starts.

use super::Hand;
use super::lone::Lone;
use crate::axes::{Config, GridName, RealName, with_grid};
use dogleaf_core::grid::Grid;
use dogleaf_core::scene::{PaperSpec, Units};

/// What a lone leaf does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Led over by its corner, hinged.
    Turn,
    /// Let go, clamped level.
    Fall,
}

/// A stage for one grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Stage {
    /// What happens on it.
    pub kind: Kind,
    /// Width and height of the leaf, metres.
    pub size_m: [f64; 2],
    /// Its paper.
    pub paper: PaperSpec,
    /// Rate at which air takes speed, 1/s.
    pub damping_per_s: f64,
    /// Seconds that are watched.
    pub seconds: f64,
    /// Where the nodes are at first, model units, in `f64`.
    pub start: Vec<[f64; 3]>,
}

impl Stage {
    /// The stage on which all configurations on this grid play. A turn starts from where the hand and the weight
    /// have bent the leaf: from a flat one the side it buckles to would decide everything.
    pub fn new(kind: Kind, grid: GridName) -> Self {
        let mut stage = Self::flat(kind);
        with_grid!(grid, G => stage.fill::<G>(grid));
        stage
    }

    /// The same for any grid: the leaf starts straight.
    pub fn flat(kind: Kind) -> Self {
        let (size_m, seconds) = match kind {
            Kind::Turn => ([0.13, 0.20], 1.2),
            Kind::Fall => ([0.15, 0.20], 0.5),
        };
        Self {
            kind,
            size_m,
            paper: PaperSpec::default(),
            damping_per_s: 1.2,
            seconds,
            start: Vec::new(),
        }
    }

    fn fill<G: Grid>(&mut self, grid: GridName) {
        let config = Config { grid, real: RealName::F64, newton: None, ..Config::STANDARD };
        let mut lone = Box::new(Lone::<f64, G>::new(self, &config));
        if self.kind == Kind::Turn {
            lone.come_to_rest();
        }
        self.start = lone.places();
    }

    /// Scales of its leaf.
    pub fn units(&self) -> Units {
        Units::of_leaf(self.size_m[0], self.size_m[1], self.paper.areal_mass_gsm)
    }

    /// The hand, where there is one.
    pub fn hand(&self) -> Option<Hand> {
        (self.kind == Kind::Turn).then(|| Hand::new(0.5 * self.units().length(self.size_m[1])))
    }
}
