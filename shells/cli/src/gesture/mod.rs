//! Gestures: pointer samples as lines of JSON, and those this program makes itself.

pub(crate) mod builtin;
mod fixtures;
mod lines;
pub(crate) mod path;
mod wild;

pub(crate) use fixtures::write_all;
pub(crate) use lines::{GestureError, load};
