//! Newton's method on a ribbon: shift, step, line search, barrier, multipliers.
//!
//! Each iteration is one backward sweep and a trial or two, each of which is a forward sweep that answers to where it
//! leads. The first iterations of a step in time leave out what forces gain by turning: those forces are still inertia's
//! against the whole way. Where the model has no minimum, or no share of its step lowers the merit, a shift of both
//! creases' unknowns grows. Rulings at their bounds are held there on the way, and only where that does not help is the
//! whole step shortened for them. A loop's multipliers move whenever its Lagrangian is nearly minimised; a loop that is
//! still open when the iterations are used up is closed by `mend`.
//!
//! Source: ours; Levenberg's shift, Fiacco and McCormick's barrier, Powell's multipliers. Checked by
//! `tests/ribbon_newton.rs`, `tests/ribbon_loops.rs`, `tests/ribbon_hard_cases.rs`.

use super::barrier::duals;
use super::body::{Body, Energy};
use super::contact::touch::Touch;
use super::load::{Ask, Loads};
use super::report::{Report, Settings, Status};
use crate::real::{Num, Real};

/// Share of the predicted fall that a trial must reach.
const ARMIJO: f64 = 1e-4;
/// A shift below this share of the stiffness is none.
const LEAST_SHIFT: f64 = 1e-8;
/// A shift above this is hopeless.
const MOST_SHIFT: f64 = 1e12;
/// Iterations at the start of a step in time whose model is Gauss and Newton's.
const ROUGH: u32 = 2;
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
/// A loop never opens wider than this on the way, unless it is: radians, or share of its length.
const WIDEST: f64 = 0.05;
/// A trial that meets something is not shortened by more than this at once.
const LEAST_FREE: f64 = 0.02;
/// Share of the way searched by contact that iterations may go; the rest is for closing.
const RANGE: f64 = 0.75;

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
}

/// A direction from the sweeps.
#[derive(Clone, Copy)]
struct Direction<R> {
    fall: R,
    /// The largest change of a crease, were the whole step taken.
    size: R,
    /// The share to try first.
    longest: R,
    /// Slopes may be held at their bounds; and some were.
    hold: bool,
    held: bool,
}

impl<R: Real> Solver<R> {
    /// Before its first solve.
    pub const NEW: Self = Self { shift: R::ZERO };

    /// Minimises; the body is left at the best point, evaluated and kept. `watch` sees the objective and the loop's gap
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
        body.part_rulings();
        start_barrier(body, floor);
        body.soften(R::of(FIRST_PENALTY));
        body.hold.forget(body.strip.stiff * R::of(MOST_PENALTY), body.strip.length());
        body.place(R::ZERO);
        let mut energy = body.evaluate(ask, loads);
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
        }
    }

    /// One iteration; answers how the solve ended, if it did.
    fn iterate(&mut self) -> Option<Status> {
        let Some(mut to) = self.direction() else { return Some(Status::Stalled) };
        self.report.iterations += 1;
        let mut found = self.search(&mut to);
        if to.held && found.is_none_or(|(_, share)| share < R::of(0.1)) {
            (to.longest, to.hold, to.held) = (self.body.solve(false).0[1], false, false);
            found = self.search(&mut to);
        }
        (self.report.fall, self.report.size) = (to.fall, to.size);
        if !(to.size.finite() && to.fall.finite()) {
            return Some(Status::Held);
        }
        match found {
            Some((energy, share)) => self.take(&to, energy, share),
            None => self.refuse(&to),
        }
    }

    /// Factors, with as much shift as that needs.
    fn direction(&mut self) -> Option<Direction<R>> {
        self.touch.press(&self.body.pose());
        self.body.rough = self.report.iterations < ROUGH && self.body.motion.kappa > R::ZERO;
        for _ in 0..self.settings.shifts {
            self.report.factorisations += 1;
            let shift = self.solver.shift;
            if let Some(fall) = self.body.factor_touching(self.ask, self.loads, self.touch, shift) {
                let (size, longest) = (R::ZERO, R::one());
                return Some(Direction { fall, size, longest, hold: true, held: false });
            }
            self.solver.grow();
        }
        None
    }

    /// Halves the share until the merit falls.
    fn search(&mut self, to: &mut Direction<R>) -> Option<(Energy<R>, R)> {
        let (length, widest) = (self.body.strip.length(), self.opened.larger(R::of(WIDEST)));
        let before = self.energy.total(self.body.mu);
        let slack = before.magnitude() * R::of(8.0 * R::EPSILON);
        let mut share = to.longest;
        for trial in 0..self.settings.trials {
            let rolled = self.body.roll(share, to.hold);
            if trial == 0 {
                (to.size, to.held) = (rolled.size / share, rolled.held > 0);
            }
            let free = self.touch.free(&self.body.pose(), R::of(RANGE));
            if free < R::one() {
                share *= free.larger(R::of(LEAST_FREE));
                continue;
            }
            let trial = self.weigh();
            let closed = !self.body.looped() || self.body.gap.size(length) <= widest;
            let enough = before - to.fall * share * R::of(ARMIJO) + slack;
            if closed && trial.total(self.body.mu) <= enough {
                return Some((trial, share));
            }
            share *= R::of(0.5);
        }
        None
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
        self.body.place(R::ZERO);
        self.body.reconstruct();
        self.weigh()
    }

    /// Takes a trial.
    fn take(&mut self, to: &Direction<R>, energy: Energy<R>, share: R) -> Option<Status> {
        let fell = self.energy.total(self.body.mu) - energy.total(self.body.mu);
        let won = fell / (to.fall * share * (R::one() - share * R::of(0.5)));
        accept(self.body);
        self.energy = energy;
        if share < to.longest * R::of(0.3) || (!to.held && won < R::of(0.1)) {
            self.solver.grow();
        } else if share >= to.longest && (to.held || won > R::of(0.5)) {
            self.solver.shrink(if won > R::of(0.8) { 0.1 } else { 0.25 });
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

    /// Lowers the barrier.
    fn relax(&mut self) {
        self.body.mu = (self.body.mu * R::of(0.1)).larger(self.floor);
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
        let most = self.body.strip.stiff * R::of(MOST_PENALTY);
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

/// Duals follow, then the point is kept.
pub(super) fn accept<R: Real, const N: usize>(body: &mut Body<R, N>) {
    let (mu, limit) = (body.mu, body.strip.limit);
    let mut stages = body.used_mut().iter_mut().peekable();
    while let Some(s) = stages.next() {
        let (kept, crease) = stages.peek().map_or((R::ZERO, R::ZERO), |n| (n.kept.c, n.crease.c));
        s.dual = duals(s.dual, kept - s.kept.c, crease - s.crease.c, limit, mu);
    }
    body.keep();
}
