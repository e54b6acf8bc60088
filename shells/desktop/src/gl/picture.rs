//! Pictures on the card: pages, the grain of the table.

use super::Gl;
use glow::HasContext;

/// A picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Texture(pub(super) glow::NativeTexture);

impl Gl {
    /// A picture from RGBA bytes, rows from the top, with a mip chain. The bytes stay as they are: the shader reads
    /// them as sRGB, so that the chain's means are of what the eye sees, and print stays legible.
    ///
    /// # Errors
    ///
    /// The driver has no room.
    pub(crate) fn picture(&self, size: [u32; 2], rgba: &[u8]) -> Result<Texture, String> {
        let texture = self.blank(size, Some(rgba))?;
        self.chain(texture);
        Ok(texture)
    }

    /// Room for a picture; `rgba` may already be known.
    pub(super) fn blank(
        &self,
        [width, height]: [u32; 2],
        rgba: Option<&[u8]>,
    ) -> Result<Texture, String> {
        let (w, h) = (width as i32, height as i32);
        let enough = rgba.is_none_or(|b| b.len() == 4 * width as usize * height as usize);
        if !enough {
            return Err("a picture has four bytes a pixel".to_owned());
        }
        // SAFETY: the context is current; the slice is as long as the driver reads.
        unsafe {
            let texture = self.raw.create_texture()?;
            self.raw.bind_texture(glow::TEXTURE_2D, Some(texture));
            self.raw.pixel_store_i32(glow::UNPACK_ALIGNMENT, 1);
            let pixels = glow::PixelUnpackData::Slice(rgba);
            let (inside, outside) = (glow::RGBA8 as i32, glow::RGBA);
            let byte = glow::UNSIGNED_BYTE;
            self.raw.tex_image_2d(glow::TEXTURE_2D, 0, inside, w, h, 0, outside, byte, pixels);
            for (name, value) in [
                (glow::TEXTURE_MIN_FILTER, glow::LINEAR_MIPMAP_LINEAR),
                (glow::TEXTURE_MAG_FILTER, glow::LINEAR),
                (glow::TEXTURE_WRAP_S, glow::CLAMP_TO_EDGE),
                (glow::TEXTURE_WRAP_T, glow::CLAMP_TO_EDGE),
            ] {
                self.raw.tex_parameter_i32(glow::TEXTURE_2D, name, value as i32);
            }
            Ok(Texture(texture))
        }
    }

    /// Makes the mip chain.
    pub(super) fn chain(&self, texture: Texture) {
        // SAFETY: the context is current, and the texture is its own.
        unsafe {
            self.raw.bind_texture(glow::TEXTURE_2D, Some(texture.0));
            self.raw.generate_mipmap(glow::TEXTURE_2D);
        }
    }

    /// Gives a picture back.
    pub(crate) fn forget(&self, texture: Texture) {
        // SAFETY: the context is current, and the texture is its own.
        unsafe { self.raw.delete_texture(texture.0) }
    }

    /// Reads a picture through this unit from now on.
    pub(crate) fn bind(&self, unit: u32, texture: Texture) {
        // SAFETY: the context is current, and the texture is its own.
        unsafe {
            self.raw.active_texture(glow::TEXTURE0 + unit);
            self.raw.bind_texture(glow::TEXTURE_2D, Some(texture.0));
            self.raw.active_texture(glow::TEXTURE0);
        }
    }
}
