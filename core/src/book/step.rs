//! The step: hand, blocks, leaf, collisions, velocities. Book Sec. 3.1-3.4.

use super::{Book, nothing};
use crate::collision::{block, leaf};
use crate::grid::Grid;
use crate::real::{Lanes, Num, Real, V2};
use crate::state::Root;
use crate::state::field::groups;
use crate::state::sheet::{CONTACT, DELTA};
use crate::step::strip::{StripAsk, step as step_strip};
use crate::step::{Ask, StepReport, StepStatus};

/// World steps one call may catch up; what is owed beyond is dropped: no spiral after a pause.
const MOST_STEPS: u32 = 8;
/// Squared edge ratios a sheet of paper can have; outside, the net is collapsing or torn out.
const BAND: (f64, f64) = (0.25, 2.56);

/// Strain of an edge from which a step is taken again in parts, and how many: two halvings.
const OVERSTRAINED: f64 = 0.08;
const HALVINGS: u32 = 2;
const PARTS: u32 = 1 << HALVINGS;

impl<R: Real, G: Grid> Book<R, G> {
    /// Lets `dt_us` microseconds pass.
    ///
    /// # Cost
    ///
    /// At most eight world steps of [`Settings::substeps`](crate::scene::Settings) each; nothing while asleep.
    pub fn advance(&mut self, dt_us: u32) -> StepReport {
        self.advance_by(dt_us, Self::substep)
    }

    /// [`Book::advance`] by another substep than the product's.
    pub(crate) fn advance_by(
        &mut self,
        dt_us: u32,
        mut substep: impl FnMut(&mut Self, &mut StepReport),
    ) -> StepReport {
        let mut report = nothing();
        self.owed_us += u64::from(dt_us);
        for _ in 0..MOST_STEPS {
            if self.owed_us < u64::from(self.step_us) {
                break;
            }
            self.owed_us -= u64::from(self.step_us);
            report.add(&self.step_by(&mut substep));
        }
        self.owed_us = self.owed_us.min(u64::from(self.step_us));
        report
    }

    /// One world step.
    pub fn step(&mut self) -> StepReport {
        self.step_by(&mut Self::substep)
    }

    fn step_by(&mut self, substep: &mut impl FnMut(&mut Self, &mut StepReport)) -> StepReport {
        let mut report = nothing();
        let until = self.now_us + u64::from(self.step_us);
        while let Some(sample) = self.samples.front().copied().filter(|s| s.t_us <= until) {
            let _ = self.samples.pop_front();
            self.touch(&sample, &mut report);
        }
        if !self.asleep {
            for _ in 0..self.settings.substeps {
                substep(self, &mut report);
            }
            report.steps = 1;
        }
        self.now_us = until;
        if !self.asleep {
            self.settle(&mut report);
        }
        report
    }

    fn substep(&mut self, report: &mut StepReport) {
        self.hold(report);
        self.step_midline(report);
        if self.active {
            self.step_leaf(report);
        }
    }

    /// Blocks and boards: solve, collide, velocities.
    pub(super) fn step_midline(&mut self, report: &mut StepReport) {
        let ask = StripAsk {
            h: self.h,
            keep: self.keep,
            gravity: V2([R::ZERO, self.gravity.0[1]]),
            delta: R::of(DELTA),
            contact: R::of(CONTACT),
        };
        let boards = self.has_boards();
        for (strip, board) in self.blocks.iter_mut().zip(&mut self.boards) {
            let ground = if boards {
                let before = board.x;
                report.chain_solves += u32::from(step_strip::<R, 2, 2>(board, &self.board, &ask));
                report.pushed += block::resolve(board, &block::Ground::table());
                block::velocities(board, &before, self.h);
                block::Ground::board(board)
            } else {
                block::Ground::table()
            };
            let before = strip.x;
            report.chain_solves += u32::from(step_strip::<R, 7, 12>(strip, &self.fibre, &ask));
            report.pushed += block::resolve(strip, &ground);
            block::velocities(strip, &before, self.h);
        }
    }

    /// The leaf: solve, collide, velocities, and the guard that keeps the last good pose.
    ///
    /// A step that strains the sheet more than paper bears is taken back, and taken again in [`PARTS`].
    fn step_leaf(&mut self, report: &mut StepReport) {
        let ask = self.ask();
        let was = self.strain.larger(self.squeeze);
        self.kept.copy_from(&self.leaf);
        let mut own = self.try_leaf(&ask);
        let is = self.strain.larger(self.squeeze);
        let tried = matches!(own.status, StepStatus::Converged | StepStatus::Reduced);
        if (tried && is > R::of(OVERSTRAINED) && is > was) || own.status == StepStatus::Recovered {
            self.leaf.copy_from(&self.kept);
            own.status = StepStatus::Asleep;
            own.parted = 1;
            self.in_parts(&ask, &mut own);
        }
        let back = matches!(own.status, StepStatus::Held | StepStatus::Recovered);
        self.eased |= back;
        self.stuck = if back { self.stuck + 1 } else { 0 };
        report.add(&own);
    }

    fn in_parts(&mut self, ask: &Ask<R>, own: &mut StepReport) {
        let (mut h, mut keep) = (ask.h, ask.keep);
        for _ in 0..HALVINGS {
            (h, keep) = (h * R::of(0.5), keep.root());
        }
        let part = Ask { h, keep, ..*ask };
        for _ in 0..PARTS {
            let done = self.try_leaf(&part);
            own.add(&done);
            if done.status.failed() {
                break;
            }
        }
    }

    /// One step of the leaf as asked. Where it fails the pose is the one before.
    fn try_leaf(&mut self, ask: &Ask<R>) -> StepReport {
        self.before.copy_from(&self.leaf.x);
        let mut own = nothing();
        self.solver.step(&self.sheet, &mut self.leaf, ask, &self.settings, &mut own);
        let [left, right] = self.binding.profiles(&self.blocks);
        let done = leaf::resolve(
            &mut self.leaf,
            [&left, &right],
            self.binding.half_held(),
            self.settings.passes,
            &mut self.scratch,
        );
        own.passes = done.passes;
        own.pushed = done.pushed;
        if !self.leaf.x.finite() {
            own.status = StepStatus::Held;
        } else if !self.measure() {
            own.status = StepStatus::Recovered;
        }
        if matches!(own.status, StepStatus::Held | StepStatus::Recovered) {
            self.keep_pose();
        } else {
            self.velocities(ask.h);
        }
        own
    }

    /// What the leaf's step is asked: air and weight are those of a landing leaf once it lies.
    fn ask(&mut self) -> Ask<R> {
        let landing = self.lay_down();
        Ask {
            h: self.h,
            keep: if landing { self.keep_squeezed } else { self.keep },
            gravity: self.gravity * (R::of(1.0) + self.press),
            root: Root::Hinge,
            grab: self.grab,
        }
    }

    /// Back to the pose before the step, at rest, free of contacts. Should that not be one of numbers either,
    /// because memory was spoilt, the leaf lies again where it was taken up.
    fn keep_pose(&mut self) {
        self.leaf.x.copy_from(&self.before);
        if !self.leaf.x.finite() {
            self.lay_leaf(self.binding.from_right);
        }
        self.leaf.v.clear();
        self.leaf.pushed.clear();
        self.leaf.holding.clear();
        let _ = self.measure();
    }

    /// `v = (x - x_before) / h`, after the collisions.
    fn velocities(&mut self, h: R) {
        let rate = R::of(1.0) / h;
        let (x, before) = (self.leaf.x.raw(), self.before.raw());
        for ((v, &x), &b) in self.leaf.v.raw_mut().iter_mut().zip(x).zip(before) {
            *v = (x - b) * rate;
        }
    }

    /// Measures how much the most stretched edge is strained. Answers whether every edge has a length a sheet
    /// of paper can have.
    pub(super) fn measure(&mut self) -> bool {
        let [across, along] = self.sheet.spacing.map(|l| R::Lanes::all(R::of(1.0) / (l * l)));
        let (mut least, mut most) = (R::Lanes::one(), R::Lanes::one());
        for k in groups::<R, G>() {
            let inside = R::Lanes::mask(k, 0, G::NZ);
            let between = R::Lanes::mask(k, 0, G::NZ - 1);
            for i in 1..G::NX {
                let x = self.leaf.x.rows(i, k, 0);
                let one = R::Lanes::one();
                let a = (x - self.leaf.x.rows(i - 1, k, 0)).norm_sq() * across;
                let b = (self.leaf.x.rows(i, k, 1) - x).norm_sq() * along;
                for (ratio, mask) in [(a, inside), (b, between)] {
                    let ratio = R::Lanes::pick_less(R::Lanes::zero(), mask, ratio, one);
                    least = least.smaller(ratio);
                    most = most.larger(ratio);
                }
            }
        }
        let (smallest, largest) = (-(-least).largest(), most.largest());
        self.strain = largest.root() - R::of(1.0);
        self.squeeze = R::of(1.0) - smallest.larger(R::ZERO).root();
        smallest > R::of(BAND.0) && largest < R::of(BAND.1)
    }
}
