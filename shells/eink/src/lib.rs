//! Page turns on electronic paper. A panel shows a handful of pictures a second, each drawn over the ghost of the one
//! before; so of a turn only a few key frames are shown, and each changes as little of the panel as it can.
//!
//! ```text
//! Reading ─► pose: the leaf in whole numbers ─► plan: is it shown now, where, with which waveform
//!                                              │
//!            stage: where pages stand ─► sheet ─► band: page, shadow, leaf, outline ─► dither ─► draw ─► panel
//! ```
//!
//! From the pose on there are only whole numbers: every target draws the same pixels, and one without a floating point
//! unit draws them as fast. [`Strip`] keeps the poses of a whole turn in some kilobytes, so such a target may also be
//! handed turns that were computed elsewhere.
//!
//! `no_std`, no allocation, nothing that panics. Buffers are the caller's.
#![no_std]
#![forbid(unsafe_code)]

pub mod band;
pub mod dither;
pub mod draw;
pub mod panel;
pub mod plan;
pub mod pose;
mod raster;
pub mod rect;
mod root;
pub mod sheet;
pub mod simulated;
pub mod stage;
pub mod strip;

pub use band::{Band, Canvas, Print, Scene};
pub use dither::Depth;
pub use draw::{Ink, draw};
pub use panel::{Panel, PanelError, Waveform};
pub use plan::{Picture, Planner, Policy, Style, Update};
pub use pose::{Faces, Pose};
pub use rect::Rect;
pub use sheet::Sheet;
pub use simulated::Simulated;
pub use stage::{Layout, Stage, StageError};
pub use strip::Strip;
