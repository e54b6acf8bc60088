//! What is drawn into when it is not the window: shadow maps, the grain, a picture to be kept.

use super::{Gl, Texture};
use glow::HasContext;

/// A texture of depths that is asked by comparing.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Maps {
    pub(crate) texture: Texture,
    frame: glow::NativeFramebuffer,
}

/// A picture with several samples a pixel, and the one it is resolved into.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Canvas {
    size: [u32; 2],
    many: glow::NativeFramebuffer,
    one: glow::NativeFramebuffer,
    stores: [glow::NativeRenderbuffer; 3],
}

impl Gl {
    /// Room for depth maps.
    ///
    /// # Errors
    ///
    /// The driver has no room, or cannot draw depth alone.
    pub(crate) fn maps(&self, [width, height]: [i32; 2]) -> Result<Maps, String> {
        // SAFETY: the context is current.
        unsafe {
            let texture = self.raw.create_texture()?;
            self.raw.bind_texture(glow::TEXTURE_2D, Some(texture));
            let inside = glow::DEPTH_COMPONENT16;
            self.raw.tex_storage_2d(glow::TEXTURE_2D, 1, inside, width, height);
            for (name, value) in [
                (glow::TEXTURE_MIN_FILTER, glow::LINEAR),
                (glow::TEXTURE_MAG_FILTER, glow::LINEAR),
                (glow::TEXTURE_WRAP_S, glow::CLAMP_TO_EDGE),
                (glow::TEXTURE_WRAP_T, glow::CLAMP_TO_EDGE),
                (glow::TEXTURE_COMPARE_MODE, glow::COMPARE_REF_TO_TEXTURE),
                (glow::TEXTURE_COMPARE_FUNC, glow::LEQUAL),
            ] {
                self.raw.tex_parameter_i32(glow::TEXTURE_2D, name, value as i32);
            }
            let frame = self.raw.create_framebuffer()?;
            self.raw.bind_framebuffer(glow::FRAMEBUFFER, Some(frame));
            let (target, place) = (glow::FRAMEBUFFER, glow::DEPTH_ATTACHMENT);
            self.raw.framebuffer_texture_2d(target, place, glow::TEXTURE_2D, Some(texture), 0);
            self.raw.draw_buffers(&[glow::NONE]);
            self.raw.read_buffer(glow::NONE);
            self.whole()?;
            Ok(Maps { texture: Texture(texture), frame })
        }
    }

    /// Draws into them from now on.
    pub(crate) fn to_maps(&self, maps: Maps) {
        // SAFETY: the context is current, and the frame is its own.
        unsafe { self.raw.bind_framebuffer(glow::FRAMEBUFFER, Some(maps.frame)) }
    }

    /// A picture that `draw` makes once, with its mip chain.
    ///
    /// # Errors
    ///
    /// The driver has no room.
    pub(crate) fn drawn(&self, size: [u32; 2], draw: impl FnOnce()) -> Result<Texture, String> {
        let texture = self.blank(size, None)?;
        // SAFETY: the context is current, and all names are its own.
        unsafe {
            let frame = self.raw.create_framebuffer()?;
            self.raw.bind_framebuffer(glow::FRAMEBUFFER, Some(frame));
            let (target, place) = (glow::FRAMEBUFFER, glow::COLOR_ATTACHMENT0);
            self.raw.framebuffer_texture_2d(target, place, glow::TEXTURE_2D, Some(texture.0), 0);
            self.whole()?;
            self.raw.viewport(0, 0, size[0] as i32, size[1] as i32);
            draw();
            self.raw.bind_framebuffer(glow::FRAMEBUFFER, None);
            self.raw.delete_framebuffer(frame);
        }
        self.chain(texture);
        Ok(texture)
    }

    /// Room for a picture with up to `samples` samples a pixel.
    ///
    /// # Errors
    ///
    /// The driver has no room.
    pub(crate) fn canvas(&self, size: [u32; 2], samples: i32) -> Result<Canvas, String> {
        let (w, h) = (size[0] as i32, size[1] as i32);
        // SAFETY: the context is current, and all names are its own.
        unsafe {
            let samples = samples.min(self.raw.get_parameter_i32(glow::MAX_SAMPLES));
            let mut stores = Vec::new();
            let mut frame = |parts: &[(u32, u32, i32)]| -> Result<_, String> {
                let frame = self.raw.create_framebuffer()?;
                self.raw.bind_framebuffer(glow::FRAMEBUFFER, Some(frame));
                for &(place, format, samples) in parts {
                    let store = self.raw.create_renderbuffer()?;
                    stores.push(store);
                    let kind = glow::RENDERBUFFER;
                    self.raw.bind_renderbuffer(kind, Some(store));
                    self.raw.renderbuffer_storage_multisample(kind, samples, format, w, h);
                    self.raw.framebuffer_renderbuffer(glow::FRAMEBUFFER, place, kind, Some(store));
                }
                self.whole()?;
                Ok(frame)
            };
            let colour = (glow::COLOR_ATTACHMENT0, glow::RGBA8, samples);
            let depth = (glow::DEPTH_ATTACHMENT, glow::DEPTH_COMPONENT24, samples);
            let many = frame(&[colour, depth])?;
            let one = frame(&[(colour.0, colour.1, 0)])?;
            let stores = stores.try_into().map_err(|_| "three buffers".to_owned())?;
            Ok(Canvas { size, many, one, stores })
        }
    }

    /// Draws into it from now on.
    pub(crate) fn to_canvas(&self, canvas: &Canvas) {
        // SAFETY: the context is current, and the frame is its own.
        unsafe {
            self.raw.bind_framebuffer(glow::FRAMEBUFFER, Some(canvas.many));
            self.raw.viewport(0, 0, canvas.size[0] as i32, canvas.size[1] as i32);
        }
    }

    /// What was drawn: RGBA bytes, rows from the top.
    pub(crate) fn read(&self, canvas: &Canvas) -> Vec<u8> {
        let (w, h) = (canvas.size[0] as i32, canvas.size[1] as i32);
        let row = 4 * canvas.size[0] as usize;
        let mut bytes = vec![0; row * canvas.size[1] as usize];
        // SAFETY: the context is current, the frames are its own and of one size, and the slice holds all pixels.
        unsafe {
            self.raw.bind_framebuffer(glow::READ_FRAMEBUFFER, Some(canvas.many));
            self.raw.bind_framebuffer(glow::DRAW_FRAMEBUFFER, Some(canvas.one));
            let (what, how) = (glow::COLOR_BUFFER_BIT, glow::NEAREST);
            self.raw.blit_framebuffer(0, 0, w, h, 0, 0, w, h, what, how);
            self.raw.bind_framebuffer(glow::FRAMEBUFFER, Some(canvas.one));
            self.raw.pixel_store_i32(glow::PACK_ALIGNMENT, 1);
            let pixels = glow::PixelPackData::Slice(Some(&mut bytes));
            self.raw.read_pixels(0, 0, w, h, glow::RGBA, glow::UNSIGNED_BYTE, pixels);
        }
        bytes.chunks_exact(row.max(4)).rev().flatten().copied().collect()
    }

    /// Gives a canvas back.
    pub(crate) fn forget_canvas(&self, canvas: &Canvas) {
        // SAFETY: the context is current, and all names are its own.
        unsafe {
            self.raw.delete_framebuffer(canvas.many);
            self.raw.delete_framebuffer(canvas.one);
            canvas.stores.iter().for_each(|store| self.raw.delete_renderbuffer(*store));
        }
    }

    fn whole(&self) -> Result<(), String> {
        // SAFETY: the context is current.
        let status = unsafe { self.raw.check_framebuffer_status(glow::FRAMEBUFFER) };
        let complete = status == glow::FRAMEBUFFER_COMPLETE;
        if complete { Ok(()) } else { Err(format!("the driver cannot draw into it ({status:#x})")) }
    }
}
