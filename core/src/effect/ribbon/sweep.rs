//! One backward sweep that assembles and eliminates eight stages after eight, one forward sweep that finds the step.
//!
//! The models of eight stages are built, eliminated and forgotten before they leave the processor's first cache.
//! Beside the first derivatives it has all of the second, the geometric ones included: a wrench `W` beyond a crease
//! enters through the crease's second axes and through `½[ξ, S]·W`, because twists that follow one another do not commute.
//!
//! Checked by `tests/ribbon_derivatives.rs`.

use super::assemble::{Assembly, Bends};
use super::barrier::{bounds, longest};
use super::body::{Body, Stage};
use super::contact::touch::Touch;
use super::forces::{Model, Pushed};
use super::frame::{Six, dot6, halves, six};
use super::joint::{Crease, Turn, about};
use super::load::{Ask, Loads, Pull};
use super::resample::Pair;
use super::riccati::{self, C, Part, Value, state};
use super::strip::Strip;
use crate::real::{Eight, LANES, Real, V3};
use nalgebra::{SMatrix, SVector};

/// What a shift weighs on a slope, against an angle: slopes move by more.
pub const SLOPES: f64 = 0.03;

/// What the backward sweep carries along.
struct Carried<R: Real> {
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

/// What pulls at a segment: its own crease, the end if it is the last; its far vertices.
struct Beside<R> {
    pull: Pull<R>,
    end: Option<Pair<R>>,
    far: Pair<R>,
    rough: R,
}

#[inline(always)]
pub(super) fn pulls<R: Real>(
    ask: &Ask<R>,
    loads: &impl Loads<R>,
    crease: usize,
    pair: &Pair<R>,
    pull: &mut Pull<R>,
) {
    pull.clear();
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
        let (mut carried, assembly) = (self.carried(shift), Assembly::of(self));
        let Self { strip, stages, end, rough, room, .. } = self;
        let used = stages.get_mut(..strip.n)?;
        let mut pull = Pull::none();
        pulls(ask, loads, strip.n, &end.pair, &mut pull);
        carried.end(&pull, &end.pair);
        let at_end = pull.some().then_some(pull.gradient);
        let mut beside = Beside { end: at_end, pull, far: end.pair, rough: *rough };
        let mut first = true;
        for last in (0..strip.n).rev().step_by(LANES) {
            assembly.fill(strip, (used, end), last, room);
            let slots = room.parts.iter_mut().zip(&room.bends);
            for (j, (part, bend)) in (0..=last).rev().zip(slots) {
                let s = used.get(j)?;
                pulls(ask, loads, j, &s.pair, &mut beside.pull);
                beside.push(strip, s, (touch, j), ask.guide(j), part);
                carried.tie(part, bend);
            }
            for (j, part) in (0..=last).rev().zip(&room.parts) {
                let gain = &mut used.get_mut(j)?.gain;
                let Carried { value, drift, fall, .. } = &mut carried;
                if core::mem::replace(&mut first, false) {
                    value.add(part, *drift);
                } else {
                    value.eliminate(part, *drift, fall, gain)?;
                }
            }
        }
        let turn = used.first()?.turn;
        self.factor_start(&mut carried, turn)
    }

    /// What lies beyond the last segment: nothing, or a loop's joint.
    fn carried(&self, shift: R) -> Carried<R> {
        let (mut value, mut beyond) = (Value::zero(), [R::ZERO; 6]);
        if self.looped() {
            let [at_end, at_start] = self.hold.gradient(&self.gap);
            value.join(&at_end, &self.hold.hessian(&self.gap));
            value.d = value.z + R::Eight::from_array(state(&at_start, [R::ZERO; 2]));
            beyond = at_end;
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
        let [psi, slope] = turn.axes(&self.base).map(|a| about(a, self.base.p));
        let (o, l) = (R::ZERO, R::one());
        let crease = Part {
            axes: [state(&psi, [l, o]), state(&slope, [o, l])],
            tie: [state(&bracket(&psi, beyond), [o; 2]), [o; LANES]],
            h: [shift, o, o],
            free: [self.strip.hinge > o, false],
            ..Part::ZERO
        };
        value.eliminate(&crease, drift, fall, &mut self.root_gain)?;
        self.base_step = [o; 6];
        if self.strip.free {
            let [p, q, r, s, t, u, ..] = value.zz;
            let (m, g) = if drift { (value.dd, value.d) } else { ([p, q, r, s, t, u], value.z) };
            let (m, g) = (m.map(Eight::array), &riccati::six(g.array()));
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
    /// Completes what ties a crease to the state before it: the wrench of all that is beyond turns with both.
    #[inline(always)]
    fn tie(&mut self, part: &mut Part<R>, bend: &Bends<R>) {
        let beyond = self.beyond.map(|w| w * self.turns);
        let [torque, force] = halves(&beyond);
        let moment = torque - bend.p.cross(force);
        for (tie, axis) in part.tie.iter_mut().zip(&part.axes) {
            for (tie, turned) in tie.iter_mut().zip(bracket(&riccati::six(*axis), &beyond)) {
                *tie += turned;
            }
        }
        let [psi, mixed, slope] = part.h;
        part.h = [
            psi + self.shift,
            mixed + moment.dot(bend.mixed),
            slope + moment.dot(bend.slope) + self.shift * R::of(SLOPES),
        ];
        self.beyond.iter_mut().zip(&part.z).for_each(|(b, &x)| *b += x);
    }

    /// What loads at the end itself add.
    fn end(&mut self, pull: &Pull<R>, pair: &Pair<R>) {
        let mut part = Part::ZERO;
        curve(pull, pair, V3([R::ZERO; 3]), &mut part);
        self.value.add(&part, self.drift);
    }
}

impl<R: Real> Beside<R> {
    /// Adds what pulls and pushes at a segment, from the last one on.
    #[inline(always)]
    fn push<T: Touch<R>>(
        &mut self,
        strip: &Strip<R>,
        s: &Stage<R>,
        touch: (&T, usize),
        lean: V3<R>,
        part: &mut Part<R>,
    ) {
        let (end, guided) = (self.end.take(), lean.0 != [R::ZERO; 3]);
        if T::ACTIVE || self.pull.some() || end.is_some() || guided {
            let ([a, b], [c, d]) = (s.pair, self.far);
            let pulls = [self.pull.gradient, end.unwrap_or([V3([R::ZERO; 3]); 2])];
            let pushed = Pushed { x: [a, b, c, d], pulls, lean, rough: self.rough };
            add(part, &pushed.model(strip, &s.frame, touch));
            curve(&self.pull, &s.pair, s.frame.t * strip.half, part);
        }
        self.far = s.pair;
    }
}

/// Adds what else pulls at a segment.
fn add<R: Real>(part: &mut Part<R>, m: &Model<R>) {
    for (row, (xx, &xc)) in part.zz.iter_mut().zip(m.xx.iter().zip(&m.xc[0])) {
        row.iter_mut().zip(xx).for_each(|(v, &m)| *v += m);
        row[C] += xc;
    }
    let near = state(&m.xc[0], [R::ZERO, m.cc[0]]);
    part.zz[C].iter_mut().zip(near).for_each(|(v, m)| *v += m);
    part.z.iter_mut().zip(state(&m.x, [R::ZERO, m.c[0]])).for_each(|(v, m)| *v += m);
    let far = state(&m.xc[1], [R::ZERO, m.cc[1]]);
    part.tie[1].iter_mut().zip(far).for_each(|(v, m)| *v += m);
    (part.g[1], part.h[2]) = (part.g[1] + m.c[1], part.h[2] + m.cc[2]);
}

/// Adds the curvature terms of loads: rank one each, over `(ξ, c)`.
fn curve<R: Real>(pull: &Pull<R>, pair: &Pair<R>, slide: V3<R>, part: &mut Part<R>) {
    for (weight, [a, b]) in &pull.terms {
        let x = six(pair[0].cross(*a) + pair[1].cross(*b), *a + *b);
        let z = state(&x, [R::ZERO, slide.dot(*b - *a)]);
        for (row, &r) in part.zz.iter_mut().zip(&z) {
            let r = r * *weight;
            row.iter_mut().zip(&z).for_each(|(v, &z)| *v += r * z);
        }
    }
}
