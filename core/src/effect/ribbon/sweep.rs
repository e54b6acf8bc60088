//! One backward sweep that assembles and eliminates stage by stage, one forward sweep that finds the step.
//!
//! The model of a stage never leaves the processor's registers and first cache: it is built, eliminated and forgotten.
//! Beside the first derivatives it has all of the second, the geometric ones included: a wrench `W` beyond a crease
//! enters through the crease's second axes and through `½[ξ, S]·W`, because twists that follow one another do not commute.
//!
//! Checked by `tests/ribbon_derivatives.rs`.

use super::barrier::{bounds, longest, wall};
use super::bending;
use super::body::{Body, Stage};
use super::frame::{Six, dot6, halves, six};
use super::inertia::{Model, model};
use super::joint::{Crease, Turn, about};
use super::load::{Ask, Loads, Pull};
use super::resample::{Pair, Sample};
use super::riccati::{Tie, Value, plus};
use crate::real::{Real, V3};
use nalgebra::{SMatrix, SVector};

/// What a segment is followed by.
#[derive(Clone, Copy)]
struct Next<R> {
    pair: Pair<R>,
    want: [Sample<R>; 2],
    crease: Crease<R>,
    turn: Turn<R>,
    /// There is a crease, not the end.
    inner: bool,
}

impl<R: Real, const N: usize> Body<R, N> {
    /// Assembles and factors; answers how much the model falls to first order along the step, or nothing where it has
    /// no minimum under this shift.
    ///
    /// # Cost
    ///
    /// Some 1,500 operations a segment.
    pub fn factor(&mut self, ask: &Ask<R>, loads: &impl Loads<R>, shift: R) -> Option<R> {
        let Self { strip, stages, end, motion, mu, hold, gap, .. } = self;
        let looped = strip.closure != super::spec::Closure::Open;
        let drift = looped && strip.free;
        let shift_unit = strip.stiff * R::of(2.0) * shift;
        let (mut value, mut beyond, mut fall) = (Value::ZERO, [R::ZERO; 6], R::ZERO);
        if looped {
            let [at_end, at_start] = hold.gradient(gap);
            beyond = at_end;
            value.x = at_end;
            value.xx = hold.hessian(gap);
            for (d, (&e, &s)) in value.d.iter_mut().zip(at_end.iter().zip(&at_start)) {
                *d = e + s;
            }
        }
        let mut others = [[V3([R::ZERO; 3]); 2]; 2];
        let mut last = Pull::none();
        ask.pull(strip.n, &end.pair, &mut last);
        loads.pull(strip.n, &end.pair, &mut last);
        others[1] = last.gradient;
        let mut pulled_end = Some(last);
        let mut next = Next {
            pair: end.pair,
            want: end.want,
            crease: Crease::default(),
            turn: Turn::NONE,
            inner: false,
        };
        let n = strip.n;
        for (j, s) in stages.iter_mut().take(n).enumerate().rev() {
            let mut pull = Pull::none();
            ask.pull(j, &s.pair, &mut pull);
            loads.pull(j, &s.pair, &mut pull);
            others[0] = pull.gradient;
            let cell = Self::cell(s, (&next.pair, &next.want, next.crease.c));
            let m = model(strip, motion, &cell, &others, ask.guide(j));
            let bent = bending::derivatives(strip, j, s.crease, next.crease);
            let w = wall(cell.spread, strip.limit, *mu, s.dual);
            if next.inner {
                let axes = next_axes(s, &next, strip.cell);
                let mut tie = tie(&m, &bent, &next, s, &beyond, &axes, strip.cell);
                tie.g[1] += w.slope;
                tie.h[2] += w.curve;
                tie.u[1][1] -= w.curve;
                tie.h[0] += shift_unit;
                tie.h[2] += shift_unit;
                tie.drift = drift;
                s.gain = value.eliminate(&axes, &tie, &mut fall)?;
            }
            own(&mut value, &m, &bent, drift);
            value.u[1] -= w.slope;
            value.uu[2] += w.curve;
            curve(&mut value, &pull, &s.pair, s.frame.t * strip.half, drift);
            if let Some(last) = pulled_end.take() {
                curve(&mut value, &last, &end.pair, V3([R::ZERO; 3]), drift);
            }
            for (b, &x) in beyond.iter_mut().zip(&m.x) {
                *b += x;
            }
            others[1] = [V3([R::ZERO; 3]); 2];
            next = Next { pair: s.pair, want: s.want, crease: s.crease, turn: s.turn, inner: true };
        }
        self.factor_start(
            value,
            next.turn,
            &beyond,
            [shift_unit, R::of(if drift { 1.0 } else { 0.0 })],
            fall,
        )
    }

    /// The hinge at the start, then the start itself.
    fn factor_start(
        &mut self,
        mut value: Value<R>,
        turn: Turn<R>,
        beyond: &Six<R>,
        [shift, drift]: [R; 2],
        mut fall: R,
    ) -> Option<R> {
        let drift = drift > R::ZERO;
        let hinged = self.strip.hinge > R::ZERO;
        let axis = turn.axes(&self.base);
        let axes = [about(axis[0], self.base.p), about(axis[1], self.base.p)];
        let o = R::ZERO;
        let tie = Tie {
            x: [bracket(&axes[0], beyond), [o; 6]],
            u: [[o; 2]; 2],
            g: [o; 2],
            h: [shift, o, o],
            free: [hinged, false],
            drift,
        };
        self.root_gain = value.eliminate(&axes, &tie, &mut fall)?;
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
            fall -= dot6(&self.base_step, g);
        }
        Some(fall)
    }

    /// The step of every crease from the factor; answers the largest, the largest share of it that stays inside, and
    /// how many were held. Where `hold`, a crease whose step would leave the bounds is held at them on the way, and those
    /// beyond it answer to that by their rules: one ruling at its bound does not shorten the step of all.
    pub fn solve(&mut self, hold: bool) -> ([R; 2], u32) {
        let drift = self.looped() && self.strip.free;
        let (d, limit, n) = (self.base_step, self.strip.limit, self.strip.n);
        let far = drift.then_some(&d);
        let start = if drift { [R::ZERO; 6] } else { d };
        let mut step = self.root_gain.rule(&start, [R::ZERO; 2], far);
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
                let rule = s.gain.rule(&x, own, far);
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

fn next_axes<R: Real>(s: &Stage<R>, next: &Next<R>, cell: R) -> [Six<R>; 2] {
    let p = s.frame.p + s.frame.t * cell;
    let [a, b] = next.turn.axes(&s.frame);
    [about(a, p), about(b, p)]
}

/// `½ [ξ, S]·W` as a row over `ξ`.
fn bracket<R: Real>(axis: &Six<R>, beyond: &Six<R>) -> Six<R> {
    let ([w, v], [torque, force]) = (halves(axis), halves(beyond));
    let half = R::of(0.5);
    six((w.cross(torque) + v.cross(force)) * half, w.cross(force) * half)
}

/// What ties the next crease to this segment.
#[inline(always)]
fn tie<R: Real>(
    m: &Model<R>,
    bent: &bending::Bent<R>,
    next: &Next<R>,
    s: &Stage<R>,
    beyond: &Six<R>,
    axes: &[Six<R>; 2],
    cell: R,
) -> Tie<R> {
    let p = s.frame.p + s.frame.t * cell;
    let [mixed, bend] = next.turn.second_axes(&s.frame);
    let [torque, force] = halves(beyond);
    let moment = torque - p.cross(force);
    let (b, h) = (&bent.g, &bent.h);
    let mut x = [bracket(&axes[0], beyond), bracket(&axes[1], beyond)];
    for (x, &m) in x[1].iter_mut().zip(&m.xc[1]) {
        *x += m;
    }
    Tie {
        x,
        u: [[h[2][0], h[2][1]], [h[3][0], h[3][1] + m.cc[1]]],
        g: [b[2], b[3] + m.c[1]],
        h: [h[2][2], h[2][3] + moment.dot(mixed), h[3][3] + m.cc[2] + moment.dot(bend)],
        free: [true; 2],
        drift: false,
    }
}

/// Adds a segment's own terms.
#[inline(always)]
fn own<R: Real>(value: &mut Value<R>, m: &Model<R>, bent: &bending::Bent<R>, drift: bool) {
    plus(&mut value.xx, &m.xx);
    for i in 0..6 {
        value.x[i] += m.x[i];
        value.xu[1][i] += m.xc[0][i];
    }
    value.u[0] += bent.g[0];
    value.u[1] += bent.g[1] + m.c[0];
    value.uu[0] += bent.h[0][0];
    value.uu[1] += bent.h[0][1];
    value.uu[2] += bent.h[1][1] + m.cc[0];
    if drift {
        plus(&mut value.xd, &m.xx);
        plus(&mut value.dd, &m.xx);
        for i in 0..6 {
            value.d[i] += m.x[i];
            value.ud[1][i] += m.xc[0][i];
        }
    }
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

/// Gradient of everything that is minimised, by each crease and by the start's twist.
impl<R: Real, const N: usize> Body<R, N> {
    /// Adjoint sweep (Ribbon App. C): hands each crease's gradient to `take`, last crease first; answers the start's.
    ///
    /// # Cost
    ///
    /// That of assembling; for oracles and tests.
    pub fn gradient(
        &self,
        ask: &Ask<R>,
        loads: &impl Loads<R>,
        mut take: impl FnMut(usize, [R; 2]),
    ) -> Six<R> {
        let strip = &self.strip;
        let mut beyond = [R::ZERO; 6];
        let mut at_start = [R::ZERO; 6];
        if self.looped() {
            [beyond, at_start] = self.hold.gradient(&self.gap);
        }
        let mut last = Pull::none();
        ask.pull(strip.n, &self.end.pair, &mut last);
        loads.pull(strip.n, &self.end.pair, &mut last);
        let mut others = [[V3([R::ZERO; 3]); 2], last.gradient];
        let mut carried = [R::ZERO; 2];
        let mut next = (self.end.pair, self.end.want, Crease::default());
        for (j, s) in self.used().iter().enumerate().rev() {
            let near = j.checked_sub(1).and_then(|i| self.stages.get(i));
            let f = near.map_or(&self.base, |s| &s.frame);
            let mut pull = Pull::none();
            ask.pull(j, &s.pair, &mut pull);
            loads.pull(j, &s.pair, &mut pull);
            others[0] = pull.gradient;
            let cell = Self::cell(s, (&next.0, &next.1, next.2.c));
            let m = model(strip, &self.motion, &cell, &others, ask.guide(j));
            let bent = bending::derivatives(strip, j, s.crease, next.2);
            let w = wall(cell.spread, strip.limit, self.mu, s.dual);
            if j + 1 < strip.n {
                take(j + 1, [carried[0] + bent.g[2], carried[1] + bent.g[3] + m.c[1] + w.slope]);
            }
            for (b, &x) in beyond.iter_mut().zip(&m.x) {
                *b += x;
            }
            let step = if j == 0 { R::ZERO } else { strip.cell };
            let [a, b] = s.turn.axes(f).map(|a| dot6(&about(a, f.p + f.t * step), &beyond));
            carried = [a + bent.g[0], b + bent.g[1] + m.c[0] - w.slope];
            others[1] = [V3([R::ZERO; 3]); 2];
            next = (s.pair, s.want, s.crease);
        }
        take(0, carried);
        for (b, &s) in beyond.iter_mut().zip(&at_start) {
            *b += s;
        }
        beyond
    }
}
