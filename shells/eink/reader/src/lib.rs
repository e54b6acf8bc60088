//! A reader for electronic paper without a machine: a built-in book, a recorded finger, a simulated panel.
//!
//! The same code runs on a host, where its pictures are golden, and in `shells/eink/firmware`, where they must come out the
//! same to the bit; what it does is what an app for electronic paper does:
//!
//! ```text
//! touch ─► Reading ─► Pose ─► Planner: is a picture due? ─► draw, band by band ─► panel
//!             │ the finger is gone: the fall is computed at once, its key frames wait for the panel
//!             └ nothing owed: sleep
//! ```
//!
//! `no_std`, no allocation, nothing that panics. [`Room`] is the caller's to place.
#![no_std]
#![forbid(unsafe_code)]

pub mod built;
pub mod desk;
pub mod fall;
pub mod line;
pub mod room;
pub mod scene;
pub mod touch;

pub use built::Built;
pub use desk::{Desk, Part, Shot, Watch};
pub use room::Room;
pub use touch::Touches;
