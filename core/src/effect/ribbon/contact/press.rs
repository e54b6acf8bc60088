//! Energy, pushes and limits of what is near a ribbon.
//!
//! The others stand still while one ribbon is solved for. Of two segments of one ribbon both are pushed; what couples
//! them is left out of the Hessian, which counts each side twice for it, so it stays above the true one.

use super::advance;
use super::distance::{Bounds, Meeting, Parts, Quad, meetings};
use super::near::{LAST, Near, Pairing};
use super::push::{FLOOR, SOLID, barrier};
use super::surface::Surface;
use super::touch::{By, Pose, Push, Touch, Touched};
use crate::effect::ribbon::inertia::Four;
use crate::real::{Real, V3};
use heapless::Vec;

/// Share of the way to a surface that a trial may go.
const SHARE: f64 = 0.9;
/// How far one that is pressed into a surface may sink in a trial, as a share of the barrier's reach.
const SINKS: f64 = 0.1;
/// Meetings of two segments at most.
const MEETINGS: usize = 24;
/// Solids that push one vertex at once.
const SOLIDS: usize = 8;

impl<R: Real, S: Surface<R>, const N: usize, const O: usize, const K: usize> Near<R, S, N, O, K> {
    /// What a pair's segments have for themselves.
    fn parts(&self, pair: Pairing) -> [Parts; 2] {
        let last = |k: u16| Parts::own(!self.looped && usize::from(k) + 1 == self.n);
        let other = self.others.get(usize::from(pair.other)).map(|o| o.1);
        let there = if pair.own { last(pair.other) } else { other.unwrap_or(Parts::ALL) };
        [last(pair.segment), there]
    }
    fn other(&self, pair: Pairing, pose: impl Fn(usize) -> Quad<R>) -> Quad<R> {
        let k = usize::from(pair.other);
        if pair.own {
            return pose(k);
        }
        self.others.get(k).map_or([V3([R::of(f64::INFINITY); 3]); 4], |o| o.0)
    }
    /// A pair's meetings within the barrier's reach, and their distances.
    fn each(&self, pair: Pairing, pose: &Pose<'_, R>, mut take: impl FnMut(&Meeting<R>, R)) {
        let reach = R::of(self.cushion.reach_m);
        let a = pose.corners(usize::from(pair.segment));
        let b = self.other(pair, |k| pose.corners(k));
        if !Bounds::of(&a).within(&Bounds::of(&b), reach) {
            return;
        }
        meetings([&a, &b], self.parts(pair), |m| {
            let sq = m.way.norm_sq();
            if sq < reach * reach && sq > R::ZERO {
                take(m, sq.root());
            }
        });
    }
    /// Hands over what is nearer than the reach at a pose: shares here and there, the way apart, the distance.
    pub(super) fn overlaps(
        &self,
        pose: &Pose<'_, R>,
        mut take: impl FnMut(Pairing, Four<R>, Four<R>, V3<R>, R),
    ) {
        for &pair in &self.pairs {
            self.each(pair, pose, |m, d| take(pair, m.here, m.there, m.way * (R::one() / d), d));
        }
    }
    /// Creases that the ground may push: a loop's last is its first.
    fn creases(&self) -> core::ops::Range<usize> {
        0..self.n + usize::from(!self.looped)
    }
    /// The segment that answers for a crease, and the shares of its two vertices there.
    fn answering(&self, crease: usize) -> (usize, [Four<R>; 2]) {
        let (o, l) = (R::ZERO, R::of(1.0));
        if crease >= self.n {
            return (crease - 1, [[o, o, l, o], [o, o, o, l]]);
        }
        (crease, [[l, o, o, o], [o, l, o, o]])
    }
    fn press_on_surface(&mut self, crease: usize, pose: &Pose<'_, R>) {
        let (segment, shares) = self.answering(crease);
        for (rim, (p, weights)) in pose.pair(crease).into_iter().zip(shares).enumerate() {
            let mut found = Vec::<Push<R>, SOLIDS>::new();
            self.surface.each_of(2 * crease + rim, p, |d, normal| {
                let [_, slope, curve] = barrier(&self.cushion, d, S::FLOOR);
                if curve > R::ZERO {
                    let _ = found.push(Push { weights, normal, slope, curve });
                }
            });
            found.into_iter().for_each(|push| self.keep(segment, push));
        }
    }
    fn press_pair(&mut self, pair: Pairing, pose: &Pose<'_, R>) {
        let cushion = self.cushion;
        let twice = R::of(if pair.own { 2.0 } else { 1.0 });
        let mut found = Vec::<Meeting<R>, MEETINGS>::new();
        self.each(pair, pose, |m, _| {
            let _ = found.push(*m);
        });
        for m in &found {
            let d = m.way.norm();
            let ([_, slope, curve], normal) = (barrier(&cushion, d, FLOOR), m.way * (R::one() / d));
            let here = Push { weights: m.here, normal, slope, curve: curve * twice };
            self.keep(usize::from(pair.segment), here);
            if pair.own {
                let there = Push { weights: m.there, normal: -normal, ..here };
                self.keep(usize::from(pair.other), there);
            }
        }
    }
    fn keep(&mut self, segment: usize, push: Push<R>) {
        let place = self.pushes.len() as u16;
        let Some(head) = self.heads.get_mut(segment) else { return };
        match self.pushes.push((push, *head)) {
            Ok(()) => *head = place,
            Err(_) => self.counts.crowded += 1,
        }
    }
    /// What a pair's other segment is.
    fn by(&self, pair: Pairing, weights: Four<R>) -> By<R> {
        if pair.own {
            return By::Itself { segment: usize::from(pair.other), weights };
        }
        let place = self.others.get(usize::from(pair.other)).map_or([0; 2], |o| o.2);
        let [ribbon, segment] = place.map(usize::from);
        By::Other { ribbon, segment, weights }
    }
    /// Where a crease was before the step.
    fn set_out(&self, crease: usize) -> [V3<R>; 2] {
        let none = [V3([R::ZERO; 3]); 2];
        if crease < self.n {
            self.own.get(crease).map_or(none, |[a, b, _, _]| [*a, *b])
        } else {
            self.own.get(self.n.saturating_sub(1)).map_or(none, |[_, _, c, d]| [*c, *d])
        }
    }
    /// How far a trial may go for a vertex' sake.
    fn limit(&self, [from, to]: [V3<R>; 2], set_out: V3<R>, range: R) -> R {
        // A ground is looked at wherever a vertex goes; of others only what was near is known.
        let gone = (to - set_out).norm_sq();
        if (self.itself || !self.others.is_empty()) && gone > range * range {
            return (R::of(SHARE) * range / gone.root()).smaller(R::of(0.5));
        }
        if !S::HARD {
            return R::one();
        }
        let mut befores = Vec::<R, SOLIDS>::new();
        self.surface.each(from, |d, _| {
            let _ = befores.push(d);
        });
        // What is pressed that hard is held by the barrier's parabola alone, yet sinks but slowly.
        let reach = R::of(self.cushion.reach_m);
        let (hard, sinks) = (reach * R::of(SOLID), reach * R::of(SINKS));
        let (mut share, mut befores) = (R::of(1.0), befores.into_iter());
        self.surface.each(to, |after, _| {
            let Some(before) = befores.next() else { return };
            let least = if before <= hard { before.smaller(R::ZERO) - sinks } else { R::ZERO };
            if after <= least {
                share = share.smaller(R::of(SHARE) * (before - least) / (before - after));
            }
        });
        share
    }
}

impl<R: Real, S: Surface<R>, const N: usize, const O: usize, const K: usize> Touch<R>
    for Near<R, S, N, O, K>
{
    fn energy(&mut self, pose: &Pose<'_, R>) -> R {
        let mut sum = R::ZERO;
        for (vertex, p) in self.creases().flat_map(|k| pose.pair(k)).enumerate() {
            self.surface.each_of(vertex, p, |d, _| sum += barrier(&self.cushion, d, S::FLOOR)[0]);
        }
        for &pair in &self.pairs {
            self.each(pair, pose, |_, d| sum += barrier(&self.cushion, d, FLOOR)[0]);
        }
        sum
    }
    fn press(&mut self, pose: &Pose<'_, R>) {
        self.heads = [LAST; N];
        self.pushes.clear();
        for k in self.creases() {
            self.press_on_surface(k, pose);
        }
        for place in 0..self.pairs.len() {
            if let Some(&pair) = self.pairs.get(place) {
                self.press_pair(pair, pose);
            }
        }
        self.counts.pushes = self.pushes.len() as u32;
    }
    fn pushes(&self, segment: usize, mut take: impl FnMut(&Push<R>)) {
        let mut place = self.heads.get(segment).copied().unwrap_or(LAST);
        for _ in 0..self.pushes.len() {
            let Some((push, next)) = self.pushes.get(usize::from(place)) else { break };
            take(push);
            place = *next;
        }
    }
    fn free(&mut self, pose: &Pose<'_, R>, range: R) -> R {
        if !S::HARD && !self.full && !self.itself && self.others.is_empty() {
            return R::one();
        }
        let range = self.range * range;
        let mut share = if self.full { R::ZERO } else { R::of(1.0) };
        let least = R::of(FLOOR * self.cushion.reach_m);
        for crease in self.creases() {
            let start = self.set_out(crease);
            for ((p, q), s) in pose.kept_pair(crease).into_iter().zip(pose.pair(crease)).zip(start)
            {
                share = share.smaller(self.limit([p, q], s, range));
            }
        }
        for &pair in &self.pairs {
            let k = usize::from(pair.segment);
            let (from, to) = (pose.kept(k), pose.corners(k));
            let there = [self.other(pair, |k| pose.kept(k)), self.other(pair, |k| pose.corners(k))];
            share = advance::free([&from, &to], [&there[0], &there[1]], share, least);
        }
        self.counts.limited += u32::from(share < R::of(1.0));
        share
    }
    fn touched(&self, pose: &Pose<'_, R>, mut take: impl FnMut(&Touched<R>)) {
        let reach = R::of(self.cushion.reach_m);
        for crease in self.creases() {
            let (segment, shares) = self.answering(crease);
            for (p, weights) in pose.pair(crease).into_iter().zip(shares) {
                self.surface.each(p, |d, normal| {
                    if d < reach {
                        take(&Touched { segment, weights, normal, by: By::Ground });
                    }
                });
            }
        }
        for &pair in &self.pairs {
            self.each(pair, pose, |m, d| {
                let (segment, normal) = (usize::from(pair.segment), m.way * (R::one() / d));
                take(&Touched { segment, weights: m.here, normal, by: self.by(pair, m.there) });
            });
        }
    }
}
