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

/// Lifts nodes that sank below the ground, keeps them on their side of the binding, and remembers them.
/// Answers how many.
///
/// # Hard case
///
/// A block stiffer than its weight stands up in the binding; without the wall it could fall to the other side.
pub fn resolve<R: Real, const N: usize>(strip: &mut Strip<R, N>, ground: &Ground<R>) -> u32 {
    let mut pushed = 0;
    let inner = strip.x.first().copied().unwrap_or_default();
    let wall = Ground { from: inner, normal: V2([R::of(1.0), R::ZERO]) };
    let touched = strip.pushed.iter_mut().zip(strip.offset.iter_mut().zip(&mut strip.holding));
    for (x, (dir, (offset, holding))) in strip.x.iter_mut().zip(touched).skip(1) {
        let depth = |g: &Ground<R>| -g.normal.dot(*x - g.from);
        let deepest = if depth(&wall) > depth(ground) { wall } else { *ground };
        let under = depth(&deepest);
        if under > R::ZERO {
            *x = *x + deepest.normal * under;
            pushed += 1;
        }
        *dir = deepest.normal;
        *offset = deepest.normal.dot(*x);
        *holding = if under > R::ZERO { R::of(1.0) } else { R::ZERO };
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
