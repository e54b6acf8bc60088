//! What momentum a ribbon has, and a step that keeps it.
//!
//! ```text
//! P = Σ M v    L = Σ (x - x̄) × M v    v ← v + ΔP/m + I⁻¹ΔL × (x - x̄)
//! ```
//!
//! Reading the last step's vertices where the new ones are loses some of both, see [`resample`](super::resample). Where
//! nothing but weight acts they are known, and the rigid motion that is missing is given back after the step.
//!
//! Source: ours. Checked by `tests/ribbon_momentum.rs`.

use super::body::Body;
use super::inertia::Four;
use super::life::Ribbon;
use super::report::{Report, Status};
use crate::real::{Real, V3};
use nalgebra::{SMatrix, SVector};

/// Share of the mean moment of inertia below which one counts for none: a line does not spin about itself.
const LEAST: f64 = 1e-6;

/// Momentum of a ribbon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Momentum<R> {
    /// Kilograms.
    pub mass: R,
    /// Centre of mass, in the ribbon's own coordinates, metres.
    pub middle: V3<R>,
    /// Kilogram metres per second.
    pub linear: V3<R>,
    /// About the centre of mass, kilogram square metres per second.
    pub angular: V3<R>,
}

impl<R: Real, const N: usize> Ribbon<R, N> {
    /// Its momentum now.
    ///
    /// # Cost
    ///
    /// Some 150 operations a segment.
    pub fn momentum(&self) -> Momentum<R> {
        let strip = &self.posed().strip;
        let o = V3([R::ZERO; 3]);
        let (mut moment, mut linear, mut angular) = (o, o, o);
        for (spread, x, v) in cells(self.posed()) {
            moment = strip.mass.times(spread, &x).iter().fold(moment, |s, &m| s + m);
            let moved = strip.mass.times(spread, &v);
            linear = moved.iter().fold(linear, |s, &m| s + m);
            angular = turning(angular, &x, &moved);
        }
        let mass = strip.cell_mass() * R::of(strip.n as f64);
        let middle = moment * (R::one() / mass);
        Momentum { mass, middle, linear, angular: angular - middle.cross(linear) }
    }

    /// Gives its vertices the rigid motion that makes its momentum what is wanted; of what is wanted, mass and centre do
    /// not count.
    ///
    /// # Accuracy
    ///
    /// Rounding; of a turn about an axis with next to no moment of inertia, a part.
    pub fn restore(&mut self, wanted: &Momentum<R>) {
        let now = self.momentum();
        let shift = (wanted.linear - now.linear) * (R::one() / now.mass);
        let spin = self.spin(now.middle, wanted.angular - now.angular);
        let more = |x: V3<R>| shift + spin.cross(x - now.middle);
        let (body, _) = self.memory();
        for s in body.used_mut() {
            let ([a, b], [u, v]) = (s.pair, s.velocity);
            s.velocity = [u + more(a), v + more(b)];
        }
        let ([a, b], [u, v]) = (body.end.pair, body.end.velocity);
        body.end.velocity = [u + more(a), v + more(b)];
    }

    /// [`Ribbon::step`] of a ribbon that nothing holds, pulls or touches: it keeps its momentum, but for weight and for
    /// the fading that its spec asks for. Of one with a clamp, springs or guides it is that step.
    ///
    /// # Accuracy
    ///
    /// Momentum to rounding. What a step itself errs by, of first order in `h`, is as before.
    ///
    /// # Errors
    ///
    /// As [`Ribbon::step`].
    ///
    /// # Hard case
    ///
    /// It does not see what a caller lets act beside it: where there is contact, take [`Ribbon::step_touching`].
    pub fn step_free(&mut self, h: f64) -> Report<R> {
        let pulled = !(self.ask.springs.is_empty() && self.ask.guides.is_empty());
        if pulled || !self.posed().strip.free {
            return self.step(h);
        }
        let before = self.momentum();
        let report = self.step(h);
        if report.status == Status::Held {
            return report;
        }
        let keep = R::of((-self.spec().damping_per_s * h).exponential());
        let fall = V3(self.gravity.map(|g| R::of(g * h)));
        let linear = before.linear * keep + fall * before.mass;
        self.restore(&Momentum { linear, angular: before.angular * keep, ..before });
        report
    }

    /// The turn that has so much angular momentum.
    fn spin(&self, middle: V3<R>, angular: V3<R>) -> V3<R> {
        let (body, o) = (self.posed(), V3([R::ZERO; 3]));
        let column = |axis: V3<R>| {
            cells(body).fold(o, |sum, (spread, x, _)| {
                let way = x.map(|x| x - middle);
                let moved = body.strip.mass.times(spread, &way.map(|w| axis.cross(w)));
                turning(sum, &way, &moved)
            })
        };
        let (l, z) = (R::one(), R::ZERO);
        let columns = [[l, z, z], [z, l, z], [z, z, l]].map(|axis| column(V3(axis)).0);
        let trace = columns[0][0] + columns[1][1] + columns[2][2];
        let at = |r: usize, c: usize| {
            let entry = columns.get(c).and_then(|column| column.get(r)).copied().unwrap_or(z);
            if r == c { entry + trace * R::of(LEAST) } else { entry }
        };
        let mut a = SMatrix::<R, 3, 3>::from_fn(at);
        let mut b = SVector::<R, 3>::from(angular.0);
        if R::solve_small(&mut a, &mut b) { V3([b.x, b.y, b.z]) } else { o }
    }
}

/// Spread, vertices and their velocities of every segment.
fn cells<R: Real, const N: usize>(
    body: &Body<R, N>,
) -> impl Iterator<Item = (R, Four<V3<R>>, Four<V3<R>>)> {
    let own = body.used().iter();
    let end = (R::ZERO, body.end.pair, body.end.velocity);
    let next = own.clone().skip(1).map(|s| (s.kept.c, s.pair, s.velocity));
    own.zip(next.chain(core::iter::once(end))).map(|(s, (c, [p, q], [u, v]))| {
        let ([a, b], [d, e]) = (s.pair, s.velocity);
        (c - s.kept.c, [a, b, p, q], [d, e, u, v])
    })
}

/// `Σ x × m`, added.
fn turning<R: Real>(sum: V3<R>, x: &Four<V3<R>>, m: &Four<V3<R>>) -> V3<R> {
    x.iter().zip(m).fold(sum, |sum, (x, &m)| sum + x.cross(m))
}
