//! A lone leaf held along its spine edge: the same leaf, solver and time as a book's, nothing to collide with.
//!
//! It is where paper is measured against the heavy elastica, and the smallest scene there is.

use super::open::SEED_GRAVITY;
use crate::grid::Grid;
use crate::real::{Real, V2, V3};
use crate::scene::units::WIDTH;
use crate::scene::{Fidelity, LeafSpec, PaperSpec, Settings, SpecError, Units, WorldSpec};
use crate::state::{Field, Fnv, Leaf, Root, Sheet, Stretch};
use crate::step::Ask;
use crate::step::merit::merit;
use crate::step::{Solver, StepReport, StepStatus};

/// World steps one call may catch up; what is owed beyond is dropped.
const MOST_STEPS: u32 = 8;

/// A leaf clamped along its spine edge at the origin. Never sleeps.
#[derive(Debug, Clone)]
pub struct LoneLeaf<R: Real, G: Grid> {
    spec: LeafSpec,
    units: Units,
    settings: Settings,
    damping_per_s: f64,
    step_us: u32,
    owed_us: u64,
    now_us: u64,
    ask: Ask<R>,
    sheet: Sheet<R, G>,
    leaf: Leaf<R, G>,
    solver: Solver<R, G>,
    before: Field<R, G>,
}

impl<R: Real, G: Grid> LoneLeaf<R, G> {
    /// A leaf that was never laid: for the caller to place.
    pub const EMPTY: Self = Self {
        spec: LeafSpec { width_m: 0.15, height_m: 0.20, clamp_angle_deg: 0.0, curl_per_m: 0.0 },
        units: Units { metres: 1.0, kilograms: 1.0 },
        settings: Settings::STANDARD,
        damping_per_s: 0.0,
        step_us: 16_667,
        owed_us: 0,
        now_us: 0,
        ask: Ask {
            h: R::ZERO,
            keep: R::ZERO,
            gravity: V3([R::ZERO; 3]),
            root: Root::Hinge,
            grab: None,
        },
        sheet: Sheet::ZERO,
        leaf: Leaf::ZERO,
        solver: Solver::ZERO,
        before: Field::ZERO,
    };

    /// Lays the leaf in place, at rest: straight along the clamp's tangent, or on an arc of the given curvature.
    ///
    /// # Errors
    ///
    /// The first bad field; then nothing was changed.
    pub fn open(
        &mut self,
        spec: &LeafSpec,
        paper: &PaperSpec,
        world: &WorldSpec,
        fidelity: Fidelity,
    ) -> Result<(), SpecError> {
        spec.check()?;
        paper.check()?;
        world.check()?;
        self.spec = *spec;
        self.units = Units::of_leaf(spec.width_m, spec.height_m, paper.areal_mass_gsm);
        (self.step_us, self.damping_per_s) = (world.step_us, world.damping_per_s);
        (self.owed_us, self.now_us) = (0, 0);
        let angle = spec.clamp_angle_deg * (core::f64::consts::PI / 180.0);
        self.ask = Ask {
            h: R::ZERO,
            keep: R::ZERO,
            gravity: V3(world.gravity.map(|g| R::of(self.units.length(g)))),
            root: Root::Clamp(V3([angle.cosine(), angle.sine(), 0.0].map(R::of))),
            grab: None,
        };
        let (height, pull) = (self.units.length(spec.height_m), self.ask.gravity.norm().wide());
        self.sheet.fill(WIDTH, height, paper, &self.units, pull / SEED_GRAVITY);
        self.sheet.clamp(paper);
        self.set_settings(fidelity.settings())?;
        self.lay(angle);
        Ok(())
    }

    /// Turns the dials of the step by hand, between any two steps; [`LoneLeaf::open`] sets those of a fidelity.
    ///
    /// # Errors
    ///
    /// The first dial out of range; then nothing was changed.
    pub fn set_settings(&mut self, settings: Settings) -> Result<(), SpecError> {
        settings.check()?;
        self.settings = settings;
        let h = f64::from(self.step_us) * 1e-6 / f64::from(settings.substeps);
        self.ask.h = R::of(h);
        self.ask.keep = R::of((-self.damping_per_s * h).exponential());
        self.sheet.regularise(settings.delta);
        self.solver.forget();
        Ok(())
    }

    /// Edges of rest length along an arc: each turned by `κ l` from the last, the first by half of it.
    fn lay(&mut self, angle: f64) {
        let l = WIDTH / (G::NX - 1) as f64;
        let turn = self.spec.curl_per_m * self.units.metres * l;
        let (mut at, mut next) = ([0.0; 2], angle + 0.5 * turn);
        self.leaf.lay(
            self.sheet.spacing,
            (0..G::NX).map(|_| {
                let here = at;
                at = [at[0] + l * next.cosine(), at[1] + l * next.sine()];
                next += turn;
                V2(here.map(R::of))
            }),
        );
    }

    /// Lets `dt_us` microseconds pass.
    ///
    /// # Cost
    ///
    /// At most eight world steps of [`Settings::substeps`] each.
    pub fn advance(&mut self, dt_us: u32) -> StepReport {
        let mut report = StepReport::default();
        self.owed_us += u64::from(dt_us);
        for _ in 0..MOST_STEPS {
            if self.owed_us < u64::from(self.step_us) {
                break;
            }
            self.owed_us -= u64::from(self.step_us);
            report.add(&self.step());
        }
        self.owed_us = self.owed_us.min(u64::from(self.step_us));
        report
    }

    /// One world step.
    pub fn step(&mut self) -> StepReport {
        let mut report = StepReport::default();
        for _ in 0..self.settings.substeps {
            self.substep(&mut report);
        }
        report.steps = 1;
        self.now_us += u64::from(self.step_us);
        report
    }

    fn substep(&mut self, report: &mut StepReport) {
        self.before.copy_from(&self.leaf.x);
        let mut own = StepReport::default();
        self.solver.step(&self.sheet, &mut self.leaf, &self.ask, &self.settings, &mut own);
        if !self.leaf.x.finite() {
            own.status = StepStatus::Held;
        }
        if own.status == StepStatus::Held {
            self.leaf.x.copy_from(&self.before);
            self.leaf.v.clear();
            if !self.leaf.x.finite() {
                self.lay(self.spec.clamp_angle_deg * (core::f64::consts::PI / 180.0));
            }
        } else {
            self.velocities();
        }
        report.add(&own);
    }

    /// `v = (x - x_before) / h`.
    fn velocities(&mut self) {
        let rate = R::of(1.0) / self.ask.h;
        let (x, before) = (self.leaf.x.raw(), self.before.raw());
        for ((v, &x), &b) in self.leaf.v.raw_mut().iter_mut().zip(x).zip(before) {
            *v = (x - b) * rate;
        }
    }

    /// What was asked for.
    pub fn spec(&self) -> &LeafSpec {
        &self.spec
    }
    /// The dials of its step.
    pub fn settings(&self) -> Settings {
        self.settings
    }
    /// Scales between the model and SI.
    pub fn units(&self) -> &Units {
        &self.units
    }
    /// The leaf. Model units; X from the clamp, Y up, Z along the clamp.
    pub fn leaf(&self) -> &Leaf<R, G> {
        &self.leaf
    }
    /// What it is made of.
    pub fn sheet(&self) -> &Sheet<R, G> {
        &self.sheet
    }
    /// Time since it was laid, microseconds.
    pub fn now_us(&self) -> u64 {
        self.now_us
    }
    /// How far its edges are from their rest length.
    pub fn stretch(&self) -> Stretch<R> {
        self.leaf.stretch(self.sheet.spacing)
    }
    /// Kinetic energy; and height, bending and isometry energy. Model units.
    pub fn energy(&self) -> [R; 2] {
        let kinetic = Field::<R, G>::nodes().fold(R::ZERO, |sum, (i, k)| {
            sum + self.sheet.mass.at(i, k) * R::of(0.5) * self.leaf.v.at(i, k).norm_sq()
        });
        // At its own aim a pose has no inertia: what is left of the merit is the potential.
        let x = &self.leaf.x;
        [kinetic, merit(&self.sheet, &self.leaf, x, x, &self.ask).energy]
    }
    /// The hash of everything that decides the future.
    ///
    /// # Determinism
    ///
    /// Equal on every target for equal specs.
    pub fn state_hash(&self) -> u64 {
        let mut hash = Fnv::default();
        for (i, k) in Field::<R, G>::nodes() {
            let node = [self.leaf.x.at(i, k), self.leaf.v.at(i, k)];
            node.iter().flat_map(|v| v.0).for_each(|c| hash.real(c));
        }
        hash.value()
    }
}
