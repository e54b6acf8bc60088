//! The Newton step of the leaf and its line search: Eq. 4 on the condensed system.

use super::ask::Ask;
use super::assemble::assemble;
use super::constant::Constant;
use super::matrix::Matrix;
#[cfg(feature = "seed")]
use super::matrix::NoMatrix;
use super::merit::merit;
use super::report::{StepReport, StepStatus};
use super::star::rows;
use crate::grid::Grid;
use crate::kkt::solve::Unknowns;
use crate::kkt::{Factor, Stencil};
use crate::real::{Lanes, Num, Real, V3};
use crate::scene::Settings;
use crate::state::field::{Field, groups};
use crate::state::{Leaf, Root, Sheet};

/// Least weight of the residual in the merit. Source: RHS19.
const LEAST_MU: f64 = 0.05;
/// The weight in terms of the largest multiplier. Source: RHS19.
const MU_OVER_LAMBDA: f64 = 1.1;
/// Rounding a resting leaf may lose without the step being called worse: a share of the merit plus one unit,
/// which is the weight of a leaf times a thousandth of its width.
const SLACK: f64 = 1e-6;

/// Workspace of the leaf's step: placed by the caller, nothing of it is state.
#[derive(Debug, Clone)]
pub struct Solver<R: Real, G: Grid> {
    constant: Constant<R, G>,
    filled_for: Option<(R, bool)>,
    stencil: Stencil<R, G>,
    factor: Factor<R, G>,
    gradient: Field<R, G>,
    aim: Field<R, G>,
    start: Field<R, G>,
    dx: Field<R, G>,
    unknowns: Unknowns<R, G>,
    #[cfg(feature = "faults")]
    pub(crate) faults: super::fault::Faults,
}

impl<R: Real, G: Grid> Solver<R, G> {
    /// An empty workspace.
    pub const ZERO: Self = Self {
        constant: Constant::ZERO,
        filled_for: None,
        stencil: Stencil::ZERO,
        factor: Factor::ZERO,
        gradient: Field::ZERO,
        aim: Field::ZERO,
        start: Field::ZERO,
        dx: Field::ZERO,
        unknowns: Unknowns::ZERO,
        #[cfg(feature = "faults")]
        faults: super::fault::Faults::NONE,
    };

    /// Forgets the sheet it was filled for: call after changing the sheet.
    pub fn forget(&mut self) {
        self.filled_for = None;
    }

    /// Moves the leaf's positions by one implicit step; velocities are left to the collision pass.
    ///
    /// # Cost
    ///
    /// At most `newton` factorisations, each with at most `trials` merit evaluations, and as many for each
    /// refinement.
    ///
    /// # Hard case
    ///
    /// Where no trial improves the merit, or a number is not finite, the pose stays and the report says so.
    pub fn step(
        &mut self,
        sheet: &Sheet<R, G>,
        leaf: &mut Leaf<R, G>,
        ask: &Ask<R>,
        dials: &Settings,
        report: &mut StepReport,
    ) {
        self.prepare(sheet, ask);
        self.aim_at(leaf, ask);
        for _ in 0..dials.newton {
            #[cfg_attr(not(feature = "seed"), expect(unused_mut))]
            let mut status = self.newton(sheet, leaf, ask, dials, report);
            #[cfg(feature = "seed")]
            for _ in 0..dials.refinements {
                if status.failed() {
                    break;
                }
                status = status.worse(self.refine(sheet, leaf, ask, dials, report));
            }
            report.newton_steps += 1;
            report.status = report.status.worse(status);
            if status.failed() || self.moved() < R::of(dials.tolerance) {
                break;
            }
        }
    }

    fn prepare(&mut self, sheet: &Sheet<R, G>, ask: &Ask<R>) {
        let clamped = matches!(ask.root, Root::Clamp(_));
        if self.filled_for != Some((ask.h, clamped)) {
            self.constant.fill(sheet, ask.h, ask.root);
            self.filled_for = Some((ask.h, clamped));
        }
    }

    /// `x̃ = x + h e^(-ch) v`.
    fn aim_at(&mut self, leaf: &Leaf<R, G>, ask: &Ask<R>) {
        let carry = ask.h * ask.keep;
        let (x, v) = (leaf.x.raw(), leaf.v.raw());
        for ((aim, &x), &v) in self.aim.raw_mut().iter_mut().zip(x).zip(v) {
            *aim = x + carry * v;
        }
    }

    /// Eq. 4: matrix, factor, step. A frame of its own on the stack, as the chains and the collisions have.
    #[inline(never)]
    fn newton(
        &mut self,
        sheet: &Sheet<R, G>,
        leaf: &mut Leaf<R, G>,
        ask: &Ask<R>,
        dials: &Settings,
        report: &mut StepReport,
    ) -> StepStatus {
        self.inertia(sheet, leaf, ask);
        let Self { constant, stencil, factor, gradient, dx, .. } = self;
        assemble(sheet, leaf, dx, ask, &mut Matrix { constant, stencil, factor }, gradient);
        self.factor.decompose();
        report.regularised += self.factor.regularised;
        self.take(sheet, leaf, ask, dials, report)
    }

    /// A step with the factor of the last pose: cheap, and it converges where the pose has hardly changed.
    #[cfg(feature = "seed")]
    fn refine(
        &mut self,
        sheet: &Sheet<R, G>,
        leaf: &mut Leaf<R, G>,
        ask: &Ask<R>,
        dials: &Settings,
        report: &mut StepReport,
    ) -> StepStatus {
        self.inertia(sheet, leaf, ask);
        assemble(sheet, leaf, &self.dx, ask, &mut NoMatrix, &mut self.gradient);
        self.take(sheet, leaf, ask, dials, report)
    }

    /// Solves for the step and takes it.
    fn take(
        &mut self,
        sheet: &Sheet<R, G>,
        leaf: &mut Leaf<R, G>,
        ask: &Ask<R>,
        dials: &Settings,
        report: &mut StepReport,
    ) -> StepStatus {
        self.gather();
        self.factor.solve(&mut self.unknowns);
        #[cfg(feature = "faults")]
        self.faults.spoil(&mut self.unknowns);
        self.scatter();
        if !self.dx.finite() {
            return StepStatus::Held;
        }
        if dials.trials == 0 {
            self.start.copy_from(&leaf.x);
            self.try_step(leaf, R::of(1.0));
            return StepStatus::Converged;
        }
        let mu =
            R::of(LEAST_MU).larger(R::of(MU_OVER_LAMBDA) * self.largest_multiplier(sheet, leaf));
        self.line_search(sheet, leaf, ask, mu, dials.trials, report)
    }

    /// Largest change of a coordinate in the last full step.
    fn moved(&self) -> R {
        self.dx.raw().iter().fold(R::ZERO, |most, d| most.larger(d.magnitude()))
    }

    /// `M (x - x̃) / h²` into `dx`, which is free until the solve.
    fn inertia(&mut self, sheet: &Sheet<R, G>, leaf: &Leaf<R, G>, ask: &Ask<R>) {
        let scale = R::Lanes::all(R::of(1.0) / (ask.h * ask.h));
        for i in 0..G::NX {
            for k in groups::<R, G>() {
                let away = leaf.x.rows(i, k, 0) - self.aim.rows(i, k, 0);
                self.dx.set_rows(i, k, 0, away * (sheet.mass.rows(i, k) * scale));
            }
        }
    }

    /// `-(g + JᵀC/δ)` into the order of the unknowns.
    fn gather(&mut self) {
        let nodes = (1..G::NX).flat_map(|i| (0..G::NZ).map(move |k| (i, k)));
        let (triples, _) = self.unknowns.numbers_mut().as_chunks_mut::<3>();
        for (slot, (i, k)) in triples.iter_mut().zip(nodes) {
            *slot = (-self.gradient.at(i, k)).0;
        }
        if let Some(rest) = self.unknowns.numbers_mut().get_mut(G::UNKNOWNS..) {
            rest.fill(R::ZERO);
        }
    }

    /// The solution back onto the nodes; the held column does not move.
    fn scatter(&mut self) {
        self.dx.clear();
        let nodes = (1..G::NX).flat_map(|i| (0..G::NZ).map(move |k| (i, k)));
        let (triples, _) = self.unknowns.numbers().as_chunks::<3>();
        for (&step, (i, k)) in triples.iter().zip(nodes) {
            self.dx.set(i, k, V3(step));
        }
    }

    /// `max |λ|`, with `λ = (C + J dx) / δ` at the pose the step starts from.
    fn largest_multiplier(&self, sheet: &Sheet<R, G>, leaf: &Leaf<R, G>) -> R {
        let mut largest = R::Lanes::zero();
        let scales = sheet.row_scales().map(R::Lanes::all);
        for i in 1..G::NX - 1 {
            for k in groups::<R, G>() {
                let weight = sheet.star.rows(i, k);
                if weight.largest() <= R::ZERO {
                    continue;
                }
                let steps = [
                    self.dx.rows(i + 1, k, 0),
                    self.dx.rows(i, k, 1),
                    self.dx.rows(i - 1, k, 0),
                    self.dx.rows(i, k, -1),
                    self.dx.rows(i, k, 0),
                ];
                let rows = rows(&leaf.x, i, k, &scales.map(|v| v * weight));
                for (r, value) in rows.values.into_iter().enumerate() {
                    let lambda =
                        rows.nodes.iter().zip(steps).fold(value, |sum, (node, d)| {
                            node.get(r).map_or(sum, |g| sum + g.dot(d))
                        });
                    largest = largest.larger(lambda.magnitude());
                }
            }
        }
        largest.largest() / sheet.delta.root()
    }

    /// Halves the step until the merit is no worse, at most `trials` times.
    fn line_search(
        &mut self,
        sheet: &Sheet<R, G>,
        leaf: &mut Leaf<R, G>,
        ask: &Ask<R>,
        mu: R,
        trials: u32,
        report: &mut StepReport,
    ) -> StepStatus {
        let before = merit(sheet, leaf, &leaf.x, &self.aim, ask).at(mu);
        let allowed = before + (before.magnitude() + R::of(1.0)) * R::of(SLACK);
        self.start.copy_from(&leaf.x);
        let mut share = R::of(1.0);
        for trial in 0..trials {
            self.try_step(leaf, share);
            let after = merit(sheet, leaf, &leaf.x, &self.aim, ask).at(mu);
            #[cfg(feature = "faults")]
            if self.faults.no_better() {
                share *= R::of(0.5);
                continue;
            }
            if after <= allowed {
                report.cuts += trial;
                return if trial == 0 { StepStatus::Converged } else { StepStatus::Reduced };
            }
            share *= R::of(0.5);
        }
        report.cuts += trials;
        leaf.x.copy_from(&self.start);
        if before.finite() { StepStatus::Stalled } else { StepStatus::Held }
    }

    fn try_step(&self, leaf: &mut Leaf<R, G>, share: R) {
        let (start, dx) = (self.start.raw(), self.dx.raw());
        for ((x, &s), &d) in leaf.x.raw_mut().iter_mut().zip(start).zip(dx) {
            *x = s + share * d;
        }
    }
}
