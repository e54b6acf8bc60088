//! One frame of a book being read.

use super::policy::{EINK_US, MotionPolicy};
use super::{Notice, Reading, Tick};
use crate::book::Book;
use crate::event::Event;
use crate::grid::Grid;
use crate::hand::{Phase, Sample, View};
use crate::real::Real;
use crate::record::{Recorder, Sink};
use crate::step::StepReport;

/// World steps at most until a leaf that is let go lies.
const LANDING: u32 = 600;

/// What one call of [`Reading::step`] did.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Frame {
    /// The mesh is to be made and drawn: something of what is shown changed.
    pub draw: bool,
    /// What the physics did.
    pub report: StepReport,
}

/// What is told of everything the book is given and does: a recorder, or `()`.
pub trait Tape {
    /// The book was handed a sample.
    fn input(&mut self, sample: &Sample);
    /// The reader looks from elsewhere.
    fn look(&mut self, view: &View);
    /// The book took one world step.
    fn step(&mut self, hash: impl FnOnce() -> u64);
}

impl Tape for () {
    fn input(&mut self, _: &Sample) {}
    fn look(&mut self, _: &View) {}
    fn step(&mut self, _: impl FnOnce() -> u64) {}
}

/// A recorder that may be there. A full one takes no more and can still be finished, so its refusals are not told.
impl<S: Sink> Tape for Option<Recorder<S>> {
    fn input(&mut self, sample: &Sample) {
        let _ = self.as_mut().map(|r| r.input(sample));
    }
    fn look(&mut self, view: &View) {
        let _ = self.as_mut().map(|r| r.look(view));
    }
    fn step(&mut self, hash: impl FnOnce() -> u64) {
        let _ = self.as_mut().map(|r| r.step(hash()));
    }
}

impl<R: Real, G: Grid> Reading<R, G> {
    /// Lets time pass until `now_us` of the app's clock.
    ///
    /// # Cost
    ///
    /// As many world steps as time asks for: one, if it is called once a step. After a pause 64 at most, and eight
    /// times as many under a cap; a leaf that must lie at once takes up to 600.
    pub fn step(&mut self, now_us: u64, tape: &mut impl Tape) -> Frame {
        let mut frame = Frame::default();
        let (passed, steps) = self.clock.of_step(now_us, self.setup.world.step_us);
        if self.paused {
            self.clock.forget();
        } else {
            self.advance(passed, steps, tape, &mut frame.report);
        }
        self.shown_us = self.shown_us.saturating_add(passed);
        frame.draw = self.shows();
        frame
    }

    fn advance(&mut self, passed: u64, steps: u64, tape: &mut impl Tape, report: &mut StepReport) {
        let flies = self.trail.advance(passed);
        self.dirty |= flies && self.motion.policy.follows();
        let free = self.book.leaf().is_some() && self.down == 0 && self.auto.is_none();
        let before = self.free_us;
        self.free_us = if free { before.saturating_add(passed) } else { 0 };
        if free && self.is_due(before) {
            self.finish(tape);
            return;
        }
        let haste = if free { self.motion.haste() } else { 1 };
        for _ in 0..steps.saturating_mul(haste) {
            if !self.book.needs_frame() && self.auto.is_none() {
                break;
            }
            self.one(tape, report);
        }
        self.clock.join(&self.book);
    }

    /// Whether a leaf that has been free for so long has to lie now: because that is not to be seen, or takes too
    /// long. What was let go is seen once more where little motion is wanted.
    fn is_due(&self, before_us: u64) -> bool {
        let late = self.motion.cap_us.is_some_and(|cap| self.free_us >= u64::from(cap));
        late || match self.motion.policy {
            MotionPolicy::None => true,
            MotionPolicy::Reduced => before_us > 0,
            MotionPolicy::Full | MotionPolicy::EInk => false,
        }
    }

    /// One world step, and what it tells.
    fn one(&mut self, tape: &mut impl Tape, report: &mut StepReport) {
        let until = self.book.now_us().saturating_add(u64::from(self.setup.world.step_us));
        self.lead(until, tape);
        let own = self.book.step();
        tape.step(|| self.book.state_hash());
        self.moved(own.steps > 0);
        report.add(&own);
    }

    /// Takes note of what a step changed.
    fn moved(&mut self, stepped: bool) {
        let pages = self.pages();
        while let Some(event) = self.book.take_event() {
            match event {
                Event::Lifted { .. } => {
                    self.over = false;
                    self.trail.clear();
                }
                Event::Held { leaves } => self.trail.flip(leaves),
                Event::Committed { .. } | Event::Cancelled => {
                    self.trail.clear();
                    self.dirty = true;
                }
                Event::Asleep => self.dirty |= self.motion.policy.follows(),
            }
            self.notices.tell(event, pages);
        }
        if let Some(leaf) = self.book.leaf() {
            let root = self.book.binding().root();
            let over = self.trail.watch(leaf, root, self.book.binding().from_right);
            if over && !self.over {
                self.over = true;
                self.notices.push(Notice::Tick(Tick::Over));
            }
        }
        self.dirty |= stepped && self.motion.policy.follows();
    }

    /// Whether what is shown changed, under the policy.
    fn shows(&mut self) -> bool {
        let aloft = self.book.leaf().is_some();
        // Once let go, a leaf is seen where the finger left it.
        let left = self.motion.policy == MotionPolicy::Reduced && aloft && !self.aloft;
        let asked = self.dirty || (left && self.down == 0 && self.auto.is_none());
        let settled = !self.book.needs_frame() && self.trail.still();
        let early = self.motion.policy == MotionPolicy::EInk && self.shown_us < EINK_US;
        if !asked || (early && !settled) {
            return false;
        }
        self.dirty = false;
        self.aloft = aloft;
        self.shown_us = 0;
        true
    }

    /// Lets the leaf nobody holds come to lie at once.
    pub fn skip(&mut self, tape: &mut impl Tape) {
        if self.down == 0 && self.auto.is_none() {
            self.finish(tape);
        }
    }

    /// Lets everything that moves by itself come to rest at once, whatever time that takes in the book, and shows each
    /// step on the way: for screens that are slower than a turn. Does nothing while a finger is down.
    pub fn ahead(&mut self, tape: &mut impl Tape, mut seen: impl FnMut(&Book<R, G>)) {
        if self.down != 0 {
            return;
        }
        let mut report = StepReport::default();
        for _ in 0..LANDING {
            let moving = self.book.leaf().is_some() || self.book.needs_frame();
            if !moving && self.auto.is_none() {
                break;
            }
            self.one(tape, &mut report);
            seen(&self.book);
        }
        self.free_us = 0;
        self.trail.clear();
        self.clock.join(&self.book);
        self.dirty = true;
    }

    /// Steps until nothing is in the air.
    pub(super) fn finish(&mut self, tape: &mut impl Tape) {
        self.ahead(tape, |_| ());
    }

    /// Takes every finger away.
    pub(super) fn lift_fingers(&mut self, tape: &mut impl Tape) {
        self.stop_auto(tape);
        let down = self.down;
        for id in (0..64_u8).filter(|id| down & 1 << id != 0) {
            let t_us = self.clock.of_sample(0, &self.book);
            let cancel = Sample { t_us, id, phase: Phase::Cancel, x: 0, y: 0, leaves: 0 };
            let _ = self.feed(cancel, tape);
        }
        self.down = 0;
    }
}
