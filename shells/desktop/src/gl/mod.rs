//! OpenGL ES 3.0 behind calls that cannot be misused: the one place here that speaks to the driver.
//!
//! Every `unsafe` block in this module stands on the same two facts. The context is current on this thread for as
//! long as a [`Gl`] lives: whoever makes one promises it, and nothing here can be sent to another thread. And every
//! name handed to the driver was made by this very [`Gl`], since its types have no other maker.
#![allow(unsafe_code)]

mod canvas;
mod mesh;
mod picture;
mod program;

pub(crate) use canvas::{Canvas, Maps};
pub(crate) use mesh::Mesh;
pub(crate) use picture::Texture;
pub(crate) use program::Program;

use glow::HasContext;

/// A current context.
pub struct Gl {
    raw: glow::Context,
}

impl Gl {
    /// Takes a context over.
    ///
    /// # Safety
    ///
    /// It is current on this thread and stays so as long as this value lives.
    pub unsafe fn new(raw: glow::Context) -> Self {
        Self { raw }
    }

    /// What the driver calls itself.
    #[must_use]
    pub fn name(&self) -> String {
        // SAFETY: the context is current.
        let text = |what| unsafe { self.raw.get_parameter_string(what) };
        format!("{}, {}", text(glow::VERSION), text(glow::RENDERER))
    }

    /// Waits until all that was asked for is drawn.
    pub(crate) fn finish(&self) {
        // SAFETY: the context is current.
        unsafe { self.raw.finish() }
    }

    /// The first thing the driver complained about since it was last asked.
    pub(crate) fn complaint(&self) -> Option<u32> {
        // SAFETY: the context is current.
        let error = unsafe { self.raw.get_error() };
        (error != glow::NO_ERROR).then_some(error)
    }

    /// Draws into the window from now on.
    pub(crate) fn to_window(&self, [width, height]: [u32; 2]) {
        // SAFETY: the context is current; nought names the window's own buffer.
        unsafe {
            self.raw.bind_framebuffer(glow::FRAMEBUFFER, None);
            self.raw.viewport(0, 0, width as i32, height as i32);
        }
    }

    /// Clears colour and depth, and hides what turns its back.
    pub(crate) fn begin_picture(&self, [r, g, b]: [f32; 3]) {
        // SAFETY: the context is current.
        unsafe {
            self.raw.disable(glow::BLEND);
            self.raw.disable(glow::SCISSOR_TEST);
            self.raw.enable(glow::DEPTH_TEST);
            self.raw.enable(glow::CULL_FACE);
            self.raw.depth_mask(true);
            self.raw.depth_func(glow::LESS);
            self.raw.clear_color(r, g, b, 1.0);
            self.raw.clear(glow::COLOR_BUFFER_BIT | glow::DEPTH_BUFFER_BIT);
        }
    }

    /// Clears depth alone; both sides of everything count.
    pub(crate) fn begin_maps(&self) {
        // SAFETY: the context is current.
        unsafe {
            self.raw.enable(glow::DEPTH_TEST);
            self.raw.disable(glow::CULL_FACE);
            self.raw.depth_mask(true);
            self.raw.depth_func(glow::LESS);
            self.raw.clear(glow::DEPTH_BUFFER_BIT);
        }
    }

    /// Draws into this part of the target only, pixels from the lower left.
    pub(crate) fn part(&self, [x, y, width, height]: [i32; 4]) {
        // SAFETY: the context is current.
        unsafe { self.raw.viewport(x, y, width, height) }
    }
}

impl std::fmt::Debug for Gl {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Gl({})", self.name())
    }
}
