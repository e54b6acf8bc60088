//! How large the book is, where it lies open, and how many pixels a page needs.

use crate::error::CliError;
use dogleaf_content::{Book, ContentError};
use dogleaf_core::hand::View;
use dogleaf_core::scene::{BookSpec, Direction};

/// Most pages a simulated book has.
const MOST_PAGES: usize = 20_000;
/// Texels a page has for each pixel it covers: it is seen at a slant, and filtered.
const TEXELS: f64 = 1.3;

/// The book to simulate.
pub(crate) fn spec(
    content: &Book,
    page: Option<u32>,
    direction: Direction,
    file: &str,
) -> Result<BookSpec, CliError> {
    let [width_m, height_m] = content.size_m();
    let pages = content.page_count().min(MOST_PAGES) as u32;
    let spec = BookSpec {
        width_m,
        height_m,
        pages,
        open_at: open_at(page, pages, file)?,
        direction,
        ..BookSpec::default()
    };
    spec.check()?;
    Ok(spec)
}

/// Pages read before the turn: always whole leaves, and one is left to turn.
fn open_at(page: Option<u32>, pages: u32, file: &str) -> Result<u32, CliError> {
    let most = 2 * (pages.div_ceil(2) - 1);
    let Some(page) = page else {
        let third = pages / 3 / 2 * 2;
        return Ok(third.max(2).min(most));
    };
    if page == 0 || page > pages {
        let (file, page, last) = (file.to_owned(), page as usize, pages as usize);
        return Err(ContentError::NoSuchPage { file, page, last }.into());
    }
    let read = page / 2 * 2;
    if read > most {
        return Err(CliError::Call(format!("{file}: after page {page} there is no leaf to turn")));
    }
    Ok(read)
}

/// Pixels across and down that show a page as sharp as the picture can, also when it is lifted.
pub(super) fn page_pixels(view: &View, book: &BookSpec) -> [u32; 2] {
    let [ex, ey, ez] = view.eye_m;
    let [tx, ty, tz] = view.target_m;
    let away = ((ex - tx).powi(2) + (ey - ty).powi(2) + (ez - tz).powi(2)).sqrt();
    let nearest = (away - 0.7 * book.width_m).max(0.3 * away);
    let half_angle = 0.5 * view.fov_y_deg.to_radians();
    let pixels_per_m = 0.5 * f64::from(view.height_px) / (half_angle.tan() * nearest);
    let most = f64::from(dogleaf_content::limits::MAX_SIDE_PX);
    [book.width_m, book.height_m].map(|m| (TEXELS * m * pixels_per_m).clamp(16.0, most) as u32)
}
