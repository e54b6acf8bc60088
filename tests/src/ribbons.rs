//! Ribbon scenes that several tests play: a helix that unrolls, a long ribbon that falls, one that is twisted, a loop
//! that is pulled.

use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::joint::Crease;
use dogleaf_core::effect::ribbon::{
    Closure, Guide, Loads, Pull, Report, Ribbon, RibbonSpec, Root, Settings, Spring, Status,
};
use dogleaf_core::real::{Real, V3};
use std::f64::consts::PI;

/// Flexural rigidity of the scenes, newton metres: five sheets of office paper.
pub const RIGIDITY: f64 = 2e-3;

/// What the scenes are made of: a metre by five centimetres, a hundred grams per square metre.
pub fn spec(segments: usize) -> RibbonSpec {
    RibbonSpec { segments, rigidity_nm: RIGIDITY, ..RibbonSpec::default() }
}

/// A ribbon in a box.
///
/// # Panics
///
/// Where the spec is refused.
pub fn open<R: Real, const N: usize>(spec: &RibbonSpec) -> Box<Ribbon<R, N>> {
    let mut ribbon = Box::new(Ribbon::<R, N>::EMPTY);
    ribbon.open(spec, [0.0; 3]).expect("a sound spec");
    ribbon
}

/// The frame that a ribbon is laid from.
pub fn start<R: Real>() -> Frame<R> {
    Frame::at(V3([R::ZERO; 3]))
}

/// Three turns of a helix, clamped at one end, let go under gravity.
pub fn helix<R: Real, const N: usize>(spec: &RibbonSpec) -> Box<Ribbon<R, N>> {
    let mut ribbon = open::<R, N>(spec);
    ribbon.gravity = [0.0, -9.81, 0.0];
    let psi = R::of(6.0 * PI / spec.segments as f64);
    ribbon.lay(&start(), |_| Crease { psi, c: R::of(0.3) });
    ribbon
}

/// A ground that pushes back: `k/2 z²` below zero at every vertex.
#[derive(Debug, Clone, Copy)]
pub struct Ground {
    /// Newton per metre.
    pub stiffness: f64,
}

impl<R: Real> Loads<R> for Ground {
    fn energy(&self, _: usize, pair: &[V3<R>; 2]) -> R {
        let below = pair.iter().map(|p| (-p.0[2]).larger(R::ZERO));
        below.fold(R::ZERO, |sum, d| sum + d * d * R::of(0.5 * self.stiffness))
    }
    fn pull(&self, _: usize, pair: &[V3<R>; 2], pull: &mut Pull<R>) {
        let k = R::of(self.stiffness);
        let (none, up) = (V3([R::ZERO; 3]), V3([R::ZERO, R::ZERO, R::of(1.0)]));
        let [a, b] = pair.map(|p| (-p.0[2]).larger(R::ZERO));
        pull.push(up * (-k * a), up * (-k * b));
        if a > R::ZERO {
            pull.curve(k, [up, none]);
        }
        if b > R::ZERO {
            pull.curve(k, [none, up]);
        }
    }
}

/// A wavy ribbon of three metres, free, half a metre above the ground.
pub fn falling<R: Real, const N: usize>(segments: usize) -> Box<Ribbon<R, N>> {
    falling_from(segments, 0.5)
}

/// The same from another height, metres.
pub fn falling_from<R: Real, const N: usize>(segments: usize, height: f64) -> Box<Ribbon<R, N>> {
    let long = RibbonSpec { length_m: 3.0, root: Root::Free, ..spec(segments) };
    let mut ribbon = open::<R, N>(&long);
    ribbon.gravity = [0.0, 0.0, -9.81];
    let base = Frame::at(V3([0.0, 0.0, height].map(R::of)));
    let wave = |j: usize, k: f64| (j as f64 * k).sin();
    ribbon
        .lay(&base, |j| Crease { psi: R::of(0.1 * wave(j, 0.05)), c: R::of(0.2 * wave(j, 0.03)) });
    ribbon
}

/// Turns the end's normal to an angle about the ribbon's axis.
pub fn twist<R: Real, const N: usize>(ribbon: &mut Ribbon<R, N>, angle: f64, stiffness: f64) {
    let normal = V3([0.0, -angle.sin(), angle.cos()].map(R::of));
    let segment = ribbon.spec().segments - 1;
    ribbon.ask.guides.clear();
    let guide = Guide { segment, normal, stiffness: R::of(stiffness) };
    assert!(ribbon.ask.guides.push(guide).is_ok(), "one guide fits");
}

/// A free ring or Möbius band of five grams at rest, and a spring from one of its corners to a point a metre away.
pub fn pulled<R: Real, const N: usize>(
    segments: usize,
    closure: Closure,
    stiffness: f64,
) -> Box<Ribbon<R, N>> {
    let spec = RibbonSpec { closure, root: Root::Free, regularisation: 4e-2, ..spec(segments) };
    let mut ribbon = open::<R, N>(&spec);
    ribbon.gravity = [0.0, 0.0, -9.81];
    ribbon.wind(&start(), &Settings::EXACT);
    if stiffness > 0.0 {
        let crease = segments / 3;
        let from = ribbon.pairs().nth(crease).map_or(start().p, |pair| pair[0]);
        let target = from + V3([0.7, 0.5, 0.5].map(R::of));
        let spring = Spring { crease, rim: 0, target, stiffness: R::of(stiffness) };
        assert!(ribbon.ask.springs.push(spring).is_ok(), "one spring fits");
    }
    ribbon
}

/// How many Newton iterations a step needs to come within a share of its best objective, where it does.
pub fn iterations_to<const N: usize>(
    ribbon: &Ribbon<f64, N>,
    h: f64,
    loads: &impl Loads<f64>,
    share: f64,
) -> Option<usize> {
    let mut copy = Box::new(ribbon.clone());
    let thorough = copy.settings.thorough;
    copy.settings = Settings { iterations: 300, tolerance: 1e-9, thorough, ..Settings::EXACT };
    let mut trace = Vec::new();
    copy.step_watched(h, loads, |f, _| trace.push(f));
    let (first, best) = (trace[0], trace.iter().copied().fold(f64::INFINITY, f64::min));
    trace.iter().position(|f| f - best <= share * (first - best))
}

/// The largest change of a rim edge's length, as a share of the edge's length in the flat ribbon.
pub fn stretch<R: Real, const N: usize>(ribbon: &Ribbon<R, N>) -> f64 {
    let spec = ribbon.spec();
    let cell = spec.length_m / spec.segments as f64;
    let slopes: Vec<f64> = ribbon.creases().map(|c| c.c.wide()).chain([0.0]).collect();
    let pairs: Vec<_> = ribbon.pairs().collect();
    let mut worst: f64 = 0.0;
    for (pair, c) in pairs.windows(2).zip(slopes.windows(2)) {
        let spread = 0.5 * spec.width_m * (c[1] - c[0]);
        for (rim, rest) in [(0, cell - spread), (1, cell + spread)] {
            let [a, b] = [pair[0][rim], pair[1][rim]].map(|v| V3(v.0.map(Real::wide)));
            worst = worst.max(((b - a).norm() - rest).abs() / cell);
        }
    }
    worst
}

/// Every number of a ribbon's pose is finite.
pub fn finite<R: Real, const N: usize>(ribbon: &Ribbon<R, N>) -> bool {
    let pose = ribbon.pairs().flatten().chain(ribbon.velocities_now().flatten());
    pose.flat_map(|v| v.0).all(Real::finite)
}

/// Whether a report names an end that the numbers bear out: converged is a small step, or no fall beyond rounding.
pub fn honest<R: Real>(report: &Report<R>, settings: &Settings) -> bool {
    let small = report.size.wide() <= settings.tolerance && report.gap.wide() <= settings.closure;
    let rounding = 32.0 * R::EPSILON * report.objective.wide().abs();
    report.status != Status::Converged || small || report.fall.wide().abs() <= rounding
}
