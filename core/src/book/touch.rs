//! Input: a press takes a leaf up, a drag leads it, letting go frees it.

use super::Book;
use crate::collision::leaf::resolve;
use crate::event::Event;
use crate::grid::Grid;
use crate::hand::pick::{level_with, pick};
use crate::hand::tent::Tent;
use crate::hand::view::Ray;
use crate::hand::{Guide, Phase, Place, Pull, Reach, Sample};
use crate::real::{Real, V2, V3};
use crate::scene::{Direction, Pages};
use crate::state::Grab;
use crate::step::StepReport;

/// A press within this distance of the leaf in the air catches it again, model units.
const CATCH: f64 = 2.5;
/// A press this far beyond a page's edge, as a share of its size, still means the page.
const MARGIN: f64 = 1.1;
/// Way of a finger that says which leaf it means, as a share of half the picture's height.
const SLOP: f64 = 1.0 / 60.0;
/// How far a leaf just taken up is moved off its block to find what touches it, model units.
const SKIN: f64 = 1e-3;
/// A leaf whose free edge is lower than this above its block has as good as landed.
const LANDED: f64 = 2.0;

impl<R: Real, G: Grid> Book<R, G> {
    pub(super) fn touch(&mut self, sample: &Sample, report: &mut StepReport) {
        if !self.taken(sample, report) {
            report.refused += 1;
        }
    }

    fn taken(&mut self, sample: &Sample, report: &mut StepReport) -> bool {
        if self.guide.is_some_and(|g| g.id == sample.id && g.dragging()) {
            return match sample.phase {
                Phase::Down => false,
                Phase::Move => self.drag(sample, report),
                Phase::Up => self.release(sample, report),
                Phase::Cancel => self.cancel(),
            };
        }
        if let Some(press) = self.undecided.filter(|p| p.id == sample.id) {
            return self.decide(&press, sample, report);
        }
        if let Some(taken) = self.swipe(sample) {
            return taken;
        }
        sample.phase == Phase::Down && self.press(sample)
    }

    /// A finger comes down: it holds a leaf, or comes beside the one that does.
    fn press(&mut self, sample: &Sample) -> bool {
        if self.guide.is_some_and(|g| g.dragging()) {
            return self.come_beside(sample);
        }
        let ray = self.camera.ray(sample.x, sample.y);
        if self.active && !self.catches(&ray) {
            if !self.low() {
                return false;
            }
            self.merge();
        }
        if !self.active && self.handling.pages == Pages::Single {
            self.undecided = Some(*sample);
            return true;
        }
        self.hold_on(sample)
    }

    /// Where one page is seen, the way of the finger says which leaf it means: the one it lies on, or the one
    /// before it.
    fn decide(&mut self, press: &Sample, sample: &Sample, report: &mut StepReport) -> bool {
        if sample.phase != Phase::Move {
            self.undecided = None;
            return sample.phase != Phase::Down;
        }
        let way = (f64::from(sample.x) - f64::from(press.x)) * (1.0 / 256.0);
        if way.abs() < SLOP * self.camera.centre[1].wide() {
            return true;
        }
        self.undecided = None;
        let ltr = self.spec.direction == Direction::Ltr;
        let taken = if (way < 0.0) == ltr { self.hold_on(press) } else { self.pull_back(press) };
        taken && self.drag(sample, report)
    }

    /// Holds the leaf in the air, or the top leaf of the block under the pointer.
    fn hold_on(&mut self, sample: &Sample) -> bool {
        let ray = self.camera.ray(sample.x, sample.y);
        if !self.active && !self.lift(&ray, u32::from(sample.leaves.max(1))) {
            return false;
        }
        let (node, _) = pick(&self.leaf, &ray);
        self.take_node(sample, node, Place::under(&self.leaf, &ray));
        true
    }

    /// Takes the last leaf that was read by its fore-edge: it comes to the finger.
    fn pull_back(&mut self, sample: &Sample) -> bool {
        let ray = self.camera.ray(sample.x, sample.y);
        let from_right = self.spec.direction == Direction::Rtl;
        if !self.take_up(from_right, u32::from(sample.leaves.max(1))) {
            return false;
        }
        let node = level_with(&self.leaf, &ray);
        self.take_node(sample, node, Place::at(node));
        true
    }

    fn take_node(&mut self, sample: &Sample, node: (usize, usize), place: Place<R>) {
        let at = self.leaf.x.at(node.0, node.1);
        let reach = self.reach(node, at, &place);
        self.guide = Some(Guide::take(sample, node, place, at, &reach));
        self.grab = Some(Grab { node, target: at, firm: R::of(1.0) });
        self.wake();
    }

    /// Nobody holds anything.
    pub(super) fn free_hand(&mut self) {
        self.guide = None;
        self.grab = None;
        self.beside = None;
        self.undecided = None;
    }

    fn catches(&self, ray: &Ray<R>) -> bool {
        pick(&self.leaf, ray).1 < R::of(CATCH * CATCH)
    }

    /// The free edge of the leaf is about where it will rest.
    pub(super) fn low(&self) -> bool {
        let profiles = self.binding.profiles(&self.blocks);
        let tip = self.tip();
        let side = &profiles[usize::from(tip.0[0] >= R::ZERO)];
        tip.0[1] - side.thickness < R::of(LANDED)
            && tip.0[0].magnitude() > self.sheet.spacing[0] * R::of(4.0)
    }

    /// Mean place of the free edge.
    pub(super) fn tip(&self) -> V3<R> {
        let sum = (0..G::NZ).fold(V3::zero(), |s, k| s + self.leaf.x.at(G::NX - 1, k));
        sum * R::of(1.0 / G::NZ as f64)
    }

    /// Takes leaves off the block the ray meets. Answers whether there were any.
    fn lift(&mut self, ray: &Ray<R>, leaves: u32) -> bool {
        let [left, right] = self.binding.thickness();
        let top = V3([R::ZERO, left.larger(right), R::ZERO]);
        let Some(met) = ray.meet(top, V3([R::ZERO, R::of(1.0), R::ZERO])) else { return false };
        let from_right = met.0[0] > self.binding.root().0[0];
        let width = R::of(crate::scene::units::WIDTH * MARGIN);
        let height = R::of(0.5 * self.units.length(self.spec.height_m) * MARGIN);
        if met.0[0].magnitude() > width + self.binding.half() || met.0[2].magnitude() > height {
            return false;
        }
        self.take_up(from_right, leaves)
    }

    /// Takes leaves off one block and lays them, as one active leaf, where they were.
    pub fn take_up(&mut self, from_right: bool, leaves: u32) -> bool {
        let side = usize::from(from_right);
        let there = self.binding.leaves[side.min(1)];
        let held = leaves.min(there);
        if held == 0 || self.active {
            return false;
        }
        self.binding.leaves[side.min(1)] = there - held;
        self.binding.held = held;
        self.binding.from_right = from_right;
        self.soften();
        self.lay_leaf(from_right);
        self.active = true;
        self.note(Event::Lifted { from_right, leaves: held });
        self.wake();
        true
    }

    /// Lets the leaf round the gutter's edges, as far as the thicker block asks.
    pub(super) fn soften(&mut self) {
        let [left, right] = self.binding.thickness();
        let arc = left.larger(right) * R::of(core::f64::consts::FRAC_PI_2);
        self.sheet.soften(arc, &self.paper, &self.units);
        self.solver.forget();
    }

    /// Lays the leaf on one block, at rest.
    pub(super) fn lay_leaf(&mut self, on_right: bool) {
        let profiles = self.binding.profiles(&self.blocks);
        let profile = &profiles[usize::from(on_right)];
        let above = profile.thickness + self.binding.half_held();
        let sign = R::of(if on_right { 1.0 } else { -1.0 });
        let outline = profile.outline(above);
        let places = crate::collision::profile::stride(&outline, self.sheet.spacing[0]);
        self.leaf.lay(self.sheet.spacing, places.map(|p| V2([p.0[0] * sign, p.0[1]])));
        let root = self.binding.root();
        for k in 0..G::NZ {
            let at = self.leaf.x.at(0, k);
            self.leaf.x.set(0, k, V3([root.0[0], root.0[1], at.0[2]]));
        }
        // The block already carries the leaf: without these contacts the first solve would sink it.
        let half = self.binding.half_held() + R::of(SKIN);
        let _ = resolve(&mut self.leaf, [&profiles[0], &profiles[1]], half, 1, &mut self.scratch);
        if !self.measure() {
            self.lay_straight(sign, profile.top() + above);
        }
    }

    /// On a block so folded that no sheet could lie on it the leaf stands out straight instead, rising to a
    /// height above all of it.
    fn lay_straight(&mut self, sign: R, height: R) {
        let width = R::of(crate::scene::units::WIDTH);
        let rise = (height / width).smaller(R::of(0.9));
        let run = (R::of(1.0) - rise * rise).root() * sign;
        let (root, step) = (self.binding.root(), self.sheet.spacing[0]);
        let place = |n: usize| root + V2([run, rise]) * (step * R::of(n as f64));
        self.leaf.lay(self.sheet.spacing, (0..G::NX).map(place));
        let _ = self.measure();
    }

    fn reach_of(&self, guide: &Guide<R>) -> Reach<R> {
        self.reach(guide.node, guide.origin(), guide.place())
    }

    /// What bounds the targets of a node that lay at `lain`, so that `place` stays under the finger.
    fn reach(&self, (column, row): (usize, usize), lain: V3<R>, place: &Place<R>) -> Reach<R> {
        let half = self.binding.half_held();
        let firm = self.handling.grip > 0.0;
        let root = self.binding.root();
        // Where the sheet has lain means nothing to a hand that does not follow the finger.
        let lain = if firm { lain } else { V3([root.0[0], root.0[1], lain.0[2]]) };
        let along = |rows: usize| self.sheet.spacing[1] * R::of(rows as f64);
        let tent = Tent {
            root: root.0[0],
            radius: self.sheet.spacing[0] * R::of(column as f64),
            floor: self.binding.thickness().map(|t| t + half),
            ends: [along(row), along(G::NZ - 1 - row)],
            lain,
        };
        let aside = self.leaf.x.at(column, row) - place.on(&self.leaf);
        Reach { tent, camera: self.camera, aside, firm }
    }

    fn drag(&mut self, sample: &Sample, report: &mut StepReport) -> bool {
        let Some(mut guide) = self.guide else { return false };
        let reach = self.reach_of(&guide);
        report.clamped += u32::from(guide.drag(sample, &reach));
        self.guide = Some(guide);
        self.wake();
        true
    }

    fn release(&mut self, sample: &Sample, report: &mut StepReport) -> bool {
        let Some(mut guide) = self.guide else { return false };
        let reach = self.reach_of(&guide);
        report.clamped += u32::from(guide.drag(sample, &reach));
        let follows = guide.release(&reach, sample.t_us);
        let grab = self.grab.filter(|_| follows);
        self.free_hand();
        self.guide = follows.then_some(guide);
        self.grab = grab;
        self.wake();
        true
    }

    /// The system took the pointer: the leaf goes back where it came from, wherever it is.
    fn cancel(&mut self) -> bool {
        let (guide, grab) = (self.guide, self.grab);
        self.free_hand();
        self.guide = guide.map(|mut guide| {
            guide.put_back(self.binding.from_right);
            guide
        });
        self.grab = grab;
        self.wake();
        true
    }

    /// Moves the target the hand pulls towards.
    pub(super) fn hold(&mut self, report: &mut StepReport) {
        let Some(mut guide) = self.guide else { return };
        if core::mem::take(&mut self.eased) {
            self.grab = None;
            return;
        }
        let reach = self.reach_of(&guide);
        let node = self.leaf.x.at(guide.node.0, guide.node.1);
        let grip = R::of(self.handling.grip);
        let pull = guide.advance(node, &reach, self.strain, self.h, grip);
        report.clamped += u32::from(pull.leashed);
        let Pull { target, firm, holds, .. } = pull;
        self.grab = holds.then_some(Grab { node: guide.node, target, firm });
        self.guide = holds.then_some(guide);
    }
}
