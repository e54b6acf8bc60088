//! Coming to rest: the leaf merges into a block, the book falls asleep.

use super::Book;
use crate::event::Event;
use crate::grid::Grid;
use crate::real::{Num, Real, V3};
use crate::scene::Direction;
use crate::state::strip::Strip;
use crate::step::StepReport;

/// A leaf slower than this, model units/s, is still.
const STILL: f64 = 0.15;
/// How long it has to be, microseconds.
const STILL_US: u64 = 120_000;
/// A leaf floating without weight sleeps after this long, microseconds.
const FLOATING_US: u64 = 1_000_000;
/// A landed leaf is merged after this long, a book nobody holds sleeps after that long, whatever still
/// trembles in it, microseconds.
const LANDED_US: u64 = 2_500_000;
/// A leaf with some weight that nobody held for so long has fallen, wherever it hangs, microseconds.
const FALLEN_US: u64 = 3_000_000;
/// Weight enough for that, model units/s²: a fiftieth of the earth's.
const HEAVY: f64 = 18.0;
/// From then on blocks slower than this are put to rest, model units/s.
const RESTLESS_US: u64 = 3_700_000;
const RESTLESS: f64 = 3.0;
/// Steps taken back one after the other before a leaf nobody holds is laid down.
const STUCK: u32 = 30;
const IDLE_US: u64 = 20_000_000;
/// How fast the weight that lays a landed leaf flat grows, in its own weights, 1/s.
const PRESSING: f64 = 60.0;
/// A landed leaf faster than this, model units/s, is not pressed yet.
const CALM: f64 = 12.0;
/// Slower than this and upright, it is balanced.
const BALANCED: f64 = 1.0;
/// Half width of the zone over the spine where it can balance, model units.
const UPRIGHT: f64 = 2.5;
/// Nudges before a leaf is taken to lean on something.
const NUDGES: u32 = 45;
/// Speed a balanced leaf is nudged by at its free edge, model units/s.
const NUDGE: f64 = 1.5;

impl<R: Real, G: Grid> Book<R, G> {
    pub(super) fn settle(&mut self, report: &mut StepReport) {
        if self.active && self.guide.is_none() {
            self.nudge(report);
        }
        self.idle_us =
            if self.guide.is_some() { 0 } else { self.idle_us + u64::from(self.step_us) };
        if self.active && self.guide.is_none() && self.overdue() {
            report.forced_rests += 1;
            self.merge();
        }
        let slow = !self.active && self.midline_speed() < R::of(RESTLESS);
        if self.idle_us >= IDLE_US || (slow && self.idle_us >= RESTLESS_US) {
            report.forced_rests += 1;
            self.fall_asleep();
            return;
        }
        if !self.still() {
            self.still_us = 0;
            return;
        }
        self.still_us += u64::from(self.step_us);
        if self.still_us < STILL_US {
            return;
        }
        if self.guide.is_some() {
            return;
        }
        let flat = self.leaning() || (self.landed && self.press >= self.most_press);
        if self.active && flat {
            self.merge();
        }
        if !self.active || self.still_us >= FLOATING_US {
            self.fall_asleep();
        }
    }

    /// A leaf let go that has landed is pressed flat, a little more each step. Answers whether it has landed.
    ///
    /// The block is the extrusion of one curve and cannot bulge where a leaf comes out of the gutter, so a leaf
    /// that merged as it lies would jump. Pressed by some times its own weight it lies where the block's top is.
    pub(super) fn lay_down(&mut self) -> bool {
        self.landed = self.guide.is_none() && (self.low() || self.rests_on_its_foot());
        if !self.landed {
            self.press = R::ZERO;
        } else if self.leaf.fastest() < R::of(CALM) {
            self.press = (self.press + self.h * R::of(PRESSING)).smaller(self.most_press);
        }
        self.landed
    }

    /// A stiff leaf may come to rest well above its block, held up where it leaves the gutter.
    fn rests_on_its_foot(&self) -> bool {
        let level = self.gravity.0[1] < R::ZERO;
        level && !self.upright() && (self.landed || self.leaf.fastest() < R::of(BALANCED))
    }

    /// The leaf should have come to lie by now, or never will.
    fn overdue(&self) -> bool {
        let heavy = self.gravity.0[1] < R::of(-HEAVY);
        self.stuck >= STUCK
            || (self.landed && self.idle_us >= LANDED_US)
            || (heavy && self.idle_us >= FALLEN_US)
    }

    fn still(&self) -> bool {
        let leaf = if self.active { self.leaf.fastest() } else { R::ZERO };
        self.midline_speed() < R::of(STILL) && leaf < R::of(STILL)
    }

    /// Largest speed of any node of blocks and boards.
    pub(super) fn midline_speed(&self) -> R {
        let blocks = self.blocks.iter().map(Strip::fastest);
        blocks.chain(self.boards.iter().map(Strip::fastest)).fold(R::ZERO, Num::larger)
    }

    fn upright(&self) -> bool {
        let out = self.tip().0[0] - self.binding.root().0[0];
        out.magnitude() < R::of(UPRIGHT)
    }

    /// Nudged in vain: it is not balanced but leans on a block as steep as itself.
    fn leaning(&self) -> bool {
        self.nudges >= NUDGES
    }

    fn fall_asleep(&mut self) {
        for strip in &mut self.blocks {
            strip.stop();
        }
        for strip in &mut self.boards {
            strip.stop();
        }
        self.leaf.v.clear();
        self.asleep = true;
        self.note(Event::Asleep);
    }

    /// A leaf balanced over the spine is tipped: towards where it leans, else back where it came from.
    fn nudge(&mut self, report: &mut StepReport) {
        let level = self.gravity.0[1] < R::ZERO;
        if !level || self.leaning() || !self.upright() || self.leaf.fastest() > R::of(BALANCED) {
            return;
        }
        let lean = self.tip().0[0] - self.binding.root().0[0];
        let home = R::of(if self.binding.from_right { 1.0 } else { -1.0 });
        let way = if lean.magnitude() > R::of(1e-3) { lean } else { home };
        let sign = R::of(if way < R::ZERO { -1.0 } else { 1.0 });
        for i in 1..G::NX {
            let share = R::of(NUDGE * i as f64 / (G::NX - 1) as f64);
            for k in 0..G::NZ {
                let v = self.leaf.v.at(i, k);
                self.leaf.v.set(i, k, v + V3([sign * share, R::ZERO, R::ZERO]));
            }
        }
        report.nudged += 1;
        self.nudges += 1;
    }

    /// The leaf becomes the top of the block it lies on. Says once how the turn ended.
    pub(super) fn merge(&mut self) {
        let onto_right = self.tip().0[0] > self.binding.root().0[0];
        let held = self.binding.held;
        self.binding.leaves[usize::from(onto_right)] += held;
        self.binding.held = 0;
        self.active = false;
        self.free_hand();
        if onto_right == self.binding.from_right {
            self.note(Event::Cancelled);
            return;
        }
        let [left, right] = self.binding.leaves;
        let read = if self.spec.direction == Direction::Ltr { left } else { right };
        self.spec.open_at = 2 * read;
        self.note(Event::Committed { page: 2 * read });
    }
}
