//! The cover: a box below each block, and the strip that joins them below the binding.

use super::Vertex;
use super::block::half_height;
use super::prism::{Form, Prism};
use crate::book::Book;
use crate::grid::Grid;
use crate::real::{Num, Real, V2, V3};
use crate::scene::Cover;
use crate::state::strip::{BOARD, Strip};

/// Thickness of a board, metres. Boards lie on the table, so it is this far below the binding.
pub const BOARD_M: f64 = 2.5e-3;
/// How far boards stand out beyond tail and head of the leaves, metres.
pub const OVERHANG_M: f64 = 3.0e-3;

/// How far the table lies below the binding (`y = 0`), metres.
pub fn table_drop_m(cover: Cover) -> f64 {
    match cover {
        Cover::Hard => BOARD_M,
        Cover::Soft => 0.0,
    }
}

/// A board seen from its side, outward: inner and outer end, underside and upper face.
#[derive(Debug, Clone, Copy)]
struct Profile {
    below: [V2<f32>; 2],
    above: [V2<f32>; 2],
    normal: V2<f32>,
}

impl Profile {
    fn new<R: Real>(board: &Strip<R, BOARD>, thickness: f32) -> Self {
        let above = board.x.map(|x| V2(x.0.map(Real::narrow)));
        let e = above[1] - above[0];
        let normal = e.left() * (1.0 / e.norm().larger(1e-6));
        Self { below: above.map(|p| p - normal * thickness), above, normal }
    }
}

/// Fills boards and spine; nothing where `out` is empty.
pub(super) fn write<R: Real, G: Grid>(book: &Book<R, G>, out: &mut [Vertex]) {
    let Some(boards) = book.boards() else { return };
    let metres = book.units().metres;
    let [left, right] = boards.each_ref().map(|b| Profile::new(b, (BOARD_M / metres) as f32));
    let form = |sign| Form {
        columns: 2,
        levels: 2,
        sign,
        half_height: half_height(book) + (OVERHANG_M / metres) as f32,
        metres: metres as f32,
    };
    let mirror = |p: V2<f32>| V2([-p.0[0], p.0[1]]);
    let spine = Profile {
        below: [mirror(left.below[0]), right.below[0]],
        above: [mirror(left.above[0]), right.above[0]],
        normal: V2([0.0, 1.0]),
    };
    let bodies = [(-1.0, left), (1.0, right), (1.0, spine)];
    for (vertices, (sign, profile)) in out.chunks_exact_mut(out.len().max(3) / 3).zip(bodies) {
        let Some(mut prism) = Prism::new(form(sign), vertices) else { return };
        let [x, y] = profile.normal.0;
        let normal = V3([x, y, 0.0]);
        for (level, points) in [profile.below, profile.above].into_iter().enumerate() {
            for (column, p) in points.into_iter().enumerate() {
                prism.set(column, level, column as f32, p, normal);
            }
        }
        prism.finish();
    }
}
