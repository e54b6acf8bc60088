//! Drawing into any target of `embedded-graphics`, band by band.

use crate::band::{Band, Canvas, Print};
use crate::dither::Depth;
use crate::rect::Rect;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::{BinaryColor, Gray4, PixelColor};
use embedded_graphics_core::primitives::Rectangle;

/// A colour of electronic paper.
pub trait Ink: PixelColor {
    /// The colour of a level, 0 black to 15 white.
    fn of_level(level: u8) -> Self;
}

impl Ink for Gray4 {
    fn of_level(level: u8) -> Self {
        Self::new(level)
    }
}

impl Ink for BinaryColor {
    /// `On` is white, as the drivers of panels have it.
    fn of_level(level: u8) -> Self {
        if level >= 8 { Self::On } else { Self::Off }
    }
}

/// Draws the pixels of `rect`.
///
/// # Cost
///
/// Each pixel of `rect` once, each triangle of the leaf once for each band it meets.
///
/// # Errors
///
/// The target's own.
///
/// # Hard case
///
/// A rectangle wider than half the band has pixels cannot be drawn, and is not: [`Band::rows`] says so.
pub fn draw<P: Print, T, const CELLS: usize>(
    rect: Rect,
    canvas: &Canvas<'_, P>,
    depth: Depth,
    band: &mut Band<CELLS>,
    target: &mut T,
) -> Result<(), T::Error>
where
    T: DrawTarget,
    T::Color: Ink,
{
    let rows = Band::<CELLS>::rows(rect.width());
    let mut top = rect.y0;
    // As many rounds as there are rows, at most.
    while rows > 0 && top < rect.y1 {
        let part = Rect { y0: top, y1: top.saturating_add(rows).min(rect.y1), ..rect };
        let mut at = (part.x0, part.y0);
        let colours = band.draw(part, canvas).map(|luma| {
            let colour = T::Color::of_level(depth.level(luma, at.0, at.1));
            at = if at.0 + 1 < part.x1 { (at.0 + 1, at.1) } else { (part.x0, at.1 + 1) };
            colour
        });
        target.fill_contiguous(&rectangle(part), colours)?;
        top = part.y1;
    }
    Ok(())
}

/// The same rectangle in the terms of `embedded-graphics`.
#[must_use]
pub fn rectangle(rect: Rect) -> Rectangle {
    let corner = Point::new(i32::from(rect.x0), i32::from(rect.y0));
    Rectangle::new(corner, Size::new(u32::from(rect.width()), u32::from(rect.height())))
}
