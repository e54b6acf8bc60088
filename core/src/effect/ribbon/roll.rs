//! A trial: a share of the step, by the sweep's rules rather than by their sum. Every crease answers to where the segment
//! before it has really come to, so what a long chain's turns add up to beyond first order does not carry its end away.
//!
//! Source: the forward pass of differential dynamic programming (Mayne 1966, Jacobson and Mayne 1970). Checked by
//! `tests/ribbon_newton.rs`, `tests/ribbon_derivatives.rs`.

use super::barrier::bounds;
use super::body::{Body, Stage};
use super::closure::Gap;
use super::frame::{Frame, Six, log_slope, six};
use super::joint::{Crease, Turn};
use crate::real::{Real, V3};

/// Angles below this have a short series (its cosine).
const NEAR: f64 = 0.9;

/// No crease turns further in one step, radians: the model knows nothing of what is beyond.
const MOST: f64 = 1.0;

/// How far a roll went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolled<R> {
    /// The largest change of a crease.
    pub size: R,
    /// How many creases were held within their bounds.
    pub held: u32,
}

/// The twist about the world's origin that takes one frame to another.
///
/// # Accuracy
///
/// A millionth of it below a quarter of a radian, where it is used most, a thousandth below half of one; rounding beyond.
#[inline]
pub(super) fn twist<R: Real>(from: &Frame<R>, to: &Frame<R>) -> Six<R> {
    let (one, half) = (R::one(), R::of(0.5));
    let p = &from.p;
    let turned = to.t * from.t.dot(*p) + to.b * from.b.dot(*p) + to.n * from.n.dot(*p);
    let shift = to.p - turned;
    let cos = (from.t.dot(to.t) + from.b.dot(to.b) + from.n.dot(to.n) - one) * half;
    if cos < R::of(NEAR) {
        let [w, _] = to.apart(from);
        return six(w, log_slope(w, shift, false));
    }
    let axis = (from.t.cross(to.t) + from.b.cross(to.b) + from.n.cross(to.n)) * half;
    // arcsin x / x in squares of the sine; what it takes from a shift and gives back is reckoned beside it.
    let z = axis.norm_sq();
    let more = one + z * (R::of(1.0 / 6.0) + z * (R::of(3.0 / 40.0) + z * R::of(5.0 / 112.0)));
    let once = axis.cross(shift);
    let twice = axis.cross(once) * R::of(1.0 / 6.0);
    six(axis * more, shift - (once - twice * more) * (half * more))
}

impl<R: Real> Stage<R> {
    /// Turns at its crease, `step` beyond the frame before; answers its own.
    #[inline]
    pub(super) fn turned(&mut self, before: &Frame<R>, step: R, half: R) -> Frame<R> {
        self.turn = Turn::of(self.crease);
        self.frame = squared(&self.turn.beyond(before, step));
        self.pair = ends(&self.frame, half, self.crease.c);
        self.frame
    }
}

/// A frame that is square but for rounding, squared again: along a chain of sharp folds what is missing would grow.
#[inline]
fn squared<R: Real>(f: &Frame<R>) -> Frame<R> {
    let half = R::of(0.5);
    let lean = f.t.dot(f.n) * half;
    let long = |x: V3<R>| (R::of(3.0) - x.norm_sq()) * half;
    let (t, n) = (f.t * long(f.t) - f.n * lean, f.n * long(f.n) - f.t * lean);
    Frame { t, b: n.cross(t), n, p: f.p }
}

/// The ends of a crease, at the frame beyond it.
pub(super) fn ends<R: Real>(f: &Frame<R>, half: R, c: R) -> [V3<R>; 2] {
    let lean = (f.t * c + f.b) * half;
    [f.p - lean, f.p + lean]
}

impl<R: Real, const N: usize> Body<R, N> {
    /// Places everything at a share of the step from where it was accepted. Creases whose steps would leave their bounds
    /// are held there where `hold`.
    ///
    /// # Cost
    ///
    /// Some 250 operations, a sine and a cosine a segment.
    pub fn roll(&mut self, share: R, hold: bool) -> Rolled<R> {
        let (strip, o) = (self.strip, R::ZERO);
        let drift = self.looped() && strip.free;
        let d = self.base_step.map(|v| v * share);
        self.base = if strip.free && share > o { self.kept_base.moved(&d) } else { self.kept_base };
        let far = drift.then_some(&d);
        let start = if drift { [o; 6] } else { d };
        let mut step = self.root_gain.rule(share, &start, [o; 2], far);
        let (mut frame, mut rolled) = (self.base, Rolled { size: o, held: 0 });
        let mut stages = self.used_mut().iter_mut().enumerate().peekable();
        while let Some((j, s)) = stages.next() {
            s.crease = Crease { psi: s.kept.psi + step[0], c: s.kept.c + step[1] };
            rolled.size = rolled.size.larger(step[0].magnitude()).larger(step[1].magnitude());
            frame = s.turned(&frame, if j == 0 { o } else { strip.cell }, strip.half);
            if let Some((_, next)) = stages.peek() {
                let (mut x, own) = (twist(&s.kept_frame, &frame), step);
                if drift {
                    x.iter_mut().zip(&d).for_each(|(x, &d)| *x -= d);
                }
                step = s.gain.rule(share, &x, own, far);
                if hold {
                    let (rule, spread) = (step, next.kept.c - s.kept.c);
                    let reach = strip.limit * R::of((strip.n - j - 1) as f64);
                    let bounds = bounds(spread, own[1], strip.limit, next.kept.c, reach);
                    step = s.gain.held(rule, bounds);
                    step[0] = step[0].larger(R::of(-MOST)).smaller(R::of(MOST));
                    rolled.held += u32::from(step != rule);
                }
            }
        }
        self.finish(&frame);
        rolled
    }
    /// The end and a loop's gap, from the last segment's frame.
    pub(super) fn finish(&mut self, last: &Frame<R>) {
        let end = Frame { p: last.p + last.t * self.strip.cell, ..*last };
        self.end.pair = ends(&end, self.strip.half, R::ZERO);
        if self.looped() {
            self.gap = Gap::between(&end, &self.base, self.joint);
        }
    }
}
