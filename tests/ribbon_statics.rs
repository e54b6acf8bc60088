//! Promise: a ribbon's rest shapes are those of the theory: the heavy elastica, and the Möbius band's energy.

use dogleaf_core::effect::ribbon::{Bending, Closure, Ribbon, RibbonSpec, Root, Settings, Status};
use dogleaf_core::real::Real;
use dogleaf_tests::elastica::droop;
use dogleaf_tests::ribbons::{open, start};
use std::f64::consts::PI;

/// Height over reach of a ribbon clamped level, for `Γ = w g L³/D`.
fn aspect(gamma: f64, segments: usize, root: Root) -> f64 {
    let (areal, rigidity) = (0.1, 0.01);
    let spec = RibbonSpec {
        segments,
        root,
        rigidity_nm: rigidity,
        areal_mass_gsm: 1e3 * areal,
        perturbation: 0.0,
        ..RibbonSpec::default()
    };
    let mut ribbon = open::<f64, 200>(&spec);
    ribbon.gravity = [0.0, 0.0, -gamma * rigidity / areal];
    let report = ribbon.settle(&Settings::EXACT);
    assert_eq!(report.status, Status::Converged, "Γ = {gamma}, {segments} segments: {report:?}");
    let end = ribbon.pairs().last().expect("an end");
    let tip = (end[0] + end[1]) * 0.5;
    -tip.0[2] / tip.0[0]
}

#[test]
fn a_hanging_ribbon_is_the_heavy_elastica() {
    println!("    Γ      H/W   n=25     n=50     n=100    order");
    for gamma in [1.0, 5.0, 10.0, 20.0, 50.0, 100.0] {
        let [drop, reach] = droop(gamma);
        let error = |n| aspect(gamma, n, Root::Clamp) / (drop / reach) - 1.0;
        let [coarse, middle, fine] = [25, 50, 100].map(error);
        let order = (middle / fine).abs().log2();
        println!(
            "{gamma:5} {:8.5} {coarse:8.1e} {middle:8.1e} {fine:8.1e} {order:6.2}",
            drop / reach
        );
        assert!(middle.abs() <= 2e-3, "Γ = {gamma}: H/W is off by {middle:.1e}");
        assert!(order >= 1.9, "Γ = {gamma}: order {order}");
    }
}

#[test]
fn a_held_first_segment_is_a_whole_order_worse() {
    let [drop, reach] = droop(10.0);
    let error = aspect(10.0, 50, Root::Segment) / (drop / reach) - 1.0;
    assert!(error < -0.03, "the seed's clamp bends a whole cell late: {error}");
}

/// `∫ κ²(1+η²)² ds / π` and the gap of a Möbius band of length `2π`.
fn band<const N: usize>(segments: usize, half_width: f64, bending: Bending) -> (f64, f64, u32) {
    let spec = RibbonSpec {
        segments,
        length_m: 2.0 * PI,
        width_m: 2.0 * half_width,
        rigidity_nm: 1.0,
        regularisation: 1e-9,
        bending,
        closure: Closure::Moebius,
        root: Root::Segment,
        ..RibbonSpec::default()
    };
    let mut ribbon = open::<f64, N>(&spec);
    let report = ribbon.wind(&start(), &Settings::EXACT);
    assert_eq!(report.status, Status::Converged, "{segments} segments: {report:?}");
    let integral = report.objective * 2.0 / spec.width_m;
    (integral / PI, report.gap, report.iterations)
}

#[test]
fn a_moebius_band_has_its_energy() {
    for (n, wanted) in [(50, 5.961), (100, 5.9375), (200, 5.933)] {
        let (u, gap, iterations) = band::<200>(n, PI / 30.0, Bending::Wunderlich);
        println!(
            "n = {n}: U = {u:.4}, closed to {gap:.1e}, {iterations} iterations from a flat ring"
        );
        assert!((u - wanted).abs() <= 1e-3, "n = {n}: {u}");
        assert!(gap <= 1e-9, "n = {n}: open by {gap}");
    }
    let (u, ..) = band::<200>(200, PI / 30.0, Bending::Wunderlich);
    assert!((u - 5.93).abs() <= 0.01, "Starostin and van der Heijden have 5.93: {u}");
}

#[test]
fn sadowskys_energy_is_a_little_less() {
    let (u, gap, _) = band::<200>(200, PI / 30.0, Bending::Sadowsky);
    assert!((u - 18.5199 / PI).abs() <= 1e-3 && gap <= 1e-9, "{u}, {gap}");
}

#[test]
fn a_ring_has_twice_pi() {
    let spec = RibbonSpec {
        segments: 50,
        length_m: 2.0 * PI,
        width_m: 0.2,
        rigidity_nm: 1.0,
        closure: Closure::Ring,
        perturbation: 0.0,
        ..RibbonSpec::default()
    };
    let mut ribbon = open::<f64, 50>(&spec);
    let report = ribbon.wind(&start(), &Settings::EXACT);
    let integral = report.objective * 2.0 / spec.width_m;
    assert!((integral - 2.0 * PI).abs() < 1e-6, "∫κ² of a circle is 2π: {integral}");
    assert!(report.gap <= 1e-9, "{report:?}");
}

#[test]
fn single_precision_finds_the_same_shape() {
    let spec = RibbonSpec { rigidity_nm: 0.01, ..RibbonSpec::default() };
    let tip = |ribbon: &Ribbon<f64, 50>| ribbon.pairs().last().map(|p| p[0].0);
    let mut double = open::<f64, 50>(&spec);
    double.gravity = [0.0, 0.0, -5.0];
    double.settle(&Settings::EXACT);
    let mut single = open::<f32, 50>(&spec);
    single.gravity = [0.0, 0.0, -5.0];
    single.settle(&Settings::STEP);
    let (wide, narrow) = (tip(&double), single.pairs().last().map(|p| p[0].0.map(Real::wide)));
    let gap =
        wide.zip(narrow).map(|(a, b)| (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max));
    assert!(gap.is_some_and(|g| g < 1e-4), "{wide:?} {narrow:?}");
}
