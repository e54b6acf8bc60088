//! What a step would sound like: how fast a ribbon met something, and how much bending it let go at once.
//!
//! A caller who wants to know places an [`Ear`] beside each ribbon. Nothing of it is in a ribbon, or in a step without one.
//!
//! Source: ours. Checked by `tests/ribbon_event.rs`.

use super::contact::crowd::step_each;
use super::contact::touch::{By, Touch, Touched};
use super::contact::{Near, Summary, Surface};
use super::inertia::Four;
use super::life::Ribbon;
use super::load::Loads;
use super::report::{Report, Status};
use super::resample::Pair;
use crate::real::{Real, V3};

/// What a step would sound like.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sound<R> {
    /// Vertices that touch something since this step, and met it faster than the ear's quietest.
    pub touches: u32,
    /// The largest speed at which one of those and what it met came together along their normal, metres per second.
    pub speed: R,
    /// Bending energy let go in the step, joules, where that is more than the ear's least power; else zero.
    pub snap: R,
}

/// Which vertices of up to `N` segments touch something: a bit each.
#[derive(Debug, Clone, Copy)]
struct Marks<const N: usize> {
    creases: [u8; N],
    end: u8,
}

impl<const N: usize> Marks<N> {
    const NONE: Self = Self { creases: [0; N], end: 0 };

    /// The bits of a crease of a ribbon of `n` segments.
    fn of(&mut self, crease: usize, n: usize) -> &mut u8 {
        let own = if crease < n { self.creases.get_mut(crease) } else { None };
        own.unwrap_or(&mut self.end)
    }
    fn count(&self) -> u32 {
        self.creases.iter().fold(self.end.count_ones(), |sum, bits| sum + bits.count_ones())
    }
}

/// Listens to one ribbon of at most `N` segments; placed by the caller: some six numbers a segment.
#[derive(Debug, Clone)]
pub struct Ear<R, const N: usize> {
    /// What meets more slowly is not heard, metres per second.
    pub quietest_m_per_s: f64,
    /// Bending that is let go at less than this is no snap, watts.
    pub least_w: f64,
    /// Velocities before the step.
    speeds: [Pair<R>; N],
    end: Pair<R>,
    /// Bending energy before the step.
    bending: R,
    /// What touched something after the last step.
    touching: Marks<N>,
}

impl<R: Real, const N: usize> Ear<R, N> {
    /// For the caller to place.
    pub const NEW: Self = Self {
        quietest_m_per_s: 1e-2,
        least_w: 1e-2,
        speeds: [[V3([R::ZERO; 3]); 2]; N],
        end: [V3([R::ZERO; 3]); 2],
        bending: R::ZERO,
        touching: Marks::NONE,
    };

    /// [`Ribbon::step_touching`], heard. Ribbons added to `near` are heard as if they stood still; where they move too,
    /// see [`step_all_heard`].
    ///
    /// # Cost
    ///
    /// A look for what touches, as one evaluation of contact's energy; and two of the ribbon's.
    pub fn step(
        &mut self,
        ribbon: &mut Ribbon<R, N>,
        h: f64,
        loads: &impl Loads<R>,
        touch: &mut impl Touch<R>,
    ) -> (Report<R>, Sound<R>) {
        self.before(ribbon);
        let report = ribbon.step_touching(h, loads, touch);
        let still = [V3([R::ZERO; 3]); 4];
        (report, self.after(ribbon, h, &report, touch, |_, _| still))
    }

    /// Takes in how a ribbon is before a step.
    pub fn before(&mut self, ribbon: &Ribbon<R, N>) {
        let body = ribbon.posed();
        self.speeds.iter_mut().zip(body.used()).for_each(|(speed, s)| *speed = s.velocity);
        self.end = body.end.velocity;
        self.bending = ribbon.energy().bending;
    }

    /// What the step since [`Ear::before`] sounds like; `other` answers the velocities of a segment of another ribbon:
    /// how many were added to what is near before it, and which segment.
    ///
    /// # Accuracy
    ///
    /// Speeds are those before the step: what gravity adds within it, `g h`, is not heard.
    pub fn after(
        &mut self,
        ribbon: &Ribbon<R, N>,
        h: f64,
        report: &Report<R>,
        touch: &impl Touch<R>,
        other: impl Fn(usize, usize) -> Four<V3<R>>,
    ) -> Sound<R> {
        let mut sound = Sound { touches: 0, speed: R::ZERO, snap: R::ZERO };
        if report.status == Status::Held {
            return sound;
        }
        let released = self.bending - ribbon.energy().bending;
        if released > R::of(self.least_w * h) {
            sound.snap = released;
        }
        let (n, quietest) = (ribbon.spec().segments, R::of(self.quietest_m_per_s));
        let (mut now, mut fresh) = (Marks::<N>::NONE, Marks::<N>::NONE);
        touch.touched(&ribbon.posed().pose(), |t| {
            let (crease, bit) = vertex(t);
            *now.of(crease, n) |= bit;
            let speed = self.closing(t, n, &other);
            if speed > quietest && *self.touching.of(crease, n) & bit == 0 {
                *fresh.of(crease, n) |= bit;
                sound.speed = sound.speed.larger(speed);
            }
        });
        sound.touches = fresh.count();
        self.touching = now;
        sound
    }

    /// How fast two points that touch came together.
    fn closing(&self, t: &Touched<R>, n: usize, other: impl Fn(usize, usize) -> Four<V3<R>>) -> R {
        let here = mean(&self.segment(t.segment, n), &t.weights);
        let there = match &t.by {
            By::Ground => V3([R::ZERO; 3]),
            By::Itself { segment, weights } => mean(&self.segment(*segment, n), weights),
            By::Other { ribbon, segment, weights } => mean(&other(*ribbon, *segment), weights),
        };
        (there - here).dot(t.normal)
    }

    /// Velocities of a segment before the step.
    fn segment(&self, segment: usize, n: usize) -> Four<V3<R>> {
        let pair = |k: usize| if k < n { self.speeds.get(k) } else { None }.unwrap_or(&self.end);
        let ([a, b], [c, d]) = (*pair(segment), *pair(segment + 1));
        [a, b, c, d]
    }
}

/// The crease and the bit of the vertex that is nearest to where a segment is touched.
fn vertex<R: Real>(t: &Touched<R>) -> (usize, u8) {
    let [a, b, c, d] = t.weights;
    let (near, far) = (a.larger(b), c.larger(d));
    let (crease, second) = if far > near { (t.segment + 1, d > c) } else { (t.segment, b > a) };
    (crease, 1 << u8::from(second))
}

fn mean<R: Real>(four: &Four<V3<R>>, weights: &Four<R>) -> V3<R> {
    let shares = four.iter().zip(weights);
    shares.fold(V3([R::ZERO; 3]), |sum, (&v, &w)| sum + v * w)
}

/// [`step_all`](super::contact::step_all), heard: an ear for each ribbon, in the same order. `hear` gets the number of a
/// ribbon and what its step sounds like. A meeting of two is heard by the one, the other, or both.
pub fn step_all_heard<R: Real, S: Surface<R>, const N: usize, const O: usize, const K: usize>(
    ribbons: &mut [Ribbon<R, N>],
    h: f64,
    near: &mut Near<R, S, N, O, K>,
    ears: &mut [Ear<R, N>],
    mut hear: impl FnMut(usize, Sound<R>),
) -> Summary<R> {
    step_each(ribbons, h, near, |i, ribbon, near, [before, after]| {
        let Some(ear) = ears.get_mut(i) else { return ribbon.step_touching(h, &(), near) };
        ear.before(ribbon);
        let report = ribbon.step_touching(h, &(), near);
        let other = |k: usize, segment: usize| {
            let found = before.get(k).or_else(|| after.get(k.checked_sub(before.len())?));
            found.map_or([V3([R::ZERO; 3]); 4], |ribbon| speeds(ribbon, segment))
        };
        hear(i, ear.after(ribbon, h, &report, near, other));
        report
    })
}

/// Velocities of a segment now.
fn speeds<R: Real, const N: usize>(ribbon: &Ribbon<R, N>, segment: usize) -> Four<V3<R>> {
    let body = ribbon.posed();
    let pair = |k: usize| body.used().get(k).map_or(body.end.velocity, |s| s.velocity);
    let ([a, b], [c, d]) = (pair(segment), pair(segment + 1));
    [a, b, c, d]
}
