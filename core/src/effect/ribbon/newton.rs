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
/// A shift above this is hopeless.
const MOST_SHIFT: f64 = 1e12;

/// What is carried from one solve to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solver<R> {
    /// Shift, in units of twice the stiffness.
    pub shift: R,
}

impl<R: Real> Solver<R> {
    /// Without memory.
    pub const NEW: Self = Self { shift: R::ZERO };

    /// Minimises; the body is left at the best point, evaluated and kept. `watch` sees each iteration's energy.
    pub fn minimise<const N: usize>(
        &mut self,
        body: &mut Body<R, N>,
        ask: &Ask<R>,
        loads: &impl Loads<R>,
        settings: &Settings,
        mut watch: impl FnMut(&Energy<R>, [R; 4]),
    ) -> Report<R> {
        let mut report = Report { status: Status::Capped, ..Report::NONE };
        let floor = body.strip.stiff * R::of(settings.barrier);
        start_barrier(body, floor);
        body.place(R::ZERO);
        let mut energy = body.evaluate(ask, loads);
        report.trials += 1;
        let mut joined = body.gap.size(body.strip.length());
        for _ in 0..settings.iterations {
            watch(&energy, [joined, body.mu, self.shift, report.size]);
            let Some(fall) = self.factor(body, ask, loads, settings, &mut report) else {
                report.status = Status::Stalled;
                break;
            };
            let [size, share] = body.solve();
            (report.fall, report.size) = (fall, size);
            if !(size.finite() && fall.finite()) {
                report.status = Status::Held;
                break;
            }
            report.iterations += 1;
            let Some((next, share)) =
                search(body, ask, loads, settings, energy, [fall, share], &mut report)
            else {
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
                    body.hold.update(&body.gap);
                    energy.joint = body.hold.energy(&body.gap);
                }
                report.status = Status::Capped;
                continue;
            };
            let won = (energy.total(body.mu) - next.total(body.mu))
                / (fall * share * (R::one() - share * R::of(0.5)));
            accept(body);
            energy = next;
            if won > R::of(0.5) && share > R::of(0.5) {
                self.shift = self.shift * R::of(0.25);
                if self.shift < R::of(LEAST_SHIFT) {
                    self.shift = R::ZERO;
                }
            } else if won < R::of(0.1) || share < R::of(0.1) {
                self.grow();
            }
            joined = body.gap.size(body.strip.length());
            let small = size <= R::of(settings.tolerance) && share >= R::one();
            let closed = !body.looped() || joined <= R::of(settings.closure);
            if small && closed && body.mu <= floor {
                report.status = Status::Converged;
                break;
            }
            lower(body, floor, fall * share);
            if body.looped() {
                body.hold.update(&body.gap);
                energy.joint = body.hold.energy(&body.gap);
            }
        }
        watch(&energy, [joined, body.mu, self.shift, report.size]);
        (report.objective, report.gap) = (energy.objective, joined);
        report
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
            if let Some(fall) = body.factor(ask, loads, self.shift) {
                return Some(fall);
            }
            self.grow();
        }
        None
    }
}

/// Duals that fit the barrier parameter where none were kept.
fn start_barrier<R: Real, const N: usize>(body: &mut Body<R, N>, floor: R) {
    body.mu = (body.strip.stiff * R::of(1e-5)).larger(floor);
    let (mu, limit) = (body.mu, body.strip.limit);
    let mut stages = body.used_mut().iter_mut().peekable();
    while let Some(s) = stages.next() {
        let far = stages.peek().map_or(R::ZERO, |n| n.kept.c);
        let u = (far - s.kept.c) / limit;
        s.dual = [mu / (R::one() - u), mu / (R::one() + u)];
    }
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
    [fall, longest]: [R; 2],
    report: &mut Report<R>,
) -> Option<(Energy<R>, R)> {
    let before = energy.total(body.mu);
    let slack = before.magnitude() * R::of(8.0 * R::EPSILON);
    let mut share = longest;
    for _ in 0..settings.trials {
        body.place(share);
        let trial = body.evaluate(ask, loads);
        report.trials += 1;
        if trial.total(body.mu) <= before - fall * share * R::of(ARMIJO) + slack {
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
