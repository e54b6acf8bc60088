//! Promise: a loop stays closed on every step, whatever pulls at it, within a bounded number of iterations, in both
//! precisions; where walls are in the way of that, it says so.

use dogleaf_core::effect::ribbon::contact::{Cushion, HalfSpace, Near};
use dogleaf_core::effect::ribbon::{Closure, RibbonSpec, Root, Settings, Spring, Status};
use dogleaf_core::real::{Real, V3};
use dogleaf_tests::random::Pcg;
use dogleaf_tests::ribbons::{finite, open, pulled, spec, start, stretch};

/// Forty steps; answers the worst gap, the most iterations, and how many steps did not converge.
fn play<R: Real>(closure: Closure, stiffness: f64) -> (f64, u32, u32) {
    let mut ribbon = pulled::<R, 50>(50, closure, stiffness);
    let (mut gap, mut most, mut capped) = (0.0_f64, 0, 0);
    let rigid = if R::NAME == "f64" { 1e-9 } else { 1e-4 };
    for step in 0..40 {
        let report = ribbon.step(0.01);
        assert_ne!(report.status, Status::Held, "step {step}");
        assert!(finite(&ribbon) && stretch(&ribbon) < rigid, "step {step}");
        (gap, most) = (gap.max(report.gap.wide()), most.max(report.iterations));
        capped += u32::from(report.status != Status::Converged);
    }
    println!(
        "{} {closure:?} {stiffness:6} N/m: open by {gap:.1e}, at most {most} iterations, {capped} of 40 capped",
        R::NAME
    );
    (gap, most, capped)
}

#[test]
fn a_free_loop_converges() {
    for closure in [Closure::Ring, Closure::Moebius] {
        let (gap, most, capped) = play::<f64>(closure, 0.0);
        assert!(gap <= 1e-6 && most <= 60 && capped == 0, "{gap}, {most}, {capped}");
    }
}

#[test]
fn a_loop_pulled_by_a_corner_stays_closed() {
    for closure in [Closure::Ring, Closure::Moebius] {
        for stiffness in [100.0, 1e3, 1e4] {
            let (gap, most, _) = play::<f64>(closure, stiffness);
            assert!(gap <= 1e-5, "{closure:?} {stiffness}: open by {gap}");
            assert!(most <= 72, "{closure:?} {stiffness}: {most} iterations");
        }
    }
}

#[test]
fn so_it_does_in_single_precision() {
    for closure in [Closure::Ring, Closure::Moebius] {
        for stiffness in [0.0, 100.0, 1e3, 1e4] {
            let (gap, most, _) = play::<f32>(closure, stiffness);
            assert!(gap <= 1e-5, "{closure:?} {stiffness}: open by {gap}");
            assert!(most <= 72, "{closure:?} {stiffness}: {most} iterations");
        }
    }
}

#[test]
fn without_the_closing_steps_a_pulled_loop_is_open() {
    let mut ribbon = pulled::<f64, 50>(50, Closure::Moebius, 1e4);
    ribbon.settings = Settings { closure: f64::INFINITY, ..Settings::STEP };
    let gap = (0..10).map(|_| ribbon.step(0.01).gap).fold(0.0, f64::max);
    assert!(gap > 1e-3, "the control: nobody closes what is asked to be closed at will, {gap}");
}

/// A room of four metres.
fn walls<R: Real>() -> [HalfSpace<R>; 6] {
    [0, 1, 2, 3, 4, 5].map(|k| {
        let mut inwards = [0.0; 3];
        inwards[k / 2] = if k % 2 == 0 { 1.0 } else { -1.0 };
        let normal = V3(inwards.map(R::of));
        HalfSpace { point: normal * R::of(-2.0), normal }
    })
}

/// A band of twenty segments pulled at 1e4 N/m to places beyond the walls, too, ten steps each: how many steps ended open by more
/// than `bound`, and how many of them did not say so.
fn thrown<R: Real>(steps: u32, bound: f64, seed: u64) -> (u32, u32) {
    const N: usize = 20;
    let band = RibbonSpec { closure: Closure::Moebius, root: Root::Free, ..spec(N) };
    let mut ribbon = open::<R, N>(&RibbonSpec { damping_per_s: 1.0, ..band });
    ribbon.wind(&start(), &Settings::STEP);
    let mut near = Box::new(Near::<R, _, N, 1, 2048>::over(walls(), Cushion::default()));
    // OPEN: one of so wide cells that may touch itself, too, crumples, and most of its steps end open, and say so.
    near.itself = false;
    let (mut random, mut open, mut silent, mut worst) = (Pcg::new(seed), 0, 0, 0.0_f64);
    for step in 0..steps {
        if step % 10 == 0 {
            ribbon.ask.springs.clear();
            let (crease, rim) = (1 + random.below(N - 1), random.below(2));
            let target = V3((random.v3() * 2.0).0.map(R::of));
            let spring = Spring { crease, rim, target, stiffness: R::of(1e4) };
            assert!(ribbon.ask.springs.push(spring).is_ok(), "one fits");
        }
        near.begin(&ribbon, 0.01);
        let report = ribbon.step_touching(0.01, &(), &mut *near);
        let wide = report.gap.wide() > bound;
        (open, worst) = (open + u32::from(wide), worst.max(report.gap.wide()));
        silent += u32::from(wide && report.status != Status::Open);
    }
    println!("{} against walls: {open} of {steps} open, by {worst:.1e} at most", R::NAME);
    (open, silent)
}

#[test]
fn a_band_thrown_at_walls_is_closed_or_says_that_it_is_not() {
    let (double, single) = (thrown::<f64>(1000, 1e-5, 15), thrown::<f32>(1000, 1e-4, 16));
    assert_eq!((double.1, single.1), (0, 0), "it says so");
    assert!(double.0 <= 10 && single.0 <= 10, "and that is rare: {double:?}, {single:?}");
}
