//! How large a book is, where it lies open, from where it is seen, and how many pixels a page needs.

use crate::error::DesktopError;
use crate::view::Options;
use dogleaf_content::Book;
use dogleaf_core::hand::View;
use dogleaf_core::record::Setup;
use dogleaf_core::scene::{BookSpec, Direction, Pages, PaperSpec, Preset};

/// Most pages a simulated book has.
const MOST_PAGES: usize = 20_000;
/// Texels a page has for each pixel it covers: it is seen at a slant, and filtered.
const TEXELS: f64 = 1.3;
/// Width that is seen where one page is, in pages: a little of the other one shows that it is a book.
const SINGLE: f64 = 0.60;

/// What the book is opened with.
pub(crate) fn setup(content: &Book, options: &Options) -> Result<Setup, DesktopError> {
    let [width_m, height_m] = content.size_m();
    let pages = content.page_count().min(MOST_PAGES) as u32;
    let direction = options.direction;
    let open_at = open_at(options.page, pages)?;
    let book = BookSpec { width_m, height_m, pages, open_at, direction, ..BookSpec::default() };
    let view = view(&book, options.handling.pages, options.size);
    let setup = Setup {
        paper: PaperSpec::from(Preset::Book),
        view,
        fidelity: options.fidelity,
        handling: options.handling,
        ..Setup::reading(book, 1, 1)
    };
    setup.check()?;
    Ok(setup)
}

/// From where a reader sees it.
pub(crate) fn view(book: &BookSpec, pages: Pages, [width_px, height_px]: [u32; 2]) -> View {
    let (width, height) = (width_px.clamp(1, 16_384), height_px.clamp(1, 16_384));
    match pages {
        Pages::Spread => View::reading(book.width_m, book.height_m, width, height),
        Pages::Single => {
            let mut view = View::reading(SINGLE * book.width_m, book.height_m, width, height);
            let side = if book.direction == Direction::Ltr { 0.5 } else { -0.5 };
            let aside = side * book.width_m;
            view.eye_m[0] += aside;
            view.target_m[0] += aside;
            view
        }
    }
}

/// Pages read before the first turn: always whole leaves. A third of the book, unless a page is named.
fn open_at(page: Option<u32>, pages: u32) -> Result<u32, DesktopError> {
    match page {
        None => Ok((pages / 3 / 2 * 2).max(2).min(2 * (pages.div_ceil(2) - 1))),
        Some(page) if (1..=pages).contains(&page) => Ok(page / 2 * 2),
        Some(page) => {
            Err(DesktopError::Call(format!("there is no page {page}: the last is {pages}")))
        }
    }
}

/// Pixels across and down that show a page as sharp as the picture can, also when it is lifted.
pub(crate) fn page_pixels(view: &View, book: &BookSpec) -> [u32; 2] {
    let [ex, ey, ez] = view.eye_m;
    let [tx, ty, tz] = view.target_m;
    let away = ((ex - tx).powi(2) + (ey - ty).powi(2) + (ez - tz).powi(2)).sqrt();
    let nearest = (away - 0.7 * book.width_m).max(0.3 * away);
    let half_angle = 0.5 * view.fov_y_deg.to_radians();
    let pixels_per_m = 0.5 * f64::from(view.height_px) / (half_angle.tan() * nearest);
    let most = f64::from(dogleaf_content::limits::MAX_SIDE_PX).min(4096.0);
    [book.width_m, book.height_m].map(|m| (TEXELS * m * pixels_per_m).clamp(16.0, most) as u32)
}
