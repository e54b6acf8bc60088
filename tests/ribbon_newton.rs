//! Promise: a thorough step is minimised in few Newton iterations, and an iteration's work grows with the segments and no
//! faster.

use dogleaf_core::effect::ribbon::{Loads, Ribbon, Settings, Status};
use dogleaf_tests::ribbons::{Ground, falling_from, helix, iterations_to, open, spec, twist};
use std::f64::consts::PI;
use std::time::Instant;

/// Mean iterations to a millionth of the way, over the steps of a scene.
fn mean<const N: usize>(
    name: &str,
    mut ribbon: Box<Ribbon<f64, N>>,
    ([steps, h], thorough): ([f64; 2], bool),
    loads: &impl Loads<f64>,
    mut ask: impl FnMut(&mut Ribbon<f64, N>, f64),
) -> f64 {
    ribbon.settings = Settings { thorough, ..ribbon.settings };
    let (mut counts, mut taken, mut capped) = (Vec::new(), Vec::new(), 0);
    for k in 0..steps as u32 {
        ask(&mut ribbon, f64::from(k + 1) / steps);
        counts.extend(iterations_to(&ribbon, h, loads, 1e-6));
        let report = ribbon.step_under(h, loads);
        assert_ne!(report.status, Status::Held, "{name}, step {k}");
        taken.push(report.iterations as usize);
        capped += u32::from(report.status != Status::Converged);
    }
    assert_eq!(counts.len(), steps as usize, "{name}: a best point is reached");
    let mean = |v: &[usize]| v.iter().sum::<usize>() as f64 / v.len() as f64;
    counts.sort_unstable();
    println!(
        "{name:14} to 1e-6 of the way {:5.1} (median {}, most {}); a step {:5.1}, {capped} of {steps} capped",
        mean(&counts),
        counts[counts.len() / 2],
        counts[counts.len() - 1],
        mean(&taken)
    );
    mean(&counts)
}

/// A fall of 150 segments from a height, metres, in steps of a hundredth of a second.
fn fall(name: &str, height: f64, (steps, thorough): (f64, bool)) -> f64 {
    let (ground, ribbon) = (Ground { stiffness: 5.0 }, falling_from::<f64, 150>(150, height));
    mean(name, ribbon, ([steps, 0.01], thorough), &ground, |_, _| {})
}

#[test]
fn a_helix_unrolls_in_few_iterations() {
    for (name, h) in [("helix h=0.01", 0.01_f64), ("helix h=0.05", 0.05)] {
        let ribbon = helix::<f64, 50>(&spec(50));
        let found = mean(name, ribbon, ([(1.0 / h).round(), h], true), &(), |_, _| {});
        assert!(found <= 5.5, "{name}: {found}");
    }
}

#[test]
fn a_falling_ribbon_and_a_twisted_one_take_more() {
    let flight = fall("fall, in air", 0.5, (25.0, true));
    assert!(flight <= 4.0, "in the air: {flight}");
    // Where it lands decides how it folds, and what that costs: one height says little.
    let heights = [0.5, 0.45, 0.4, 0.55, 0.6, 0.35];
    let falls = heights.map(|z| fall(&format!("fall from {z} m"), z, (100.0, true)));
    let every = falls.iter().sum::<f64>() / 6.0;
    assert!(falls[0] <= 9.0 && every <= 9.0, "down to the ground: {falls:?}");
    let plain = fall("fall, plainly", 0.5, (100.0, false));
    assert!(plain > falls[0] + 1.0, "the control: {plain} against {falls:?}");
    let run = ([100.0, 0.01], true);
    let twisted = mean("twist 4 pi", open::<f64, 50>(&spec(50)), run, &(), |r, t| {
        twist(r, 4.0 * PI * t, 10.0);
    });
    assert!(twisted <= 14.0, "twisted: {twisted}");
}

/// Seconds of one factorisation and one evaluation, the best of many.
fn seconds<const N: usize>(segments: usize) -> f64 {
    let mut ribbon = helix::<f64, N>(&spec(segments));
    for _ in 0..5 {
        ribbon.step(0.01);
    }
    let ask = ribbon.ask.clone();
    let body = ribbon.body();
    let mut best = f64::INFINITY;
    for _ in 0..400 {
        let start = Instant::now();
        let fall = body.factor(&ask, &(), 1e6);
        let (step, _) = body.solve(true);
        body.place(0.0);
        let energy = body.evaluate(&ask, &());
        best = best.min(start.elapsed().as_secs_f64());
        assert!(fall.is_some() && step[0].is_finite() && energy.objective.is_finite(), "sound");
    }
    best
}

#[test]
fn an_iterations_work_is_linear_in_the_segments() {
    let times = [(50, seconds::<400>(50)), (100, seconds::<400>(100)), (400, seconds::<400>(400))];
    for (n, t) in times {
        println!("n = {n:3}: {:6.2} us an iteration", 1e6 * t);
    }
    let ratio = times[2].1 / times[0].1;
    assert!(ratio <= 9.0, "t(400)/t(50) = {ratio}");
}
