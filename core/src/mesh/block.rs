//! A page block: curves of one page's length, from the midline up to the open page, extruded along Z.
//!
//! The midline is the underside. The curve at height `y` starts on the binding edge `y` inwards of its
//! end, goes round the end in a circle of radius `y`, then follows the midline at that distance: so
//! does every leaf of a block. All are as long as a page is wide, hence the sheared fore-edge.

use super::curve::{Knot, Polyline, unit};
use super::layout::{LEVELS, Layout};
use super::prism::{Form, Prism};
use super::{Vertex, columns, spline};
use crate::book::Book;
use crate::grid::Grid;
use crate::real::{Real, V2, V3};
use crate::state::strip::{BLOCK, Strip};

/// Directions round the end of the binding; one more than a power of two.
const FAN: usize = 17;
/// Points an edge of the midline gets.
const POINTS: usize = 4;
/// Corners of the drawn midline, the fan included.
const DENSE: usize = FAN + POINTS * (BLOCK - 1) + 1;

/// Fills the parts of one block; nothing where `out` is empty.
pub(super) fn write<R: Real, G: Grid>(book: &Book<R, G>, on_right: bool, out: &mut [Vertex]) {
    let ([left, right], [a, b]) = (book.blocks(), book.binding().thickness());
    let (strip, thickness) = if on_right { (right, b) } else { (left, a) };
    let form = Form {
        columns: Layout::<G>::COLUMNS,
        levels: LEVELS,
        sign: if on_right { 1.0 } else { -1.0 },
        half_height: half_height(book),
        metres: book.units().metres as f32,
    };
    let Some(mut prism) = Prism::new(form, out) else { return };
    let end = V2(strip.x[0].0.map(Real::narrow));
    let midline = dense(strip);
    let mut line = Polyline::new();
    let last = form.columns - 1;
    for level in 0..LEVELS {
        let height = thickness.narrow() * (level as f32 / (LEVELS - 1) as f32);
        curve(&midline, height, &mut line);
        for (column, (share, knot)) in line.pace(last, columns::steps(last)).enumerate() {
            prism.set(column, level, share, knot.p.xy() + end, knot.n);
        }
    }
    prism.finish();
}

/// Half the height of the pages, model units.
pub(super) fn half_height<R: Real, G: Grid>(book: &Book<R, G>) -> f32 {
    book.sheet().spacing[1].narrow() * 0.5 * (G::NZ - 1) as f32
}

/// The curve at `height` above the midline, seen from the midline's first node.
pub(super) fn curve(midline: &[Knot; DENSE], height: f32, line: &mut Polyline) {
    line.clear();
    // The underside has no way round the end.
    let from = if height > 0.0 { 0 } else { FAN };
    for knot in midline.iter().skip(from) {
        let forward = V3([knot.n.0[1], -knot.n.0[0], 0.0]);
        line.push(Knot { p: knot.p + knot.n * height, n: knot.n }, forward, 0.0);
    }
}

/// The midline as a smooth curve seen from its first node, with its normals; the fan before it.
pub(super) fn dense<R: Real>(strip: &Strip<R, BLOCK>) -> [Knot; DENSE] {
    let spans = Smooth::new(strip);
    let mut knots = [Knot { p: V3([0.0; 3]), n: V3([0.0; 3]) }; DENSE];
    for (n, knot) in knots.iter_mut().skip(FAN).enumerate() {
        let span = (n / POINTS).min(BLOCK - 2);
        *knot = spans.at(span, (n - POINTS * span) as f64 / POINTS as f64);
    }
    let first = knots.get(FAN).map_or(V3([0.0, 1.0, 0.0]), |knot| knot.n);
    for (knot, n) in knots.iter_mut().zip(fan(first)) {
        knot.n = n;
    }
    knots
}

/// Unit vectors evenly spread from towards the other side to `to`, by halving.
fn fan(to: V3<f32>) -> [V3<f32>; FAN] {
    let mut rays = [V3([-1.0, 0.0, 0.0]); FAN];
    if let Some(last) = rays.last_mut() {
        *last = to;
    }
    let mut step = FAN / 2;
    while step > 0 {
        for i in (step..FAN).step_by((2 * step).max(1)) {
            let ray = |i: usize| rays.get(i).copied().unwrap_or(to);
            let middle = unit(ray(i - step) + ray(i + step), V3([0.0, 1.0, 0.0]));
            if let Some(slot) = rays.get_mut(i) {
                *slot = middle;
            }
        }
        step /= 2;
    }
    rays
}

/// Points and slopes of the drawn midline.
///
/// Where it bends over, the curve cuts the corner and touches the middles of the edges; where it is
/// hollow it goes through the corner and sags below the edges. So it never stands above the polyline
/// the leaf was kept off.
#[derive(Debug)]
struct Smooth {
    p: [V3<f32>; BLOCK],
    m: [V3<f32>; BLOCK],
}

impl Smooth {
    fn new<R: Real>(strip: &Strip<R, BLOCK>) -> Self {
        let origin = strip.x[0];
        let p = strip.x.map(|x| V3([(x - origin).0[0].narrow(), (x - origin).0[1].narrow(), 0.0]));
        let mut smooth = Self { p, m: [V3([0.0; 3]); BLOCK] };
        let inner = smooth.p.iter_mut().zip(&mut smooth.m).skip(1);
        for ((point, slope), &[a, b, c]) in inner.zip(p.array_windows::<3>()) {
            let bend = a - b * 2.0 + c;
            let over = (b - a).xy().cross((c - b).xy()) < 0.0;
            *point = if over { b + bend * 0.125 } else { b };
            *slope = (c - a) * 0.5;
        }
        smooth.close();
        smooth
    }

    /// Slopes at both ends, free of moment.
    fn close(&mut self) {
        let free = |from: V3<f32>, to: V3<f32>, m: V3<f32>| (to - from) * 1.5 - m * 0.5;
        let ([a, b, .., y, z], [ma, mb, .., my, mz]) = (&self.p, &mut self.m);
        *ma = free(*a, *b, *mb);
        *mz = free(*y, *z, *my);
    }

    fn at(&self, span: usize, t: f64) -> Knot {
        let two = |v: &[V3<f32>; BLOCK]| {
            [v.get(span), v.get(span + 1)].map(|v| v.copied().unwrap_or(V3([0.0; 3])))
        };
        let (p, m) = (two(&self.p), two(&self.m));
        let along = spline::blend(p, m, spline::slope_weights(t));
        let n = unit(V3([-along.0[1], along.0[0], 0.0]), V3([0.0, 1.0, 0.0]));
        Knot { p: spline::blend(p, m, spline::weights(t)), n }
    }
}
