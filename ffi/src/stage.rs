//! From where the book is seen, and what a renderer has to know of that: the same camera as a matrix.

use crate::options::Layout;
use dogleaf_core::hand::View;
use dogleaf_core::mesh::{OVERHANG_M, table_drop_m};
use dogleaf_core::record::Setup;
use dogleaf_core::scene::{BookSpec, Direction, Units};

/// From where one looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, uniffi::Enum)]
pub enum Gaze {
    /// A reader at a table.
    Table,
    /// Straight down: the open pages fill the view, as on a flat screen.
    Above,
}

/// What stands around the book, for the renderer. It changes with `look` and `resize` only.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct Stage {
    /// From metres of the book frame to clip space as GL has it (z from -1 to 1): 16 numbers, column by column.
    pub view_projection: Vec<f32>,
    /// Eye, metres: 3 numbers.
    pub eye: Vec<f32>,
    /// Width of the view, pixels.
    pub width_px: u32,
    /// Height of the view, pixels.
    pub height_px: u32,
    /// Side of a pixel one metre away, metres.
    pub pixel_at_one_metre: f32,
    /// Height of the table in the book frame, metres: below nought.
    pub table_y: f32,
    /// Thickness of a leaf, metres.
    pub leaf_m: f32,
    /// Radius of a sphere about the binding that holds the book however it is opened, metres.
    pub radius_m: f32,
}

/// Gap between the table and what lies on it, metres: none of them shall show through the other.
const GAP_M: f64 = 1e-4;
/// What the sphere is wider than a page on either side.
const SLACK: f64 = 1.04;
/// Far plane, metres: beyond the corners of a table of six metres.
const FAR_M: f64 = 40.0;
/// Near plane, as a share of the eye's distance.
const NEAR: f64 = 0.1;

/// Opening of the view from above, degrees, and the tangent of its half: narrow, so that a leaf in the air is not
/// much larger than one that lies.
const ABOVE: (f64, f64) = (20.0, 0.176_326_980_708_464_97);
/// Share of the view that the open pages fill, seen from above.
const FILL: f64 = 0.96;

/// The view that shows all of what the layout asks for.
pub(crate) fn view(book: &BookSpec, layout: Layout, gaze: Gaze, width: u32, height: u32) -> View {
    // A single page is seen in a view twice as wide as one that shows the spread.
    let seen = if layout == Layout::Single { width.saturating_mul(2) } else { width };
    let mut view = View::reading(book.width_m, book.height_m, seen, height);
    if gaze == Gaze::Above {
        let aspect = f64::from(seen.max(1)) / f64::from(height.max(1));
        let (fov_y_deg, half) = ABOVE;
        let across = book.width_m / (half * aspect * FILL);
        let along = 0.5 * book.height_m / (half * FILL);
        let eye_m = [0.0, across.max(along), 0.0];
        view = View { eye_m, target_m: [0.0; 3], fov_y_deg, ..view };
    }
    view.width_px = width;
    if layout == Layout::Single {
        let side = if book.direction == Direction::Ltr { 0.5 } else { -0.5 };
        view.eye_m[0] = side * book.width_m;
        view.target_m[0] = side * book.width_m;
    }
    view
}

/// From where a book opened with `setup` is looked at.
pub(crate) fn gaze(setup: &Setup) -> Gaze {
    let [_, _, z] = setup.view.eye_m;
    if z == setup.view.target_m[2] { Gaze::Above } else { Gaze::Table }
}

/// The stage of a book opened with `setup`.
pub(crate) fn stage(setup: &Setup) -> Stage {
    let (book, view) = (&setup.book, &setup.view);
    let metres = Units { metres: 1.0, kilograms: 1.0 };
    let c = view.camera::<f64>(&metres);
    let distance = {
        let d: f64 = (0..3).map(|n| (view.eye_m[n] - view.target_m[n]).powi(2)).sum();
        d.sqrt()
    };
    let (near, far) = (NEAR * distance, FAR_M + distance);
    let across = c.focal / c.centre[0];
    let up = c.focal / c.centre[1];
    let depth = (far + near) / (far - near);
    let shift = 2.0 * far * near / (far - near);
    // Rows of the matrix: clip x, y, z, w of a place in metres.
    let row = |axis: [f64; 3], scale: f64, add: f64| {
        let dot: f64 = axis.iter().zip(c.eye.0).map(|(a, e)| a * e).sum();
        [axis[0] * scale, axis[1] * scale, axis[2] * scale, add - dot * scale]
    };
    let rows = [
        row(c.right.0, across, 0.0),
        row(c.up.0, up, 0.0),
        row(c.forward.0, depth, -shift),
        row(c.forward.0, 1.0, 0.0),
    ];
    let view_projection = (0..16).map(|n| rows[n % 4][n / 4] as f32).collect();
    let eye = c.eye.0.iter().map(|&e| e as f32).collect();
    let leaf = setup.paper.thickness_mm * 1e-3;
    let page = (book.width_m + OVERHANG_M).hypot(0.5 * book.height_m + OVERHANG_M);
    let radius = SLACK * page.hypot(f64::from(book.leaves()) * leaf);
    Stage {
        view_projection,
        eye,
        width_px: view.width_px,
        height_px: view.height_px,
        pixel_at_one_metre: (1.0 / c.focal) as f32,
        table_y: (-table_drop_m(book.cover) - GAP_M) as f32,
        leaf_m: leaf as f32,
        radius_m: radius as f32,
    }
}

#[cfg(test)]
mod check {
    use super::{Gaze, stage, view};
    use crate::options::Layout;
    use dogleaf_core::real::V3;
    use dogleaf_core::record::Setup;
    use dogleaf_core::scene::{BookSpec, Direction, Units};

    #[test]
    fn the_matrix_sees_what_the_hand_sees() {
        for direction in [Direction::Ltr, Direction::Rtl] {
            for layout in [Layout::Spread, Layout::Single] {
                for gaze in [Gaze::Table, Gaze::Above] {
                    let book = BookSpec { direction, ..BookSpec::default() };
                    let view = view(&book, layout, gaze, 900, 700);
                    assert_eq!(view.check(), Ok(()), "{layout:?} {gaze:?}");
                    same(&view);
                }
            }
        }
    }

    fn same(view: &dogleaf_core::hand::View) {
        let setup = Setup { view: *view, ..Setup::reading(BookSpec::default(), 900, 700) };
        let m = stage(&setup).view_projection;
        let hand = view.camera::<f64>(&Units { metres: 1.0, kilograms: 1.0 });
        for p in [[0.0, 0.0, 0.0], [0.1, 0.02, -0.08], [-0.12, 0.13, 0.09]] {
            let row = |r: usize| {
                let sum: f32 = (0..3).map(|n| m[4 * n + r] * p[n] as f32).sum();
                f64::from(sum + m[12 + r])
            };
            let x = (row(0) / row(3) + 1.0) * 0.5 * f64::from(view.width_px);
            let y = (1.0 - row(1) / row(3)) * 0.5 * f64::from(view.height_px);
            let seen = hand.project(V3(p)).expect("before the eye");
            assert!((x - seen[0]).abs() < 0.01, "{x} is not {}", seen[0]);
            assert!((y - seen[1]).abs() < 0.01, "{y} is not {}", seen[1]);
            let depth = row(2) / row(3);
            assert!(depth.abs() < 1.0, "{p:?} lies between the planes: {depth}");
        }
    }

    #[test]
    fn the_pages_fill_the_view_and_no_more() {
        for (layout, aspect) in [(Layout::Spread, 1400), (Layout::Single, 600)] {
            let book = BookSpec::default();
            let view = view(&book, layout, Gaze::Above, aspect, 1000);
            let hand = view.camera::<f64>(&Units { metres: 1.0, kilograms: 1.0 });
            let corner = hand.project(V3([book.width_m, 0.0, 0.5 * book.height_m]));
            let [x, y] = corner.expect("before the eye");
            let [w, h] = [f64::from(aspect), 1000.0];
            assert!(x < w && y < h, "inside: {x} {y}");
            assert!(x > 0.9 * w || y > 0.9 * h, "and large: {x} {y}");
        }
    }
}
