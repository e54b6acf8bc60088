//! Triangles to samples: which triangle is seen at every sample of the picture.
//!
//! Nothing is shaded here. A sample only keeps the number of its nearest triangle; [`crate::pixel`]
//! then groups the samples of a pixel by surface and shades each group once.

mod clip;
mod cover;
mod geometry;
mod setup;

pub(crate) use cover::{Grid, NONE, draw_band};
pub(crate) use geometry::Geometry;
pub(crate) use setup::{Plane, Triangle};

/// Width of a tile, pixels.
pub(crate) const TILE_WIDTH: usize = 64;
/// Height of a tile and of the bands handed to threads, pixels.
pub(crate) const TILE_HEIGHT: usize = 16;
/// Steps of the fixed-point grid in one pixel.
pub(crate) const SUBPIXELS: i64 = 256;
