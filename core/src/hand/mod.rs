//! What the reader does: looks, presses, drags, lets go.

pub mod guide;
pub mod pick;
pub mod place;
pub mod sample;
pub mod tent;
pub mod view;

pub use guide::{Guide, Pull, Reach};
pub use place::Place;
pub use sample::{Phase, Sample};
pub use view::{Camera, View};
