//! Promise: a ribbon that flies free keeps its momentum where it is asked to, whatever its interpolation loses; what a plain
//! step loses is written down.

use dogleaf_core::effect::ribbon::joint::Crease;
use dogleaf_core::effect::ribbon::{Mass, Report, Resample, Ribbon, RibbonSpec, Root, Status};
use dogleaf_core::real::{Real, V3};
use dogleaf_tests::ribbons::{finite, open, spec, start, stretch};
use std::f64::consts::PI;

/// What is left after a second, as a share of what there was: linear and angular momentum that is wrong, energy that is
/// left, and the most that it grew by in one step.
#[derive(Debug)]
struct Left {
    linear: f64,
    angular: f64,
    energy: f64,
    grew: f64,
}

fn wide<R: Real>(v: V3<R>) -> V3<f64> {
    V3(v.0.map(Real::wide))
}

/// Three turns of a helix that flies at a metre per second and spins once a second, without weight.
fn flying<R: Real>(resample: Resample, mass: Mass) -> Box<Ribbon<R, 50>> {
    let mut ribbon = open::<R, 50>(&RibbonSpec { resample, mass, root: Root::Free, ..spec(50) });
    let psi = R::of(6.0 * PI / 50.0);
    ribbon.lay(&start(), |_| Crease { psi, c: R::of(0.3) });
    let middle = ribbon.momentum().middle;
    let (v, w) = (V3([0.6, 0.0, 0.8].map(R::of)), V3([2.0, 3.0, 5.0].map(R::of)));
    ribbon.launch(|x| v + w.cross(x - middle));
    ribbon
}

fn play<R: Real>(
    mut ribbon: Box<Ribbon<R, 50>>,
    mut step: impl FnMut(&mut Ribbon<R, 50>) -> Report<R>,
) -> Left {
    let (first, energy) = (ribbon.momentum(), ribbon.energy().total().wide());
    let (mut before, mut grew) = (energy, 0.0_f64);
    for k in 0..100 {
        let report = step(&mut ribbon);
        assert_ne!(report.status, Status::Held, "step {k}");
        assert!(finite(&ribbon), "step {k}");
        let now = ribbon.energy().total().wide();
        (grew, before) = (grew.max((now - before) / energy), now);
    }
    let last = ribbon.momentum();
    let off = |a: V3<R>, b: V3<R>| (wide(a) - wide(b)).norm() / wide(a).norm();
    Left {
        linear: off(first.linear, last.linear),
        angular: off(first.angular, last.angular),
        energy: before / energy,
        grew,
    }
}

#[test]
fn a_plain_step_loses_momentum() {
    for resample in [Resample::Smooth, Resample::Linear] {
        let left = play(flying::<f64>(resample, Mass::Consistent), |r| r.step(0.01));
        println!("{resample:?}: {left:?}");
        assert!(left.linear < 0.03 && left.angular < 0.6, "{resample:?}: {left:?}");
        assert!(left.angular > 0.02, "the control: nothing keeps it, {left:?}");
        assert!(left.grew <= 1e-12, "{resample:?}: energy never grows, {left:?}");
    }
}

#[test]
fn a_free_step_keeps_momentum() {
    for resample in [Resample::Smooth, Resample::Linear] {
        for mass in [Mass::Consistent, Mass::Lumped] {
            let left = play(flying::<f64>(resample, mass), |r| r.step_free(0.01));
            println!("{resample:?}, {mass:?}, kept: {left:?}");
            assert!(left.linear <= 1e-12 && left.angular <= 1e-4, "{resample:?}: {left:?}");
            assert!(left.energy < 1.0 && left.grew <= 1e-3, "{resample:?}: {left:?}");
        }
    }
    let single = play(flying::<f32>(Resample::Smooth, Mass::Consistent), |r| r.step_free(0.01));
    println!("f32, kept: {single:?}");
    assert!(single.linear <= 1e-4 && single.angular <= 1e-3, "{single:?}");
}

#[test]
fn weight_adds_what_it_should() {
    let mut ribbon = flying::<f64>(Resample::Smooth, Mass::Consistent);
    ribbon.gravity = [0.0, -9.81, 0.0];
    let first = ribbon.momentum();
    for _ in 0..50 {
        ribbon.step_free(0.01);
    }
    let last = ribbon.momentum();
    let wanted = first.linear + V3([0.0, -9.81 * 0.5 * first.mass, 0.0]);
    assert!((last.linear - wanted).norm() <= 1e-12, "{last:?}");
    assert!((first.mass / (0.1 * 0.05) - 1.0).abs() < 1e-12, "the mass of its area: {first:?}");
    assert!((last.angular - first.angular).norm() <= 1e-4 * first.angular.norm(), "no turn");
    assert!(stretch(&ribbon) < 1e-9, "and it is not stretched");
}

#[test]
fn a_line_that_cannot_spin_about_itself_is_let_be() {
    let straight =
        RibbonSpec { mass: Mass::Lumped, root: Root::Free, perturbation: 0.0, ..spec(50) };
    let mut ribbon = open::<f64, 50>(&straight);
    ribbon.launch(|x| V3([1.0, 0.0, 0.0]) + V3([9.0, 0.0, 1.0]).cross(x));
    for _ in 0..20 {
        ribbon.step_free(0.01);
        assert!(finite(&ribbon), "no turn without inertia");
        let fastest = ribbon.velocities_now().flatten().map(|v| v.norm()).fold(0.0, f64::max);
        assert!(fastest < 10.0, "and none that is too fast: {fastest}");
    }
}

#[test]
fn what_is_held_or_pulled_takes_the_plain_step() {
    let mut clamped = open::<f64, 50>(&spec(50));
    clamped.gravity = [0.0, -9.81, 0.0];
    let mut other = clamped.clone();
    for _ in 0..5 {
        clamped.step(0.01);
        other.step_free(0.01);
    }
    assert_eq!(clamped.state_hash(), other.state_hash(), "to the bit");
}
