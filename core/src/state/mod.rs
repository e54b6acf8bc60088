//! What is so: positions and velocities of the leaf and of the midline.

pub mod field;
pub mod hash;
pub mod leaf;
pub mod sheet;
pub mod strip;

pub use field::{Field, Heights};
pub use hash::Fnv;
pub use leaf::{Grab, Leaf, Root, Sheet, Stretch};
