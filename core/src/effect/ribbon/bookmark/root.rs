//! Where a bookmark comes out of the spine: above the head band, between the leaves it lies between.

use super::ground::Layer;
use crate::book::Book;
use crate::collision::Profile;
use crate::effect::ribbon::frame::Frame;
use crate::grid::Grid;
use crate::real::{Real, V2, V3};

/// How far behind the head of the leaves it comes out, metres, and how far below where it lies.
const BEHIND: f64 = 1.5e-3;
const BELOW: f64 = 4e-3;
/// At least so far above the binding, metres.
const ABOVE: f64 = 1e-3;
/// It leaves upwards and towards the tail.
const UP: f64 = 0.8;
const TOWARDS: f64 = 0.6;
/// Share of its width that the gutter is wide where it lies across it.
const ACROSS: f64 = 0.8;
/// Halvings that find that height.
const HALVINGS: u32 = 24;
/// Between leaves it lies so far from where they come up, in its widths.
const ASIDE: f64 = 0.7;

/// The frame it is held in, metres, book frame.
pub(super) fn root<R: Real, G: Grid>(
    book: &Book<R, G>,
    place: u32,
    layer: Layer,
    width: R,
) -> Frame<R> {
    let metres = R::of(book.units().metres);
    let p = match layer {
        Layer::Block(side) => between(book, place, side, width / metres),
        _ => gutter(book, place, width / metres),
    } * metres;
    let half = R::of(0.5 * book.spec().height_m);
    let o = R::ZERO;
    // In a thin book not below what the leaves lie on.
    let y = (p.0[1] - R::of(BELOW)).larger(R::of(ABOVE));
    let at = V3([p.0[0], y, -half - R::of(BEHIND)]);
    Frame::leaning(at, V3([o, R::of(UP), R::of(TOWARDS)]), V3([o, R::of(TOWARDS), -R::of(UP)]))
}

/// Over the gutter of the open spread: where the shoulders of the blocks, circles about the ends of the binding, are as
/// far apart as the ribbon bridges. Model units.
fn gutter<R: Real, G: Grid>(book: &Book<R, G>, place: u32, width: R) -> V2<R> {
    let binding = book.binding();
    let half = binding.half();
    let left = binding.leaf * R::of(f64::from(place));
    let right = half + half - left;
    let sides = |y: R| {
        let shoulder = |r: R| (r * r - y * y).larger(R::ZERO).root();
        [shoulder(left) - half, half - shoulder(right)]
    };
    let (mut low, mut high) = (R::ZERO, left.smaller(right));
    for _ in 0..HALVINGS {
        let y = (low + high) * R::of(0.5);
        let [a, b] = sides(y);
        if b - a < width * R::of(ACROSS) { low = y } else { high = y }
    }
    let [a, b] = sides(high);
    V2([(a + b) * R::of(0.5), high])
}

/// Between leaves of a block, where they have come over its shoulder. Model units.
fn between<R: Real, G: Grid>(book: &Book<R, G>, place: u32, side: usize, width: R) -> V2<R> {
    let binding = book.binding();
    let (Some(strip), sign) = (book.blocks().get(side), if side == 0 { -1.0 } else { 1.0 }) else {
        return V2::zero();
    };
    let leaves = if side == 0 { place } else { binding.all().saturating_sub(place) };
    let above = binding.leaf * R::of(f64::from(leaves));
    let quarter = above * R::of(0.5 * core::f64::consts::PI);
    let p = Profile::new(strip, above).surface(above, quarter + width * R::of(ASIDE));
    V2([p.0[0] * R::of(sign), p.0[1]])
}
