//! Developable ribbons in ruling-bending coordinates: a bookmark, a bow, a Möbius band.
//!
//! A ribbon is a strip cut by straight rulings; its unknowns are each ruling's slope `c` and the angle `ψ` it is bent by.
//! So it cannot stretch: every step is exactly isometric. A step minimises inertia, bending and loads at once, by Newton's
//! method whose linear solve is one backward and one forward sweep, linear in the number of segments.
//!
//! | file | question |
//! |---|---|
//! | `spec` | what is asked, in SI |
//! | `strip` | what one cell is made of |
//! | `elementary`, `frame`, `joint` | logarithms, frames and twists, one crease |
//! | `resample` | where a point of the flat ribbon was bound for |
//! | `inertia`, `bending`, `load`, `barrier`, `closure` | one energy each: value and derivatives |
//! | `body` | the ribbon while it is solved for |
//! | `assemble`, `forces` | the model of a few cells at a time; what else pulls at one |
//! | `riccati`, `sweep`, `mend` | the linear solve; that of a loop's joint alone |
//! | `roll` | a trial: a share of the step, answering to where it leads |
//! | `contact` | what pushes back, and what no step may pass through |
//! | `adjoint` | the gradient alone, for oracles |
//! | `newton`, `report`, `fidelity` | the method, its limits and its answer; what accuracy costs |
//! | `life` | [`Ribbon`]: what a caller holds |
//! | `energy`, `momentum` | what it has of both; a step that keeps the latter |
//! | `event` | what a step sounds like |
//! | `record` | its steps as a file that can be played again |
//! | `bookmark` | the ribbon sewn to a book |
//!
//! Source: the seed's "Modelling Developable Ribbons Using Ruling Bending Coordinates", cited as Ribbon.

pub mod spec;
pub mod strip;
pub mod elementary;
pub mod frame;
pub mod joint;
pub mod resample;
pub mod load;
pub mod inertia;
pub mod bending;
pub mod barrier;
pub mod closure;
pub mod riccati;
pub mod body;
pub mod forces;
pub mod assemble;
pub mod sweep;
pub mod adjoint;
pub mod contact;
pub mod mend;
pub mod roll;
pub mod report;
pub mod fidelity;
pub mod newton;
pub mod life;
pub mod energy;
pub mod momentum;
pub mod event;
pub mod record;
pub mod bookmark;

pub use life::Ribbon;
pub use load::{Ask, Guide, Loads, Pull, Spring};
pub use report::{Report, Settings, Status};
pub use spec::{Bending, Closure, Mass, Resample, RibbonSpec, Root};
