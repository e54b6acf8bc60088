//! What must not overlap: leaf and blocks, block and board, board and table. Book Sec. 3.4.
//!
//! Everything is decided in the plane of the midline by distances of points to lines. After a step at
//! most three passes detect and resolve; what a pass pushed is remembered and held in the next solve.

pub mod block;
pub mod leaf;
pub mod profile;

pub use profile::Profile;
