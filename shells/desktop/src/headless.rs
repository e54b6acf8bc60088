//! A context without a window and without a display: what a machine in a rack draws with.
#![allow(unsafe_code)]

use crate::gl::Gl;
use glutin::api::egl::context::PossiblyCurrentContext;
use glutin::api::egl::device::Device;
use glutin::api::egl::display::Display;
use glutin::config::{Api, ConfigSurfaceTypes, ConfigTemplateBuilder};
use glutin::context::{ContextApi, ContextAttributesBuilder, Version};
use glutin::display::GlDisplay;
use std::ffi::CString;

/// Why there is no such context: EGL's own words.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("there is no display, and EGL draws nothing without one ({0})")]
pub struct HeadlessError(String);

/// Keeps a context current on the thread that made it.
#[derive(Debug)]
pub struct Headless {
    _context: PossiblyCurrentContext,
}

/// Makes a context of OpenGL ES 3.0 on the first device that has one, and makes it current.
///
/// The [`Gl`] is of use as long as the [`Headless`] lives.
///
/// # Errors
///
/// No EGL, no device, no OpenGL ES 3.0.
pub fn headless() -> Result<(Headless, Gl), HeadlessError> {
    let devices = Device::query_devices().map_err(|e| HeadlessError(e.to_string()))?;
    let mut last = "no device".to_owned();
    for device in devices {
        match on(&device) {
            Ok(made) => return Ok(made),
            Err(error) => last = error,
        }
    }
    Err(HeadlessError(last))
}

fn on(device: &Device) -> Result<(Headless, Gl), String> {
    let words = |e: glutin::error::Error| e.to_string();
    // SAFETY: the device comes from EGL itself, and no native display is given.
    let display = unsafe { Display::with_device(device, None) }.map_err(words)?;
    let wanted = ConfigTemplateBuilder::new()
        .with_api(Api::GLES3)
        .with_surface_type(ConfigSurfaceTypes::empty())
        .build();
    // SAFETY: the template names no window.
    let config = unsafe { display.find_configs(wanted) }.map_err(words)?.next();
    let config = config.ok_or("no configuration")?;
    let api = ContextApi::Gles(Some(Version::new(3, 0)));
    let attributes = ContextAttributesBuilder::new().with_context_api(api).build(None);
    // SAFETY: configuration and attributes are of this display; no window is given.
    let context = unsafe { display.create_context(&config, &attributes) }.map_err(words)?;
    let context = context.make_current_surfaceless().map_err(words)?;
    let find = |name: &str| {
        CString::new(name).map_or(std::ptr::null(), |name| display.get_proc_address(&name).cast())
    };
    // SAFETY: the context is current on this thread and is kept by the `Headless` beside; the loader is its own.
    let gl = unsafe { Gl::new(glow::Context::from_loader_function(find)) };
    Ok((Headless { _context: context }, gl))
}
