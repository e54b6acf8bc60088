//! Promise: a loop stays closed on every step, whatever pulls at it, within a bounded number of iterations.

use dogleaf_core::effect::ribbon::{Closure, Status};
use dogleaf_tests::ribbons::{finite, pulled, stretch};

/// Forty steps; answers the worst gap, the most iterations, and how many steps did not converge.
fn play(closure: Closure, stiffness: f64) -> (f64, u32, u32) {
    let mut ribbon = pulled::<f64, 50>(50, closure, stiffness);
    let (mut gap, mut most, mut capped) = (0.0_f64, 0, 0);
    for step in 0..40 {
        let report = ribbon.step(0.01);
        assert_ne!(report.status, Status::Held, "step {step}");
        assert!(finite(&ribbon) && stretch(&ribbon) < 1e-9, "step {step}");
        (gap, most) = (gap.max(report.gap), most.max(report.iterations));
        capped += u32::from(report.status != Status::Converged);
    }
    println!(
        "{closure:?} {stiffness:6} N/m: open by {gap:.1e}, at most {most} iterations, {capped} of 40 capped"
    );
    (gap, most, capped)
}

#[test]
fn a_free_loop_converges() {
    for closure in [Closure::Ring, Closure::Moebius] {
        let (gap, most, capped) = play(closure, 0.0);
        assert!(gap <= 1e-6 && most <= 60 && capped == 0, "{gap}, {most}, {capped}");
    }
}

#[test]
fn a_loop_pulled_by_a_corner_stays_closed() {
    for closure in [Closure::Ring, Closure::Moebius] {
        for stiffness in [100.0, 1e3, 1e4] {
            let (gap, most, _) = play(closure, stiffness);
            assert!(gap <= 1e-5, "{closure:?} {stiffness}: open by {gap}");
            assert!(most <= 72, "{closure:?} {stiffness}: {most} iterations");
        }
    }
}
