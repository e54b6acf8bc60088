//! The seed's own way with contact: a step that knows of none, then the nearest vertices that do not overlap.
//!
//! ```text
//! min ½ |δ|² + K/2 Σ |δ_i - δ_j|²     over the edges of the mesh, subject to  n·(Σ a δ) >= b
//! ```
//!
//! solved for the forces, an active set growing by the worst violation. The matrix depends on nothing but how many segments
//! there are: three diagonals. The corrected mesh is no longer developable; the next step sets out from the ribbon's own
//! shape, and what was corrected goes on as velocity. An option beside contact inside the step, which keeps the ribbon
//! developable and lets nothing pass through; this one sees only what overlaps after a step.
//!
//! Source: Ribbon Sec. 5.2, Alg. 1. Checked by `tests/ribbon_post.rs`.

use super::super::inertia::Four;
use super::near::{Near, Pairing};
use super::surface::Surface;
use crate::effect::ribbon::Ribbon;
use crate::real::{Real, V3};
use heapless::Vec;

/// `K`: how much stiffer an edge is than a vertex is held to its place.
pub const STIFFNESS: f64 = 1e2;
/// A row is violated if by more than this share of the thickness.
const SLACK: f64 = 1e-3;
/// A pivot below this share of its diagonal depends on the rows before: its force is left out.
const DEPENDENT: f64 = 1e-9;

/// `normal·Σ weights x >= bound`, over the vertices of one or two segments.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Row<R> {
    parts: [(usize, Four<R>); 2],
    normal: V3<R>,
    bound: R,
    /// The vertex, if it is one of this ribbon's that is near another segment.
    vertex: Option<usize>,
}

impl<R: Real> Row<R> {
    fn vertices(&self) -> impl Iterator<Item = (usize, R)> + '_ {
        self.parts.iter().flat_map(|(segment, weights)| {
            weights.iter().enumerate().map(move |(i, &w)| (2 * segment + i, w))
        })
    }
}

/// The corner that has all of the share, if one has.
fn lone<R: Real>(shares: &Four<R>) -> Option<usize> {
    shares.iter().position(|&w| w > R::of(1.0 - 1e-6))
}

/// Corners that have some of it.
fn corners<R: Real>(shares: &Four<R>) -> usize {
    shares.iter().filter(|&&w| w > R::of(1e-6)).count()
}

/// What a correction cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct PostReport {
    /// Overlaps found.
    pub rows: u32,
    /// Of these, those that push in the end.
    pub active: u32,
    /// Changes of the active set.
    pub changes: u32,
    /// Overlaps that found no room, or segments beyond it: nothing was corrected for them.
    pub crowded: u32,
    /// The changes were used up.
    pub capped: bool,
}

/// Room for a ribbon of `V` vertices and `M` overlaps, placed by the caller: a dozen a segment where ribbons lie flat on
/// each other.
#[derive(Debug, Clone)]
pub struct Post<R, const V: usize, const M: usize> {
    rows: Vec<Row<R>, M>,
    /// `H⁻¹ aᵀ` of each row.
    columns: [[R; V]; M],
    /// `A H⁻¹ Aᵀ`, and its factor over the active rows.
    dual: [[R; M]; M],
    factor: [[R; M]; M],
    forces: [R; M],
    active: Vec<u16, M>,
    /// Corrections of the vertices, metres.
    shift: [V3<R>; V],
    /// `H = L D Lᵀ`: pivots, and two diagonals below.
    bands: [[R; 3]; V],
}

impl<R: Real, const V: usize, const M: usize> Post<R, V, M> {
    /// Nothing: for the caller to place.
    pub const EMPTY: Self = Self {
        rows: Vec::new(),
        columns: [[R::ZERO; V]; M],
        dual: [[R::ZERO; M]; M],
        factor: [[R::ZERO; M]; M],
        forces: [R::ZERO; M],
        active: Vec::new(),
        shift: [V3([R::ZERO; 3]); V],
        bands: [[R::ZERO; 3]; V],
    };

    /// Corrects a ribbon that has taken a step of `h` seconds. `near` was begun before the step and has all others added;
    /// its cushion's reach is the thickness kept.
    ///
    /// # Cost
    ///
    /// A banded solve a row; a dense factor of the active rows for every change, of which there are at most `4 M`.
    pub fn resolve<S: Surface<R>, const N: usize, const O: usize, const K: usize>(
        &mut self,
        ribbon: &mut Ribbon<R, N>,
        near: &Near<R, S, N, O, K>,
        h: f64,
    ) -> PostReport {
        let n = ribbon.spec().segments;
        let used = 2 * (n + 1);
        let mut report = PostReport::default();
        self.shift = [V3([R::ZERO; 3]); V];
        if used > V {
            report.crowded = (used - V) as u32;
            return report;
        }
        report.crowded = self.find(ribbon, near);
        report.rows = self.rows.len() as u32;
        if self.rows.is_empty() {
            return report;
        }
        self.factor_mesh(n);
        self.assemble(used);
        let slack = R::of(SLACK * near.cushion.reach_m);
        (report.changes, report.capped) = self.push(slack);
        report.active = self.active.len() as u32;
        self.correct(used);
        let shift = self.shift;
        ribbon.nudge(R::of(1.0 / h), |vertex| shift.get(vertex).copied().unwrap_or_default());
        report
    }

    /// The mesh after the correction, from the start to the end.
    pub fn corrected<'a, const N: usize>(
        &'a self,
        ribbon: &'a Ribbon<R, N>,
    ) -> impl Iterator<Item = [V3<R>; 2]> + 'a {
        let at = |v: usize| self.shift.get(v).copied().unwrap_or_default();
        ribbon.pairs().enumerate().map(move |(j, [a, b])| [a + at(2 * j), b + at(2 * j + 1)])
    }

    /// Finds what overlaps; answers how much of it found no room.
    fn find<S: Surface<R>, const N: usize, const O: usize, const K: usize>(
        &mut self,
        ribbon: &Ribbon<R, N>,
        near: &Near<R, S, N, O, K>,
    ) -> u32 {
        self.rows.clear();
        let (n, thickness) = (ribbon.spec().segments, R::of(near.cushion.reach_m));
        let mut crowded = 0;
        let none = (0, [R::ZERO; 4]);
        for (crease, pair) in ribbon.pairs().enumerate() {
            for (rim, p) in pair.into_iter().enumerate() {
                let segment = crease.min(n - 1);
                let mut weights = [R::ZERO; 4];
                if let Some(w) = weights.get_mut(2 * (crease - segment) + rim) {
                    *w = R::one();
                }
                near.surface.each(p, |d, normal| {
                    let bound = thickness - d;
                    let row =
                        Row { parts: [(segment, weights), none], normal, bound, vertex: None };
                    crowded += u32::from(bound > R::ZERO && self.rows.push(row).is_err());
                });
            }
        }
        let pose = ribbon.posed().pose();
        near.overlaps(&pose, |pair: Pairing, here, there, normal, d| {
            let other = if pair.own { (usize::from(pair.other), there.map(|w| -w)) } else { none };
            let segment = usize::from(pair.segment);
            let (alone, theirs) = (lone(&here), lone(&there));
            // An edge that ends near another is a vertex near it, which is seen as such.
            if alone.is_none() && theirs.is_none() && corners(&here) + corners(&there) < 4 {
                return;
            }
            let vertex = alone.map(|i| 2 * segment + i);
            let row = Row { parts: [(segment, here), other], normal, bound: thickness - d, vertex };
            crowded += u32::from(!self.keep(row));
        });
        crowded
    }

    /// A vertex near several segments is held from the nearest.
    fn keep(&mut self, row: Row<R>) -> bool {
        let known = row.vertex.and_then(|v| self.rows.iter_mut().find(|r| r.vertex == Some(v)));
        match known {
            Some(known) if known.bound < row.bound => *known = row,
            Some(_) => {}
            None => return self.rows.push(row).is_ok(),
        }
        true
    }

    /// `H = 1 + K L` over the rims, the rulings and one diagonal of each segment.
    fn factor_mesh(&mut self, segments: usize) {
        self.bands = [[R::one(), R::ZERO, R::ZERO]; V];
        let k = R::of(STIFFNESS);
        let join = |bands: &mut [[R; 3]; V], i: usize, apart: usize| {
            for end in [i, i + apart] {
                if let Some(b) = bands.get_mut(end) {
                    b[0] += k;
                }
            }
            // The entry of row `i + apart` left of its pivot.
            if let Some(e) = bands.get_mut(i + apart).and_then(|b| b.get_mut(apart)) {
                *e -= k;
            }
        };
        for s in 0..=segments {
            join(&mut self.bands, 2 * s, 1);
            if s < segments {
                join(&mut self.bands, 2 * s, 2);
                join(&mut self.bands, 2 * s + 1, 2);
                join(&mut self.bands, 2 * s + 1, 1);
            }
        }
        let (mut one, mut two) = ([R::one(), R::ZERO], R::one());
        for b in self.bands.iter_mut().take(2 * (segments + 1)) {
            let [d, e1, e2] = *b;
            let l2 = e2 / two;
            let l1 = (e1 - l2 * one[1] * two) / one[0];
            let pivot = d - l2 * l2 * two - l1 * l1 * one[0];
            *b = [pivot, l1, l2];
            (two, one) = (one[0], [pivot, l1]);
        }
    }

    /// `H x = x`, in place.
    fn solve(bands: &[[R; 3]; V], x: &mut [R; V], used: usize) {
        let (mut a, mut b) = (R::ZERO, R::ZERO);
        for (v, [_, l1, l2]) in x.iter_mut().zip(bands).take(used) {
            *v = *v - *l1 * a - *l2 * b;
            (b, a) = (a, *v);
        }
        let (mut after, mut next) = ([R::ZERO; 2], [[R::ZERO; 3]; 2]);
        for (v, band) in x.iter_mut().zip(bands).take(used).rev() {
            *v = *v / band[0] - next[0][1] * after[0] - next[1][2] * after[1];
            (after, next) = ([*v, after[0]], [*band, next[0]]);
        }
    }

    fn assemble(&mut self, used: usize) {
        for (row, column) in self.rows.iter().zip(&mut self.columns) {
            *column = [R::ZERO; V];
            for (v, w) in row.vertices() {
                if let Some(c) = column.get_mut(v) {
                    *c += w;
                }
            }
            Self::solve(&self.bands, column, used);
        }
        for (i, (row, line)) in self.rows.iter().zip(&mut self.dual).enumerate() {
            for ((other, column), entry) in self.rows.iter().zip(&self.columns).zip(line.iter_mut())
            {
                let along = row.vertices().fold(R::ZERO, |sum, (v, w)| {
                    sum + w * column.get(v).copied().unwrap_or(R::ZERO)
                });
                *entry = along * row.normal.dot(other.normal);
            }
            // Two rows that say the same would make it singular.
            if let Some(d) = line.get_mut(i) {
                *d *= R::of(1.0 + 1e-6);
            }
        }
    }

    /// Lawson and Hanson's active set on `min ½ λᵀGλ - bᵀλ, λ >= 0`. Answers the changes, and whether they were used up.
    fn push(&mut self, slack: R) -> (u32, bool) {
        self.forces = [R::ZERO; M];
        self.active.clear();
        let mut changes = 0;
        for _ in 0..4 * M {
            let Some(worst) = self.worst(slack) else { return (changes, false) };
            changes += 1;
            if self.active.push(worst).is_err() {
                return (changes, true);
            }
            changes += self.hold_feasible();
        }
        (changes, true)
    }

    /// The row that is violated most.
    fn worst(&self, slack: R) -> Option<u16> {
        let mut found = (slack, None);
        for (i, (row, line)) in self.rows.iter().zip(&self.dual).enumerate() {
            let pushed = line.iter().zip(&self.forces).fold(R::ZERO, |sum, (&g, &f)| sum + g * f);
            let short = row.bound - pushed;
            if short > found.0 && !self.active.contains(&(i as u16)) {
                found = (short, Some(i as u16));
            }
        }
        found.1
    }

    /// Solves for the active forces; what would have to pull is dropped, and it is solved again.
    fn hold_feasible(&mut self) -> u32 {
        let mut dropped = 0;
        for _ in 0..M {
            let wanted = self.balance();
            let (mut share, mut first) = (R::one(), None);
            for (k, (&i, &want)) in self.active.iter().zip(&wanted).enumerate() {
                let have = self.forces.get(usize::from(i)).copied().unwrap_or(R::ZERO);
                if want <= R::ZERO {
                    let way = have / (have - want).larger(R::of(1e-30));
                    if way < share || first.is_none() {
                        (share, first) = (way.smaller(share), Some(k));
                    }
                }
            }
            for (&i, &want) in self.active.iter().zip(&wanted) {
                if let Some(f) = self.forces.get_mut(usize::from(i)) {
                    *f += (want - *f) * share;
                }
            }
            let Some(k) = first else { return dropped };
            if let Some(f) = self.active.get(k).and_then(|&i| self.forces.get_mut(usize::from(i))) {
                *f = R::ZERO;
            }
            let _ = self.active.swap_remove(k);
            dropped += 1;
        }
        dropped
    }

    /// The forces that leave no active row short: a dense Cholesky of their part of the dual.
    fn balance(&mut self) -> [R; M] {
        let m = self.active.len();
        let entry = |dual: &[[R; M]; M], i: u16, j: u16| {
            dual.get(usize::from(i)).and_then(|l| l.get(usize::from(j))).copied().unwrap_or(R::ZERO)
        };
        let mut x = [R::ZERO; M];
        for p in 0..m {
            let Some(&i) = self.active.get(p) else { break };
            let (done, rest) = self.factor.split_at_mut(p);
            let Some(line) = rest.first_mut() else { break };
            for (q, before) in done.iter().enumerate() {
                let Some(&j) = self.active.get(q) else { break };
                let inner = line.iter().zip(before).take(q).fold(R::ZERO, |s, (&a, &b)| s + a * b);
                let pivot = before.get(q).copied().unwrap_or(R::ZERO);
                let value = (entry(&self.dual, i, j) - inner) * pivot;
                if let Some(place) = line.get_mut(q) {
                    *place = value;
                }
            }
            // Pivots are kept as their inverses; nothing for a row that depends on those before.
            let inner = line.iter().take(p).fold(R::ZERO, |s, &a| s + a * a);
            let (whole, bound) = (entry(&self.dual, i, i), self.rows.get(usize::from(i)));
            let left = whole - inner;
            let sound = left > whole * R::of(DEPENDENT);
            let inverse = if sound { R::one() / left.root() } else { R::ZERO };
            if let Some(place) = line.get_mut(p) {
                *place = inverse;
            }
            let known = line.iter().zip(&x).take(p).fold(R::ZERO, |s, (&a, &b)| s + a * b);
            if let (Some(place), Some(row)) = (x.get_mut(p), bound) {
                *place = (row.bound - known) * inverse;
            }
        }
        for p in (0..m).rev() {
            let below = self.factor.iter().zip(&x).take(m).skip(p + 1);
            let known = below
                .fold(R::ZERO, |s, (line, &v)| s + line.get(p).copied().unwrap_or(R::ZERO) * v);
            let pivot = self.factor.get(p).and_then(|l| l.get(p)).copied().unwrap_or(R::ZERO);
            if let Some(v) = x.get_mut(p) {
                *v = (*v - known) * pivot;
            }
        }
        x
    }

    /// `δ = H⁻¹ Aᵀ λ`.
    fn correct(&mut self, used: usize) {
        for ((row, column), &force) in self.rows.iter().zip(&self.columns).zip(&self.forces) {
            if force <= R::ZERO {
                continue;
            }
            for (d, &c) in self.shift.iter_mut().zip(column).take(used) {
                *d = *d + row.normal * (c * force);
            }
        }
    }
}
