//! What the tests share.

pub mod case;
pub mod chains;
pub mod depth;
pub mod elastica;
pub mod gesture;
pub mod golden;
pub mod watch;
pub mod dense;
pub mod differences;
pub mod posed;
pub mod random;
pub mod stack;
pub mod house;
pub mod soak;
pub mod crc;
pub mod scenario;
pub mod app;
pub mod ribbons;
