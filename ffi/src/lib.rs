//! dogleaf for Kotlin and Swift: a [`Book`] that an app feeds with fingers and time, and whose mesh it draws.
//!
//! ```text
//! per frame    pointers(samples)    fingers since the last frame, if any
//!              step(now)            -> draw? another frame? which generation of the mesh? notices waiting?
//!              notices()            only if some wait
//!              pieces()             only if `pieces_generation` moved
//! once         mesh(), indices()    addresses: they stay, as long as the object does
//! ```
//!
//! Nothing calls back, nothing waits, no list of floats crosses. A panic below becomes an error and a book put
//! back to rest ([`DogleafError::Panicked`]); a book that was shut answers [`DogleafError::Closed`] to everything.
//!
//! This is the only crate that names uniffi. `cargo ci bindings` writes what it makes of it.

// uniffi's scaffolding exports its functions by name, which the language calls unsafe. None of ours is.
#![allow(unsafe_code)]

mod book;
mod desk;
mod eink;
mod error;
mod frame;
mod journal;
mod life;
mod mesh;
mod notice;
mod options;
mod pointer;
mod stage;
mod words;

pub use book::Book;
pub use eink::{PanelOptions, PanelUpdate, Waveform, panel_options};
pub use error::DogleafError;
pub use frame::{FrameInfo, StepStatus};
pub use mesh::{IndexView, MeshView, Piece, PieceFace, Surface};
pub use notice::{Notice, Tick};
pub use options::{
    BookOptions, Cover, Direction, Fidelity, Layout, Motion, MotionPolicy, Paper, book_options,
};
pub use pointer::{Phase, PointerSample};
pub use stage::{Gaze, Stage};
pub use words::FrameWords;

uniffi::setup_scaffolding!();

/// Version of dogleaf.
#[uniffi::export]
#[must_use]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
