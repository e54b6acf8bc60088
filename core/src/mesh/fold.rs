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

use super::spline::MOST;
use crate::real::{Lanes, Num, Real, V3};

/// The halves of a fold are this far apart one node from it, in lengths of an edge: a turn of 145°.
const APART: f64 = 0.6;

/// Eight rows of nodes, from spine to fore-edge, as they are drawn.
#[derive(Debug)]
pub(super) struct Rows<R: Real> {
    pub(super) nodes: [V3<R::Lanes>; MOST],
    pub(super) slopes: [V3<R::Lanes>; MOST],
    pub(super) count: usize,
    /// One in every lane that is a row, else zero.
    pub(super) there: R::Lanes,
}

/// A sharp fold in some of eight rows.
#[derive(Debug)]
struct Fold<T> {
    /// Cosine of the turn; below zero where it is one.
    turn: T,
    /// The direction it is gone round in, of unit length.
    round: V3<T>,
}

impl<R: Real> Rows<R> {
    pub(super) fn node(&self, i: usize) -> V3<R::Lanes> {
        self.nodes.get(i).copied().unwrap_or_else(V3::zero)
    }
    pub(super) fn slope(&self, i: usize) -> V3<R::Lanes> {
        self.slopes.get(i).copied().unwrap_or_else(V3::zero)
    }

    /// Draws the halves of flat folds apart.
    pub(super) fn open(&mut self, edge: R) {
        for i in 1..self.count.saturating_sub(1) {
            let Some(Fold { turn, round }) = self.fold(i) else { continue };
            let gap = (self.node(i + 1) - self.node(i - 1)).dot(round);
            let lacks = (R::Lanes::of(APART) * R::Lanes::all(edge) - gap).larger(R::Lanes::zero());
            let lacks = R::Lanes::pick_less(turn, R::Lanes::zero(), lacks, R::Lanes::zero());
            // The column at the spine stays.
            let share = R::Lanes::of(if i == 1 { 1.0 } else { 0.5 });
            let shift = round * (lacks * share);
            if let Some(after) = self.nodes.get_mut(i + 1) {
                *after = *after + shift;
            }
            if let Some(before) = self.nodes.get_mut(i - 1).filter(|_| i > 1) {
                *before = *before - shift;
            }
        }
    }

    /// Turns the slopes at sharp folds in their common direction.
    pub(super) fn turn(&mut self) {
        for i in 1..self.count.saturating_sub(1) {
            let Some(Fold { turn, round }) = self.fold(i) else { continue };
            if let Some(slope) = self.slopes.get_mut(i) {
                let old = *slope;
                let pick = |new, old| R::Lanes::pick_less(turn, R::Lanes::zero(), new, old);
                let ([a, b, c], [x, y, z]) = (round.0, old.0);
                *slope = V3([pick(a, x), pick(b, y), pick(c, z)]);
            }
        }
    }

    fn fold(&self, i: usize) -> Option<Fold<R::Lanes>> {
        let before = unit::<R>(self.node(i) - self.node(i - 1));
        let after = unit::<R>(self.node(i + 1) - self.node(i));
        let turn = before.dot(after) * self.there;
        if (-turn).largest() <= R::ZERO {
            return None;
        }
        let axis = before.cross(after);
        let mean = V3(axis.0.map(|c| (c * self.there).sum()));
        let mean = mean * (R::of(1.0) / mean.norm().larger(R::of(1e-6)));
        let axis = axis + V3(mean.0.map(R::Lanes::all));
        Some(Fold { turn, round: unit::<R>(axis.cross(before - after)) })
    }
}

fn unit<R: Real>(v: V3<R::Lanes>) -> V3<R::Lanes> {
    v * (R::Lanes::one() / v.norm().larger(R::Lanes::of(1e-6)))
}
