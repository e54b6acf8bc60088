//! How large a page is drawn: into the caller's box, its shape kept.

use crate::limits::{MAX_ELONGATION, MAX_PIXELS, MAX_SIDE_PX};

/// The largest size of the page's shape within the box, at most `enlarge` times the page, and
/// never more than may be allocated.
pub(crate) fn fit(page: (f32, f32), max: (u32, u32), enlarge: f64) -> (u32, u32) {
    let (w, h) = (f64::from(page.0), f64::from(page.1));
    let (max_w, max_h) = (max.0.clamp(1, MAX_SIDE_PX), max.1.clamp(1, MAX_SIDE_PX));
    let wanted = (f64::from(max_w) / w).min(f64::from(max_h) / h).min(enlarge);
    let affordable = (MAX_PIXELS as f64 / (w * h)).sqrt();
    // Rounded up on both sides it would be just over the limit.
    let whole = if wanted < affordable { f64::round } else { f64::floor };
    let side =
        |length: f64, max: u32| (whole(length * wanted.min(affordable)) as u32).clamp(1, max);
    (side(w, max_w), side(h, max_h))
}

/// Whether a page of this size can be drawn at all.
pub(crate) fn check_shape((w, h): (f32, f32)) -> Result<(), String> {
    let elongation = (w / h).max(h / w);
    if w > 0.0 && h > 0.0 && elongation <= MAX_ELONGATION {
        return Ok(());
    }
    Err(format!("its size, {w} x {h}, is not that of a page"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shape_is_kept_and_the_box_respected() {
        assert_eq!(fit((100.0, 200.0), (1000, 1000), 20.0), (500, 1000), "height binds");
        assert_eq!(fit((100.0, 200.0), (50, 1000), 20.0), (50, 100), "width binds");
        assert_eq!(fit((100.0, 200.0), (1000, 1000), 2.0), (200, 400), "enlargement binds");
        assert_eq!(fit((100.0, 200.0), (0, 0), 2.0), (1, 1), "an empty box is one pixel");
    }

    #[test]
    fn no_box_asks_for_more_than_the_limits() {
        for page in [(1.0, 1.0), (3.0, 4.0), (8e3, 8e3), (200.0, 1.0), (1.0, 7.3)] {
            for max in [(u32::MAX, u32::MAX), (16_384, 16_384), (u32::MAX, 3)] {
                let (w, h) = fit(page, max, f64::INFINITY);
                assert!(w <= MAX_SIDE_PX && h <= MAX_SIDE_PX, "{w} x {h} has a side too long");
                assert!(u64::from(w) * u64::from(h) <= MAX_PIXELS, "{w} x {h} is too much");
            }
        }
        assert_eq!(fit((1.0, 1.0), (9000, 9000), 1e9), (8000, 8000), "64 megapixels");
    }

    #[test]
    fn impossible_shapes_are_refused() {
        for bad in [(0.0, 1.0), (f32::NAN, 1.0), (1.0, f32::INFINITY), (1.0, -1.0), (1.0, 201.0)] {
            assert!(check_shape(bad).is_err(), "{bad:?} passed for a page");
        }
        assert!(check_shape((1.0, 200.0)).is_ok(), "a long strip is a page");
    }
}
