//! Draws an open book in software, so that the picture looks like paper, and writes animations of it.
//!
//! No GPU and no system library: the same bytes on any machine and any number of threads. One
//! [`Renderer`] draws [`Patch`]es (triangles with a [`Material`]) under [`Lights`] as a [`Camera`]
//! sees them; [`anim::Writer`] turns frames into a file.
//!
//! # The way of a frame
//!
//! Triangles are placed, cut at the near plane and sorted into tiles; every sample keeps the number
//! of its nearest triangle; each pixel shades each surface it sees once, by the seed's Eq. 15
//! ([`shade`]). The lamp throws soft shadows, the room is pre-integrated and dimmed by what stands in
//! the way.
//!
//! # Why a rasteriser of our own
//!
//! `euc` 0.5.3 was looked at first. It divides by `w` without cutting at the near plane, so a table
//! that reaches behind the camera cannot be drawn; it runs the fragment program on every triangle
//! that is not yet hidden, so that overdrawn paper pays for its shadows; it has one sample a pixel,
//! one thread, and tells the program neither its neighbours' texture places nor its coverage, without
//! which print on a bent page turns to grey or to glitter. All of that lies inside its one loop,
//! which would have to be replaced whole.

pub mod anim;
mod camera;
mod environment;
mod error;
mod fast;
mod hit;
mod lattice;
mod light;
mod lighting;
mod material;
mod parallel;
mod patch;
mod pixel;
mod raster;
mod renderer;
pub mod shade;
mod shadow;
mod texture;
mod tone;

pub use camera::Camera;
pub use environment::Environment;
pub use error::{AnimError, RenderError};
pub use glam::Vec3;
pub use light::{Lights, PointLight};
pub use material::{Material, PAPER_ALPHA, PAPER_TINT};
pub use patch::Patch;
pub use renderer::{MAX_SIDE, Renderer, Stats};
pub use texture::{MAX_TEXTURE_SIDE, Texture};
