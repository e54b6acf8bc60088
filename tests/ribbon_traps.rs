//! Promise: what a ribbon's solver can fall into, and prototypes did, it does not: each trap has a test that fails where we
//! do. Those without one elsewhere are here.
//!
//! | | trap | guarded by |
//! |---|---|---|
//! | 1 | straight interpolation has its kinks where the solver starts, and rulings stick | `interpolation_has_no_kink_for_rulings_to_stick_at` |
//! | 2 | shift on slopes alone: worse local minima | `ribbon_derivatives::the_newton_step_solves_the_exact_hessian` (the shift is on both), the command line's `bench_json` (who ends lower) |
//! | 3 | the way of a soft helix is chaotic: only steps compare | `single_steps_compare_and_whole_ways_do_not`, `ribbon_fidelity` |
//! | 4 | bending is indefinite where `c² > 1/3` | `bending_is_indefinite_beyond_a_slope_and_the_rough_model_never` |
//! | 5 | a flat ribbon does not notice a twist | `ribbon_hard_cases::a_flat_ribbon_notices_a_pure_twist`; `flat_ribbons_are_perturbed_and_their_slopes_cost` |
//! | 6 | pivots made positive one by one | `an_indefinite_model_is_refused_not_bent` |
//! | 7 | closures that vanish at half a turn | `a_joint_half_a_turn_off_is_open` |
//! | 8 | stopping at an open loop; limits that have units | `who_says_converged_is_closed`, `energy_has_no_unit` |
//! | 9 | a clamp that bends half a cell late, a seam that does not | `ribbon_statics::a_held_first_segment_is_a_whole_order_worse`, `a_ring_has_twice_pi` |
//! | 10 | rulings at their bounds, where logarithms end | `a_wide_ribbon_at_its_bounds_has_numbers`, `ribbon_hard_cases` |
//! | 11 | momentum is lost by resampling | `ribbon_momentum` |
//! | 12 | a rotation vector ends at a whole turn; single precision far away | `ribbon_hard_cases::a_start_that_was_turned_many_times_turns_on`, `far_from_the_origin_single_precision_is_as_good` |
//! | 13 | a loop and a violent pull | `ribbon_loops` |
//! | 14 | regularisation that counts | `regularisation_scales_and_is_small` |
//! | 15 | several heavy elasticas | `the_oracle_hangs_by_the_lowest_root` |

use dogleaf_core::effect::ribbon::bending;
use dogleaf_core::effect::ribbon::closure::Gap;
use dogleaf_core::effect::ribbon::elementary::hyperbolic;
use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::joint::Crease;
use dogleaf_core::effect::ribbon::strip::Strip;
use dogleaf_core::effect::ribbon::{
    Bending, Closure, Resample, Ribbon, RibbonSpec, Root, Settings, Spring, Status,
};
use dogleaf_core::real::V3;
use dogleaf_core::scene::SpecError;
use dogleaf_tests::elastica::droop;
use dogleaf_tests::random::Pcg;
use dogleaf_tests::ribbons::{finite, helix, iterations_to, open, pulled, spec, start, twist};
use std::f64::consts::PI;

/// Iterations to a millionth of the way, the mean of thirty steps of a helix.
fn to_the_bottom(spec: &RibbonSpec) -> f64 {
    let mut ribbon = helix::<f64, 50>(spec);
    let count = |r: &Ribbon<f64, 50>| iterations_to(r, 0.01, &(), 1e-6).unwrap_or(300);
    let mut sum = 0;
    for _ in 0..30 {
        sum += count(&ribbon);
        ribbon.step(0.01);
    }
    sum as f64 / 30.0
}

#[test]
fn interpolation_has_no_kink_for_rulings_to_stick_at() {
    let of = |resample| to_the_bottom(&RibbonSpec { resample, ..spec(50) });
    let (own, smooth, linear) =
        (to_the_bottom(&spec(50)), of(Resample::Smooth), of(Resample::Linear));
    println!("iterations: {own} by default, {smooth} smooth, {linear} straight");
    assert!(own <= 6.0, "{own}");
    assert!(linear > 1.5 * smooth, "the control: the seed's own sticks, {linear}");
}

/// Where a helix's tip is after a time, in steps of `h`.
fn tip(h: f64, time: f64) -> V3<f64> {
    let mut ribbon = helix::<f64, 50>(&spec(50));
    for _ in 0..(time / h).round() as u32 {
        ribbon.step(h);
    }
    ribbon.pairs().last().map_or(V3([0.0; 3]), |p| p[0])
}

#[test]
fn single_steps_compare_and_whole_ways_do_not() {
    let apart = |time| (tip(0.01, time) - tip(0.005, time)).norm();
    let (one, whole) = (apart(0.01), apart(0.5));
    println!(
        "h = 0.01 and 0.005: tips {one:.1e} m apart after a step, {whole:.1e} m after half a second"
    );
    assert!(one < 2e-3, "a step converges: {one}");
    assert!(whole > 0.02, "a whole way does not: nothing is learnt from comparing two, {whole}");
}

#[test]
fn bending_is_indefinite_beyond_a_slope_and_the_rough_model_never() {
    let strip = Strip::<f64>::of(&RibbonSpec { regularisation: 1e-9, ..spec(50) });
    let wide = Strip::<f64>::of(&RibbonSpec { bending: Bending::Wunderlich, ..spec(50) });
    let mut random = Pcg::new(4);
    for _ in 0..2000 {
        let psi = random.within(0.1, 1.0);
        let (c, far) = (random.within(-1.5, 1.5), random.within(-1.5, 1.5));
        let (near, next) = (Crease { psi, c }, Crease { psi: random.within(-1.0, 1.0), c: far });
        let h = bending::derivatives(&strip, 5, near, next).h;
        let det = h[0][0] * h[1][1] - h[0][1] * h[1][0];
        let scale = (strip.stiff * psi).powi(2);
        assert!((det / scale - (1.0 - 3.0 * c * c)).abs() < 1e-6, "at {c}: {}", det / scale);
        // Wunderlich's rulings may not be further apart than the barrier lets them.
        let spread = Crease { c: c + wide.limit * random.within(-1.0, 1.0), ..next };
        for (strip, next) in [(&strip, next), (&wide, spread)] {
            let rough = bending::rough(strip, 5, near, next);
            let x = [0; 4].map(|_| random.within(-1.0, 1.0));
            let form: f64 = (0..4)
                .flat_map(|i| (0..4).map(move |k| (i, k)))
                .map(|(i, k)| rough[i][k] * x[i] * x[k])
                .sum();
            assert!(form >= -1e-12 * strip.stiff, "{near:?}, {next:?}: {form}");
        }
    }
}

#[test]
fn flat_ribbons_are_perturbed_and_their_slopes_cost() {
    assert!(RibbonSpec::default().perturbation >= 1e-9, "else a pure twist is not noticed");
    let none = RibbonSpec { regularisation: 0.0, ..spec(50) };
    assert_eq!(none.check(50), Err(SpecError::OutOfRange("ribbon.regularisation")));
}

#[test]
fn an_indefinite_model_is_refused_not_bent() {
    let slanted = RibbonSpec { regularisation: 1e-6, perturbation: 0.0, ..spec(20) };
    let mut ribbon = open::<f64, 20>(&slanted);
    ribbon.lay(&start(), |j| Crease {
        psi: 0.3,
        c: 0.05 * (j.min(20 - j) as f64) + 0.9 * f64::from(u8::from(j == 10)),
    });
    let ask = ribbon.ask.clone();
    let body = ribbon.body();
    body.place(0.0);
    body.motion.kappa = 0.0;
    body.evaluate(&ask, &());
    assert_eq!(body.factor(&ask, &(), 0.0), None, "no minimum, no step");
    let shift =
        (0..20).map(|k| 1e-2 * 2_f64.powi(k)).find(|&s| body.factor(&ask, &(), s).is_some());
    let shift = shift.expect("some shift is enough");
    let fall = body.factor(&ask, &(), shift).expect("once more");
    let before = body.evaluate(&ask, &()).total(body.mu);
    let _ = body.solve(false);
    body.place(1e-5);
    let after = body.evaluate(&ask, &()).total(body.mu);
    assert!(((before - after) / (1e-5 * fall) - 1.0).abs() < 1e-2, "and then it is downhill");
}

#[test]
fn a_joint_half_a_turn_off_is_open() {
    let from = Frame::at(V3([0.0; 3])).moved(&[0.3, -0.2, 0.5, 0.1, 0.2, 0.3]);
    for axis in [from.t, from.b, from.n] {
        let [x, y, z] = (axis * PI).0;
        let turned = Frame { p: from.p, ..from.moved(&[x, y, z, 0.0, 0.0, 0.0]) };
        let cross = |a: &Frame<f64>| {
            let sum = a.t.cross(from.t) + a.b.cross(from.b) + a.n.cross(from.n);
            (sum * 0.5).norm()
        };
        let gap = Gap::between(&turned, &from, [0.0, 1.0]);
        assert!((gap.size(1.0) - PI).abs() < 1e-6, "half a turn is seen: {gap:?}");
        assert!(cross(&turned) < 1e-12, "the control: differences of axes do not see it");
    }
    let gap = Gap::between(&from, &from, [0.0, 1.0]);
    assert!(gap.size(1.0) < 1e-15, "and no turn is none");
}

#[test]
fn who_says_converged_is_closed() {
    let (mut told, mut least) = (0, 0.0_f64);
    for closure in [Closure::Ring, Closure::Moebius] {
        for stiffness in [0.0, 30.0, 300.0] {
            let mut ribbon = pulled::<f64, 50>(50, closure, stiffness);
            for _ in 0..40 {
                let mut open = 0.0;
                let report = ribbon.step_watched(0.01, &(), |_, gap| open = gap);
                if report.status == Status::Converged {
                    assert!(report.gap <= ribbon.settings.closure, "{closure:?}: {report:?}");
                    (told, least) = (told + 1, least.max(open));
                }
            }
        }
    }
    assert!(told > 20, "most do converge: {told}");
    assert!(least <= Settings::STEP.closure, "and what was seen is what was told: {least}");
}

/// Creases after some steps of a scene whose energies are all a power of two times those of another.
fn scaled(closure: Closure, factor: f64) -> Vec<[f64; 2]> {
    let own = RibbonSpec { closure, root: Root::Free, ..spec(30) };
    let mut ribbon = open::<f64, 30>(&RibbonSpec {
        rigidity_nm: own.rigidity_nm * factor,
        areal_mass_gsm: own.areal_mass_gsm * factor,
        ..own
    });
    ribbon.gravity = [0.0, 0.0, -9.81];
    if closure == Closure::Open {
        ribbon.lay(&start(), |_| Crease { psi: 0.2, c: 0.2 });
    } else {
        ribbon.wind(&start(), &Settings::STEP);
    }
    let spring = Spring { crease: 10, rim: 1, target: V3([0.1, 0.2, 0.3]), stiffness: factor };
    assert!(ribbon.ask.springs.push(spring).is_ok(), "it fits");
    for _ in 0..5 {
        ribbon.step(0.01);
    }
    ribbon.creases().map(|c| [c.psi, c.c]).collect()
}

#[test]
fn energy_has_no_unit() {
    for closure in [Closure::Open, Closure::Moebius] {
        let joules = scaled(closure, 1.0);
        for power in [-12, 12] {
            let other = scaled(closure, 2_f64.powi(power));
            let most = joules.iter().flatten().zip(other.iter().flatten());
            let most = most.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(most <= 1e-9, "{closure:?}, 2^{power}: creases differ by {most}");
        }
    }
}

#[test]
fn a_wide_ribbon_at_its_bounds_has_numbers() {
    for q in [0.985_f64, 0.999_999, 1.0 - 1e-15] {
        assert!(hyperbolic(q)[0].is_finite(), "A({q})");
    }
    for bending in [Bending::Sadowsky, Bending::Wunderlich] {
        let wide = RibbonSpec { width_m: 0.2, bending, ..spec(50) };
        let mut ribbon = open::<f64, 50>(&wide);
        let limit = ribbon.body().strip.limit;
        let mut nearest = 0.0_f64;
        for k in 1..=60 {
            twist(&mut ribbon, 4.0 * PI * f64::from(k) / 60.0, 10.0);
            let report = ribbon.step(0.01);
            assert!(finite(&ribbon) && report.objective.is_finite(), "{bending:?}, step {k}");
            assert_ne!(report.status, Status::Held, "{bending:?}, step {k}");
            let c: Vec<f64> = ribbon.creases().map(|c| c.c).chain([0.0]).collect();
            nearest = c.windows(2).map(|w| (w[1] - w[0]).abs() / limit).fold(nearest, f64::max);
            assert!(nearest <= 1.0 + 1e-12, "{bending:?}, step {k}: rulings cross by {nearest}");
        }
        println!("{bending:?}: {nearest:.6} of the bound is used");
        assert!(bending == Bending::Wunderlich || nearest > 0.99, "the bound counts: {nearest}");
        // Outside, which a line search may try, the merit is no number to fall for, and not NaN.
        let ask = ribbon.ask.clone();
        let body = ribbon.body();
        body.place(0.0);
        body.stages[20].crease.c += 3.0 * limit;
        let total = body.evaluate(&ask, &()).total(body.mu);
        assert!(total.is_nan() || total > 1e300, "{bending:?}: {total} would be taken");
    }
}

#[test]
fn regularisation_scales_and_is_small() {
    let strip = |n, rigidity_nm| Strip::<f64>::of(&RibbonSpec { rigidity_nm, ..spec(n) });
    for (n, d) in [(25, 1e-6), (50, 2e-3), (400, 10.0)] {
        let s = strip(n, d);
        assert!((s.slope / s.stiff / spec(n).regularisation - 1.0).abs() < 1e-12, "{n}, {d}");
    }
    // Where the tip of a twisted ribbon comes to hang.
    let tip = |regularisation| {
        let stiff = RibbonSpec { regularisation, rigidity_nm: 0.06, ..spec(50) };
        let mut ribbon = open::<f64, 50>(&stiff);
        ribbon.gravity = [0.0, 0.0, -9.81];
        twist(&mut ribbon, 1.0, 10.0);
        let report = ribbon.settle(&Settings::EXACT);
        assert!(report.objective.is_finite(), "{report:?}");
        ribbon.pairs().last().map_or(V3([0.0; 3]), |p| p[0])
    };
    let none = tip(1e-8);
    let [fine, own, printed] =
        [1e-5, spec(50).regularisation, 0.1 / 0.0015].map(|beta| (tip(beta) - none).norm());
    println!(
        "tip off by {fine:.1e} m for rest shapes, {own:.1e} m by default, {printed:.1e} m as printed"
    );
    assert!(fine < 1e-3, "{fine}");
    assert!(
        own > 10.0 * fine,
        "the control: ours by default is for steps, and tells in limp rest shapes, {own}"
    );
    assert!(printed > 2.0 * own, "and a tenth of a joule is another shape, {printed}");
}

#[test]
fn the_oracle_hangs_by_the_lowest_root() {
    // Reach and drop of the branch that grows from the flat sheet, by shooting from the tip.
    let table = [
        (1.0, 0.991_246_40, 0.123_471_40),
        (5.0, 0.846_657_18, 0.495_904_05),
        (10.0, 0.656_353_76, 0.700_199_72),
        (20.0, 0.445_232_05, 0.829_881_44),
        (50.0, 0.245_014_76, 0.907_917_12),
        (100.0, 0.159_223_38, 0.937_523_94),
        (200.0, 0.107_420_44, 0.956_769_20),
    ];
    for (gamma, reach, drop) in table {
        let [z, x] = droop(gamma);
        assert!((x - reach).abs() < 1e-6 && (z - drop).abs() < 1e-6, "Γ = {gamma}: {x}, {z}");
    }
}
