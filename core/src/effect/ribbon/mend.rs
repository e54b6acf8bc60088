//! Closes a loop that a solve has left ajar: Gauss and Newton's steps on the joint's six rows alone, each the shortest in
//! all creases' unknowns that leaves what is touched where it is. Their matrix is positive definite whatever pulls.
//!
//! Source: ours. Checked by `tests/ribbon_loops.rs`.

use super::body::{Body, Stage};
use super::closure::Hold;
use super::contact::touch::{Push, Touch, four, stiffen_by};
use super::forces::Model;
use super::frame::Frame;
use super::joint::{Turn, about};
use super::report::{Report, Settings};
use super::resample::Pair;
use super::riccati::{C, Part, Value, state};
use super::strip::Strip;
use crate::real::{Real, V3};

/// What a step of a slope weighs against one of an angle: slopes have bounds, angles have none.
const SLOPES: f64 = 100.0;
/// Penalty of a turn at the joint, against one for a crease's own.
const RATE: f64 = 1e6;
/// The same in `f32`, whose sweep loses the creases' own beside more.
const RATE_SINGLE: f64 = 1e3;
/// What a point that is touched weighs, against the joint: where there are many, it has to give.
const FIRM: f64 = 1e-2;
/// Rulings are held so many roundings before their bounds.
const BRIM: f64 = 256.0;

/// A closing step's share below which the other kind is tried.
const FAR: f64 = 0.3;
/// A step that meets something is not shortened by more than this at once.
const LEAST_FREE: f64 = 0.02;
/// Steps at most that close a loop.
const CLOSINGS: u32 = 40;

impl<R: Real, const N: usize> Body<R, N> {
    /// Closes the joint by at most forty steps. Where one kind of step comes not far, rulings at their bounds or a contact
    /// are in its way: then it is the other's turn.
    pub(super) fn close<T: Touch<R>>(
        &mut self,
        touch: &mut T,
        settings: &Settings,
        report: &mut Report<R>,
    ) {
        let (mut lean, mut failed) = (true, 0);
        let (middle, length) = (self.middle(), self.strip.length());
        for _ in 0..CLOSINGS {
            self.stand();
            if failed > 1 || self.gap.size(length) <= R::of(settings.closure) {
                break;
            }
            report.iterations += 1;
            report.factorisations += 1;
            let share = self.draw(touch, settings.trials, lean);
            failed = if share > R::ZERO { 0 } else { failed + 1 };
            lean ^= share < R::of(FAR);
        }
        if self.strip.free && !T::ACTIVE {
            self.centre(middle);
        }
    }

    /// Takes the first share of a closing step that closes well and is free; answers which, or zero.
    fn draw<T: Touch<R>>(&mut self, touch: &mut T, trials: u32, lean: bool) -> R {
        touch.press(&self.pose());
        let (before, mut share) = (self.ajar(), R::one());
        if self.factor_joint(touch, lean).is_none() {
            return R::ZERO;
        }
        self.lead_joint();
        for _ in 0..trials {
            self.place(share);
            self.reconstruct();
            let free = touch.free(&self.pose(), R::one());
            if free < R::one() {
                share *= free.larger(R::of(LEAST_FREE));
                continue;
            }
            let closes = self.ajar() < before * (R::one() - share * R::of(0.1));
            if closes && self.inside() {
                self.accept();
                return share;
            }
            share *= R::of(0.5);
        }
        R::ZERO
    }

    /// Brings a free loop's middle back to where it was: closing gives no momentum.
    fn centre(&mut self, middle: V3<R>) {
        self.stand();
        self.base.p = self.base.p + middle - self.middle();
        self.reconstruct();
        self.keep();
    }

    /// Factors the joint's rows; `lead_joint` then gives the step. A free start stays where it is, and so do, in
    /// the direction they are pushed, points that `touch` has found; so do all slopes but where `lean`.
    ///
    /// # Cost
    ///
    /// Some 500 operations a segment.
    fn factor_joint<T: Touch<R>>(&mut self, touch: &T, lean: bool) -> Option<R> {
        let (o, cell, strip) = (R::ZERO, self.strip.cell, self.strip);
        let (rows, mut value) = (self.joint_rows(), Value::zero());
        let weight = rows.shift * R::of(FIRM);
        let [at_end, _] = rows.gradient(&self.gap);
        value.join(&at_end, &rows.hessian(&self.gap));
        let (n, mut fall, mut pair) = (strip.n, o, self.end.pair);
        let mut next = None::<Turn<R>>;
        for (j, s) in self.stages.iter_mut().take(n).enumerate().rev() {
            let mut part = alone([true, lean]);
            if T::ACTIVE {
                hold(&mut part, &held(touch, weight, &strip, (j, s, &pair)));
            }
            match next {
                Some(turn) => {
                    turned(&mut part, &turn, &s.frame, s.frame.p + s.frame.t * cell);
                    value.eliminate(&part, false, &mut fall, &mut s.gain)?;
                }
                None => value.add(&part, false),
            }
            (next, pair) = (Some(s.turn), s.pair);
        }
        let mut part = alone([strip.hinge > o, false]);
        turned(&mut part, &next?, &self.base, self.base.p);
        value.eliminate(&part, false, &mut fall, &mut self.root_gain)?;
        self.base_step = [o; 6];
        Some(fall)
    }
    /// The joint's rows, without multipliers.
    fn joint_rows(&self) -> Hold<R> {
        let (rate, length) =
            (if R::EPSILON > 1e-10 { RATE_SINGLE } else { RATE }, self.strip.length());
        let turn = R::of(rate);
        Hold { lambda: [R::ZERO; 6], turn, shift: turn * R::of(40.0) / (length * length) }
    }
    /// What a closing step lowers.
    fn ajar(&self) -> R {
        self.joint_rows().energy(&self.gap)
    }
    /// The mean of the creases' middles as placed, a loop's last not counted twice.
    fn middle(&self) -> V3<R> {
        let ends = self.used().iter().fold(V3([R::ZERO; 3]), |sum, s| sum + s.pair[0] + s.pair[1]);
        ends * (R::of(0.5) / R::of(self.strip.n as f64))
    }
    /// The step of every crease from `factor_joint`. Rulings are held a little before their bounds: what comes
    /// nearer at each step would soon be nearer than rounding.
    fn lead_joint(&mut self) {
        let limit = self.strip.limit;
        self.strip.limit = limit * R::of(1.0 - BRIM * R::EPSILON);
        let _ = self.solve(true);
        self.strip.limit = limit;
    }
}

/// A crease's own weight.
fn alone<R: Real>(free: [bool; 2]) -> Part<R> {
    Part { h: [R::one(), R::ZERO, R::of(SLOPES)], free, ..Part::ZERO }
}

/// Turns about a crease.
fn turned<R: Real>(part: &mut Part<R>, turn: &Turn<R>, frame: &Frame<R>, p: V3<R>) {
    let ([psi, slope], o, l) = (turn.axes(frame).map(|a| about(a, p)), R::ZERO, R::one());
    part.axes = [state(&psi, [l, o]), state(&slope, [o, l])];
}

/// Keeps what is touched where it is.
fn hold<R: Real>(part: &mut Part<R>, m: &Model<R>) {
    let o = R::ZERO;
    for (row, (xx, &xc)) in part.zz.iter_mut().zip(m.xx.iter().zip(&m.xc[0])) {
        *row = state(xx, [o, xc]);
    }
    part.zz[C] = state(&m.xc[0], [o, m.cc[0]]);
    part.tie[1] = state(&m.xc[1], [o, m.cc[1]]);
    part.h[2] += m.cc[2];
}

/// What a segment's pushed points weigh, each a share of what the joint does.
fn held<R: Real>(
    touch: &impl Touch<R>,
    weight: R,
    strip: &Strip<R>,
    (j, s, beyond): (usize, &Stage<R>, &Pair<R>),
) -> Model<R> {
    let (o, none) = (R::ZERO, [R::ZERO; 6]);
    let mut m = Model { x: none, c: [o; 2], xx: [none; 6], xc: [none; 2], cc: [o; 3] };
    let x = four(s.pair, *beyond);
    touch.pushes(j, |p| {
        let firm = Push { curve: weight, ..*p };
        stiffen_by(&firm, &x, strip, s.frame.t, &mut m);
    });
    m
}
