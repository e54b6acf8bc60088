//! Sharp folds, so that all rows go round them the same way.
//!
//! A net may fold flat upon itself at a node, where paper would keep a loop. Drawn as it is, the two
//! halves would lie in each other and no normal at the fold could face both. So the halves are drawn a
//! little apart, and the direction in which the fold is gone round is the rows' common one:
//!
//! ```text
//! φ > 90°:  t ∥ b × (d₁ - d₂)     d₁, d₂ unit chords before and after the node
//!           b = d₁ × d₂ + the mean direction of d₁ × d₂ over the rows
//! ```
//!
//! For a lone fold `t` is the direction half-way between the chords. In a flat one that is lost in
//! rounding, but the neighbours know it.

use super::spline::Line;
use crate::grid::Grid;
use crate::real::{Eight as _, Lanes, Num, Real, V3};
use crate::state::Field;

/// The halves of a fold are this far apart one node from it, in lengths of an edge: a turn of 145°.
const APART: f64 = 0.6;

/// Eight rows of a field, from spine to fore-edge.
#[derive(Debug)]
pub(super) struct Eight<'a, R: Real, G: Grid> {
    pub(super) field: &'a mut Field<R, G>,
    /// The first of the rows.
    pub(super) k: usize,
}

impl<R: Real, G: Grid> Line<R::Eight> for Eight<'_, R, G> {
    #[inline(always)]
    fn at(&self, i: usize) -> V3<R::Eight> {
        self.field.eight(i, self.k)
    }
    #[inline(always)]
    fn put(&mut self, i: usize, v: V3<R::Eight>) {
        self.field.set_eight(i, self.k, v);
    }
}

/// A sharp fold in some of eight rows.
#[derive(Debug)]
struct Fold<T> {
    /// Cosine of the turn; below zero where it is one.
    turn: T,
    /// The direction it is gone round in, of unit length.
    round: V3<T>,
}

/// Draws the halves of flat folds apart; `edge` is the length of an edge.
pub(super) fn open<R: Real, G: Grid>(nodes: &mut Eight<'_, R, G>, edge: R) {
    let zero = R::Eight::zero();
    for i in 1..G::NX - 1 {
        let Some(Fold { turn, round }) = fold(nodes, i) else { continue };
        let gap = (nodes.at(i + 1) - nodes.at(i - 1)).dot(round);
        let lacks = (R::Eight::all(R::of(APART) * edge) - gap).larger(zero);
        // The column at the spine stays.
        let share = R::Eight::of(if i == 1 { 1.0 } else { 0.5 });
        let shift = round * (R::Eight::pick_less(turn, zero, lacks, zero) * share);
        nodes.put(i + 1, nodes.at(i + 1) + shift);
        if i > 1 {
            nodes.put(i - 1, nodes.at(i - 1) - shift);
        }
    }
}

/// Turns the slopes at sharp folds in their common direction.
pub(super) fn turn<R: Real, G: Grid>(nodes: &Eight<'_, R, G>, slopes: &mut Eight<'_, R, G>) {
    for i in 1..G::NX - 1 {
        let Some(Fold { turn, round }) = fold(nodes, i) else { continue };
        let pick = |new, old| R::Eight::pick_less(turn, R::Eight::zero(), new, old);
        let ([a, b, c], [x, y, z]) = (round.0, slopes.at(i).0);
        slopes.put(i, V3([pick(a, x), pick(b, y), pick(c, z)]));
    }
}

/// The fold at node `i`, if any of the rows has one.
fn fold<R: Real, G: Grid>(nodes: &Eight<'_, R, G>, i: usize) -> Option<Fold<R::Eight>> {
    let there = R::Eight::mask(nodes.k, 0, G::NZ);
    let before = unit::<R>(nodes.at(i) - nodes.at(i - 1));
    let after = unit::<R>(nodes.at(i + 1) - nodes.at(i));
    let turn = before.dot(after) * there;
    if (-turn).largest() <= R::ZERO {
        return None;
    }
    let axis = before.cross(after);
    let mean = V3(axis.0.map(|c| (c * there).sum()));
    let mean = mean * (R::of(1.0) / mean.norm().larger(R::of(1e-6)));
    let axis = axis + V3(mean.0.map(R::Eight::all));
    Some(Fold { turn, round: unit::<R>(axis.cross(before - after)) })
}

fn unit<R: Real>(v: V3<R::Eight>) -> V3<R::Eight> {
    v * (R::Eight::one() / v.norm().larger(R::Eight::of(1e-6)))
}
