//! Newton's method on a ribbon: shift, step, line search, barrier, multipliers.
//!
//! Each iteration is one backward sweep and a trial or two, each of which is a forward sweep that answers to where it
//! leads (`descent`). A loop's multipliers move whenever its Lagrangian is nearly minimised; a loop that is still open when
//! the iterations are used up is closed by `mend`.
//!
//! Source: ours; Levenberg's shift, Fiacco and McCormick's barrier, Powell's multipliers. Checked by
//! `tests/ribbon_newton.rs`, `tests/ribbon_loops.rs`, `tests/ribbon_hard_cases.rs`.

use super::body::{Body, Energy};
use super::contact::touch::Touch;
use super::load::{Ask, Loads};
use super::report::{Report, Settings, Status};
use crate::real::{Num, Real};
use descent::Direction;

mod descent;

/// A shift below this share of the stiffness is none.
const LEAST_SHIFT: f64 = 1e-8;
/// A shift above this is hopeless.
const MOST_SHIFT: f64 = 1e12;
/// The shift that a solve begins with.
const FIRST_SHIFT: f64 = 1.0;
/// What a shift grows by.
const GROWTH: f64 = 3.0;
/// First barrier parameter, in units of the crease stiffness.
const FIRST_BARRIER: f64 = 1e-5;
/// First penalty of a turn at a loop's joint, in units of the whole strip's stiffness.
const FIRST_PENALTY: f64 = 3e4;
/// Largest penalty there, in units of a crease's stiffness.
const MOST_PENALTY: f64 = 1e5;
/// The same in `f32`, where a stiffer joint drowns the merit.
const MOST_PENALTY_SINGLE: f64 = 1e2;
/// A loop never opens wider than this on the way, unless it is: radians, or share of its length.
const WIDEST: f64 = 0.05;

/// The method; a solve does not depend on the one before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solver<R> {
    /// Shift, in units of twice the stiffness.
    pub shift: R,
}

/// One solve under way.
struct Run<'a, R: Real, L, T, const N: usize> {
    solver: &'a mut Solver<R>,
    body: &'a mut Body<R, N>,
    ask: &'a Ask<R>,
    loads: &'a L,
    touch: &'a mut T,
    settings: &'a Settings,
    report: Report<R>,
    energy: Energy<R>,
    /// The last barrier parameter.
    floor: R,
    /// The loop's gap at the start, now, and when the multipliers moved last.
    opened: R,
    joined: R,
    moved: R,
    /// The shift that sufficed when last one was needed.
    sufficed: R,
}

impl<R: Real> Solver<R> {
    /// Before its first solve.
    pub const NEW: Self = Self { shift: R::ZERO };

    /// Minimises from where the body stands; it is left at the best point, evaluated and kept. `watch` sees the objective and the loop's gap
    /// before every iteration and at the end.
    ///
    /// # Cost
    ///
    /// At most [`Settings::iterations`] iterations, and forty cheaper ones where a loop has to be closed: a handful, but
    /// where contact or many rulings at their bounds are in the way.
    ///
    /// # Errors
    ///
    /// None: how it ended is in the report.
    pub fn minimise<const N: usize>(
        &mut self,
        body: &mut Body<R, N>,
        ask: &Ask<R>,
        loads: &impl Loads<R>,
        touch: &mut impl Touch<R>,
        settings: &Settings,
        mut watch: impl FnMut(R, R),
    ) -> Report<R> {
        let mut run = Run::begin(self, body, ask, loads, touch, settings);
        if !run.energy.objective.finite() {
            run.report.status = Status::Held;
            return run.report;
        }
        for _ in 0..settings.iterations {
            watch(run.energy.objective, run.joined);
            if let Some(status) = run.iterate() {
                run.report.status = status;
                break;
            }
        }
        let open = run.body.looped() && run.joined > R::of(settings.closure);
        if open && run.report.status != Status::Held {
            run.close();
        }
        watch(run.energy.objective, run.joined);
        (run.report.objective, run.report.gap) = (run.energy.objective, run.joined);
        run.report
    }

    fn shrink(&mut self, factor: f64) {
        self.shift *= R::of(factor);
        if self.shift < R::of(LEAST_SHIFT) {
            self.shift = R::ZERO;
        }
    }

    fn grow(&mut self) {
        self.shift = (self.shift * R::of(GROWTH)).larger(R::of(1e-3));
    }
}

impl<'a, R: Real, L: Loads<R>, T: Touch<R>, const N: usize> Run<'a, R, L, T, N> {
    fn begin(
        solver: &'a mut Solver<R>,
        body: &'a mut Body<R, N>,
        ask: &'a Ask<R>,
        loads: &'a L,
        touch: &'a mut T,
        settings: &'a Settings,
    ) -> Self {
        solver.shift = R::of(FIRST_SHIFT);
        let floor = body.strip.stiff * R::of(settings.barrier);
        if body.part_rulings() {
            body.stand();
        }
        start_barrier(body, floor);
        body.soften(R::of(FIRST_PENALTY));
        body.hold.forget(body.strip.stiff * R::of(MOST_PENALTY), body.strip.length());
        let mut energy = body.weigh(ask, loads);
        body.mark();
        energy.objective += touch.energy(&body.pose());
        let gap = body.gap.size(body.strip.length());
        let report = Report { status: Status::Capped, trials: 1, ..Report::NONE };
        let moved = R::of(1e3);
        Self {
            solver,
            body,
            ask,
            loads,
            touch,
            settings,
            report,
            energy,
            floor,
            opened: gap,
            joined: gap,
            moved,
            sufficed: R::ZERO,
        }
    }

    /// One iteration; answers how the solve ended, if it did.
    fn iterate(&mut self) -> Option<Status> {
        let Some((to, found)) = self.descend() else { return Some(Status::Stalled) };
        self.report.iterations += 1;
        (self.report.fall, self.report.size) = (to.fall, to.size);
        if !(to.size.finite() && to.fall.finite()) {
            return Some(Status::Held);
        }
        match found {
            Some((energy, share)) => self.take(&to, energy, share),
            None => self.refuse(&to),
        }
    }

    /// The merit of what is placed.
    fn weigh(&mut self) -> Energy<R> {
        self.report.trials += 1;
        let mut energy = self.body.weigh(self.ask, self.loads);
        energy.objective += self.touch.energy(&self.body.pose());
        energy
    }

    /// Back to what was accepted last.
    fn back(&mut self) -> Energy<R> {
        self.body.stand();
        self.weigh()
    }

    /// Takes a trial.
    fn take(&mut self, to: &Direction<R>, energy: Energy<R>, share: R) -> Option<Status> {
        let fell = self.energy.total(self.body.mu) - energy.total(self.body.mu);
        let won = fell / to.foretold(share);
        self.body.accept();
        self.energy = energy;
        if share < to.longest * R::of(0.3) || (!to.held && won < R::of(0.1)) {
            self.solver.grow();
        } else if share >= to.longest && won > R::of(if to.held { 0.1 } else { 0.5 }) {
            let well = if self.settings.thorough { 0.03 } else { 0.1 };
            self.solver.shrink(if won > R::of(0.8) { well } else { 0.25 });
        }
        self.joined = self.body.gap.size(self.body.strip.length());
        let small = to.size <= R::of(self.settings.tolerance) && share >= R::one();
        let least = energy.objective.magnitude() * R::of(8.0 * R::EPSILON);
        if (small || to.fall <= least) && self.closed() && self.body.mu <= self.floor {
            return Some(Status::Converged);
        }
        if share > R::of(0.5)
            && to.fall * share < self.body.mu * R::of(30.0 * self.body.strip.n as f64)
        {
            self.relax();
        }
        if self.body.looped() {
            self.hold(to.fall);
        }
        None
    }

    /// No share of the step lowers the merit: more shift, or a tighter problem, or the end.
    fn refuse(&mut self, to: &Direction<R>) -> Option<Status> {
        let rounding = self.energy.total(self.body.mu).magnitude() * R::of(8.0 * R::EPSILON);
        self.energy = self.back();
        if self.solver.shift < R::of(MOST_SHIFT) && to.fall > rounding {
            self.solver.grow();
            return None;
        }
        let last = self.body.mu <= self.floor;
        if last {
            return Some(if self.closed() { Status::Converged } else { Status::Stalled });
        }
        self.relax();
        if self.body.looped() {
            self.tighten();
        }
        None
    }

    fn closed(&self) -> bool {
        !self.body.looped() || self.joined <= R::of(self.settings.closure)
    }

    /// Lowers the barrier; slowly where a loop has to be kept closed meanwhile.
    fn relax(&mut self) {
        let share = if self.body.looped() { 0.1 } else { 0.01 };
        self.body.mu = (self.body.mu * R::of(share)).larger(self.floor);
    }

    /// Looks after a loop: stiffens what opens, moves the multipliers when the Lagrangian is nearly minimised.
    fn hold(&mut self, fall: R) {
        if self.joined > (self.opened * R::of(2.0)).larger(R::of(0.1 * WIDEST)) {
            self.stiffen();
        }
        let (hold, gap) = (&self.body.hold, &self.body.gap);
        let cost = hold.turn * gap.turn.norm_sq() + hold.shift * gap.shift.norm_sq();
        let rounding = self.energy.total(self.body.mu).magnitude() * R::of(16.0 * R::EPSILON);
        if fall < cost * R::of(0.1) || fall < rounding {
            self.tighten();
        }
        self.energy.joint = self.body.hold.energy(&self.body.gap);
    }

    /// Moves the multipliers, and where the gap did not shrink well, raises the penalties.
    fn tighten(&mut self) {
        self.body.hold.update(&self.body.gap);
        if self.joined > self.moved * R::of(0.1) {
            self.stiffen();
        }
        self.moved = self.joined;
        self.energy.joint = self.body.hold.energy(&self.body.gap);
    }

    fn stiffen(&mut self) {
        let single = size_of::<R>() == size_of::<f32>();
        let most = if single { MOST_PENALTY_SINGLE } else { MOST_PENALTY };
        let most = self.body.strip.stiff * R::of(most);
        let hold = &mut self.body.hold;
        if hold.turn >= most {
            return;
        }
        (hold.turn, hold.shift) = (hold.turn * R::of(10.0), hold.shift * R::of(10.0));
    }

    /// Closes a loop that is still open when the iterations are used up, or says that something is in the way.
    fn close(&mut self) {
        self.body.close(self.touch, self.settings, &mut self.report);
        self.energy = self.back();
        self.joined = self.body.gap.size(self.body.strip.length());
        // Nothing is closed better than to rounding.
        let least = self.settings.closure.larger(64.0 * R::EPSILON);
        if self.joined > R::of(least) {
            self.report.status = Status::Open;
        }
    }
}

/// The first barrier parameter, and duals that fit it.
fn start_barrier<R: Real, const N: usize>(body: &mut Body<R, N>, floor: R) {
    body.mu = (body.strip.stiff * R::of(FIRST_BARRIER)).larger(floor);
    let (mu, limit) = (body.mu, body.strip.limit);
    let mut stages = body.used_mut().iter_mut().peekable();
    while let Some(s) = stages.next() {
        let far = stages.peek().map_or(R::ZERO, |n| n.kept.c);
        let u = (far - s.kept.c) / limit;
        s.dual = [mu / (R::one() - u), mu / (R::one() + u)];
    }
}
