//! A picture to be mapped onto a surface: texels with a mip chain.
//!
//! A texel keeps the square root of the light, 8 bits a channel: nearly as fair to dark colours as sRGB, and
//! squaring it back is one multiplication where sRGB needs a table. Samples are blended as light.

mod mip;
mod sample;

pub(crate) use sample::Footprint;

use crate::error::RenderError;
use crate::tone::decode_srgb;

/// Largest side of a texture, texels.
pub const MAX_TEXTURE_SIDE: u32 = 16_384;

/// One level of the mip chain, rows from the top.
#[derive(Debug, Clone)]
struct Level {
    width: usize,
    height: usize,
    /// Square roots of light; the fourth byte pads the texel to a power of two.
    texels: Vec<[u8; 4]>,
}

/// A page picture, ready to be sampled at any size and slant.
///
/// # Shapes and units
///
/// Made from sRGB, 8 bits a channel.
#[derive(Debug, Clone)]
pub struct Texture {
    levels: Vec<Level>,
}

impl Texture {
    /// Builds a texture from RGBA bytes, rows from the top. Where the picture is transparent the
    /// bare (white) paper shows.
    ///
    /// # Cost
    ///
    /// One pass over the picture plus a third for the mip chain; 5.4 bytes a texel are kept.
    ///
    /// # Errors
    ///
    /// [`RenderError::Texture`] if a side is zero or above [`MAX_TEXTURE_SIDE`], or the number of bytes is
    /// not `4 · width · height`.
    pub fn from_rgba8(width: u32, height: u32, rgba: &[u8]) -> Result<Self, RenderError> {
        let sides = 1..=MAX_TEXTURE_SIDE;
        let needed = if sides.contains(&width) && sides.contains(&height) {
            width as usize * height as usize * 4
        } else {
            0
        };
        if needed == 0 || rgba.len() != needed {
            return Err(RenderError::Texture { width, height, needed, got: rgba.len() });
        }
        let roots: [u8; 256] =
            std::array::from_fn(|i| (decode_srgb(i as u8).sqrt() * 255.0 + 0.5) as u8);
        let texels =
            rgba.chunks_exact(4).map(|t| over_white(t).map(|c| roots[usize::from(c)])).collect();
        let first = Level { width: width as usize, height: height as usize, texels };
        Ok(Self { levels: mip::chain(first) })
    }

    /// Width and height of the finest level, texels.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.levels[0].width as u32, self.levels[0].height as u32)
    }
}

/// Lays a texel with alpha over white.
fn over_white(rgba: &[u8]) -> [u8; 4] {
    let a = u32::from(rgba[3]);
    let mix = |c: u8| ((u32::from(c) * a + 255 * (255 - a) + 127) / 255) as u8;
    [mix(rgba[0]), mix(rgba[1]), mix(rgba[2]), 255]
}
