//! Normals of one side of the leaf, from where its vertices ended up.
//!
//! Where the leaf folds so sharply that neighbours face away from each other, a normal is chosen that
//! all triangles around the vertex agree with.

use super::curve::{norm, unit};
use super::layout::ALONG;
use super::{Vertex, spline};
use crate::real::V3;

/// Neighbours whose normals meet at less than this cosine are at a fold.
const FOLD: f32 = 0.7;
/// The columns at the spine are so narrow that a triangle may stand out of them unseen.
const NARROW: usize = 3;
/// Corrections a normal at a fold gets at most.
const ROUNDS: usize = 24;
/// Least cosine between it and a triangle around it that is aimed at.
const AGREE: f32 = 0.05;
/// Vertices of a column at most.
const MOST: usize = ALONG * (spline::MOST - 1) + 1;
/// Neighbours of a vertex, the way round in which columns and rows grow.
const RING: [(isize, isize); 6] = [(-1, -1), (0, -1), (1, 0), (1, 1), (0, 1), (-1, 0)];

/// Derivative at `i` of `n` points along a line, second order; only its direction matters.
pub(super) fn direction(i: usize, n: usize, p: impl Fn(usize) -> V3<f32>) -> V3<f32> {
    if i == 0 {
        p(1) - p(0)
    } else if i + 1 < n {
        p(i + 1) - p(i - 1)
    } else {
        p(i) * 3.0 - p(i.saturating_sub(1)) * 4.0 + p(i.saturating_sub(2))
    }
}

/// A refined net as it stands in the buffer.
#[derive(Debug, Clone, Copy)]
pub(super) struct Net {
    pub(super) columns: usize,
    pub(super) rows: usize,
    /// One where normals go up from a leaf on the right, else minus one.
    pub(super) side: f32,
}

impl Net {
    /// Sets all normals.
    ///
    /// # Hard case
    ///
    /// The direction across is the sum of two chords of nearly equal length, so it agrees with both
    /// however sharply they fold. With a twist besides, see [`Net::folds`].
    pub(super) fn normals(&self, net: &mut [Vertex]) {
        let mut across = [V3([0.0; 3]); MOST];
        for j in 0..self.columns {
            self.across(net, j, &mut across);
            let start = j * self.rows;
            let Some(column) = net.get_mut(start..start + self.rows) else { return };
            let mut along = [V3([0.0; 3]); MOST];
            for (r, slot) in along.iter_mut().enumerate().take(self.rows) {
                let p = |r: usize| column.get(r).map_or(V3([0.0; 3]), |v| V3(v.position));
                *slot = direction(r, self.rows, p);
            }
            let up = V3([0.0, self.side, 0.0]);
            for (v, (&a, &b)) in column.iter_mut().zip(across.iter().zip(&along)) {
                v.normal = unit((a * 1e4).cross(b * (1e4 * self.side)), up).0;
            }
        }
    }

    /// Directions across at the vertices of column `j`.
    fn across(&self, net: &[Vertex], j: usize, out: &mut [V3<f32>; MOST]) {
        let column = |j: usize| {
            let start = j * self.rows;
            net.get(start..start + self.rows).unwrap_or_default()
        };
        let place = |v: &Vertex| V3(v.position);
        if j + 1 < self.columns {
            let pairs = column(j + 1).iter().zip(column(j.saturating_sub(1)));
            for (slot, (next, last)) in out.iter_mut().zip(pairs) {
                *slot = place(next) - place(last);
            }
            return;
        }
        let (two, one) = (column(j.saturating_sub(2)), column(j.saturating_sub(1)));
        for (slot, (here, (a, b))) in out.iter_mut().zip(column(j).iter().zip(two.iter().zip(one)))
        {
            *slot = place(here) * 3.0 - place(b) * 4.0 + place(a);
        }
    }

    /// Corrects normals at folds. Answers the first and the last column where no normal agrees with all
    /// triangles around.
    pub(super) fn folds(&self, net: &mut [Vertex]) -> Option<(usize, usize)> {
        let mut failed = None;
        let narrow = if self.sharp(net) { self.columns } else { NARROW };
        for j in 0..narrow {
            for r in 0..self.rows {
                if !self.folded(net, j, r) {
                    continue;
                }
                match self.agreed(net, j, r) {
                    Some(n) => self.set(net, j, r, |v| v.normal = n.0),
                    None => failed = Some((failed.map_or(j, |(first, _)| first), j)),
                }
            }
        }
        failed
    }

    /// Draws the rows straighter between two columns: each vertex goes to the middle of its neighbours,
    /// once outwards and once back.
    pub(super) fn smooth(&self, net: &mut [Vertex], first: usize, last: usize) {
        let band = first.max(1)..(last + 1).min(self.columns - 1);
        for j in band.clone().chain(band.rev()) {
            for r in 0..self.rows {
                let p =
                    |j: usize| net.get(j * self.rows + r).map_or(V3([0.0; 3]), |v| V3(v.position));
                let place = (p(j - 1) + p(j + 1)) * 0.5;
                self.set(net, j, r, |v| v.position = place.0);
            }
        }
    }

    fn set(&self, net: &mut [Vertex], j: usize, r: usize, change: impl FnOnce(&mut Vertex)) {
        if let Some(v) = net.get_mut(j * self.rows + r) {
            change(v);
        }
    }

    /// Whether any two neighbours are at a fold.
    fn sharp(&self, net: &[Vertex]) -> bool {
        let sharp = |(a, b): (&Vertex, &Vertex)| V3(a.normal).dot(V3(b.normal)) < FOLD;
        let across = net.iter().zip(net.iter().skip(self.rows)).any(sharp);
        across
            || net.chunks_exact(self.rows.max(1)).any(|c| c.iter().zip(c.iter().skip(1)).any(sharp))
    }

    fn folded(&self, net: &[Vertex], j: usize, r: usize) -> bool {
        let Some(here) = net.get(j * self.rows + r) else { return false };
        if j < NARROW {
            return true;
        }
        RING.iter().any(|&by| {
            self.neighbour(net, j, r, by).is_some_and(|v| V3(v.normal).dot(V3(here.normal)) < FOLD)
        })
    }

    fn neighbour<'a>(
        &self,
        net: &'a [Vertex],
        j: usize,
        r: usize,
        by: (isize, isize),
    ) -> Option<&'a Vertex> {
        let j = j.checked_add_signed(by.0).filter(|&j| j < self.columns)?;
        let r = r.checked_add_signed(by.1).filter(|&r| r < self.rows)?;
        net.get(j * self.rows + r)
    }

    /// A normal that agrees with every triangle around, if there is one: starts at their mean and leans
    /// towards those that do not agree yet.
    fn agreed(&self, net: &[Vertex], j: usize, r: usize) -> Option<V3<f32>> {
        let here = net.get(j * self.rows + r).copied().unwrap_or_default();
        let spoke = |n: usize| {
            let by = RING.get(n % RING.len()).copied().unwrap_or_default();
            self.neighbour(net, j, r, by).map(|v| (V3(v.position) - V3(here.position)) * 1e4)
        };
        let around: [V3<f32>; RING.len()] =
            core::array::from_fn(|n| match (spoke(n), spoke(n + 1)) {
                (Some(a), Some(b)) => unit(a.cross(b) * self.side, V3([0.0; 3])),
                _ => V3([0.0; 3]),
            });
        let agree = |sum: V3<f32>| around.iter().all(|n| n.norm_sq() == 0.0 || n.dot(sum) > 0.0);
        let first = V3(here.normal);
        if agree(first) {
            return Some(first);
        }
        let mut sum = around.iter().fold(V3([0.0; 3]), |sum, &n| sum + n);
        for _ in 0..ROUNDS {
            let mut lean = false;
            for &n in around.iter().filter(|n| n.norm_sq() > 0.0) {
                if sum.dot(n) < AGREE * norm(sum) {
                    sum = sum + n;
                    lean = true;
                }
            }
            if !lean {
                break;
            }
        }
        agree(sum).then(|| unit(sum, first))
    }
}
