//! A lone leaf and the core's solver: nothing to collide with, so that the motion is smooth and its limit known.

use super::{Hand, Kind, Look, Sim, Stage};
use crate::axes::Config;
use dogleaf_core::grid::Grid;
use dogleaf_core::real::{Real, V2, V3};
use dogleaf_core::scene::Settings;
use dogleaf_core::scene::units::WIDTH;
use dogleaf_core::state::{Field, Grab, Leaf, Root, Sheet};
use dogleaf_core::step::merit::merit;
use dogleaf_core::step::{Ask, Solver, StepReport};

/// A leaf, its solver and the hand.
#[derive(Debug, Clone)]
pub struct Lone<R: Real, G: Grid> {
    pub(crate) sheet: Sheet<R, G>,
    pub(crate) leaf: Leaf<R, G>,
    pub(crate) ask: Ask<R>,
    before: Field<R, G>,
    solver: Solver<R, G>,
    dials: Settings,
    hand: Option<Hand>,
}

/// Gravity the seed's weights belong to, model units.
const SEEDS_GRAVITY: f64 = 98.1;
/// Gravity, m/s².
const GRAVITY: f64 = 9.81;

pub(super) fn boxed<R: Real, G: Grid>(stage: &Stage, config: &Config) -> Box<dyn Sim> {
    Box::new(Lone::<R, G>::new(stage, config))
}

impl<R: Real, G: Grid> Lone<R, G> {
    /// The leaf of a stage where it starts, at rest; laid straight where the stage does not know yet.
    pub fn new(stage: &Stage, config: &Config) -> Self {
        let units = stage.units();
        let h = 1.0 / f64::from(config.rate);
        let mut new = Self {
            sheet: Sheet::ZERO,
            leaf: Leaf::ZERO,
            before: Field::ZERO,
            solver: Solver::ZERO,
            dials: config.settings(),
            hand: stage.hand(),
            ask: Ask {
                h: R::of(h),
                keep: R::of((-stage.damping_per_s * h).exponential()),
                gravity: V3([R::ZERO, R::of(-units.length(GRAVITY)), R::ZERO]),
                root: root(stage.kind),
                grab: None,
            },
        };
        let pull = units.length(GRAVITY) / SEEDS_GRAVITY;
        new.sheet.fill(WIDTH, units.length(stage.size_m[1]), &stage.paper, &units, pull);
        if stage.kind == Kind::Fall {
            new.sheet.clamp(&stage.paper);
        }
        new.sheet.regularise(config.delta);
        new.lay(stage);
        new
    }

    fn lay(&mut self, stage: &Stage) {
        let slope = if stage.kind == Kind::Turn { 0.12_f64 } else { 0.0 };
        let edge = WIDTH / (G::NX - 1) as f64;
        let along = [edge * slope.cosine(), edge * slope.sine()];
        let places = (0..G::NX).map(|i| V2(along.map(|c| R::of(c * i as f64))));
        self.leaf.lay(self.sheet.spacing, places);
        for ((i, k), place) in Field::<R, G>::nodes().zip(&stage.start) {
            self.leaf.x.set(i, k, V3(place.map(R::of)));
        }
    }

    /// Where the nodes are.
    pub fn places(&self) -> Vec<[f64; 3]> {
        Field::<R, G>::nodes().map(|(i, k)| self.leaf.x.at(i, k).0.map(Real::wide)).collect()
    }

    /// Lets the leaf find where hand and weight hold it, without inertia: steps of growing length without memory.
    pub fn come_to_rest(&mut self) {
        let (h, keep) = (self.ask.h, self.ask.keep);
        self.ask.keep = R::ZERO;
        for n in 0..240_u32 {
            self.ask.h = R::of(if n < 60 { 0.01 } else { 0.1 });
            let _ = self.step(0.0);
            if n > 60 && self.leaf.fastest() < R::of(1e-11) {
                break;
            }
        }
        (self.ask.h, self.ask.keep) = (h, keep);
        self.solver.forget();
        self.leaf.v.clear();
    }

    /// Sets the hand's target for a moment.
    pub fn lead(&mut self, t_s: f64) {
        let Some(hand) = &self.hand else { return };
        self.ask.grab = Some(Grab {
            node: (G::NX - 1, 0),
            target: V3(hand.at(t_s).map(R::of)),
            firm: R::of(1.0),
        });
    }

    /// `v = (x - x_before) / h`.
    fn velocities(&mut self) {
        let rate = R::of(1.0) / self.ask.h;
        let (x, before) = (self.leaf.x.raw(), self.before.raw());
        for ((v, &x), &b) in self.leaf.v.raw_mut().iter_mut().zip(x).zip(before) {
            *v = (x - b) * rate;
        }
    }

    /// Kinetic energy; and height, bending and isometry energy. Model units.
    fn energy(&self) -> [R; 2] {
        let kinetic = Field::<R, G>::nodes().fold(R::ZERO, |sum, (i, k)| {
            sum + self.sheet.mass.at(i, k) * R::of(0.5) * self.leaf.v.at(i, k).norm_sq()
        });
        let x = &self.leaf.x;
        [kinetic, merit(&self.sheet, &self.leaf, x, x, &self.ask).energy]
    }
}

/// How the spine column is held.
pub(super) fn root<R: Real>(kind: Kind) -> Root<R> {
    match kind {
        Kind::Turn => Root::Hinge,
        Kind::Fall => Root::Clamp(V3([1.0, 0.0, 0.0].map(R::of))),
    }
}

impl<R: Real, G: Grid> Sim for Lone<R, G> {
    fn step(&mut self, t_s: f64) -> StepReport {
        let mut report = StepReport::default();
        self.lead(t_s);
        self.before.copy_from(&self.leaf.x);
        self.solver.step(&self.sheet, &mut self.leaf, &self.ask, &self.dials, &mut report);
        self.velocities();
        report.steps = 1;
        report
    }

    fn look(&self) -> Option<Look> {
        Some(Look::of(&self.leaf, &self.sheet, self.energy()))
    }

    fn edge(&self) -> Option<f64> {
        let sum = (0..G::NZ).fold(0.0, |s, k| s + self.leaf.x.at(G::NX - 1, k).0[0].wide());
        Some(sum / (WIDTH * G::NZ as f64))
    }

    fn bytes(&self) -> usize {
        size_of::<Sheet<R, G>>()
            + size_of::<Leaf<R, G>>()
            + size_of::<Field<R, G>>()
            + size_of::<Solver<R, G>>()
    }
}
