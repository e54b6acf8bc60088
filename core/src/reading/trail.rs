//! Leaves that slip into the hand and out of it while a finger marks a place. Book Sec. 4.1, "Finger-bookmarking".
//!
//! The way the held leaf came is remembered as a few of its poses, in order. A leaf that is added runs along them
//! from the block to the hand, one that is given back runs the other way. It is a picture: the physics only knows
//! how many leaves are held.

use crate::grid::Grid;
use crate::real::{Real, V2};
use crate::state::{Field, Leaf};

/// Poses that are remembered.
const POSES: usize = 8;
/// Angle between two of them about the spine, as a sine: an eighth of half a turn.
const APART: f64 = 0.38;
/// Time a leaf takes on its way, microseconds.
const FLIGHT_US: u64 = 220_000;
/// A leaf on its way. Whoever swipes faster than it flies sees fewer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Flier {
    /// Into the hand, or back to the block.
    inwards: bool,
    /// Since it set out, microseconds.
    age_us: u64,
}

/// The way the held leaf came.
#[derive(Debug, Clone)]
pub(super) struct Trail<R: Real, G: Grid> {
    poses: [Field<R, G>; POSES],
    /// Directions from the spine to the middle of the fore-edge in those poses.
    ways: [V2<R>; POSES],
    used: usize,
    held: u32,
    flier: Option<Flier>,
}

impl<R: Real, G: Grid> Trail<R, G> {
    pub(super) const EMPTY: Self = Self {
        poses: [const { Field::ZERO }; POSES],
        ways: [V2([R::ZERO; 2]); POSES],
        used: 0,
        held: 1,
        flier: None,
    };

    /// Forgets the way: the leaf lies, or another was taken up.
    pub(super) fn clear(&mut self) {
        self.used = 0;
        self.held = 1;
        self.flier = None;
    }

    /// Nothing is on its way.
    pub(super) fn still(&self) -> bool {
        self.flier.is_none()
    }

    /// Looks at the leaf after a step; answers whether it is past the vertical, seen from where it came.
    ///
    /// A pose is remembered once the leaf has come far enough from the last; one that goes back forgets them.
    pub(super) fn watch(&mut self, leaf: &Leaf<R, G>, root: V2<R>, from_right: bool) -> bool {
        let tip = leaf.x.at(G::NX - 1, G::NZ / 2);
        let out = V2([tip.0[0] - root.0[0], tip.0[1] - root.0[1]]);
        let length = (out.0[0] * out.0[0] + out.0[1] * out.0[1]).root().larger(R::of(1e-6));
        let way = out * (R::of(1.0) / length);
        let back = |sine: R| (sine < R::ZERO) == from_right;
        while self.used > 1 && back(self.sine(self.used - 1, way)) {
            self.used -= 1;
        }
        let far = self.used == 0 || self.sine(self.used - 1, way).magnitude() > R::of(APART);
        let slots = (self.poses.get_mut(self.used), self.ways.get_mut(self.used));
        if let (true, (Some(pose), Some(known))) = (far, slots) {
            pose.copy_from(&leaf.x);
            *known = way;
            self.used += 1;
        }
        (way.0[0] < R::ZERO) == from_right
    }

    /// Sine of the angle from a remembered way to another.
    fn sine(&self, n: usize, way: V2<R>) -> R {
        self.ways.get(n).map_or(R::ZERO, |w| w.0[0] * way.0[1] - w.0[1] * way.0[0])
    }

    /// The hand holds another number of leaves now: one sets out.
    pub(super) fn flip(&mut self, leaves: u32) {
        let inwards = leaves > self.held;
        self.held = leaves;
        self.flier = Some(Flier { inwards, age_us: 0 });
    }

    /// Whether the leaf on its way goes into the hand; nothing if there is none.
    pub(super) fn way(&self) -> Option<bool> {
        self.flier.map(|f| f.inwards)
    }

    /// Lets time pass. Answers whether something was on its way.
    pub(super) fn advance(&mut self, passed_us: u64) -> bool {
        let Some(flier) = &mut self.flier else { return false };
        flier.age_us = flier.age_us.saturating_add(passed_us);
        if flier.age_us >= FLIGHT_US {
            self.flier = None;
        }
        true
    }

    /// The pose of the leaf on its way, between where it lay and `now`, where the held one is.
    pub(super) fn pose(&self, now: &Field<R, G>, out: &mut Field<R, G>) -> bool {
        let Some(flier) = self.flier.filter(|_| self.used > 0) else { return false };
        let t = R::of(flier.age_us as f64 / FLIGHT_US as f64).smaller(R::of(1.0));
        let t = if flier.inwards { t } else { R::of(1.0) - t };
        // Smoothly: `3t² - 2t³` of the way along all poses and the present one.
        let along = t * t * (R::of(3.0) - R::of(2.0) * t) * R::of(self.used as f64);
        let mut first = 0;
        while first + 1 < self.used && along >= R::of((first + 1) as f64) {
            first += 1;
        }
        let share = (along - R::of(first as f64)).smaller(R::of(1.0)).larger(R::ZERO);
        let from = self.poses.get(first).unwrap_or(now);
        let to = self.poses.get(first + 1).filter(|_| first + 1 < self.used).unwrap_or(now);
        for ((slot, &a), &b) in out.raw_mut().iter_mut().zip(from.raw()).zip(to.raw()) {
            *slot = a + (b - a) * share;
        }
        true
    }
}
