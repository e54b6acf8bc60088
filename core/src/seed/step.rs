//! Newton's method on Eq. 3 with the full `DF`, and the merit line search.

use super::assemble::{self, How};
use super::factor::Factor;
use super::grid::{SeedGrid, Table, get, set};
use super::matrix::{Matrix, Sink, Slots};
use super::merit::merit;
use super::model::Model;
use super::number;
use super::pose::Pose;
use super::settings::SeedSettings;
use crate::real::Real;

use crate::step::merit::Merit;
use crate::step::{StepReport, StepStatus};

/// Line-search trials at most.
const TRIALS: u32 = 20;

/// Least weight of the residual in the merit. Source: RHS19.
const LEAST_MU: f64 = 0.05;
/// The weight in terms of the largest multiplier. Source: RHS19.
const MU_OVER_LAMBDA: f64 = 1.1;
/// Rounding a resting book may lose without the step being called worse.
const SLACK: f64 = 1e-6;

/// Workspace of the seed's step: placed by the caller, nothing of it is state.
#[derive(Debug, Clone)]
pub struct Solver<R: Real, G: SeedGrid> {
    /// Which slots are laid out: without or with the constraint Hessian.
    laid_out: Option<bool>,
    matrix: Matrix<R, G>,
    factor: Factor<R, G>,
    held: G::Numbers<u16>,
    /// `-[∇Φ + Jᵀλ, C]` by number.
    rhs: G::Numbers<R>,
    /// `[dx, dλ]` by number.
    direction: G::Numbers<R>,
    /// Multipliers at their numbers.
    lambda: G::Numbers<R>,
    solution: G::Numbers<R>,
    rest: G::Numbers<R>,
    aim: Pose<R, G>,
    start: Pose<R, G>,
    dx: Pose<R, G>,
}

/// Adds to the matrix and subtracts from the right-hand side, but for what is held.
struct Values<'a, R: Real, G: SeedGrid> {
    matrix: &'a mut Matrix<R, G>,
    held: &'a [u16],
    rhs: &'a mut [R],
}

impl<R: Real, G: SeedGrid> Sink<R> for Values<'_, R, G> {
    #[inline]
    fn add(&mut self, a: usize, b: usize, value: R) {
        if get(self.held, a) | get(self.held, b) == 0 {
            self.matrix.add(a, b, value);
        }
    }
    #[inline]
    fn pull(&mut self, a: usize, value: R) {
        if let Some(slot) = self.rhs.get_mut(a) {
            *slot -= value;
        }
    }
}

impl<R: Real, G: SeedGrid> Solver<R, G> {
    /// An empty workspace.
    pub const ZERO: Self = Self {
        laid_out: None,
        matrix: Matrix::ZERO,
        factor: Factor::ZERO,
        held: <G::Numbers<u16> as Table<u16>>::BLANK,
        rhs: <G::Numbers<R> as Table<R>>::BLANK,
        direction: <G::Numbers<R> as Table<R>>::BLANK,
        lambda: <G::Numbers<R> as Table<R>>::BLANK,
        solution: <G::Numbers<R> as Table<R>>::BLANK,
        rest: <G::Numbers<R> as Table<R>>::BLANK,
        aim: Pose::ZERO,
        start: Pose::ZERO,
        dx: Pose::ZERO,
    };

    /// The matrix of the last Newton step.
    pub fn matrix(&self) -> &Matrix<R, G> {
        &self.matrix
    }
    /// Its factor.
    pub fn factor(&self) -> &Factor<R, G> {
        &self.factor
    }
    /// The right-hand side of the last Newton step, by number.
    pub fn rhs(&self) -> &[R] {
        self.rhs.as_ref()
    }
    /// The last Newton direction `[dx, dλ]`, by number.
    pub fn direction(&self) -> &[R] {
        self.direction.as_ref()
    }
    /// Every slot that was found has its place in the generated sizes.
    pub fn complete(&self) -> bool {
        let with = |pair: [usize; 2], curved: bool| {
            let [plain, all] = pair;
            if curved { all } else { plain }
        };
        self.laid_out.is_some_and(|curved| {
            self.matrix.entries() == with(G::ENTRIES, curved)
                && self.factor.entries() == with(G::FILL, curved)
        })
    }

    /// Moves the pose by one implicit step; `velocity` is that of the last one.
    ///
    /// # Cost
    ///
    /// [`SeedSettings::newton`] factorisations, at most 20 merit evaluations each.
    ///
    /// # Hard case
    ///
    /// Where no trial improves the merit, or a number is not finite, the pose stays and the report says so.
    pub fn step(
        &mut self,
        model: &Model<'_, R, G>,
        settings: &SeedSettings,
        pose: &mut Pose<R, G>,
        velocity: &Pose<R, G>,
        report: &mut StepReport,
    ) {
        self.begin(model, settings, pose, velocity);
        if !self.complete() {
            report.status = report.status.worse(StepStatus::Held);
            return;
        }
        for iteration in 0..settings.newton.max(1) {
            let curved = settings.constraint_hessian && iteration > 0;
            self.solve(model, settings, pose, curved);
            report.newton_steps += 1;
            report.regularised += self.factor.regularised;
            let status = if self.direction.as_ref().iter().all(|v| v.finite()) {
                self.line_search(model, settings, pose, report)
            } else {
                StepStatus::Held
            };
            report.status = report.status.worse(status);
            if matches!(status, StepStatus::Held | StepStatus::Stalled) {
                break;
            }
        }
    }

    /// Assembles, factors and solves the first Newton step of a time step; nothing moves.
    pub fn linearise(
        &mut self,
        model: &Model<'_, R, G>,
        settings: &SeedSettings,
        pose: &Pose<R, G>,
        velocity: &Pose<R, G>,
    ) {
        self.begin(model, settings, pose, velocity);
        self.solve(model, settings, pose, false);
    }

    /// The merit of another pose in the time step last begun.
    pub fn merit(
        &self,
        model: &Model<'_, R, G>,
        settings: &SeedSettings,
        pose: &Pose<R, G>,
    ) -> Merit<R> {
        merit(model, settings.lock_spine, pose, &self.aim)
    }

    /// `x̃ = x + h e^(-ch) v`, `λ = 0`, and what is held.
    fn begin(
        &mut self,
        model: &Model<'_, R, G>,
        settings: &SeedSettings,
        pose: &Pose<R, G>,
        velocity: &Pose<R, G>,
    ) {
        self.aim.sum(pose, velocity, model.ask.h * model.ask.keep);
        self.lambda.as_mut().fill(R::zero());
        model.mark_held(settings.lock_spine, self.held.as_mut());
        if self.laid_out != Some(settings.constraint_hessian) {
            let how = How::new(settings, settings.constraint_hessian);
            let mut slots = Slots::new(&mut self.matrix);
            assemble::system(model, how, pose, pose, &[], &mut slots);
            self.factor.analyse(&self.matrix);
            self.laid_out = Some(settings.constraint_hessian);
        }
    }

    /// Assembles, factors and solves at `pose` and the present multipliers.
    fn solve(
        &mut self,
        model: &Model<'_, R, G>,
        settings: &SeedSettings,
        pose: &Pose<R, G>,
        curved: bool,
    ) {
        self.assemble(model, settings, pose, curved);
        self.factor.factor(&self.matrix);
        self.permute_rhs();
        self.solution.as_mut().copy_from_slice(self.rest.as_ref());
        self.factor.solve(self.solution.as_mut());
        for _ in 0..settings.refinements {
            self.permute_rhs();
            self.matrix.subtract_product(self.solution.as_ref(), self.rest.as_mut());
            self.factor.solve(self.rest.as_mut());
            let sums = self.solution.as_mut().iter_mut().zip(self.rest.as_ref());
            sums.for_each(|(x, &d)| *x += d);
        }
        for (at, &unknown) in G::ORDER.iter().enumerate() {
            set(self.direction.as_mut(), usize::from(unknown), get(self.solution.as_ref(), at));
        }
    }

    fn assemble(
        &mut self,
        model: &Model<'_, R, G>,
        settings: &SeedSettings,
        pose: &Pose<R, G>,
        curved: bool,
    ) {
        self.matrix.clear();
        self.rhs.as_mut().fill(R::zero());
        let held = self.held.as_ref();
        let how = How::new(settings, curved);
        let mut values = Values { matrix: &mut self.matrix, held, rhs: self.rhs.as_mut() };
        assemble::system(model, how, pose, &self.aim, self.lambda.as_ref(), &mut values);
        for (at, _) in held.iter().enumerate().filter(|&(_, &h)| h != 0) {
            let sign = if at < number::stars::<G>() { R::of(1.0) } else { R::of(-1.0) };
            self.matrix.set_diagonal(at, sign);
            set(self.rhs.as_mut(), at, R::zero());
        }
    }

    fn permute_rhs(&mut self) {
        for (to, &unknown) in self.rest.as_mut().iter_mut().zip(G::ORDER) {
            *to = get(self.rhs.as_ref(), usize::from(unknown));
        }
    }

    /// Halves the step until the merit is no worse, at most 20 times.
    fn line_search(
        &mut self,
        model: &Model<'_, R, G>,
        settings: &SeedSettings,
        pose: &mut Pose<R, G>,
        report: &mut StepReport,
    ) -> StepStatus {
        let mu = R::of(LEAST_MU).larger(R::of(MU_OVER_LAMBDA) * self.largest_multiplier());
        let before = self.merit(model, settings, pose).at(mu);
        let allowed = before + before.magnitude() * R::of(SLACK);
        self.start.clone_from(pose);
        self.dx.spread(self.direction.as_ref());
        let mut share = R::of(1.0);
        for trial in 0..TRIALS {
            pose.sum(&self.start, &self.dx, share);
            let after = self.merit(model, settings, pose).at(mu);
            if after <= allowed {
                report.cuts += trial;
                self.follow(share);
                return if trial == 0 { StepStatus::Converged } else { StepStatus::Reduced };
            }
            share *= R::of(0.5);
        }
        report.cuts += TRIALS;
        pose.clone_from(&self.start);
        if before.finite() { StepStatus::Stalled } else { StepStatus::Held }
    }

    /// The multipliers go as far as the positions.
    fn follow(&mut self, share: R) {
        let first = number::stars::<G>();
        let sums = self.lambda.as_mut().iter_mut().zip(self.direction.as_ref()).skip(first);
        sums.for_each(|(l, &d)| *l += share * d);
    }

    /// `max |λ + dλ|`.
    fn largest_multiplier(&self) -> R {
        let sums = self.lambda.as_ref().iter().zip(self.direction.as_ref());
        let sums = sums.skip(number::stars::<G>());
        sums.fold(R::zero(), |m, (&l, &d)| m.larger((l + d).magnitude()))
    }
}
