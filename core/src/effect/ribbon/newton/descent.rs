//! Which way down: the model an iteration follows, and how far.
//!
//! The first iteration of a step in time leaves out what forces gain by turning: those forces are still inertia's against
//! the whole way. After it the model is exact. Where that has no minimum a shift of both creases' unknowns grows until it
//! has. There are other ways to give it one: to leave out a share of what forces gain by turning, or all of it. None is
//! best everywhere, so a thorough solve follows each and takes the lowest merit. Rulings at their bounds are held there on
//! the way, and only where that does not help is the whole step shortened for them.
//!
//! Source: ours; Levenberg's shift, Gauss and Newton's model, and what lies between. Checked by `tests/ribbon_newton.rs`.

use super::super::body::Energy;
use super::super::contact::touch::Touch;
use super::super::frame::Six;
use super::super::load::Loads;
use super::{GROWTH, Run, WIDEST};
use crate::real::Real;

/// Share of the predicted fall that a trial must reach.
const ARMIJO: f64 = 1e-4;
/// Below this share of the predicted fall, half the step is tried too.
const POOR: f64 = 0.5;
/// A trial that meets something is not shortened by more than this at once.
const LEAST_FREE: f64 = 0.02;
/// Share of the way searched by contact that iterations may go; the rest is for closing.
const RANGE: f64 = 0.75;
/// Halvings between the exact model and the rough one.
const BETWEEN: u32 = 2;
/// Shifts of the rough model, as multiples of the last.
const SHIFTS: [f64; 2] = [1.0, 30.0];
/// Where the next search for a shift begins, as a share of the one that sufficed.
const AGAIN: f64 = 0.1;

/// A direction from the sweeps.
#[derive(Clone, Copy)]
pub(super) struct Direction<R> {
    pub(super) fall: R,
    /// The largest change of a crease, were the whole step taken.
    pub(super) size: R,
    /// The share to try first.
    pub(super) longest: R,
    /// Slopes may be held at their bounds; and some were.
    hold: bool,
    pub(super) held: bool,
}

impl<R: Real> Direction<R> {
    fn of(fall: R) -> Self {
        Self { fall, size: R::ZERO, longest: R::one(), hold: true, held: false }
    }
    /// The fall that the model foretells for a share of the step.
    pub(super) fn foretold(&self, share: R) -> R {
        self.fall * share * (R::one() - share * R::of(0.5))
    }
}

/// What a share of the step leads to, if it lowers the merit: the energy there, and the share.
type Found<R> = Option<(Energy<R>, R)>;

/// What makes a model that has a minimum.
#[derive(Clone, Copy)]
struct Model<R> {
    /// Share of what forces gain by turning that it leaves out.
    rough: R,
    shift: R,
}

/// A trial that lowers the merit.
#[derive(Clone, Copy)]
struct Bid<R> {
    model: Model<R>,
    to: Direction<R>,
    share: R,
    energy: Energy<R>,
    /// The start's part of the step.
    base_step: Six<R>,
}

/// The best of several bids.
struct Auction<R> {
    best: Option<Bid<R>>,
    /// The best is what is placed.
    placed: bool,
    /// What is placed is not what was accepted last.
    away: bool,
}

impl<R: Real, L: Loads<R>, T: Touch<R>, const N: usize> Run<'_, R, L, T, N> {
    /// The direction, and what was found along it: the merit there and the share. Nothing where no shift suffices.
    pub(super) fn descend(&mut self) -> Option<(Direction<R>, Found<R>)> {
        self.touch.press(&self.body.pose());
        let first = self.report.iterations == 0 && self.body.motion.kappa > R::ZERO;
        self.body.rough = if first { R::one() } else { R::ZERO };
        let mut fall = self.factor(self.solver.shift);
        if self.settings.thorough && fall.is_none() && !first {
            if let Some(bid) = self.best() {
                self.solver.shift = bid.model.shift;
                return Some((bid.to, Some((bid.energy, bid.share))));
            }
            self.body.rough = R::ZERO;
        }
        for _ in 0..self.settings.shifts {
            if fall.is_some() {
                break;
            }
            self.solver.grow();
            fall = self.factor(self.solver.shift);
        }
        let mut to = Direction::of(fall?);
        let mut found = self.search(&mut to);
        if to.held && found.is_none_or(|(_, share)| share < R::of(0.1)) {
            (to.longest, to.hold, to.held) = (self.body.solve(false).0[1], false, false);
            found = self.search(&mut to);
        }
        Some((to, found))
    }

    fn factor(&mut self, shift: R) -> Option<R> {
        self.report.factorisations += 1;
        self.body.factor_touching(self.ask, self.loads, self.touch, shift)
    }

    /// Whether a loop is no further open than it may be on the way.
    fn joined(&self) -> bool {
        let widest = self.opened.larger(R::of(WIDEST));
        !self.body.looped() || self.body.gap.size(self.body.strip.length()) <= widest
    }

    /// Halves the share until the merit falls.
    fn search(&mut self, to: &mut Direction<R>) -> Found<R> {
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
            let enough = before - to.fall * share * R::of(ARMIJO) + slack;
            if self.joined() && trial.total(self.body.mu) <= enough {
                return Some((trial, share));
            }
            share *= R::of(0.5);
        }
        None
    }

    /// Where the exact model has no minimum under the last shift: the lowest merit that other models lead to, placed; or
    /// nothing, and everything as it was.
    ///
    /// # Cost
    ///
    /// Five factorisations and as many trials or a few more, and those that look for the shift.
    fn best(&mut self) -> Option<Bid<R>> {
        let mut sale = Auction { best: None, placed: true, away: false };
        let (shift, one) = (self.solver.shift, R::one());
        self.shifted(&mut sale);
        let (mut low, mut high) = (R::ZERO, one);
        for _ in 0..BETWEEN {
            let rough = (low + high) * R::of(0.5);
            let bound = self.follow(&mut sale, Model { rough, shift });
            *if bound { &mut high } else { &mut low } = rough;
        }
        for times in SHIFTS {
            let _ = self.follow(&mut sale, Model { rough: one, shift: shift * R::of(times) });
        }
        let Some(bid) = sale.best else {
            self.body.recall();
            return None;
        };
        if !sale.placed {
            self.body.base_step = bid.base_step;
            self.body.place(one);
            self.body.reconstruct();
            let _ = self.weigh();
        }
        Some(bid)
    }

    /// Follows the exact model with a shift that suffices.
    fn shifted(&mut self, sale: &mut Auction<R>) {
        let least = (self.solver.shift * R::of(GROWTH)).larger(R::of(1e-3));
        let mut shift = self.sufficed.larger(least);
        for _ in 0..self.settings.shifts {
            if self.follow(sale, Model { rough: R::ZERO, shift }) {
                self.sufficed = shift * R::of(AGAIN);
                return;
            }
            shift *= R::of(GROWTH);
        }
    }

    /// Follows a model the whole way, or half where that is poor. Answers whether it has a minimum.
    fn follow(&mut self, sale: &mut Auction<R>, model: Model<R>) -> bool {
        if core::mem::replace(&mut sale.away, false) {
            self.body.recall();
        }
        self.body.rough = model.rough;
        let Some(fall) = self.factor(model.shift) else { return false };
        let (mut to, before) = (Direction::of(fall), self.energy.total(self.body.mu));
        for share in [R::one(), R::of(0.5)] {
            let rolled = self.body.roll(share, true);
            (sale.away, sale.placed) = (true, false);
            (to.size, to.held) = (rolled.size / share, rolled.held > 0);
            if self.touch.free(&self.body.pose(), R::of(RANGE)) < R::one() {
                break;
            }
            let energy = self.weigh();
            let fell = before - energy.total(self.body.mu);
            if self.joined() && fell >= fall * share * R::of(ARMIJO) {
                let base_step = self.body.base_step.map(|v| v * share);
                if sale.offer(Bid { model, to, share, energy, base_step }, self.body.mu) {
                    self.body.set_aside();
                }
            }
            if fell > to.foretold(share) * R::of(POOR) {
                break;
            }
        }
        true
    }
}

impl<R: Real> Auction<R> {
    /// Answers whether it is the best so far.
    fn offer(&mut self, bid: Bid<R>, mu: R) -> bool {
        let better = self.best.is_none_or(|b| bid.energy.total(mu) < b.energy.total(mu));
        if better {
            (self.best, self.placed) = (Some(bid), true);
        }
        better
    }
}
