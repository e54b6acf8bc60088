//! What may be turned: the axes, their levels, and the configurations made of them.

mod config;
mod grid;
mod levels;
mod parse;

pub(crate) use config::with_types;
pub use config::{Config, Form, MOST_NEWTON, RealName, TOLERANCE};
pub use grid::GridName;
pub(crate) use grid::with_grid;
pub use levels::{AXES, Levels};
