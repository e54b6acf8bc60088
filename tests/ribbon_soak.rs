//! Promise: a ribbon lives through a million steps of random pulls and twists, of a thousandth to a twentieth of a second,
//! in a box, in its own way: no number that is none, no panic, nothing allocated, every edge of its rims as long as it was.
//!
//! `RIBBON_STEPS=1000000 cargo test --profile swift -p dogleaf-tests --test ribbons soak -- --nocapture` plays so many of
//! each kind; some hundreds without it.

use crate::tally::asked;
use dogleaf_core::effect::ribbon::contact::{Cushion, HalfSpace, Near};
use dogleaf_core::effect::ribbon::{Closure, RibbonSpec, Root, Spring, Status};
use dogleaf_core::effect::ribbon::{Report, Ribbon};
use dogleaf_core::real::{Real, V3};
use dogleaf_tests::random::Pcg;
use dogleaf_tests::ribbons::{finite, open, spec, start, stretch, twist};
use std::io::Write as _;

/// Segments.
const N: usize = 20;
/// The walls around.
type Walls<R> = [HalfSpace<R>; 6];
type Around<R> = Near<R, Walls<R>, N, 1, 2048>;

/// A room of four metres.
fn walls<R: Real>() -> Walls<R> {
    [0, 1, 2, 3, 4, 5].map(|k| {
        let mut inwards = [0.0; 3];
        inwards[k / 2] = if k % 2 == 0 { 1.0 } else { -1.0 };
        let normal = V3(inwards.map(R::of));
        HalfSpace { point: normal * R::of(-2.0), normal }
    })
}

/// A pull, a twist or neither, and a step of any length.
fn disturb<R: Real>(ribbon: &mut Ribbon<R, N>, most: f64, random: &mut Pcg) -> f64 {
    ribbon.ask.springs.clear();
    ribbon.ask.guides.clear();
    match random.below(3) {
        0 => {
            let (crease, rim) = (1 + random.below(N - 1), random.below(2));
            let stiffness = R::of(10_f64.powf(random.within(0.0, most.log10())));
            let target = V3(random.v3().0.map(R::of));
            let spring = Spring { crease, rim, target, stiffness };
            assert!(ribbon.ask.springs.push(spring).is_ok(), "one fits");
        }
        1 => twist(ribbon, random.within(-6.0, 6.0), random.within(0.0, 10.0)),
        _ => {}
    }
    10_f64.powf(random.within(-3.0, 0.05_f64.log10()))
}

/// What came of it.
#[derive(Debug, Default)]
struct Sum {
    capped: u32,
    stalled: u32,
    held: u32,
    iterations: u64,
    limited: u64,
    asked: u64,
    stretch_m: f64,
    gap: f64,
}

impl Sum {
    fn take<R: Real>(&mut self, report: &Report<R>) {
        self.capped += u32::from(report.status == Status::Capped);
        self.stalled += u32::from(report.status == Status::Stalled);
        self.held += u32::from(report.status == Status::Held);
        self.iterations += u64::from(report.iterations);
        self.gap = self.gap.max(report.gap.wide());
    }
}

/// With `most` newton per metre at most; where that is gentle, it touches itself.
fn soak<R: Real>(name: &str, change: impl Fn(&mut RibbonSpec), most: f64, seed: u64) {
    let steps = std::env::var("RIBBON_STEPS").ok().and_then(|s| s.parse().ok()).unwrap_or(400);
    let mut random = Pcg::new(seed);
    let mut own = RibbonSpec { damping_per_s: 1.0, ..spec(N) };
    change(&mut own);
    let mut ribbon = open::<R, N>(&own);
    if own.closure != Closure::Open {
        let settings = ribbon.settings;
        ribbon.wind(&start(), &settings);
    }
    ribbon.gravity = [0.0, -9.81, 0.0];
    let mut near = Box::new(Around::<R>::over(walls(), Cushion::default()));
    near.itself = most < 100.0;
    let (mut sum, mut h) = (Sum::default(), 0.01);
    for step in 0..steps {
        if step % 10 == 0 {
            h = disturb(&mut ribbon, most, &mut random);
        }
        sum.asked += asked(|| {
            near.begin(&ribbon, h);
            let walled = own.root == Root::Free;
            sum.take(&if walled {
                ribbon.step_touching(h, &(), &mut *near)
            } else {
                ribbon.step(h)
            });
        });
        sum.limited += u64::from(near.counts.limited);
        assert!(finite(&ribbon), "{name} {}, step {step}", R::NAME);
        sum.stretch_m = sum.stretch_m.max(stretch(&ribbon) * own.length_m / N as f64);
        if (step + 1) % 20_000 == 0 {
            let _ = writeln!(std::io::stderr(), "{name} {}: {} steps, {sum:?}", R::NAME, step + 1);
        }
    }
    println!("{name} {}: {steps} steps, {sum:?}", R::NAME);
    assert_eq!((sum.held, sum.asked), (0, 0), "{name}: {sum:?}");
    assert!(sum.stretch_m <= 1e-6, "{name}: a rim edge is off by {} m", sum.stretch_m);
}

#[test]
fn a_clamped_ribbon_lives() {
    soak::<f64>("clamped", |_| {}, 1e4, 11);
    soak::<f32>("clamped", |_| {}, 1e4, 12);
}

#[test]
fn a_free_ribbon_lives() {
    soak::<f64>("free", |s| s.root = Root::Free, 1e4, 13);
    soak::<f32>("free", |s| s.root = Root::Free, 1e4, 14);
}

#[test]
fn a_free_band_lives() {
    soak::<f64>("band", |s| (s.closure, s.root) = (Closure::Moebius, Root::Free), 1e4, 15);
}

#[test]
fn a_ribbon_that_touches_itself_lives() {
    soak::<f64>("itself", |s| s.root = Root::Free, 10.0, 16);
}
