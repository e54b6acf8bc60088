//! How large the book is, where it lies open, and how many pixels a page needs.

use crate::args::TurnArgs;
use crate::error::{CliError, shown};
use dogleaf_content::{Book, BookKind, ContentError};
use dogleaf_core::hand::View;
use dogleaf_core::scene::BookSpec;

/// Width of a page nobody knows the size of, metres.
const WIDTH_M: f64 = 0.130;
/// Sizes of a page that a PDF is believed, metres.
const SANE_M: std::ops::RangeInclusive<f64> = 0.060..=0.300;
/// Metres in a point of a PDF.
const POINT_M: f64 = 0.0254 / 72.0;
/// Most pages a simulated book has.
const MOST_PAGES: usize = 20_000;
/// Texels a page has for each pixel it covers: it is seen at a slant, and filtered.
const TEXELS: f64 = 1.3;

/// The book to simulate.
pub(super) fn spec(content: &Book, args: &TurnArgs) -> Result<BookSpec, CliError> {
    let [width_m, height_m] = size_m(content);
    let pages = content.page_count().min(MOST_PAGES) as u32;
    let spec = BookSpec {
        width_m,
        height_m,
        pages,
        open_at: open_at(args, pages)?,
        direction: args.direction.into(),
        ..BookSpec::default()
    };
    spec.check()?;
    Ok(spec)
}

/// Width and height of a page: a PDF's own, if they are a book's; else of the default width.
fn size_m(content: &Book) -> [f64; 2] {
    let aspect = f64::from(content.aspect()).clamp(0.2, 5.0);
    let own = match content.kind() {
        BookKind::Pdf => pdf_size_m(content, aspect),
        _ => None,
    };
    own.unwrap_or([WIDTH_M, WIDTH_M / aspect])
}

/// The size of the first page that has the typical shape.
fn pdf_size_m(content: &Book, aspect: f64) -> Option<[f64; 2]> {
    let sizes = (0..content.page_count().min(64)).filter_map(|i| content.page_size(i).ok());
    let points = |(w, h): (f32, f32)| [f64::from(w), f64::from(h)];
    let mut typical = sizes.map(points).filter(|[w, h]| (w / h / aspect - 1.0).abs() < 0.01);
    let size = typical.next()?.map(|side| side * POINT_M);
    size.iter().all(|side| SANE_M.contains(side)).then_some(size)
}

/// Pages read before the turn: always whole leaves, and one is left to turn.
fn open_at(args: &TurnArgs, pages: u32) -> Result<u32, CliError> {
    let most = 2 * (pages.div_ceil(2) - 1);
    let Some(page) = args.page else {
        let third = pages / 3 / 2 * 2;
        return Ok(third.max(2).min(most));
    };
    let file = shown(&args.book);
    if page == 0 || page > pages {
        let (page, last) = (page as usize, pages as usize);
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
