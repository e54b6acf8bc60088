//! Newton's method on a ribbon: shift, step, line search, barrier, multipliers.
//!
//! Each iteration is one backward and one forward sweep and a trial or two. Where the model has no minimum, or no
//! share of its step lowers the merit, a shift of both creases' unknowns grows; it is kept from step to step.

use super::barrier::duals;
use super::body::{Body, Energy};
use super::load::{Ask, Loads};
use super::report::{Report, Settings, Status};
use crate::real::Real;

/// Share of the predicted fall that a trial must reach.
const ARMIJO: f64 = 1e-4;
/// A shift below this share of the stiffness is none.
const LEAST_SHIFT: f64 = 1e-8;
/// Largest penalty of a turn at a loop's joint, in units of the crease stiffness.
const MOST_PENALTY: f64 = 1e5;
/// Steps at most that close a loop at the end.
const CLOSINGS: u32 = 12;
/// A loop never opens wider than this on the way, unless it is: radians, or share of its length.
const WIDEST: f64 = 0.05;
/// A shift above this is hopeless.
const MOST_SHIFT: f64 = 1e12;

/// What is carried from one solve to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solver<R> {
    /// Shift, in units of twice the stiffness.
    pub shift: R,
    /// What the first iteration of the last solve needed.
    pub first: R,
}

impl<R: Real> Solver<R> {
    /// Without memory.
    pub const NEW: Self = Self { shift: R::ZERO, first: R::ZERO };

    /// Minimises; the body is left at the best point, evaluated and kept. `watch` sees each iteration's energy.
    pub fn minimise<const N: usize>(
        &mut self,
        body: &mut Body<R, N>,
        ask: &Ask<R>,
        loads: &impl Loads<R>,
        settings: &Settings,
        mut watch: impl FnMut(&Energy<R>, [R; 7]),
    ) -> Report<R> {
        let mut report = Report { status: Status::Capped, ..Report::NONE };
        self.shift = self.first;
        self.shrink(0.25);
        let floor = body.strip.stiff * R::of(settings.barrier);
        body.part_rulings();
        start_barrier(body, floor, settings.tune[3]);
        body.soften(R::of(settings.tune[1]));
        body.place(R::ZERO);
        let mut energy = body.evaluate(ask, loads);
        report.trials += 1;
        let mut joined = body.gap.size(body.strip.length());
        let opened = joined;
        let mut last_gap = R::of(1e3);
        let mut dbg = [R::ZERO; 3];
        for _ in 0..settings.iterations {
            watch(&energy, [joined, body.mu, self.shift, report.size, dbg[0], dbg[1], dbg[2]]);
            let Some(fall) = self.factor(body, ask, loads, settings, &mut report) else {
                report.status = Status::Stalled;
                break;
            };
            let ([size, share], held) = body.solve(true);
            let longest = share;
            (report.fall, report.size) = (fall, size);
            if !(size.finite() && fall.finite()) {
                report.status = Status::Held;
                break;
            }
            report.iterations += 1;
            if report.iterations == 1 {
                self.first = self.shift;
            }
            let mut found =
                search(body, ask, loads, settings, energy, [fall, share, opened], &mut report);
            let mut longest = longest;
            if held > 0 && found.is_none_or(|(_, s)| s < R::of(0.1)) {
                let ([_, share], _) = body.solve(false);
                longest = share;
                found =
                    search(body, ask, loads, settings, energy, [fall, share, opened], &mut report);
            }
            let Some((next, share)) = found else {
                if self.shift < R::of(MOST_SHIFT)
                    && fall > energy.total(body.mu).magnitude() * R::of(8.0 * R::EPSILON)
                {
                    self.grow();
                    body.place(R::ZERO);
                    energy = body.evaluate(ask, loads);
                    continue;
                }
                body.place(R::ZERO);
                energy = body.evaluate(ask, loads);
                let done = body.mu <= floor && joined <= R::of(settings.closure);
                report.status = if done { Status::Converged } else { Status::Stalled };
                if done || !relax(body, floor) {
                    break;
                }
                if body.looped() {
                    last_gap = tighten(body, joined, last_gap);
                    energy.joint = body.hold.energy(&body.gap);
                }
                report.status = Status::Capped;
                continue;
            };
            let won = (energy.total(body.mu) - next.total(body.mu))
                / (fall * share * (R::one() - share * R::of(0.5)));
            dbg = [longest, share, won];
            accept(body);
            energy = next;
            if share < longest * R::of(0.3) || (held == 0 && won < R::of(0.1)) {
                self.grow();
            } else if share >= longest && (held > 0 || won > R::of(0.5)) {
                self.shrink(if won > R::of(0.8) { settings.tune[4] } else { 0.25 });
            }
            joined = body.gap.size(body.strip.length());
            let small = size <= R::of(settings.tolerance) && share >= R::one();
            let closed = !body.looped() || joined <= R::of(settings.closure);
            if small && closed && body.mu <= floor {
                report.status = Status::Converged;
                break;
            }
            if share > R::of(0.5) {
                lower(body, floor, fall * share);
            }
            if body.looped() && joined > (opened * R::of(2.0)).larger(R::of(0.1 * WIDEST)) {
                stiffen(body);
                energy.joint = body.hold.energy(&body.gap);
            }
            if body.looped() && nearly(fall, body, &energy) {
                last_gap = tighten(body, joined, last_gap);
                energy.joint = body.hold.energy(&body.gap);
            }
        }
        if body.looped() && joined > R::of(settings.closure) && report.status != Status::Held {
            (energy, joined) = close(body, ask, loads, settings, &mut report);
        }
        watch(&energy, [joined, body.mu, self.shift, report.size, dbg[0], dbg[1], dbg[2]]);
        (report.objective, report.gap) = (energy.objective, joined);
        report
    }

    fn shrink(&mut self, factor: f64) {
        self.shift = self.shift * R::of(factor);
        if self.shift < R::of(LEAST_SHIFT) {
            self.shift = R::ZERO;
        }
    }

    fn grow(&mut self) {
        self.shift = (self.shift * R::of(8.0)).larger(R::of(1e-3));
    }

    fn factor<const N: usize>(
        &mut self,
        body: &mut Body<R, N>,
        ask: &Ask<R>,
        loads: &impl Loads<R>,
        settings: &Settings,
        report: &mut Report<R>,
    ) -> Option<R> {
        for _ in 0..settings.shifts {
            report.factorisations += 1;
            if let Some(fall) =
                body.factor(ask, loads, [self.shift * R::of(settings.tune[0]), self.shift])
            {
                return Some(fall);
            }
            self.grow();
        }
        None
    }
}

/// Duals that fit the barrier parameter where none were kept.
fn start_barrier<R: Real, const N: usize>(body: &mut Body<R, N>, floor: R, start: f64) {
    body.mu = (body.strip.stiff * R::of(start)).larger(floor);
    let (mu, limit) = (body.mu, body.strip.limit);
    let mut stages = body.used_mut().iter_mut().peekable();
    while let Some(s) = stages.next() {
        let far = stages.peek().map_or(R::ZERO, |n| n.kept.c);
        let u = (far - s.kept.c) / limit;
        s.dual = [mu / (R::one() - u), mu / (R::one() + u)];
    }
}

/// Whether the loop's Lagrangian is nearly minimised, against what its gap costs.
fn nearly<R: Real, const N: usize>(fall: R, body: &Body<R, N>, energy: &Energy<R>) -> bool {
    let hold = &body.hold;
    let cost = hold.turn * body.gap.turn.norm_sq() + hold.shift * body.gap.shift.norm_sq();
    fall < cost * R::of(0.1) || fall < energy.total(body.mu).magnitude() * R::of(16.0 * R::EPSILON)
}

/// Moves the multipliers, and where the gap did not shrink well, raises the penalties.
fn tighten<R: Real, const N: usize>(body: &mut Body<R, N>, gap: R, before: R) -> R {
    body.hold.update(&body.gap);
    let most = body.strip.stiff * R::of(MOST_PENALTY);
    if gap > before * R::of(0.1) && body.hold.turn < most {
        stiffen(body);
    }
    gap
}

fn stiffen<R: Real, const N: usize>(body: &mut Body<R, N>) {
    body.hold.turn = body.hold.turn * R::of(10.0);
    body.hold.shift = body.hold.shift * R::of(10.0);
}

/// Closes a loop that is still open when the iterations are used up.
fn close<R: Real, const N: usize>(
    body: &mut Body<R, N>,
    ask: &Ask<R>,
    loads: &impl Loads<R>,
    settings: &Settings,
    report: &mut Report<R>,
) -> (Energy<R>, R) {
    let length = body.strip.length();
    body.place(R::ZERO);
    body.reconstruct();
    let mut joined = body.gap.size(length);
    for _ in 0..CLOSINGS {
        report.factorisations += 1;
        if joined <= R::of(settings.closure) || body.factor_joint().is_none() {
            break;
        }
        report.iterations += 1;
        let _ = body.solve(true);
        let mut share = R::one();
        for _ in 0..settings.trials {
            body.place(share);
            body.reconstruct();
            let gap = body.gap.size(length);
            if gap < joined * R::of(0.9) && body.inside() {
                joined = gap;
                accept(body);
                break;
            }
            share = share * R::of(0.5);
        }
    }
    body.place(R::ZERO);
    (body.evaluate(ask, loads), joined)
}

/// Lowers the barrier once its problem is nearly solved.
fn lower<R: Real, const N: usize>(body: &mut Body<R, N>, floor: R, fall: R) {
    if fall < body.mu * R::of(30.0 * body.strip.n as f64) {
        relax(body, floor);
    }
}

fn relax<R: Real, const N: usize>(body: &mut Body<R, N>, floor: R) -> bool {
    let more = body.mu > floor;
    body.mu = (body.mu * R::of(0.1)).larger(floor);
    more
}

/// Halves the share until the merit falls.
fn search<R: Real, const N: usize>(
    body: &mut Body<R, N>,
    ask: &Ask<R>,
    loads: &impl Loads<R>,
    settings: &Settings,
    energy: Energy<R>,
    [fall, longest, opened]: [R; 3],
    report: &mut Report<R>,
) -> Option<(Energy<R>, R)> {
    let length = body.strip.length();
    let widest = opened.larger(R::of(WIDEST));
    let before = energy.total(body.mu);
    let slack = before.magnitude() * R::of(8.0 * R::EPSILON);
    let mut share = longest;
    for _ in 0..settings.trials {
        body.place(share);
        let trial = body.evaluate(ask, loads);
        report.trials += 1;
        let open = body.gap.size(length) > widest;
        if !open && trial.total(body.mu) <= before - fall * share * R::of(ARMIJO) + slack {
            return Some((trial, share));
        }
        share = share * R::of(0.5);
    }
    None
}

/// Duals follow, then the point is kept.
fn accept<R: Real, const N: usize>(body: &mut Body<R, N>) {
    let (mu, limit) = (body.mu, body.strip.limit);
    let mut stages = body.used_mut().iter_mut().peekable();
    while let Some(s) = stages.next() {
        let (kept, crease) = stages.peek().map_or((R::ZERO, R::ZERO), |n| (n.kept.c, n.crease.c));
        s.dual = duals(s.dual, kept - s.kept.c, crease - s.crease.c, limit, mu);
    }
    body.keep();
}
