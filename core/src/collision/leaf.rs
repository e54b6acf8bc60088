//! The leaf against both page blocks, as many rows at a time as travel together.
//!
//! Nodes against the blocks' edges, and the blocks' nodes against the leaf's edges. The leaf belongs
//! above both midlines from the start, so the side of a push never has to be guessed: a node that was
//! thrown through a block comes back up along the normal. Beyond a block's end its last edge goes on,
//! as the leaf is assumed above the block and never beside it.
//!
//! Source: Book Sec. 3.4. Not handled, as in the seed: self-collision, friction.

use super::profile::{Profile, Segment};
use crate::grid::Grid;
use crate::real::{Lanes, Num, Real, V2, V3};
use crate::state::field::groups;
use crate::state::{Field, Leaf};

/// A node whose squared distance is more than this much above the clearance's is clear of the block.
const MARGIN: f64 = 1.001;

/// What a pass did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Outcome {
    /// Passes taken.
    pub passes: u32,
    /// Nodes moved in the last step's passes.
    pub pushed: u32,
}

/// The deepest overlap found so far.
#[derive(Debug, Clone, Copy)]
struct Push<T> {
    depth: T,
    direction: V2<T>,
}

/// Resolves overlaps by at most `passes` passes and remembers what was pushed.
///
/// `sides` are the outlines of the left and the right block; `half` is half the leaf's thickness.
///
/// # Cost
///
/// One pass at 11x8 about 3,000 lane operations; a leaf in the air takes one.
pub fn resolve<R: Real, G: Grid>(
    leaf: &mut Leaf<R, G>,
    sides: [&Profile<R>; 2],
    half: R,
    passes: u32,
    before: &mut Field<R, G>,
) -> Outcome {
    before.copy_from(&leaf.x);
    let mut done = 0;
    for _ in 0..passes {
        done += 1;
        let mut moved = nodes(leaf, sides, half);
        moved |= edges(leaf, sides, half);
        if !moved {
            break;
        }
    }
    Outcome { passes: done, pushed: remember(leaf, before) }
}

/// Nodes of the leaf against the edges of the blocks. Answers whether any moved.
fn nodes<R: Real, G: Grid>(leaf: &mut Leaf<R, G>, sides: [&Profile<R>; 2], half: R) -> bool {
    let mut moved = false;
    let top = sides.iter().fold(R::ZERO, |top, side| top.larger(side.top() + side.thickness));
    for i in 1..G::NX {
        if lowest(&leaf.x, i) > top + half {
            continue;
        }
        for k in groups::<R, G>() {
            let x = leaf.x.rows(i, k, 0);
            let zero = R::Lanes::zero();
            let mut push = Push { depth: zero, direction: V2::zero() };
            for (side, sign) in sides.into_iter().zip([-1.0, 1.0]) {
                let sign = R::Lanes::of(sign);
                let outward = V2([x.0[0] * sign, x.0[1]]);
                let found = deepest(side, outward, side.thickness + half);
                let pick = |new, old| R::Lanes::pick_less(push.depth, found.depth, new, old);
                push = Push {
                    depth: pick(found.depth, push.depth),
                    direction: V2([
                        pick(found.direction.0[0] * sign, push.direction.0[0]),
                        pick(found.direction.0[1], push.direction.0[1]),
                    ]),
                };
            }
            let push = spine(sides, x.xy(), push);
            if push.depth.largest() > R::ZERO {
                moved = true;
                let shift = push.direction * push.depth;
                leaf.x.add_rows(i, k, 0, V3([shift.0[0], shift.0[1], zero]));
            }
        }
    }
    moved
}

/// Height of the lowest node of column `i`: a column that is high enough touches nothing.
fn lowest<R: Real, G: Grid>(x: &Field<R, G>, i: usize) -> R {
    let first = x.at(i, 0).0[1];
    (1..G::NZ).fold(first, |low, k| low.smaller(x.at(i, k).0[1]))
}

/// The floor between the blocks: below the binding's level the spine is solid.
#[inline(always)]
fn spine<R: Real>(
    sides: [&Profile<R>; 2],
    p: V2<R::Lanes>,
    push: Push<R::Lanes>,
) -> Push<R::Lanes> {
    let (zero, one) = (R::Lanes::zero(), R::Lanes::one());
    let [left, right] = sides.map(|s| R::Lanes::all(s.segments[0].from.0[0]));
    let inside =
        R::Lanes::pick_less(-p.0[0], left, R::Lanes::pick_less(p.0[0], right, one, zero), zero);
    let depth = -p.0[1] * inside;
    let pick = |new, old| R::Lanes::pick_less(push.depth, depth, new, old);
    Push {
        depth: pick(depth, push.depth),
        direction: V2([pick(zero, push.direction.0[0]), pick(one, push.direction.0[1])]),
    }
}

/// How deep points lie below the curve `clearance` above a block, and which way is out.
#[inline(always)]
fn deepest<R: Real>(side: &Profile<R>, p: V2<R::Lanes>, clearance: R) -> Push<R::Lanes> {
    let zero = R::Lanes::zero();
    let mut nearest_sq = R::Lanes::of(1e18);
    let mut nearest = V2::zero();
    let mut normal = V2::zero();
    let mut side_of = R::Lanes::one();
    let last = side.segments.len() - 1;
    for (n, s) in side.segments.iter().enumerate() {
        let (v, above) = from_segment::<R>(s, p, n == 0, n == last);
        let d_sq = v.norm_sq();
        let better = |new, old| R::Lanes::pick_less(d_sq, nearest_sq, new, old);
        let n = s.normal.0.map(R::Lanes::all);
        nearest = V2([better(v.0[0], nearest.0[0]), better(v.0[1], nearest.0[1])]);
        normal = V2([better(n[0], normal.0[0]), better(n[1], normal.0[1])]);
        side_of = better(above, side_of);
        nearest_sq = better(d_sq, nearest_sq);
    }
    // Most nodes are further away than that: no root is needed to see it, with a margin for its rounding.
    let reach = R::Lanes::all(clearance * clearance * R::of(MARGIN));
    let close = R::Lanes::pick_less(nearest_sq, reach, R::Lanes::one(), zero);
    let below = R::Lanes::pick_less(side_of, zero, R::Lanes::one(), zero);
    if (close + below).largest() <= R::ZERO {
        return Push { depth: zero, direction: V2::zero() };
    }
    let length = nearest_sq.root();
    let sign = R::Lanes::pick_less(side_of, zero, R::Lanes::of(-1.0), R::Lanes::one());
    let scale = sign / length.larger(R::Lanes::of(1e-9));
    let tiny = R::Lanes::of(1e-6);
    let direction =
        |normal: R::Lanes, v: R::Lanes| R::Lanes::pick_less(length, tiny, normal, v * scale);
    let out = V2([direction(normal.0[0], nearest.0[0]), direction(normal.0[1], nearest.0[1])]);
    let depth = R::Lanes::all(clearance) - length * sign;
    // Below the binding's level on the far side of the fan there is no paper of this block.
    let beside = in_shadow::<R>(side, p, out);
    Push { depth: depth.larger(zero) * beside, direction: out }
}

/// Vector from the nearest point of a segment, and its component along the upward normal.
///
/// Before the first segment lies the fan: every point there is outside, however low. After the last the
/// block goes on.
#[inline(always)]
fn from_segment<R: Real>(
    s: &Segment<R>,
    p: V2<R::Lanes>,
    first: bool,
    last: bool,
) -> (V2<R::Lanes>, R::Lanes) {
    let lanes = |v: V2<R>| V2(v.0.map(R::Lanes::all));
    let away = p - lanes(s.from);
    let (zero, one) = (R::Lanes::zero(), R::Lanes::one());
    let reached = away.dot(lanes(s.along));
    let t = reached.larger(zero);
    let t = if last { t } else { t.smaller(R::Lanes::all(s.length)) };
    let above = away.dot(lanes(s.normal));
    let above = if first { R::Lanes::pick_less(reached, zero, one, above) } else { above };
    (away - lanes(s.along) * t, above)
}

/// One where the way out has no downward part, or the point is over the block; else zero.
#[inline(always)]
fn in_shadow<R: Real>(side: &Profile<R>, p: V2<R::Lanes>, out: V2<R::Lanes>) -> R::Lanes {
    let over = p.0[0] - R::Lanes::all(side.segments[0].from.0[0]);
    let one = R::Lanes::one();
    let fan = R::Lanes::pick_less(out.0[1], R::Lanes::of(-1e-4), R::Lanes::zero(), one);
    R::Lanes::pick_less(over, R::Lanes::zero(), fan, one)
}

/// Nodes of the blocks against the edges of the leaf. Answers whether any edge moved.
fn edges<R: Real, G: Grid>(leaf: &mut Leaf<R, G>, sides: [&Profile<R>; 2], half: R) -> bool {
    let mut moved = false;
    for (side, sign) in sides.into_iter().zip([-1.0, 1.0]) {
        let clearance = R::Lanes::all(side.thickness + half);
        for s in side.segments.iter().skip(1) {
            let node = V2([s.from.0[0] * R::of(sign), s.from.0[1]]);
            let near = node.0[1] + (side.thickness + half) * R::of(MARGIN);
            for i in 1..G::NX - 1 {
                if lowest(&leaf.x, i) > near && lowest(&leaf.x, i + 1) > near {
                    continue;
                }
                for k in groups::<R, G>() {
                    moved |= edge::<R, G>(leaf, i, k, node, R::of(sign), clearance);
                }
            }
        }
    }
    moved
}

/// One block node against the edges between columns `i` and `i + 1`.
#[inline(always)]
fn edge<R: Real, G: Grid>(
    leaf: &mut Leaf<R, G>,
    i: usize,
    k: usize,
    node: V2<R>,
    sign: R,
    clearance: R::Lanes,
) -> bool {
    let (a, b) = (leaf.x.rows(i, k, 0).xy(), leaf.x.rows(i + 1, k, 0).xy());
    let e = b - a;
    let to = V2(node.0.map(R::Lanes::all)) - a;
    let length_sq = e.norm_sq().larger(R::Lanes::of(1e-9));
    let t = to.dot(e) / length_sq;
    let zero = R::Lanes::zero();
    // An edge that runs inwards above the block is folded over it: it has no underside here.
    let outward = e.0[0] * R::Lanes::all(sign);
    let (one, less) = (R::Lanes::one(), R::Lanes::pick_less);
    let beside = less(zero, t, less(t, one, less(zero, outward, one, zero), zero), zero);
    if beside.largest() <= R::ZERO {
        return false;
    }
    let normal = e.left() * (R::Lanes::all(sign) / length_sq.root());
    let above = normal.dot(to);
    let along = R::Lanes::pick_less(t, R::Lanes::one(), clearance + above, zero);
    let inside = R::Lanes::pick_less(zero, t, along, zero);
    // A node far above the line is another part of the block, beside a leaf that stands on it.
    let near = R::Lanes::pick_less(above, clearance, inside, zero);
    let depth = R::Lanes::pick_less(zero, outward, near, zero).larger(zero);
    if depth.largest() <= R::ZERO {
        return false;
    }
    let shift = normal * depth;
    let shift = V3([shift.0[0], shift.0[1], zero]);
    leaf.x.add_rows(i, k, 0, shift);
    leaf.x.add_rows(i + 1, k, 0, shift);
    true
}

/// Remembers which nodes were moved, and where to: the contacts of the next solve. Answers how many.
fn remember<R: Real, G: Grid>(leaf: &mut Leaf<R, G>, before: &Field<R, G>) -> u32 {
    let (zero, one) = (R::Lanes::zero(), R::Lanes::one());
    for i in 0..G::NX {
        for k in groups::<R, G>() {
            let x = leaf.x.rows(i, k, 0).xy();
            let shift = x - before.rows(i, k, 0).xy();
            let length = shift.norm();
            let n = shift * (one / length.larger(R::Lanes::of(1e-12)));
            let on = R::Lanes::pick_less(R::Lanes::of(1e-9), length, one, zero);
            leaf.pushed.set_rows(i, k, 0, V3([n.0[0] * on, n.0[1] * on, n.dot(x) * on]));
            leaf.holding.set_rows(i, k, on);
        }
    }
    Field::<R, G>::nodes().filter(|&(i, k)| leaf.holding.at(i, k) > R::ZERO).count() as u32
}
