//! A picture without a window: a gesture is played until a moment, and the frame is kept.

use crate::error::DesktopError;
use crate::headless;
use crate::script::Script;
use crate::view::BookView;
use std::path::Path;

/// Time between two frames, microseconds.
const FRAME_US: u64 = 16_667;

/// Plays a gesture without drawing until `until_us`, a frame every sixtieth of a second.
pub fn play(view: &mut BookView, script: &mut Script, until_us: u64) {
    for now_us in (0..=until_us / FRAME_US).map(|n| n * FRAME_US) {
        script.feed(now_us, view);
        view.step(now_us);
    }
}

/// Draws the book as it is now into a PNG file.
///
/// # Errors
///
/// EGL draws nothing without a display; the file cannot be written.
pub fn save(view: &mut BookView, path: &Path) -> Result<(), DesktopError> {
    let (_context, gl) = headless::headless()?;
    let mut renderer = BookView::renderer(gl)?;
    let size = view.stage_mut().view;
    let rgba = view.frame(&mut renderer, |renderer, scene| renderer.shoot(scene))??;
    let rgb: Vec<u8> = rgba.chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
    let kind = image::ExtendedColorType::Rgb8;
    let format = image::ImageFormat::Png;
    image::save_buffer_with_format(path, &rgb, size.width_px, size.height_px, kind, format)
        .map_err(|e| DesktopError::file(path, "cannot be written", &e))
}
