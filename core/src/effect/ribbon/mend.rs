//! Closes a loop that a solve has left ajar: Gauss and Newton's steps on the joint's six rows alone, each the shortest in
//! all creases' unknowns that leaves what is touched where it is. Their matrix is positive definite whatever pulls.
//!
//! Source: ours. Checked by `tests/ribbon_loops.rs`.

use super::body::{Body, Stage};
use super::closure::Hold;
use super::contact::touch::{Push, Touch, four, stiffen_by};
use super::inertia::Model;
use super::joint::{Turn, about};
use super::resample::Pair;
use super::riccati::{Tie, Value, plus};
use super::strip::Strip;
use crate::real::Real;

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

impl<R: Real, const N: usize> Body<R, N> {
    /// Factors the joint's rows; [`Body::lead_joint`] then gives the step. A free start stays where it is, and so do, in
    /// the direction they are pushed, points that `touch` has found; so do all slopes but where `lean`.
    ///
    /// # Cost
    ///
    /// Some 500 operations a segment.
    pub fn factor_joint<T: Touch<R>>(&mut self, touch: &T, lean: bool) -> Option<R> {
        let (o, cell, strip) = (R::ZERO, self.strip.cell, self.strip);
        let (rows, mut value) = (self.joint_rows(), Value::ZERO);
        let weight = rows.shift * R::of(FIRM);
        let [at_end, _] = rows.gradient(&self.gap);
        (value.x, value.xx) = (at_end, rows.hessian(&self.gap));
        let (n, mut fall) = (strip.n, o);
        let (mut next, mut pair) = (None::<Turn<R>>, self.end.pair);
        for (j, s) in self.stages.iter_mut().take(n).enumerate().rev() {
            let held = T::ACTIVE.then(|| held(touch, weight, &strip, (j, s, &pair)));
            if let Some(turn) = next {
                let p = s.frame.p + s.frame.t * cell;
                let axes = turn.axes(&s.frame).map(|a| about(a, p));
                let mut tie = tie([true, lean]);
                if let Some(m) = &held {
                    (tie.x[1], tie.u[1][1]) = (m.xc[1], m.cc[1]);
                    tie.h[2] += m.cc[2];
                }
                value.eliminate(&axes, &tie, &mut fall, &mut s.gain)?;
            }
            if let Some(m) = &held {
                plus(&mut value.xx, &m.xx);
                value.xu[1].iter_mut().zip(&m.xc[0]).for_each(|(x, &m)| *x += m);
                value.uu[2] += m.cc[0];
            }
            (next, pair) = (Some(s.turn), s.pair);
        }
        let axes = next?.axes(&self.base).map(|a| about(a, self.base.p));
        value.eliminate(&axes, &tie([strip.hinge > o, false]), &mut fall, &mut self.root_gain)?;
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
    pub fn ajar(&self) -> R {
        self.joint_rows().energy(&self.gap)
    }
    /// The step of every crease from [`Body::factor_joint`]. Rulings are held a little before their bounds: what comes
    /// nearer at each step would soon be nearer than rounding.
    pub fn lead_joint(&mut self) {
        let limit = self.strip.limit;
        self.strip.limit = limit * R::of(1.0 - BRIM * R::EPSILON);
        let _ = self.solve(true);
        self.strip.limit = limit;
    }
}

/// A crease's own weight.
fn tie<R: Real>(free: [bool; 2]) -> Tie<R> {
    let o = R::ZERO;
    let h = [R::one(), o, R::of(SLOPES)];
    Tie { x: [[o; 6]; 2], u: [[o; 2]; 2], g: [o; 2], h, free, drift: false }
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
