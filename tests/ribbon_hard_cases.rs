//! Promise: what is hard stays finite, bounded and honest: loads, steps, sizes and inputs far from a bookmark's.

use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::joint::Crease;
use dogleaf_core::effect::ribbon::{Mass, Report, Ribbon, RibbonSpec, Root, Spring, Status};
use dogleaf_core::real::{Real, V3};
use dogleaf_tests::random::Pcg;
use dogleaf_tests::ribbons::{finite, helix, honest, open, spec, start, stretch, twist};
use std::f64::consts::PI;

/// Steps of a case.
const STEPS: usize = 30;

/// Plays steps; nothing may be lost on the way. Answers how many did not converge.
fn play<R: Real, const N: usize>(name: &str, ribbon: &mut Ribbon<R, N>, h: f64) -> usize {
    let mut capped = 0;
    for step in 0..STEPS {
        let report = ribbon.step(h);
        check(name, step, ribbon, &report);
        capped += usize::from(report.status != Status::Converged);
    }
    println!("{name}: {capped} of {STEPS} steps did not converge");
    capped
}

fn check<R: Real, const N: usize>(
    name: &str,
    step: usize,
    ribbon: &Ribbon<R, N>,
    report: &Report<R>,
) {
    assert!(finite(ribbon), "{name}, step {step}: {report:?}");
    assert!(report.iterations <= ribbon.settings.iterations + 12, "{name}: {report:?}");
    assert!(honest(report, &ribbon.settings), "{name}, step {step}: {report:?}");
    let most = if R::NAME == "f64" { 1e-9 } else { 1e-3 };
    assert!(stretch(ribbon) < most, "{name}, step {step}: stretched by {}", stretch(ribbon));
    let limit =
        0.95 * 2.0 * ribbon.spec().length_m / ribbon.spec().segments as f64 / ribbon.spec().width_m;
    let slopes: Vec<f64> = ribbon.creases().map(|c| c.c.wide()).chain([0.0]).collect();
    for pair in slopes.windows(2) {
        assert!((pair[1] - pair[0]).abs() <= limit * (1.0 + 1e-6), "{name}: rulings cross");
    }
}

fn soft(change: impl Fn(&mut RibbonSpec)) -> Box<Ribbon<f64, 400>> {
    let mut spec = spec(50);
    change(&mut spec);
    helix(&spec)
}

#[test]
fn gravity_a_thousand_and_a_million_times() {
    for factor in [1e3, 1e6] {
        let mut ribbon = soft(|_| {});
        ribbon.gravity = ribbon.gravity.map(|g| g * factor);
        play(&format!("gravity x {factor:.0e}"), &mut ribbon, 0.01);
    }
}

#[test]
fn steps_from_ten_microseconds_to_a_hundred_seconds() {
    for h in [1e-5, 1e-3, 0.05, 1.0, 100.0] {
        play(&format!("h = {h}"), &mut soft(|_| {}), h);
    }
}

#[test]
fn rigidity_over_ten_decades() {
    for d in [2e-7, 2e-5, 0.2, 2e3] {
        play(&format!("D = {d}"), &mut soft(|s| s.rigidity_nm = d), 0.01);
    }
}

#[test]
fn few_segments_and_many_narrow_ribbons_and_squares() {
    for n in [2, 3, 10, 400] {
        play(&format!("n = {n}"), &mut soft(|s| s.segments = n), 0.01);
    }
    for w in [1e-6, 0.5, 1.0] {
        play(&format!("w = {w}"), &mut soft(|s| s.width_m = w), 0.01);
    }
}

#[test]
fn white_noise_of_a_hundred_metres_per_second() {
    let mut ribbon = soft(|_| {});
    let random = std::cell::RefCell::new(Pcg::new(5));
    ribbon.launch(|_| random.borrow_mut().v3() * 100.0);
    play("noise", &mut ribbon, 0.01);
}

#[test]
fn folds_of_three_radians() {
    let mut ribbon = soft(|_| {});
    ribbon.lay(&start(), |j| Crease { psi: if j % 10 == 5 { 3.0 } else { 0.0 }, c: 0.0 });
    play("folds", &mut ribbon, 0.01);
}

#[test]
fn rulings_that_were_asked_to_cross_are_parted() {
    let mut ribbon = soft(|s| s.width_m = 0.2);
    ribbon.lay(&start(), |j| Crease { psi: 0.1, c: if j % 2 == 0 { 50.0 } else { -50.0 } });
    play("crossed", &mut ribbon, 0.01);
}

/// The angle between the end's normal and where it is asked to be, and the largest bend.
fn after_a_turn(perturbation: f64) -> (f64, f64) {
    let mut ribbon = open::<f64, 50>(&RibbonSpec { perturbation, ..spec(50) });
    for k in 1..=100 {
        twist(&mut ribbon, 2.0 * PI * f64::from(k) / 100.0, 10.0);
        ribbon.step(0.01);
    }
    let n = ribbon.frames().last().map_or(V3([0.0; 3]), |f| f.n);
    let bend = ribbon.creases().map(|c| c.psi.abs()).fold(0.0, f64::max);
    (n.dot(V3([0.0, 0.0, 1.0])), bend)
}

#[test]
fn a_flat_ribbon_notices_a_pure_twist() {
    let (dot, bend) = after_a_turn(1e-9);
    println!("n·target = {dot:.4}, largest bend {bend:.3}");
    assert!(dot > 0.999 && bend > 1e-2, "it follows: {dot}, {bend}");
}

#[test]
fn without_a_perturbation_it_would_not() {
    let mut ribbon = open::<f64, 50>(&RibbonSpec { perturbation: 0.0, ..spec(50) });
    twist(&mut ribbon, 0.5, 10.0);
    ribbon.step(0.01);
    assert!(ribbon.creases().all(|c| c.psi == 0.0), "exactly stationary: the control");
}

/// Largest bend and slope of a ribbon, flat but for a ten-thousandth, that has spun half a second about its own
/// centreline.
fn spun(mass: Mass, seed: u64) -> [f64; 2] {
    let spec = RibbonSpec { width_m: 0.1, rigidity_nm: 1e-4, perturbation: 1e-4, ..spec(50) };
    let mut ribbon = open::<f64, 50>(&RibbonSpec { mass, seed, root: Root::Free, ..spec });
    ribbon.launch(|p| V3([40.0, 0.0, 0.0]).cross(p));
    for _ in 0..50 {
        ribbon.step(0.01);
    }
    let most =
        |of: fn(Crease<f64>) -> f64| ribbon.creases().map(|c| of(c).abs()).fold(0.0, f64::max);
    [most(|c| c.psi), most(|c| c.c)]
}

#[test]
fn a_spinning_ribbon_is_felt_across_its_width_only_by_the_consistent_mass() {
    for seed in 1..=3 {
        let (consistent, lumped) = (spun(Mass::Consistent, seed), spun(Mass::Lumped, seed));
        println!("bend and slope: consistent {consistent:?}, lumped {lumped:?}");
        assert!(consistent[0] > 30.0 * lumped[0], "bends: {consistent:?} against {lumped:?}");
        assert!(consistent[1] > 1e3 * lumped[1], "slopes: {consistent:?} against {lumped:?}");
    }
}

#[test]
fn what_is_no_number_is_held() {
    let mut ribbon = soft(|_| {});
    ribbon.step(0.01);
    let before = ribbon.state_hash();
    for h in [f64::NAN, f64::INFINITY, 0.0, -1.0] {
        assert_eq!(ribbon.step(h).status, Status::Held, "h = {h}");
        assert_eq!(ribbon.state_hash(), before, "h = {h}: nothing changes");
    }
    let nan = V3([f64::NAN; 3]);
    let spring = Spring { crease: 50, rim: 0, target: nan, stiffness: 1.0 };
    assert!(ribbon.ask.springs.push(spring).is_ok(), "it fits");
    assert_eq!(ribbon.step(0.01).status, Status::Held, "a target that is no number");
    assert!(finite(&ribbon), "the pose is kept");
    ribbon.ask.springs.clear();
    assert_eq!(ribbon.step(0.01).status, Status::Converged, "and goes on");
}

#[test]
fn far_from_the_origin_single_precision_is_as_good() {
    let play = |origin: [f64; 3]| {
        let mut ribbon = Box::new(Ribbon::<f32, 50>::EMPTY);
        assert!(ribbon.open(&spec(50), origin).is_ok(), "a sound spec");
        ribbon.gravity = [0.0, -9.81, 0.0];
        ribbon.lay(&start(), |_| Crease { psi: 0.1, c: 0.1 });
        for step in 0..STEPS {
            let report = ribbon.step(0.01);
            check("far", step, &ribbon, &report);
        }
        ribbon.state_hash()
    };
    assert_eq!(play([0.0; 3]), play([1e6, -1e6, 1e6]), "its own origin travels with it");
}

#[test]
fn a_start_that_was_turned_many_times_turns_on() {
    let mut ribbon = soft(|_| {});
    for k in 0..200 {
        let angle = 0.2 * f64::from(k);
        let twist = [0.0, 0.0, angle, 0.0, 0.0, 0.0];
        ribbon.carry(&Frame::at(V3([0.0; 3])).moved(&twist));
        let report = ribbon.step(0.01);
        check("turned", k as usize, &ribbon, &report);
    }
}

/// A pull, a twist, a rest and a step of any length, at random.
fn disturb<R: Real, const N: usize>(ribbon: &mut Ribbon<R, N>, random: &mut Pcg) -> f64 {
    ribbon.ask.springs.clear();
    ribbon.ask.guides.clear();
    let what = random.below(3);
    if what == 0 {
        let (crease, rim) = (1 + random.below(50), random.below(2));
        let stiffness = R::of(10_f64.powf(random.within(0.0, 4.0)));
        let target = V3(random.v3().0.map(R::of));
        assert!(ribbon.ask.springs.push(Spring { crease, rim, target, stiffness }).is_ok(), "fits");
    } else if what == 1 {
        twist(ribbon, random.within(-6.0, 6.0), random.within(0.0, 10.0));
    }
    10_f64.powf(random.within(-3.0, -1.3))
}

fn soak<R: Real>(root: Root, steps: usize) {
    let mut random = Pcg::new(11);
    let mut ribbon = helix::<R, 50>(&RibbonSpec { root, damping_per_s: 1.0, ..spec(50) });
    let (mut capped, mut h) = (0, 0.01);
    for step in 0..steps {
        if step % 10 == 0 {
            h = disturb(&mut ribbon, &mut random);
        }
        let report = ribbon.step(h);
        check("soak", step, &ribbon, &report);
        assert_ne!(report.status, Status::Held, "{root:?}, step {step}: {report:?}");
        capped += usize::from(report.status != Status::Converged);
    }
    println!("{} {root:?}: {capped} of {steps} steps did not converge", R::NAME);
}

#[test]
fn random_pulls_and_twists() {
    soak::<f64>(Root::Clamp, 1000);
    soak::<f64>(Root::Free, 1000);
    soak::<f32>(Root::Clamp, 1000);
    soak::<f32>(Root::Free, 1000);
}
