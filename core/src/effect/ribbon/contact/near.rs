//! What is near a ribbon: pairs of segments that could meet within a step, found before it.
//!
//! Boxes around the ribbon's segments, then around eight of them, then around all, are held against another segment's box,
//! so one far away costs one comparison. All lists have fixed capacities; where one is full nothing may move, since what
//! is not listed could be passed through.

use super::distance::{Bounds, Parts, Quad};
use super::push::Cushion;
use super::surface::Surface;
use super::touch::{Push, Touch, four};
use crate::effect::ribbon::Ribbon;
use crate::real::{Real, V3};
use heapless::Vec;

/// Segments that share a box.
const GROUP: usize = 8;
/// Segments of the same ribbon nearer than so many widths of the barrier, and two more, are no contact of its own.
const WIDTHS: f64 = 2.0;
/// How far a vertex may go in a step: so many times as far as the fastest would alone, and a cell.
const RANGE: f64 = 2.0;
/// No push follows.
pub(super) const LAST: u16 = u16::MAX;

/// A segment of this ribbon and what it could meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pairing {
    /// Segment of this ribbon.
    pub segment: u16,
    /// Index of the other, in the list of others or in this ribbon.
    pub other: u16,
    /// It is in this ribbon.
    pub own: bool,
}

/// What contact cost in a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Segments of others that were near.
    pub others: u32,
    /// Pairs of segments that could meet.
    pub pairs: u32,
    /// Pushes at the last point of the solve.
    pub pushes: u32,
    /// Trials that were shortened by a contact on their way.
    pub limited: u32,
    /// Things that found no room in a list: pairs, so nothing moved; or pushes, which costs iterations.
    pub crowded: u32,
}

/// What is near one ribbon of up to `N` segments: up to `O` segments of others, up to `K` pairs and as many pushes.
/// Placed by the caller, used for one ribbon after the other.
#[derive(Debug, Clone)]
pub struct Near<R, S, const N: usize, const O: usize, const K: usize> {
    /// The ground, in the coordinates of the ribbon at hand.
    pub surface: S,
    /// How it pushes.
    pub cushion: Cushion,
    /// It may touch itself.
    pub itself: bool,
    /// What it cost.
    pub counts: Counts,
    /// Something near found no room.
    pub(super) full: bool,
    pub(super) n: usize,
    pub(super) looped: bool,
    /// How far a vertex may go in this step.
    pub(super) range: R,
    pub(super) own: [Quad<R>; N],
    boxes: [Bounds<R>; N],
    whole: Bounds<R>,
    origin: [f64; 3],
    /// How many ribbons were added.
    added: u16,
    /// Segments of others: where they are, what they have for themselves, and of which ribbon they are which segment.
    pub(super) others: Vec<(Quad<R>, Parts, [u16; 2]), O>,
    pub(super) pairs: Vec<Pairing, K>,
    pub(super) pushes: Vec<(Push<R>, u16), K>,
    pub(super) heads: [u16; N],
}

impl<R: Real, S: Surface<R>, const N: usize, const O: usize, const K: usize> Near<R, S, N, O, K> {
    /// Nothing near but a ground.
    pub const fn over(surface: S, cushion: Cushion) -> Self {
        const { assert!(N < 60_000 && O < 60_000 && K < 60_000, "indices are of sixteen bits") };
        let none = Bounds { low: V3([R::ZERO; 3]), high: V3([R::ZERO; 3]) };
        Self {
            surface,
            cushion,
            itself: true,
            counts: Counts { others: 0, pairs: 0, pushes: 0, limited: 0, crowded: 0 },
            full: false,
            n: 0,
            looped: false,
            range: R::ZERO,
            own: [[V3([R::ZERO; 3]); 4]; N],
            boxes: [none; N],
            whole: none,
            origin: [0.0; 3],
            added: 0,
            others: Vec::new(),
            pairs: Vec::new(),
            pushes: Vec::new(),
            heads: [LAST; N],
        }
    }

    /// Forgets all, takes a ribbon as it is now, and finds where it is near itself.
    ///
    /// # Cost
    ///
    /// A comparison of boxes for every two segments.
    pub fn begin(&mut self, ribbon: &Ribbon<R, N>, h: f64) {
        (self.counts, self.full, self.n) =
            (Counts::default(), false, ribbon.spec().segments.min(N));
        (self.looped, self.origin) = (ribbon.posed().looped(), ribbon.origin());
        self.added = 0;
        self.others.clear();
        self.pairs.clear();
        self.pushes.clear();
        self.heads = [LAST; N];
        let fall = V3(ribbon.gravity.map(|g| R::of(g * h * h)));
        let ways = ribbon.velocities_now().flatten().map(|v| (v * R::of(h) + fall).norm_sq());
        let cell = ribbon.posed().strip.cell;
        let fastest = ways.fold(R::ZERO, |most, w| most.larger(w)).root();
        self.range = R::of(RANGE) * (fastest + cell);
        let creases = ribbon.pairs().zip(ribbon.pairs().skip(1));
        self.whole = Bounds::none();
        for ((own, b), (near, far)) in self.own.iter_mut().zip(&mut self.boxes).zip(creases) {
            *own = four(near, far);
            *b = Bounds::of(own);
            self.whole = self.whole.with(b);
        }
        if self.itself {
            self.near_itself(cell);
        }
    }

    fn near_itself(&mut self, cell: R) {
        let margin = R::of(2.0) * self.range + R::of(self.cushion.reach_m);
        let (mut skip, mut way) = (3, cell);
        while way < R::of(WIDTHS * self.cushion.reach_m) && skip < self.n {
            (skip, way) = (skip + 1, way + cell);
        }
        for i in 0..self.n {
            for j in (i + skip)..self.n {
                let around = if self.looped { i + self.n - j } else { self.n };
                let near = match (self.boxes.get(i), self.boxes.get(j)) {
                    (Some(a), Some(b)) => around >= skip && a.within(b, margin),
                    _ => false,
                };
                if near {
                    self.list(i, j, true);
                }
            }
        }
    }

    /// Adds another ribbon as it is now.
    ///
    /// # Cost
    ///
    /// A comparison of boxes a segment; for one that is near, `N/8` and eight for each eighth that is near too.
    pub fn add<const M: usize>(&mut self, other: &Ribbon<R, M>) {
        let margin = self.range + R::of(self.cushion.reach_m);
        let [x, y, z] = other.origin();
        let [a, b, c] = self.origin;
        let shift = V3([x - a, y - b, z - c].map(R::of));
        let last = if other.posed().looped() { usize::MAX } else { other.spec().segments - 1 };
        let creases = other.pairs().zip(other.pairs().skip(1));
        for (k, (near, far)) in creases.enumerate() {
            let quad = four(near, far).map(|p| p + shift);
            let bounds = Bounds::of(&quad);
            if bounds.within(&self.whole, margin) {
                let place = [self.added, k as u16];
                self.take(&(quad, Parts::own(k == last), place), &bounds, margin);
            }
        }
        self.added = self.added.saturating_add(1);
    }

    fn take(&mut self, other: &(Quad<R>, Parts, [u16; 2]), bounds: &Bounds<R>, margin: R) {
        let (place, mut found) = (self.others.len(), false);
        for first in (0..self.n).step_by(GROUP) {
            let group = self.boxes.iter().take(self.n).skip(first).take(GROUP);
            if !group.fold(Bounds::none(), |g, b| g.with(b)).within(bounds, margin) {
                continue;
            }
            for i in first..(first + GROUP).min(self.n) {
                if self.boxes.get(i).is_some_and(|b| b.within(bounds, margin)) {
                    self.list(i, place, false);
                    found = true;
                }
            }
        }
        if found && self.others.push(*other).is_err() {
            (self.full, self.counts.crowded) = (true, self.counts.crowded + 1);
        }
        self.counts.others = self.others.len() as u32;
    }

    fn list(&mut self, segment: usize, other: usize, own: bool) {
        let pairing = Pairing { segment: segment as u16, other: other as u16, own };
        if self.pairs.push(pairing).is_err() {
            (self.full, self.counts.crowded) = (true, self.counts.crowded + 1);
        }
        self.counts.pairs = self.pairs.len() as u32;
    }

    /// Energy of contact with what was added, the ribbon being where it is, joules.
    pub fn stored(&mut self, ribbon: &Ribbon<R, N>) -> R {
        self.energy(&ribbon.posed().pose())
    }

    /// Something near found no room: nothing may move.
    pub fn full(&self) -> bool {
        self.full
    }
}
