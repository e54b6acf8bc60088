#![doc = include_str!("../README.md")]

#[cfg(target_os = "android")]
mod android;
mod error;
pub mod gesture;
mod gl;
mod glsl;
pub mod headless;
mod keys;
mod pages;
mod recorder;
pub mod renderer;
mod script;
mod shape;
pub mod shot;
mod surface;
pub mod view;
pub mod window;

pub use error::{DesktopError, one_line};
pub use gl::Gl;
pub use recorder::Recorder;
pub use renderer::{BookRenderer, DrawError, Lamp, Leaves, Scene, Stage};
pub use script::Script;
pub use view::{BookView, Options};
