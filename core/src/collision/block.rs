//! A page block on its board, a board on the table, or a block without a board on the table.

use crate::real::{Real, V2};
use crate::state::strip::{BLOCK, BOARD, Strip};

/// What a chain lies on: a line through the binding's end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ground<R> {
    /// A point of the line.
    pub from: V2<R>,
    /// Unit normal, upwards.
    pub normal: V2<R>,
}

impl<R: Real> Ground<R> {
    /// The table: level with the binding.
    pub fn table() -> Self {
        Self { from: V2::zero(), normal: V2([R::ZERO, R::of(1.0)]) }
    }
    /// A board's upper face.
    pub fn board(board: &Strip<R, BOARD>) -> Self {
        let e = board.x[1] - board.x[0];
        let length = e.norm().larger(R::of(1e-6));
        Self { from: board.x[0], normal: e.left() * (R::of(1.0) / length) }
    }
}

/// Lifts nodes that sank below the ground and remembers them. Answers how many.
pub fn resolve<R: Real, const N: usize>(strip: &mut Strip<R, N>, ground: &Ground<R>) -> u32 {
    let mut pushed = 0;
    let touched = strip.pushed.iter_mut().zip(strip.offset.iter_mut().zip(&mut strip.holding));
    for (x, (dir, (offset, holding))) in strip.x.iter_mut().zip(touched).skip(1) {
        let depth = -ground.normal.dot(*x - ground.from);
        let under = depth > R::ZERO;
        if under {
            *x = *x + ground.normal * depth;
            pushed += 1;
        }
        *dir = ground.normal;
        *offset = ground.normal.dot(*x);
        *holding = if under { R::of(1.0) } else { R::ZERO };
    }
    pushed
}

/// Velocities from the positions before and after a step.
pub fn velocities<R: Real, const N: usize>(strip: &mut Strip<R, N>, before: &[V2<R>; N], h: R) {
    let rate = R::of(1.0) / h;
    for ((v, &x), &b) in strip.v.iter_mut().zip(&strip.x).zip(before) {
        *v = (x - b) * rate;
    }
}

/// A block stands on at most six free nodes.
const _: () = assert!(BLOCK == 7, "the midline has fifteen nodes");
