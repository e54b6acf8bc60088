//! What one frame shows, in SI units: as it stands in a line of JSON.

use dogleaf_core::event::Event;
use dogleaf_core::grid::Grid;
use dogleaf_core::real::Real;
use dogleaf_core::scene::Units;
use dogleaf_core::state::{Field, Leaf, Stretch};
use serde::Serialize;

/// Everything of a scene that a frame shows; parts that are not there are absent.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Pose {
    /// State hash, 16 hex digits.
    pub(crate) hash: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) leaf: Option<LeafNodes>,
    /// Fifteen nodes from the left fore-edge to the right one, metres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) midline: Option<Vec<[f64; 2]>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) ribbons: Vec<Rims>,
    pub(crate) stretch: Strain,
    pub(crate) energy: Energy,
    pub(crate) events: Vec<EventName>,
}

/// The leaf's nodes, column by column from the spine, each tail to head, metres.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct LeafNodes {
    pub(crate) nx: usize,
    pub(crate) nz: usize,
    pub(crate) nodes: Vec<[f64; 3]>,
}

impl LeafNodes {
    pub(crate) fn of<R: Real, G: Grid>(leaf: &Leaf<R, G>, units: &Units) -> Self {
        let metres = |(i, k)| leaf.x.at(i, k).0.map(|c| units.to_metres(c.wide()));
        Self { nx: G::NX, nz: G::NZ, nodes: Field::<R, G>::nodes().map(metres).collect() }
    }
}

/// A ribbon's two borders from its start to its end, metres, and what its steps came to.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Rims {
    pub(crate) rim_a: Vec<[f64; 3]>,
    pub(crate) rim_b: Vec<[f64; 3]>,
    /// How the worst solve of the frame ended.
    pub(crate) status: &'static str,
    pub(crate) work: RibbonWork,
    /// How far a loop is from closed: radians, or share of its length.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) gap: Option<f64>,
    pub(crate) stretch: Strain,
    pub(crate) energy: Energy,
}

/// What a ribbon's frame cost, in counts.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub(crate) struct RibbonWork {
    pub(crate) steps: u32,
    pub(crate) newton_steps: u32,
    pub(crate) factorisations: u32,
    pub(crate) trials: u32,
}

impl RibbonWork {
    /// Adds another frame's.
    pub(crate) fn add(&mut self, o: &Self) {
        self.steps += o.steps;
        self.newton_steps += o.newton_steps;
        self.factorisations += o.factorisations;
        self.trials += o.trials;
    }
}

/// How far the leaf's edges are from their rest length, as a share of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct Strain {
    pub(crate) max: f64,
    pub(crate) rms: f64,
}

impl<R: Real> From<Stretch<R>> for Strain {
    fn from(s: Stretch<R>) -> Self {
        Self { max: s.max().wide(), rms: s.rms().wide() }
    }
}

/// Joules.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct Energy {
    pub(crate) kinetic: f64,
    pub(crate) potential: f64,
}

impl Energy {
    pub(crate) fn of<R: Real>([kinetic, potential]: [R; 2], units: &Units) -> Self {
        let joules = |e: R| units.to_joules(e.wide());
        Self { kinetic: joules(kinetic), potential: joules(potential) }
    }
    /// Together with another's.
    pub(crate) fn and(self, o: Self) -> Self {
        Self { kinetic: self.kinetic + o.kinetic, potential: self.potential + o.potential }
    }
}

/// An event by its name.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(tag = "event", rename_all = "lowercase")]
pub(crate) enum EventName {
    Lifted {
        from_right: bool,
        leaves: u32,
    },
    Held {
        leaves: u32,
    },
    Committed {
        page: u32,
    },
    Cancelled,
    Asleep,
    /// Vertices of a ribbon met something, the fastest at so much.
    Touched {
        ribbon: usize,
        vertices: u32,
        m_per_s: f64,
    },
    /// A ribbon let go of so much bending at once.
    Snapped {
        ribbon: usize,
        joules: f64,
    },
}

impl From<Event> for EventName {
    fn from(event: Event) -> Self {
        match event {
            Event::Lifted { from_right, leaves } => Self::Lifted { from_right, leaves },
            Event::Held { leaves } => Self::Held { leaves },
            Event::Committed { page } => Self::Committed { page },
            Event::Cancelled => Self::Cancelled,
            Event::Asleep => Self::Asleep,
        }
    }
}
