//! From where the book is seen, and what a renderer has to know of that.

use dogleaf_core::hand::View;
use dogleaf_core::mesh::{OVERHANG_M, table_drop_m};
use dogleaf_core::real::V3;
use dogleaf_core::record::Setup;
use dogleaf_core::scene::{BookSpec, Direction, Pages, Units};

/// From where one looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gaze {
    /// A reader at a table.
    Table,
    /// Straight down: the open pages fill the view.
    Above,
}

impl Gaze {
    /// That of an open book: only from above eye and target have one Z.
    #[must_use]
    pub fn of(view: &View) -> Self {
        if view.eye_m[2] == view.target_m[2] { Self::Above } else { Self::Table }
    }
}

/// Opening of the view from above, degrees; the tangent of its half; the share of it that the pages fill.
const ABOVE_DEG: f64 = 20.0;
const ABOVE_TANGENT: f64 = 0.176_326_980_708_464_97;
const ABOVE_FILL: f64 = 0.96;
/// Gap between the table and what lies on it, metres.
const GAP_M: f64 = 1e-4;
/// What the sphere of casters is wider than a page on either side.
const SLACK: f64 = 1.04;

/// The view that shows what the layout asks for.
#[must_use]
pub fn view(book: &BookSpec, layout: Pages, gaze: Gaze, [width, height]: [u32; 2]) -> View {
    let single = layout == Pages::Single;
    // One page fills a view that would, twice as wide, show both.
    let wide = if single { width.saturating_mul(2) } else { width };
    let mut view = View::reading(book.width_m, book.height_m, wide, height);
    if gaze == Gaze::Above {
        view.eye_m = [0.0, above_m(book, f64::from(wide.max(1)) / f64::from(height.max(1))), 0.0];
        view.target_m = [0.0; 3];
        view.fov_y_deg = ABOVE_DEG;
    }
    view.width_px = width;
    if single {
        let middle = 0.5 * book.width_m;
        let aside = if book.direction == Direction::Rtl { -middle } else { middle };
        view.eye_m[0] = aside;
        view.target_m[0] = aside;
    }
    view
}

/// Height from which both pages are seen, metres.
fn above_m(book: &BookSpec, aspect: f64) -> f64 {
    let reach = ABOVE_TANGENT * ABOVE_FILL;
    (book.width_m / (reach * aspect)).max(0.5 * book.height_m / reach)
}

/// Numbers of a stage.
pub const STAGE: usize = 20;

/// What a renderer makes its matrices of.
///
/// ```text
/// eye 3, right 3, up 3, forward 3: metres, unit vectors    focal length, pixels    width, height, pixels
/// height of the table, metres    thickness of a leaf, metres    radius of the sphere of casters, metres
/// width and height of a page, metres
/// ```
#[must_use]
pub fn stage(setup: &Setup) -> [f64; STAGE] {
    let camera = setup.view.camera::<f64>(&Units { metres: 1.0, kilograms: 1.0 });
    let (book, leaf_m) = (&setup.book, setup.paper.thickness_mm * 1e-3);
    let page = (book.width_m + OVERHANG_M).hypot(0.5 * book.height_m + OVERHANG_M);
    let V3([ex, ey, ez]) = camera.eye;
    let V3([rx, ry, rz]) = camera.right;
    let V3([ux, uy, uz]) = camera.up;
    let V3([fx, fy, fz]) = camera.forward;
    let [width, height] = [setup.view.width_px, setup.view.height_px].map(f64::from);
    let table = -table_drop_m(book.cover) - GAP_M;
    let radius = SLACK * page.hypot(f64::from(book.leaves()) * leaf_m);
    [
        ex,
        ey,
        ez,
        rx,
        ry,
        rz,
        ux,
        uy,
        uz,
        fx,
        fy,
        fz, //
        camera.focal,
        width,
        height,
        table,
        leaf_m,
        radius,
        book.width_m,
        book.height_m,
    ]
}

#[cfg(test)]
mod check {
    use super::{Gaze, view};
    use dogleaf_core::real::V3;
    use dogleaf_core::scene::{BookSpec, Direction, Pages, Units};

    #[test]
    fn every_layout_shows_its_page_whole() {
        for direction in [Direction::Ltr, Direction::Rtl] {
            for layout in [Pages::Spread, Pages::Single] {
                for gaze in [Gaze::Table, Gaze::Above] {
                    let book = BookSpec { direction, ..BookSpec::default() };
                    let seen = view(&book, layout, gaze, [800, 900]);
                    assert_eq!(seen.check(), Ok(()));
                    assert_eq!(Gaze::of(&seen), gaze);
                    let side = if direction == Direction::Ltr { 1.0 } else { -1.0 };
                    let camera = seen.camera::<f64>(&Units { metres: 1.0, kilograms: 1.0 });
                    let corner = V3([side * book.width_m, 0.0, 0.5 * book.height_m]);
                    let [x, y] = camera.project(corner).expect("before the eye");
                    assert!((0.0..800.0).contains(&x) && (0.0..900.0).contains(&y), "{x} {y}");
                }
            }
        }
    }
}
