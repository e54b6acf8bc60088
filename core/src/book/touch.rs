//! Input: a press takes a leaf up, a drag leads it, letting go frees it.

use super::Book;
use crate::collision::leaf::resolve;
use crate::event::Event;
use crate::grid::Grid;
use crate::hand::tent::Tent;
use crate::hand::view::Ray;
use crate::hand::{Guide, Phase, Reach, Sample, pick::pick};
use crate::real::{Real, V2, V3};
use crate::state::Grab;
use crate::step::StepReport;

/// A press within this distance of the leaf in the air catches it again, model units.
const CATCH: f64 = 2.5;
/// A press this far beyond a page's edge, as a share of its size, still means the page.
const MARGIN: f64 = 1.1;
/// How far a leaf just taken up is moved off its block to find what touches it, model units.
const SKIN: f64 = 1e-3;
/// A leaf whose free edge is lower than this above its block has as good as landed.
const LANDED: f64 = 2.0;

impl<R: Real, G: Grid> Book<R, G> {
    pub(super) fn touch(&mut self, sample: &Sample, report: &mut StepReport) {
        let own = self.guide.is_some_and(|g| g.id == sample.id && g.dragging());
        let taken = match sample.phase {
            Phase::Down => !own && self.press(sample),
            Phase::Move => own && self.drag(sample, report),
            Phase::Up => own && self.release(sample, report),
            Phase::Cancel => own && self.cancel(),
        };
        if !taken {
            report.refused += 1;
        }
    }

    /// Takes up the leaf in the air, or the top leaf of the block under the pointer.
    fn press(&mut self, sample: &Sample) -> bool {
        if self.guide.is_some_and(|g| g.dragging()) {
            return false;
        }
        let ray = self.camera.ray(sample.x, sample.y);
        if self.active && !self.catches(&ray) {
            if !self.low() {
                return false;
            }
            self.merge();
        }
        if !self.active && !self.lift(&ray, u32::from(sample.leaves.max(1))) {
            return false;
        }
        let (node, _) = pick(&self.leaf, &ray);
        let reach = self.reach(node);
        let at = self.leaf.x.at(node.0, node.1);
        self.guide = Some(Guide::take(sample.id, node, at, &ray, &reach, sample.t_us));
        self.grab = Some(Grab { node, target: at });
        self.wake();
        true
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
    fn soften(&mut self) {
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

    pub(super) fn reach(&self, (column, row): (usize, usize)) -> Reach<R> {
        let half = self.binding.half_held();
        let along = |rows: usize| self.sheet.spacing[1] * R::of(rows as f64);
        let tent = Tent {
            root: self.binding.root().0[0],
            radius: self.sheet.spacing[0] * R::of(column as f64),
            floor: self.binding.thickness().map(|t| t + half),
            ends: [along(row), along(G::NZ - 1 - row)],
        };
        Reach { tent, camera: self.camera }
    }

    fn drag(&mut self, sample: &Sample, report: &mut StepReport) -> bool {
        let Some(mut guide) = self.guide else { return false };
        let reach = self.reach(guide.node);
        let ray = self.camera.ray(sample.x, sample.y);
        report.clamped += u32::from(guide.drag(&ray, &reach, sample.t_us));
        self.guide = Some(guide);
        self.wake();
        true
    }

    fn release(&mut self, sample: &Sample, report: &mut StepReport) -> bool {
        let Some(mut guide) = self.guide else { return false };
        let reach = self.reach(guide.node);
        let ray = self.camera.ray(sample.x, sample.y);
        report.clamped += u32::from(guide.drag(&ray, &reach, sample.t_us));
        let follows = guide.release(&reach, sample.t_us);
        self.guide = follows.then_some(guide);
        if !follows {
            self.grab = None;
        }
        self.wake();
        true
    }

    /// The system took the pointer: the leaf is let go where it is, and falls.
    fn cancel(&mut self) -> bool {
        self.guide = None;
        self.grab = None;
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
        let reach = self.reach(guide.node);
        let node = self.leaf.x.at(guide.node.0, guide.node.1);
        let (target, leashed, holds) = guide.advance(node, &reach, self.strain, self.h);
        report.clamped += u32::from(leashed);
        self.grab = holds.then_some(Grab { node: guide.node, target });
        self.guide = holds.then_some(guide);
    }
}
