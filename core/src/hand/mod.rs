//! What the reader does: looks, presses, drags, lets go.

pub mod guide;
pub mod pick;
pub mod sample;
pub mod tent;
pub mod view;

pub use guide::{Guide, Reach};
pub use sample::{Phase, Sample};
pub use view::{Camera, View};
