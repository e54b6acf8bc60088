//! One backward sweep that assembles and eliminates stage by stage, one forward sweep that finds the step.
//!
//! The model of a stage never leaves the processor's registers and first cache: it is built, eliminated and forgotten.
//! Beside the first derivatives it has all of the second, the geometric ones included: a wrench `W` beyond a crease
//! enters through the crease's second axes and through `½[ξ, S]·W`, because twists that follow one another do not commute.
//!
//! Checked by `tests/ribbon_derivatives.rs`.

use super::barrier::{Wall, bounds, longest, wall};
use super::bending::{self, Bent};
use super::body::{Body, End, Stage};
use super::contact::touch::{Touch, forces, stiffen};
use super::frame::{Six, dot6, halves, six};
use super::inertia::{Cell, Model, Motion, model};
use super::joint::{Crease, Turn, about};
use super::load::{Ask, Loads, Pull};
use super::resample::{Pair, Sample};
use super::riccati::{Tie, Value, plus};
use super::strip::Strip;
use crate::real::{Real, V3};
use nalgebra::{SMatrix, SVector};

/// What a shift weighs on a slope, against an angle: slopes move by more.
pub const SLOPES: f64 = 0.03;

/// What a segment is followed by.
#[derive(Clone, Copy)]
struct Next<'a, R> {
    pair: &'a Pair<R>,
    want: &'a [Sample<R>; 2],
    crease: Crease<R>,
    /// The turn there, unless it is the end.
    turn: Option<&'a Turn<R>>,
    /// What pulls at the end, where it is.
    pulled: Pair<R>,
}

impl<'a, R: Real> Next<'a, R> {
    const NONE: Pair<R> = [V3([R::ZERO; 3]); 2];

    fn end(end: &'a End<R>, pulled: Pair<R>) -> Self {
        Self { pair: &end.pair, want: &end.want, crease: Crease::default(), turn: None, pulled }
    }
    fn crease(s: &'a Stage<R>) -> Self {
        Self {
            pair: &s.pair,
            want: &s.want,
            crease: s.crease,
            turn: Some(&s.turn),
            pulled: Self::NONE,
        }
    }
}

/// What the backward sweep carries along.
struct Carried<R> {
    value: Value<R>,
    /// Gradient by the twist of everything beyond.
    beyond: Six<R>,
    fall: R,
    /// What a shift adds to a crease's diagonal.
    shift: R,
    /// The start moves too, and the end with it.
    drift: bool,
    /// Share that is counted of what a wrench gains by turning.
    turns: R,
}

#[inline(always)]
pub(super) fn pulls<R: Real>(
    ask: &Ask<R>,
    loads: &impl Loads<R>,
    crease: usize,
    pair: &Pair<R>,
    pull: &mut Pull<R>,
) {
    pull.gradient = Next::<R>::NONE;
    pull.terms.clear();
    ask.pull(crease, pair, pull);
    loads.pull(crease, pair, pull);
}

impl<R: Real, const N: usize> Body<R, N> {
    /// Assembles and factors; answers how much the model falls to first order along the step, or nothing where it has
    /// no minimum under this shift.
    ///
    /// # Cost
    ///
    /// Some 1,500 operations a segment.
    pub fn factor(&mut self, ask: &Ask<R>, loads: &impl Loads<R>, shift: R) -> Option<R> {
        self.factor_touching(ask, loads, &(), shift)
    }

    /// As [`Body::factor`], with the pushes that contact has found.
    pub fn factor_touching(
        &mut self,
        ask: &Ask<R>,
        loads: &impl Loads<R>,
        touch: &impl Touch<R>,
        shift: R,
    ) -> Option<R> {
        let mut carried = self.carried(shift);
        let Self { strip, stages, end, motion, mu, rough, .. } = self;
        let mut pull = Pull::none();
        pulls(ask, loads, strip.n, &end.pair, &mut pull);
        curve(&mut carried.value, &pull, &end.pair, V3([R::ZERO; 3]), carried.drift);
        let mut next = Next::end(end, pull.gradient);
        for (j, s) in stages.iter_mut().take(strip.n).enumerate().rev() {
            pulls(ask, loads, j, &s.pair, &mut pull);
            let cell = Self::cell(s, (next.pair, next.want, next.crease.c));
            let spread = cell.spread;
            let others = [pull.gradient, next.pulled];
            let m = pressed(strip, motion, &cell, others, ask.guide(j), (touch, j), *rough);
            let mut bent = bending::derivatives(strip, j, s.crease, next.crease);
            if *rough > R::ZERO {
                bent.roughen(strip, j, [s.crease, next.crease], *rough);
            }
            let w = wall(spread, strip.limit, *mu, s.dual);
            if let Some(turn) = next.turn {
                carried.cross(s, turn, &m, &bent, &w, strip.cell)?;
            }
            carried.own(&m, &bent, &w);
            curve(&mut carried.value, &pull, &s.pair, s.frame.t * strip.half, carried.drift);
            next = Next::crease(s);
        }
        let turn = next.turn.copied().unwrap_or(Turn::NONE);
        self.factor_start(&mut carried, turn)
    }

    /// What lies beyond the last segment: nothing, or a loop's joint.
    fn carried(&self, shift: R) -> Carried<R> {
        let (mut value, mut beyond) = (Value::ZERO, [R::ZERO; 6]);
        if self.looped() {
            let [at_end, at_start] = self.hold.gradient(&self.gap);
            (beyond, value.x, value.xx) = (at_end, at_end, self.hold.hessian(&self.gap));
            for (d, (&e, &s)) in value.d.iter_mut().zip(at_end.iter().zip(&at_start)) {
                *d = e + s;
            }
        }
        Carried {
            value,
            beyond,
            fall: R::ZERO,
            shift: self.strip.stiff * R::of(2.0) * shift,
            drift: self.looped() && self.strip.free,
            turns: R::one() - self.rough,
        }
    }

    /// The hinge at the start, then the start itself.
    fn factor_start(&mut self, carried: &mut Carried<R>, turn: Turn<R>) -> Option<R> {
        let Carried { value, fall, shift, drift, .. } = carried;
        let beyond = &carried.beyond.map(|w| w * carried.turns);
        let (shift, drift) = (*shift, *drift);
        let axes = turn.axes(&self.base).map(|a| about(a, self.base.p));
        let o = R::ZERO;
        let tie = Tie {
            x: [bracket(&axes[0], beyond), [o; 6]],
            u: [[o; 2]; 2],
            g: [o; 2],
            h: [shift, o, o],
            free: [self.strip.hinge > o, false],
            drift,
        };
        value.eliminate(&axes, &tie, fall, &mut self.root_gain)?;
        self.base_step = [o; 6];
        if self.strip.free {
            let (m, g) = if drift { (&value.dd, &value.d) } else { (&value.xx, &value.x) };
            let mut a = SMatrix::<R, 6, 6>::from_fn(|r, c| {
                let at = m.get(r).and_then(|row| row.get(c)).copied().unwrap_or(o);
                if r == c { at + base_shift(shift, r, self.strip.length()) } else { at }
            });
            let mut b = SVector::<R, 6>::from_fn(|r, _| -g.get(r).copied().unwrap_or(o));
            if !R::solve_small(&mut a, &mut b) {
                return None;
            }
            for (s, &v) in self.base_step.iter_mut().zip(b.iter()) {
                *s = v;
            }
            *fall -= dot6(&self.base_step, g);
        }
        Some(*fall)
    }

    /// The step of every crease from the factor; answers the largest, the largest share of it that stays inside, and
    /// how many were held. Where `hold`, a crease whose step would leave the bounds is held at them on the way, and those
    /// beyond it answer to that by their rules: one ruling at its bound does not shorten the step of all.
    pub fn solve(&mut self, hold: bool) -> ([R; 2], u32) {
        let drift = self.looped() && self.strip.free;
        let (d, limit, n) = (self.base_step, self.strip.limit, self.strip.n);
        let far = drift.then_some(&d);
        let start = if drift { [R::ZERO; 6] } else { d };
        let mut step = self.root_gain.rule(R::of(1.0), &start, [R::ZERO; 2], far);
        let mut x = self.root_gain.beyond(&start, step);
        let (mut size, mut share, mut held) = (R::ZERO, R::of(1.0), 0);
        let mut stages = self.used_mut().iter_mut().enumerate().peekable();
        while let Some((j, s)) = stages.next() {
            s.step = Crease { psi: step[0], c: step[1] };
            size = size.larger(step[0].magnitude()).larger(step[1].magnitude());
            let (own, mut spread) = (step, -s.kept.c);
            step = [R::ZERO; 2];
            if let Some((_, next)) = stages.peek() {
                spread = next.kept.c - s.kept.c;
                let rule = s.gain.rule(R::of(1.0), &x, own, far);
                step = rule;
                if hold {
                    let reach = limit * R::of((n - j - 1) as f64);
                    step = s.gain.held(rule, bounds(spread, own[1], limit, next.kept.c, reach));
                    held += u32::from(step[1] != rule[1]);
                }
                x = s.gain.beyond(&x, step);
            }
            share = share.smaller(longest(spread, step[1] - own[1], limit));
        }
        ([size, if hold { R::of(1.0) } else { share }], held)
    }
}

fn base_shift<R: Real>(shift: R, row: usize, length: R) -> R {
    if row < 3 { shift } else { shift / (length * length) }
}

/// `½ [ξ, S]·W` as a row over `ξ`.
fn bracket<R: Real>(axis: &Six<R>, beyond: &Six<R>) -> Six<R> {
    let ([w, v], [torque, force]) = (halves(axis), halves(beyond));
    let half = R::of(0.5);
    six((w.cross(torque) + v.cross(force)) * half, w.cross(force) * half)
}

impl<R: Real> Carried<R> {
    /// Crosses the next crease: what lies beyond it becomes what lies beyond this segment.
    #[inline(always)]
    fn cross(
        &mut self,
        s: &mut Stage<R>,
        turn: &Turn<R>,
        m: &Model<R>,
        bent: &Bent<R>,
        wall: &Wall<R>,
        cell: R,
    ) -> Option<()> {
        let p = s.frame.p + s.frame.t * cell;
        let axes = turn.axes(&s.frame).map(|a| about(a, p));
        let [mixed, bend] = turn.second_axes(&s.frame);
        let beyond = self.beyond.map(|w| w * self.turns);
        let [torque, force] = halves(&beyond);
        let moment = torque - p.cross(force);
        let (g, h) = (&bent.g, &bent.h);
        let mut x = axes.map(|a| bracket(&a, &beyond));
        for (x, &m) in x[1].iter_mut().zip(&m.xc[1]) {
            *x += m;
        }
        let cc = h[3][3] + m.cc[2] + moment.dot(bend) + wall.curve + self.shift * R::of(SLOPES);
        let tie = Tie {
            x,
            u: [[h[2][0], h[2][1]], [h[3][0], h[3][1] + m.cc[1] - wall.curve]],
            g: [g[2], g[3] + m.c[1] + wall.slope],
            h: [h[2][2] + self.shift, h[2][3] + moment.dot(mixed), cc],
            free: [true; 2],
            drift: self.drift,
        };
        self.value.eliminate(&axes, &tie, &mut self.fall, &mut s.gain)
    }

    /// Adds a segment's own terms.
    #[inline(always)]
    fn own(&mut self, m: &Model<R>, bent: &Bent<R>, wall: &Wall<R>) {
        let value = &mut self.value;
        plus(&mut value.xx, &m.xx);
        for i in 0..6 {
            value.x[i] += m.x[i];
            value.xu[1][i] += m.xc[0][i];
            self.beyond[i] += m.x[i];
        }
        value.u[0] += bent.g[0];
        value.u[1] += bent.g[1] + m.c[0] - wall.slope;
        value.uu[0] += bent.h[0][0];
        value.uu[1] += bent.h[0][1];
        value.uu[2] += bent.h[1][1] + m.cc[0] + wall.curve;
        if self.drift {
            plus(&mut value.xd, &m.xx);
            plus(&mut value.dd, &m.xx);
            for i in 0..6 {
                value.d[i] += m.x[i];
                value.ud[1][i] += m.xc[0][i];
            }
        }
    }
}

/// The model of a cell with what pushes at it.
#[inline(always)]
pub(super) fn pressed<R: Real, T: Touch<R>>(
    strip: &Strip<R>,
    motion: &Motion<R>,
    cell: &Cell<'_, R>,
    others: [Pair<R>; 2],
    lean: V3<R>,
    (touch, segment): (&T, usize),
    rough: R,
) -> Model<R> {
    if !T::ACTIVE {
        return model(strip, motion, cell, &others, lean, rough);
    }
    let mut sum = others;
    for (pair, force) in sum.iter_mut().zip(forces(touch, segment)) {
        for (s, f) in pair.iter_mut().zip(force) {
            *s = *s + f;
        }
    }
    let mut m = model(strip, motion, cell, &sum, lean, rough);
    stiffen(touch, segment, &cell.x, strip, cell.frame.t, &mut m);
    m
}

/// Adds the curvature terms of loads: rank one each, over `(ξ, c)`.
fn curve<R: Real>(value: &mut Value<R>, pull: &Pull<R>, pair: &Pair<R>, slide: V3<R>, drift: bool) {
    for (weight, [a, b]) in &pull.terms {
        let row = six(pair[0].cross(*a) + pair[1].cross(*b), *a + *b);
        let c = slide.dot(*b - *a);
        for (i, &r) in row.iter().enumerate() {
            let r = r * *weight;
            for (k, &q) in row.iter().enumerate() {
                value.xx[i][k] += r * q;
                if drift {
                    value.xd[i][k] += r * q;
                    value.dd[i][k] += r * q;
                }
            }
            value.xu[1][i] += r * c;
            if drift {
                value.ud[1][i] += r * c;
            }
        }
        value.uu[2] += *weight * c * c;
    }
}
