//! A window with a context of OpenGL ES 3.0 on it.
#![allow(unsafe_code)]

use crate::error::{DesktopError, one_line};
use crate::gl::Gl;
use glutin::config::{Api, Config, ConfigTemplateBuilder, GlConfig};
use glutin::context::{ContextApi, ContextAttributesBuilder, PossiblyCurrentContext, Version};
use glutin::display::{GetGlDisplay, GlDisplay};
use glutin::prelude::NotCurrentGlContext;
use glutin::surface::{GlSurface, Surface, SwapInterval, WindowSurface};
use glutin_winit::{DisplayBuilder, GlWindow};
use raw_window_handle::HasWindowHandle;
use std::ffi::CString;
use std::num::NonZeroU32;
use winit::event_loop::ActiveEventLoop;
use winit::window::{Window, WindowAttributes};

/// Samples a pixel at most.
const SAMPLES: u8 = 8;

/// A window one can draw into. The context is current as long as it lives.
#[derive(Debug)]
pub(crate) struct Canvas {
    // Fields fall in this order: the surface before the window it lies on.
    surface: Surface<WindowSurface>,
    context: PossiblyCurrentContext,
    pub(crate) window: Window,
}

impl Canvas {
    /// Opens a window; the [`Gl`] is of use as long as the canvas lives.
    pub(crate) fn open(
        events: &ActiveEventLoop,
        attributes: WindowAttributes,
    ) -> Result<(Self, Gl), DesktopError> {
        let words = |e: &dyn std::fmt::Display| DesktopError::Window(one_line(&e.to_string()));
        let template = ConfigTemplateBuilder::new().with_api(Api::GLES3).with_depth_size(24);
        let display = DisplayBuilder::new().with_window_attributes(Some(attributes));
        let (window, config) =
            display.build(events, template, |found| best(found)).map_err(|e| words(&e))?;
        let window = window.ok_or_else(|| DesktopError::Window("none was made".to_owned()))?;
        Self::on(window, &config).map_err(|e| words(&e))
    }

    fn on(window: Window, config: &Config) -> Result<(Self, Gl), Box<dyn std::error::Error>> {
        let display = config.display();
        let handle = window.window_handle()?.as_raw();
        let api = ContextApi::Gles(Some(Version::new(3, 0)));
        let wanted = ContextAttributesBuilder::new().with_context_api(api).build(Some(handle));
        // SAFETY: the handle is of the window that is kept beside.
        let context = unsafe { display.create_context(config, &wanted) }?;
        let attributes = window.build_surface_attributes(Default::default())?;
        // SAFETY: as above.
        let surface = unsafe { display.create_window_surface(config, &attributes) }?;
        let context = context.make_current(&surface)?;
        // Without it the picture tears; some displays have no say in it.
        let _ = surface.set_swap_interval(&context, SwapInterval::Wait(NonZeroU32::MIN));
        let find = |name: &str| {
            CString::new(name)
                .map_or(std::ptr::null(), |name| display.get_proc_address(&name).cast())
        };
        // SAFETY: the context was just made current on this thread, and only this canvas could change that.
        let gl = unsafe { Gl::new(glow::Context::from_loader_function(find)) };
        Ok((Self { surface, context, window }, gl))
    }

    /// The window has another size.
    pub(crate) fn resize(&self, width: u32, height: u32) {
        if let (Some(width), Some(height)) = (NonZeroU32::new(width), NonZeroU32::new(height)) {
            self.surface.resize(&self.context, width, height);
        }
    }

    /// Shows what was drawn.
    pub(crate) fn swap(&self) -> Result<(), DesktopError> {
        let shown = self.surface.swap_buffers(&self.context);
        shown.map_err(|e| DesktopError::Window(one_line(&e.to_string())))
    }
}

/// The most samples up to [`SAMPLES`]; bytes as they are, for the shader encodes them itself.
fn best(found: Box<dyn Iterator<Item = Config> + '_>) -> Config {
    let worth = |c: &Config| {
        let samples = c.num_samples();
        (!c.srgb_capable(), if samples <= SAMPLES { samples } else { 0 })
    };
    let best = found.reduce(|a, b| if worth(&b) > worth(&a) { b } else { a });
    // The builder asks only where it found one.
    best.unwrap_or_else(|| unreachable!("a display without any configuration"))
}
