//! Light at a coarse lattice of pixels, and between its points.
//!
//! Asking the shadow maps is dear, and most answers run smoothly. They are asked at some pixels only. A
//! pixel of a cell whose four corners lie on one surface, with light that runs straight through
//! all of them, takes their mean; along outlines, where things touch and at sharp shadows, it
//! asks for itself. The points of a fine lattice are found from a coarser one in the same way.
//!
//! A shadow that begins at the thing that throws it is never missed: the cell the thing ends in has
//! a corner that does not fit, and every further cell the shadow reaches has a corner inside it.

use glam::Vec3;

use crate::hit::Hit;
use crate::lighting::{Light, Seen};
use crate::shadow::SkyShare;

/// A share that strays this far from the mean of its neighbours' marks a contact or a sharp shadow.
const BEND: f32 = 0.05;
/// Corners that differ by more are not averaged.
const SPREAD: f32 = 0.25;

/// Neighbours whose lamp differs by more have a sharp shadow between them.
const SHARP: f32 = 0.15;

/// One lattice point: its surface, and its light.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Probe {
    /// Patch of the surface seen there; `u32::MAX` for none.
    pub(crate) patch: u32,
    pub(crate) near: f32,
    pub(crate) normal: Vec3,
    pub(crate) seen: Seen,
    pub(crate) light: Light,
}

impl Probe {
    /// Nothing is seen here.
    pub(crate) const NONE: Self = Self {
        patch: u32::MAX,
        near: 0.0,
        normal: Vec3::Y,
        seen: Seen { sky: SkyShare { front: 1.0, back: 1.0 }, lamp: 1.0 },
        light: Light::NONE,
    };

    /// Whether this point lies on the surface of `hit`.
    pub(crate) fn fits(&self, patch: u32, hit: &Hit) -> bool {
        self.joins(patch, hit.near, hit.normal)
    }

    fn joins(&self, patch: u32, near: f32, normal: Vec3) -> bool {
        self.patch == patch
            && (self.near - near).abs() < 0.03 * near
            && self.normal.dot(normal) > 0.94
    }

    /// The three shares that decide.
    fn shares(&self) -> [f32; 3] {
        [self.seen.sky.front, self.seen.sky.back, self.seen.lamp]
    }
}

/// How far a lattice point or a cell can be trusted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Trust {
    /// Not at all.
    Nothing,
    /// What it sees of the room.
    Sky,
    /// All its light.
    Light,
}

/// The corners of a trusted cell, weighted for a place in it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Mean<'a> {
    trust: Trust,
    four: [&'a Probe; 4],
    weights: [f32; 4],
}

impl Mean<'_> {
    /// Whether the lamp's share can be trusted, too, and with it all light.
    pub(crate) fn is_whole(&self) -> bool {
        self.trust == Trust::Light
    }

    /// What is seen of the room.
    pub(crate) fn sky(&self) -> SkyShare {
        SkyShare { front: self.of(|p| p.seen.sky.front), back: self.of(|p| p.seen.sky.back) }
    }

    /// What is seen of the lamp.
    pub(crate) fn lamp(&self) -> f32 {
        self.of(|p| p.seen.lamp)
    }

    /// The light.
    pub(crate) fn light(&self) -> Light {
        let mut sum = Light::NONE;
        for (probe, weight) in self.four.iter().zip(self.weights) {
            sum.diffuse += probe.light.diffuse * weight;
            sum.through += probe.light.through * weight;
            sum.gloss += probe.light.gloss * weight;
        }
        sum
    }

    fn of(&self, pick: fn(&Probe) -> f32) -> f32 {
        self.four.iter().zip(self.weights).map(|(p, w)| w * pick(p)).sum()
    }
}

/// A lattice over one frame.
#[derive(Debug)]
pub(crate) struct Lattice {
    /// Row by row; the last column and row lie on or beyond the picture's border.
    pub(crate) probes: Vec<Probe>,
    /// Pixels between two points.
    stride: usize,
    /// Points of a row.
    pub(crate) columns: usize,
    /// Trust of the cell each point is the upper left corner of.
    cells: Vec<Trust>,
}

impl Lattice {
    /// A lattice with a point at every `stride`th pixel both ways.
    pub(crate) fn new(stride: usize) -> Self {
        Self { probes: Vec::new(), stride, columns: 0, cells: Vec::new() }
    }

    /// Makes room for a picture of this size.
    pub(crate) fn resize(&mut self, width: usize, height: usize) {
        let points = |pixels: usize| pixels.div_ceil(self.stride) + 1;
        self.columns = points(width);
        self.probes.resize(self.columns * points(height), Probe::NONE);
    }

    /// Pixel of the point in `column` and `row` of a picture of this size.
    pub(crate) fn pixel(&self, column: usize, row: usize, size: (usize, usize)) -> (usize, usize) {
        ((column * self.stride).min(size.0 - 1), (row * self.stride).min(size.1 - 1))
    }

    /// Evens out what the points see, along each surface: the sky has few directions and the lamp few
    /// points, and each draws a faint step where it goes out of sight.
    pub(crate) fn smooth(&mut self) {
        let rows = self.probes.len() / self.columns.max(1);
        for step in [1, self.columns, 1, self.columns] {
            let inside = |at: usize| match step {
                1 => !at.is_multiple_of(self.columns) && at % self.columns + 1 < self.columns,
                _ => at >= step && at / step + 1 < rows,
            };
            let evened = |at| if inside(at) { self.evened(at, step) } else { self.probes[at].seen };
            let seen: Vec<Seen> = (0..self.probes.len()).map(evened).collect();
            self.probes.iter_mut().zip(seen).for_each(|(p, seen)| p.seen = seen);
        }
    }

    /// Mean of a point, twice, and its neighbours on the same surface. Where one of the two is missing
    /// the other is left out, too: a mean of one side only would creep. Sharp shadows stay sharp.
    fn evened(&self, at: usize, step: usize) -> Seen {
        let me = &self.probes[at];
        let pair = [&self.probes[at - step], &self.probes[at + step]];
        if !pair.iter().all(|p| p.joins(me.patch, me.near, me.normal)) {
            return me.seen;
        }
        let mean = |pick: fn(&Seen) -> f32| {
            0.5 * pick(&me.seen) + 0.25 * (pick(&pair[0].seen) + pick(&pair[1].seen))
        };
        let sharp = pair.iter().any(|p| (p.seen.lamp - me.seen.lamp).abs() > SHARP);
        Seen {
            sky: SkyShare { front: mean(|s| s.sky.front), back: mean(|s| s.sky.back) },
            lamp: if sharp { me.seen.lamp } else { mean(|s| s.lamp) },
        }
    }

    /// Decides which cells can be trusted, once all points are known.
    pub(crate) fn judge(&mut self) {
        let points: Vec<Trust> = (0..self.probes.len()).map(|at| self.straight(at)).collect();
        self.cells = (0..self.probes.len()).map(|at| self.cell(at, &points)).collect();
    }

    /// What the cell of pixel (`x`, `y`) tells of a place on `patch`, if it can be trusted.
    pub(crate) fn at(&self, x: usize, y: usize, patch: u32, hit: &Hit) -> Option<Mean<'_>> {
        let at = y / self.stride * self.columns + x / self.stride;
        let trust = self.cells[at];
        if trust == Trust::Nothing || !self.probes[at].fits(patch, hit) {
            return None;
        }
        let part = |place: usize| (place % self.stride) as f32 / self.stride as f32;
        let (fx, fy) = (part(x), part(y));
        let weights = [(1.0 - fx) * (1.0 - fy), fx * (1.0 - fy), (1.0 - fx) * fy, fx * fy];
        Some(Mean { trust, four: self.corners(at).map(|i| &self.probes[i]), weights })
    }

    fn corners(&self, at: usize) -> [usize; 4] {
        [at, at + 1, at + self.columns, at + self.columns + 1]
    }

    /// How far the shares at a point lie on the line through its neighbours', both ways. Where the
    /// surface ends on one side, the other neighbour must agree outright.
    fn straight(&self, at: usize) -> Trust {
        let me = &self.probes[at];
        let column = at % self.columns;
        let fitting = |inside: bool, other: usize| {
            let other = if inside { self.probes.get(other) } else { None };
            other.filter(|o| o.joins(me.patch, me.near, me.normal)).map(Probe::shares)
        };
        let across =
            [fitting(column > 0, at.wrapping_sub(1)), fitting(column + 1 < self.columns, at + 1)];
        let down = [fitting(true, at.wrapping_sub(self.columns)), fitting(true, at + self.columns)];
        let mine = me.shares();
        let strays = |pair: &[Option<[f32; 3]>; 2], i: usize| match *pair {
            [Some(a), Some(b)] => (0.5 * (a[i] + b[i]) - mine[i]).abs() > BEND,
            [Some(a), None] | [None, Some(a)] => (a[i] - mine[i]).abs() > BEND,
            [None, None] => false,
        };
        let bent = |i: usize| strays(&across, i) || strays(&down, i);
        match (bent(0) || bent(1), bent(2)) {
            (true, _) => Trust::Nothing,
            (false, true) => Trust::Sky,
            (false, false) => Trust::Light,
        }
    }

    fn cell(&self, at: usize, points: &[Trust]) -> Trust {
        let corners = self.corners(at);
        if at % self.columns + 1 == self.columns || corners[3] >= self.probes.len() {
            return Trust::Nothing;
        }
        let first = &self.probes[at];
        let together =
            corners.iter().all(|&i| self.probes[i].joins(first.patch, first.near, first.normal));
        let spread = |i: usize| {
            let v = corners.map(|c| self.probes[c].shares()[i]);
            v.iter().copied().fold(0.0, f32::max) - v.iter().copied().fold(1.0, f32::min)
        };
        if first.patch == u32::MAX || !together || spread(0) > SPREAD || spread(1) > SPREAD {
            return Trust::Nothing;
        }
        let least = corners.iter().map(|&i| points[i]).min().unwrap_or(Trust::Nothing);
        if spread(2) > SPREAD { least.min(Trust::Sky) } else { least }
    }
}
