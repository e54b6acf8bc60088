//! Why a picture or an animation is refused.

use std::path::PathBuf;

/// Why the renderer refuses a call.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// The picture is empty or larger than [`crate::MAX_SIDE`] a side.
    #[error("picture size {width}x{height} is not between 1x1 and {max}x{max}", max = crate::MAX_SIDE)]
    PictureSize {
        /// Width asked for, pixels.
        width: u32,
        /// Height asked for, pixels.
        height: u32,
    },
    /// Only 1, 4 and 8 samples a pixel exist.
    #[error("{0} samples a pixel are not offered; choose 1, 4 or 8")]
    Samples(u32),
    /// The texture's bytes do not match its size, or the size is zero or too large.
    #[error("texture of {width}x{height} needs {needed} bytes of RGBA, got {got}")]
    Texture {
        /// Width, texels.
        width: u32,
        /// Height, texels.
        height: u32,
        /// Bytes a picture of this size has; 0 when the size itself is refused.
        needed: usize,
        /// Bytes given.
        got: usize,
    },
    /// Eye, target and up are not finite, or lie on one line, or the angle of view is not in (0, π).
    #[error(
        "camera is degenerate: eye, target and up must span a plane and the angle must be in (0, pi)"
    )]
    Camera,
}

/// Why an animation could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AnimError {
    /// The file's ending names no format we write.
    #[error("{}: unknown animation format; use .webp, .gif, .png or a folder", .0.display())]
    Format(PathBuf),
    /// Width, height or frame rate is zero or beyond what the format can say.
    #[error("animation of {width}x{height} at {fps} frames a second cannot be written")]
    Shape {
        /// Width, pixels.
        width: u32,
        /// Height, pixels.
        height: u32,
        /// Frames a second.
        fps: u32,
    },
    /// A frame has the wrong number of bytes.
    #[error("a frame has {got} bytes, expected {needed} (RGB8)")]
    Frame {
        /// Bytes of one RGB8 frame.
        needed: usize,
        /// Bytes given.
        got: usize,
    },
    /// `finish` without a single frame.
    #[error("the animation has no frame")]
    Empty,
    /// The file system said no.
    #[error("{}: {source}", path.display())]
    Io {
        /// What was being written.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// An encoder said no.
    #[error("{format} encoder: {message}")]
    Encoder {
        /// Which one.
        format: &'static str,
        /// What it said.
        message: String,
    },
}
