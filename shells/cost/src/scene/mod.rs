//! What is simulated: four scenes, and what a run hands over of each.
//!
//! | scene | what | window |
//! |---|---|---|
//! | turn | a lone leaf, hinged at the spine, its corner led over by a hand | while the hand leads |
//! | fall | a lone leaf clamped level, let go | the first half second |
//! | rest | the same leaf at rest, at three weights | at rest |
//! | release | a book: a corner is turned in a second and let go | until it sleeps |
//! | peek | a book: a corner is lifted, held and put back | until it sleeps |

mod book;
mod hand;
mod lone;
mod look;
mod rest;
mod seed;
mod stage;

pub use book::open as open_book;
pub use hand::{Hand, PATH_S};
pub use lone::Lone;
pub use look::{Look, Sim};
pub use rest::{GAMMAS, rest};
pub use stage::{Kind, Stage};

use crate::CostError;
use crate::axes::{Config, Form, GridName, with_types};
use dogleaf_core::seed::SeedGrid;

/// Puts the leaf of a configuration on a stage.
///
/// # Errors
///
/// The seed's equations on a grid they have no pattern for.
pub fn open(stage: &Stage, config: &Config) -> Result<Box<dyn Sim>, CostError> {
    match config.form {
        Form::Ours => Ok(with_types!(config, R, G => lone::boxed::<R, G>(stage, config))),
        Form::Seed { .. } => match config.grid {
            GridName::G6x5 => Ok(of_seed::<dogleaf_core::grid::G6x5>(stage, config)),
            GridName::G8x6 => Ok(of_seed::<dogleaf_core::grid::G8x6>(stage, config)),
            GridName::G11x8 => Ok(of_seed::<dogleaf_core::grid::G11x8>(stage, config)),
            other => Err(CostError::NoPattern(other)),
        },
    }
}

fn of_seed<G: SeedGrid>(stage: &Stage, config: &Config) -> Box<dyn Sim> {
    seed::boxed::<f64, G>(stage, config)
}
