//! The gradient of a step's objective by angles and slopes, and nothing else: what a method without a Hessian pays.
//!
//! The core's own gradient goes the way of its Hessian, which would make the seed's method seem three times dearer than
//! it is. This one is Ribbon App. C as rigid-body statics: the moment about a crease's axis of all that pulls beyond it.

use dogleaf_core::effect::ribbon::bending;
use dogleaf_core::effect::ribbon::body::{Body, Stage};
use dogleaf_core::effect::ribbon::frame::{Six, dot6, six};
use dogleaf_core::effect::ribbon::joint::{Crease, about};
use dogleaf_core::effect::ribbon::load::Ask;
use dogleaf_core::effect::ribbon::resample::{Pair, Sample};
use dogleaf_core::effect::ribbon::strip::Strip;
use dogleaf_core::effect::ribbon::{Loads, Pull};
use dogleaf_core::real::V3;

const NONE: V3<f64> = V3([0.0; 3]);

/// What follows a segment.
struct Next<'a> {
    pair: Pair<f64>,
    want: &'a [Sample<f64>; 2],
    crease: Crease<f64>,
    /// Loads at the end; those of a crease are counted with the segment beyond it.
    pulled: Pair<f64>,
}

/// A segment's share: wrench on it, and slopes of both its creases.
struct Share {
    wrench: Six<f64>,
    c: [f64; 2],
}

/// Writes the gradient of an evaluated body in motion; answers the start's.
pub fn gradient<const N: usize>(
    body: &Body<f64, N>,
    ask: &Ask<f64>,
    loads: &impl Loads<f64>,
    psi: &mut [f64],
    slope: &mut [f64],
) -> Six<f64> {
    let (strip, used, end) = (&body.strip, body.used(), &body.end);
    let pulled = pulls(ask, loads, strip.n, &end.pair);
    let mut next = Next { pair: end.pair, want: &end.want, crease: Crease::default(), pulled };
    let [mut beyond, at_start] =
        if body.looped() { body.hold.gradient(&body.gap) } else { [[0.0; 6]; 2] };
    psi.fill(0.0);
    slope.fill(0.0);
    for (j, s) in used.iter().enumerate().rev() {
        let own = pulls(ask, loads, j, &s.pair);
        let share = share(strip, body.motion.kappa, s, &next, own, lean(ask, j));
        let bent = bending::derivatives(strip, j, s.crease, next.crease).g;
        if j + 1 < strip.n {
            psi[j + 1] += bent[2];
            slope[j + 1] += bent[3] + share.c[1];
        }
        beyond.iter_mut().zip(&share.wrench).for_each(|(b, w)| *b += w);
        let (frame, step) =
            if j == 0 { (&body.base, 0.0) } else { (&used[j - 1].frame, strip.cell) };
        let axes = s.turn.axes(frame).map(|a| about(a, frame.p + frame.t * step));
        psi[j] += dot6(&axes[0], &beyond) + bent[0];
        slope[j] += dot6(&axes[1], &beyond) + bent[1] + share.c[0];
        next = Next { pair: s.pair, want: &s.want, crease: s.crease, pulled: [NONE; 2] };
    }
    std::array::from_fn(|i| beyond[i] + at_start[i])
}

fn share(
    strip: &Strip<f64>,
    kappa: f64,
    s: &Stage<f64>,
    next: &Next<'_>,
    own: Pair<f64>,
    lean: V3<f64>,
) -> Share {
    let (t, half) = (s.frame.t, strip.half);
    let x = [s.pair[0], s.pair[1], next.pair[0], next.pair[1]];
    let want = [&s.want[0], &s.want[1], &next.want[0], &next.want[1]];
    let d = [0, 1, 2, 3].map(|i| x[i] - want[i].y);
    let spread = next.crease.c - s.crease.c;
    let inertia = strip.mass.times(spread, &d).map(|f| f * kappa);
    let grown = strip.mass.grown(&d);
    let swell = 0.5 * kappa * (0..4).map(|i| grown[i].dot(d[i])).sum::<f64>();
    let slide = |i: usize| inertia[i].dot(t - want[i].dy) * half;
    let extra = [own[0], own[1], next.pulled[0], next.pulled[1]];
    let (mut torque, mut force) = (s.frame.n.cross(lean), NONE);
    for i in 0..4 {
        let f = inertia[i] + extra[i];
        (torque, force) = (torque + x[i].cross(f), force + f);
    }
    let c = slide(1) - slide(0) - swell + t.dot(own[1] - own[0]) * half;
    Share { wrench: six(torque, force), c: [c, slide(3) - slide(2) + swell] }
}

fn pulls(ask: &Ask<f64>, loads: &impl Loads<f64>, j: usize, pair: &Pair<f64>) -> Pair<f64> {
    let mut pull = Pull::none();
    loads.pull(j, pair, &mut pull);
    ask.pull(j, pair, &mut pull);
    pull.gradient
}

/// What pulls at a segment's normal.
fn lean(ask: &Ask<f64>, segment: usize) -> V3<f64> {
    let own = ask.guides.iter().filter(|g| g.segment == segment);
    own.fold(NONE, |sum, g| sum - g.normal * g.stiffness)
}
