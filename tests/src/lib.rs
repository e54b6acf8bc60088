//! What the tests share.

pub mod case;
pub mod depth;
pub mod gesture;
pub mod watch;
pub mod dense;
pub mod differences;
pub mod posed;
pub mod random;
pub mod stack;
pub mod house;
