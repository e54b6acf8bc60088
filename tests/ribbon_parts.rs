//! Promise: the parts of a ribbon do what they say: interpolation is exact where it can be, a cell's mass is its area's,
//! logarithms and angles are those of the host, rotations have logarithms even at half a turn.

use dogleaf_core::effect::ribbon::elementary::{angle, hyperbolic, logarithm, sine_and_versine};
use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::resample::Table;
use dogleaf_core::effect::ribbon::strip::Strip;
use dogleaf_core::effect::ribbon::{Mass, Resample, RibbonSpec};
use dogleaf_core::real::V3;
use dogleaf_core::scene::SpecError;
use dogleaf_tests::random::Pcg;
use dogleaf_tests::ribbons::spec;
use std::f64::consts::PI;

#[test]
fn elementary_functions_are_the_hosts() {
    for k in 0..1000 {
        let x = f64::from(k) * 1e-3;
        let q = 0.985 * x;
        let wanted = if q == 0.0 { 1.0 } else { q.atanh() / q };
        assert!((hyperbolic(q)[0] / wanted - 1.0).abs() < 1e-14, "atanh({q})/q");
        assert_eq!(hyperbolic(-q)[0], hyperbolic(q)[0], "even");
        let y = (50.0 * (x - 0.5)).exp();
        assert!((logarithm(y) - y.ln()).abs() < 1e-13 * y.ln().abs().max(1.0), "ln {y}");
        let turn = 0.5 * PI * x;
        assert!((angle(turn.sin(), turn.cos()) - turn).abs() < 1e-15 * 8.0, "atan2 at {turn}");
    }
}

/// The short series and what is beyond it, the seam at 0.75 included; both signs.
#[test]
fn sine_and_versine_keep_their_digits() {
    let (mut worst, mut control) = (0.0_f64, 0.0_f64);
    for i in 1..=4000 {
        let psi = 1e-9_f64.max(f64::from(i) * 8e-4);
        for psi in [psi, -psi, psi * 1e-6] {
            let half = (0.5 * psi).sin();
            let [sin, versine] = sine_and_versine(psi);
            let wanted = 2.0 * half * half;
            // Near half a turn the sine itself is a difference.
            worst =
                worst.max((sin - psi.sin()).abs() / psi.sin().abs().max(0.1 * psi.abs().min(1.0)));
            worst = worst.max((versine / wanted - 1.0).abs());
            control = control.max(((1.0 - psi.cos()) / wanted - 1.0).abs());
            let [sin, versine] = sine_and_versine(psi as f32).map(f64::from);
            let exact = f64::from(psi as f32);
            let single = (0.5 * exact).sin();
            assert!((sin - exact.sin()).abs() <= 3e-7 * exact.abs().min(1.0), "sin {psi}: {sin}");
            assert!((versine / (2.0 * single * single) - 1.0).abs() <= 5e-7, "{psi}: {versine}");
        }
    }
    assert!(worst <= 3e-15, "{worst}");
    assert!(control > 1e-6, "the control, one less the cosine: {control}");
}

#[test]
fn derivatives_of_the_hyperbolic_factor_are_differences() {
    for k in 1..98 {
        let (q, h) = (f64::from(k) * 0.01, 1e-4);
        let f = |k: f64, i: usize| hyperbolic(q + k * h)[i];
        let slope = |i| (8.0 * (f(1.0, i) - f(-1.0, i)) - f(2.0, i) + f(-2.0, i)) / (12.0 * h);
        let [_, first, second] = hyperbolic(q);
        assert!((slope(0) / first - 1.0).abs() < 1e-6, "first at {q}");
        assert!((slope(1) / second - 1.0).abs() < 1e-6, "second at {q}");
    }
}

#[test]
fn a_turn_and_its_logarithm_undo_each_other() {
    let mut random = Pcg::new(7);
    for size in [0.0, 1e-9, 1e-3, 0.5, 2.0, 3.1, PI - 1e-9, PI] {
        let axis = random.v3();
        let w = axis * (size / axis.norm());
        let from = Frame::at(V3([0.0; 3])).moved(&[0.4, -0.3, 0.2, 0.0, 0.0, 0.0]);
        let [x, y, z] = w.0;
        let [found, way] = from.moved(&[x, y, z, 0.0, 0.0, 0.0]).apart(&from);
        let gap = (found - w).norm().min((found + w).norm());
        let (gap, way) = (if size > PI - 1e-6 { gap } else { (found - w).norm() }, way.norm());
        assert!(gap < 1e-7 && way < 1e-15, "{size}: {found:?} is not {w:?}");
    }
}

/// Knots of random rulings under a function of the place in the flat ribbon.
fn table(
    resample: Resample,
    f: impl Fn(f64, f64) -> V3<f64>,
) -> (Strip<f64>, Table<f64, 20>, Vec<f64>) {
    let strip = Strip::<f64>::of(&RibbonSpec { resample, ..spec(20) });
    let mut random = Pcg::new(3);
    let slopes: Vec<f64> =
        (0..20).map(|j| if j == 0 { 0.0 } else { random.within(-0.4, 0.4) }).collect();
    let mut table = Table::EMPTY;
    let pair = |s: f64, c: f64| {
        let lean = strip.half * c;
        [f(s - lean, -strip.half), f(s + lean, strip.half)]
    };
    let knots = slopes.iter().enumerate().map(|(j, &c)| (c, pair(strip.cell * j as f64, c)));
    table.fill(&strip, knots, pair(1.0, 0.0));
    (strip, table, slopes)
}

#[test]
fn interpolation_is_exact_at_knots_and_for_what_is_straight() {
    let straight = |s: f64, y: f64| V3([2.0 * s + 1.0, y - s, 0.5 * s]);
    let bent = |s: f64, y: f64| V3([s.cos(), s.sin(), y]);
    for resample in [Resample::Smooth, Resample::Linear] {
        let (strip, line, _) = table(resample, straight);
        let (_, arc, slopes) = table(resample, bent);
        for k in 0..=200 {
            let s = f64::from(k) / 200.0;
            for rim in [0, 1] {
                let y = if rim == 0 { -strip.half } else { strip.half };
                let found = line.sample(rim, s, k as usize % 21);
                assert!((found.y - straight(s, y)).norm() < 1e-14, "{resample:?} at {s}");
                assert!((found.dy - V3([2.0, -1.0, 0.5])).norm() < 1e-12, "{resample:?} at {s}");
                let gap = (arc.sample(rim, s, 0).y - bent(s, y)).norm();
                let most = if resample == Resample::Smooth { 1e-4 } else { 1e-3 };
                assert!(gap < most, "{resample:?} misses an arc by {gap} at {s}");
            }
        }
        for (j, c) in slopes.iter().enumerate() {
            let s = strip.cell * j as f64 + strip.half * c;
            assert!((arc.sample(1, s, j).y - bent(s, strip.half)).norm() < 1e-14, "knot {j}");
        }
    }
}

#[test]
fn only_the_smooth_interpolation_has_no_kink_at_a_knot() {
    let jump = |resample| {
        let (strip, table, slopes) =
            table(resample, |s, y| V3([(6.0 * s).cos(), (6.0 * s).sin(), y]));
        let s = strip.cell * 7.0 - strip.half * slopes[7];
        let side = |e: f64| table.sample(0, s + e, 7).dy;
        (side(1e-9) - side(-1e-9)).norm()
    };
    assert!(jump(Resample::Smooth) < 1e-5, "the slope runs on");
    assert!(jump(Resample::Linear) > 1e-2, "the seed's has a kink");
}

#[test]
fn a_cells_mass_is_its_areas_and_positive() {
    for mass in [Mass::Consistent, Mass::Lumped] {
        let strip = Strip::<f64>::of(&RibbonSpec { mass, ..spec(20) });
        let area = 0.1 * strip.cell * 2.0 * strip.half;
        assert!((strip.cell_mass() / area - 1.0).abs() < 1e-14, "{mass:?}");
        for spread in [-0.9, 0.0, 0.9].map(|s| s * strip.limit) {
            let unit = |i: usize| {
                let mut x = [V3([0.0; 3]); 4];
                x[i] = V3([1.0, 0.0, 0.0]);
                x
            };
            let column = |i: usize| strip.mass.times(spread, &unit(i)).map(|v| v.0[0]);
            let matrix: Vec<[f64; 4]> = (0..4).map(column).collect();
            let sum: f64 = matrix.iter().flatten().sum();
            assert!((sum / area - 1.0).abs() < 1e-14, "all sixteen entries are the mass");
            for (i, row) in matrix.iter().enumerate() {
                assert!(row[i] > 0.0, "positive");
                let mirrored = matrix.iter().map(|column| column[i]);
                assert!(row.iter().zip(mirrored).all(|(a, b)| (a - b).abs() < 1e-18), "symmetric");
            }
        }
    }
}

#[test]
fn bad_specs_are_refused() {
    let bad = |change: fn(&mut RibbonSpec)| {
        let mut spec = spec(20);
        change(&mut spec);
        spec.check(20)
    };
    assert_eq!(bad(|_| {}), Ok(()));
    assert_eq!(bad(|s| s.segments = 21), Err(SpecError::OutOfRange("ribbon.segments")));
    assert_eq!(bad(|s| s.segments = 1), Err(SpecError::OutOfRange("ribbon.segments")));
    assert_eq!(bad(|s| s.width_m = 2.0), Err(SpecError::OutOfRange("ribbon.width_m")));
    assert_eq!(bad(|s| s.length_m = f64::NAN), Err(SpecError::NotFinite("ribbon.length_m")));
    assert_eq!(bad(|s| s.rigidity_nm = 0.0), Err(SpecError::OutOfRange("ribbon.rigidity_nm")));
    assert_eq!(
        bad(|s| s.areal_mass_gsm = -1.0),
        Err(SpecError::OutOfRange("ribbon.areal_mass_gsm"))
    );
}
