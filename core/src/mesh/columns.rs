//! Where the columns of leaf and blocks stand, as shares of a page's width: closer near the binding.
//!
//! Near the spine the page of a block of `n` leaves goes round a quarter circle of radius `n` leaves,
//! so the first columns grow by a constant ratio: any radius gets some. Source: Book Sec. 3.5,
//! "Upsampling at binding".

use crate::scene::units::WIDTH;

/// Columns that grow.
const GROWING: usize = 16;
/// Each is this much narrower than the next.
const RATIO: f64 = 0.83;
/// Columns an edge of the net gets, far from the spine.
const ACROSS: usize = 3;
/// Columns more than three an edge.
const MORE: usize = 10;
/// Vertices a row has at most: those of the finest grid.
pub(super) const MOST: usize = count(32) + 1;

/// Columns of a grid with `nx` nodes across.
pub(super) const fn count(nx: usize) -> usize {
    ACROSS * (nx - 1) + MORE
}

/// Widths of the columns in a unit of the widest, and their sum.
fn relative(columns: usize) -> (impl Iterator<Item = f64>, f64) {
    let (mut least, mut sum) = (1.0, 0.0);
    for _ in 0..GROWING {
        least *= RATIO;
        sum += least;
    }
    let mut width = least;
    let widths = (0..columns).map(move |n| {
        let now = width;
        width = if n + 1 < GROWING { now / RATIO } else { 1.0 };
        now
    });
    (widths, sum + columns.saturating_sub(GROWING) as f64)
}

/// Shares of the width at the vertices: 0 at the spine, 1 at the fore-edge.
pub(super) fn shares(columns: usize) -> impl Iterator<Item = f64> {
    let (widths, sum) = relative(columns);
    let mut at = 0.0;
    let inner = widths.enumerate().map(move |(n, w)| {
        at += w / sum;
        if n + 1 == columns { 1.0 } else { at }
    });
    core::iter::once(0.0).chain(inner)
}

/// Way to each vertex from the one before, model units; nothing to the first.
pub(super) fn steps(columns: usize) -> impl Iterator<Item = f32> {
    let mut before = 0.0;
    shares(columns).map(move |share| {
        let step = (share - before) * WIDTH;
        before = share;
        step as f32
    })
}
