//! Scenarios 9-13: one dial turned from end to end.

use super::harness::{Rules, apart, at as with, open, play};
use super::lone::lone;
use super::{At, Found};
use crate::elastica::droop;
use crate::gesture::{Gesture, Scene};
use dogleaf_core::LoneLeaf;
use dogleaf_core::grid::{G6x5, G8x6, G11x8, G16x12, G22x16, Grid};
use dogleaf_core::real::Real;
use dogleaf_core::scene::{Fidelity, LeafSpec, PaperSpec, Weights, WorldSpec};
use dogleaf_core::state::Leaf;

/// How the distance from the shape with steps of 1/4000 s falls with the step, for a leaf that falls from flat.
fn order<R: Real>(at: At) -> f64 {
    let shape = |step_us: u32| -> Leaf<R, G11x8> {
        let world = WorldSpec { step_us, ..WorldSpec::default() };
        let mut leaf = lone::<R, G11x8>(&LeafSpec::default(), &world, at);
        for _ in 0..48_000 / step_us {
            let _ = leaf.step();
        }
        leaf.leaf().clone()
    };
    let exact = shape(250);
    let off = [4_000, 2_000].map(|us| apart(Some(&shape(us)), Some(&exact)));
    (off[0] / off[1]).log2()
}

/// 9: the rules hold at every step there is, and the error is of first order.
pub fn steps<R: Real>(at: At) -> Found {
    let order = order::<R>(at);
    let mut found = Found { figure: order, faults: Vec::new() };
    found.expect(order >= 0.8, || format!("of order {order:.2}"));
    for step_us in [1_000, 4_167, 8_333, 16_667, 33_333, 66_667, 100_000] {
        let mut scene = with(&Scene::default(), at);
        scene.world.step_us = step_us;
        let seen = play::<R>(&scene, &Gesture::corner_turn(&scene.eye(), 7), &Rules::WILD);
        found.faults.extend(seen.faults.into_iter().map(|f| format!("step {step_us} us: {f}")));
    }
    for step_us in [0, 1, 99, 100_001, 200_000, u32::MAX] {
        let mut scene = Scene::default();
        scene.world.step_us = step_us;
        found.expect(open::<R>(&scene).is_err(), || format!("a step of {step_us} us was taken"));
    }
    found
}

/// 10: time is counted in whole microseconds, so there is no negative and no NaN of it; any count is taken.
pub fn frames<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let mut found = Found::default();
    let mut most = 0;
    for lift in [false, true] {
        let mut book = open::<R>(&scene).expect("a sound scene");
        let _ = lift && book.take_up(true, 1);
        let hash = book.state_hash();
        found.expect(book.advance(0).steps == 0, || "no time, but a step".into());
        found.expect(book.state_hash() == hash, || "no time, but another state".into());
        for dt_us in [1, 16_666, 16_667, 100_000, 1_000_000, 3_600_000_000, u32::MAX] {
            let before = book.now_us();
            most = most.max(book.advance(dt_us).steps);
            let went = book.now_us() - before;
            found.expect(went <= 8 * 16_667, || format!("{went} us caught up"));
            found.expect(book.leaf().is_none_or(|l| l.x.finite()), || "I1".into());
        }
    }
    found.figure = f64::from(most);
    found.expect(most <= 8, || format!("{most} steps"));
    found
}

/// Drop over reach of a leaf at rest, off from the elastica's, as a share.
fn off<R: Real, G: Grid>(at: At, gamma: f64) -> f64 {
    let (leaf, mut paper) = (LeafSpec::default(), PaperSpec::default());
    let w = leaf.width_m;
    paper.youngs_gpa *=
        paper.areal_mass_gsm * 1e-3 * 9.81 * w * w * w / gamma / paper.rigidity_nm();
    let world = WorldSpec { damping_per_s: 5.0, ..WorldSpec::default() };
    let mut lone = Box::new(LoneLeaf::<R, G>::EMPTY);
    lone.open(&leaf, &paper, &world, at.fidelity).expect("a sound leaf");
    for _ in 0..400 {
        let _ = lone.step();
    }
    let [x, y, _] = lone.leaf().x.at(G::NX - 1, G::NZ / 2).0.map(Real::wide);
    let [drop, reach] = droop(gamma);
    ((-y / x) / (drop / reach) - 1.0).abs()
}

/// 11: the droop of a clamped leaf on the grids there are, against the elastica.
pub fn grids<R: Real>(at: At) -> Found {
    let g = 10.0;
    let coarse = [off::<R, G6x5>(at, g), off::<R, G8x6>(at, g)];
    let usual = off::<R, G11x8>(at, g);
    let mut found = Found::within(usual, 0.03);
    found.expect(usual <= coarse[1] && coarse[1] <= coarse[0], || {
        format!("coarser is not worse: {:.4} {:.4} {usual:.4}", coarse[0], coarse[1])
    });
    if at.full {
        let fine = [off::<R, G16x12>(at, g), off::<R, G22x16>(at, g)];
        let best = fine[0].min(fine[1]);
        found.expect(best <= usual, || format!("finer is not better: {best:.4} {usual:.4}"));
    }
    found
}

/// Sets one of the seed's weights.
type Dial = (&'static str, fn(&mut Weights, f64));

const DIALS: [Dial; 5] = [
    ("bend_3d", |w, v| w.bend_3d = v),
    ("bend_2d", |w, v| w.bend_2d = v),
    ("glue", |w, v| w.glue = v),
    ("iso_3d", |w, v| w.iso_3d = v),
    ("position", |w, v| w.position = v),
];

fn weighted<R: Real>(at: At, set: impl Fn(&mut Weights)) -> (f64, Vec<String>) {
    let mut scene = with(&Scene::seed(), at);
    let mut weights = Weights::default();
    set(&mut weights);
    scene.paper.weights = Some(weights);
    let samples = Gesture::corner_turn(&scene.eye(), 7);
    let seen = play::<R>(&scene, &samples, &Rules::NUMBERS);
    (seen.watch.air.worst, seen.faults)
}

/// Largest stretch of a leaf that hangs still, with this weight of isometry.
fn hanging<R: Real>(at: At, iso_3d: f64) -> f64 {
    let scene = Scene::seed();
    let paper =
        PaperSpec { weights: Some(Weights { iso_3d, ..Weights::default() }), ..scene.paper };
    let world = WorldSpec { damping_per_s: 5.0, ..scene.world };
    let spec = LeafSpec {
        width_m: scene.book.width_m,
        height_m: scene.book.height_m,
        ..LeafSpec::default()
    };
    let mut lone = Box::new(LoneLeaf::<R, G11x8>::EMPTY);
    lone.open(&spec, &paper, &world, at.fidelity).expect("a sound leaf");
    for _ in 0..200 {
        let _ = lone.step();
    }
    lone.stretch().max().wide()
}

/// 12: no number is lost, and a leaf at rest keeps its lengths wherever isometry weighs enough.
pub fn weights<R: Real>(at: At) -> Found {
    let mut found = Found::default();
    let every = if at.full { 1 } else { 3 };
    let values = [1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6];
    for (name, set) in DIALS {
        for &value in values.iter().step_by(every) {
            let (worst, faults) = weighted::<R>(at, |w| set(w, value));
            found.figure = found.figure.max(worst);
            found.faults.extend(faults.into_iter().map(|f| format!("{name} {value:e}: {f}")));
        }
    }
    for iso_3d in [400.0, 1e3, 4e3, 1e5, 1e6] {
        let s = hanging::<R>(at, iso_3d);
        found.expect(s <= 0.01, || format!("iso_3d {iso_3d}: hangs stretched {:.2} %", 100.0 * s));
    }
    found
}

/// 13: two weights at a time; at the standard fidelity four values of each, else the ends.
pub fn pairs<R: Real>(at: At) -> Found {
    let all = at.full && at.fidelity == Fidelity::Standard;
    let values: &[f64] = if all { &[1e-3, 1.0, 1e3, 1e6] } else { &[1e-3, 1e6] };
    let mut found = Found::default();
    for (n, (name, set)) in DIALS.into_iter().enumerate() {
        for (other, set_other) in DIALS.into_iter().skip(n + 1) {
            for (&a, &b) in values.iter().flat_map(|a| values.iter().map(move |b| (a, b))) {
                let both = |w: &mut Weights| {
                    set(w, a);
                    set_other(w, b);
                };
                let (worst, faults) = weighted::<R>(at, both);
                found.figure = found.figure.max(worst);
                let named = |f| format!("{name} {a:e}, {other} {b:e}: {f}");
                found.faults.extend(faults.into_iter().map(named));
            }
        }
    }
    found
}
