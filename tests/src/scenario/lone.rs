//! Scenarios 1-4: a leaf left to itself.

use super::harness::{Rules, apart, at as with, play};
use super::{At, Found};
use crate::gesture::{Gesture, Scene};
use dogleaf_core::LoneLeaf;
use dogleaf_core::grid::{G11x8, Grid};
use dogleaf_core::real::Real;
use dogleaf_core::scene::{LeafSpec, PaperSpec, WorldSpec};

/// A leaf held along its spine.
pub type Lone<R, G> = Box<LoneLeaf<R, G>>;

/// A lone leaf of office paper, opened.
pub fn lone<R: Real, G: Grid>(spec: &LeafSpec, world: &WorldSpec, at: At) -> Lone<R, G> {
    let mut lone = Box::new(LoneLeaf::<R, G>::EMPTY);
    lone.open(spec, &PaperSpec::default(), world, at.fidelity).expect("a sound leaf");
    lone
}

/// Kinetic and potential energy together.
pub fn energy<R: Real, G: Grid>(leaf: &LoneLeaf<R, G>) -> f64 {
    leaf.energy().map(Real::wide).iter().sum()
}

/// 1: a million steps at full length for one leaf in `f32` stand in the soak; here fewer, of every kind.
///
/// A leaf at rest that nothing lets sleep does not creep; a book that has turned a page comes to a fixed point, which
/// is sleep.
pub fn rest<R: Real>(at: At) -> Found {
    let world = WorldSpec { damping_per_s: 5.0, ..WorldSpec::default() };
    let mut leaf = lone::<R, G11x8>(&LeafSpec::default(), &world, at);
    let steps = at.count(10_000, 1_500);
    let mut start = None;
    for n in 0..steps {
        let _ = leaf.step();
        if n == steps / 2 {
            start = Some(leaf.leaf().clone());
        }
    }
    let drift = apart(start.as_ref(), Some(leaf.leaf()));
    let mut found = Found::within(drift, 1e-5);
    let scene = with(&Scene::default(), at);
    let seen = play::<R>(&scene, &Gesture::corner_turn(&scene.eye(), 1), &Rules::GENTLE);
    let mut book = seen.book;
    let hash = book.state_hash();
    let work = (0..steps).map(|_| book.advance(16_667).steps).sum::<u32>();
    let same = work == 0 && book.state_hash() == hash;
    found.expect(same, || format!("a sleeping book took {work} steps"));
    found.with(seen.faults)
}

/// 2: energy does not grow while it falls; a lifted page let go is at rest within three seconds.
pub fn fall<R: Real>(at: At) -> Found {
    let spec = LeafSpec { clamp_angle_deg: 70.0, curl_per_m: -5.0, ..LeafSpec::default() };
    let mut leaf = lone::<R, G11x8>(&spec, &WorldSpec::default(), at);
    let (mut before, mut gained) = (energy(&leaf), 0f64);
    let scale = before.abs().max(1.0);
    for _ in 0..240 {
        let _ = leaf.step();
        let now = energy(&leaf);
        gained = gained.max((now - before) / scale);
        before = now;
    }
    let mut found = Found::within(gained, if size_of::<R>() == 4 { 2e-5 } else { 1e-6 });
    let scene = with(&Scene::default(), at);
    let eye = scene.eye();
    let lift = Gesture::press(eye.page(0.9, 0.8)).to(eye.above(0.4, 0.4, 0.8), 600_000);
    let rules = Rules { rest_s: Some(3.0), ..Rules::GENTLE };
    let seen = play::<R>(&scene, &lift.hold(300_000).cancel(), &rules);
    found.expect(seen.watch.turns() == [1, 0, 1], || "it did not come back".into());
    found.with(seen.faults)
}

/// 3: the energy that implicit steps lose halves with the step.
///
/// A leaf that starts flat and falls under its weight alone: everything in it is smooth. One that is let go from
/// an arc has a kink in its curvature at the free edge, which stirs every mode at once; what is lost then
/// falls only with the cube root of the step.
pub fn drift<R: Real>(at: At) -> Found {
    let lost = |step_us: u32| {
        let world = WorldSpec { damping_per_s: 0.0, step_us, ..WorldSpec::default() };
        let mut leaf = lone::<R, G11x8>(&LeafSpec::default(), &world, at);
        let before = energy(&leaf);
        for _ in 0..48_000 / step_us {
            let _ = leaf.step();
        }
        before - energy(&leaf)
    };
    let [coarse, fine] = [2_000, 1_000].map(lost);
    let order = (coarse / fine).log2();
    let mut found = Found { figure: order, faults: Vec::new() };
    found.expect(coarse > 0.0 && fine > 0.0, || format!("energy gained: {coarse:.2e}, {fine:.2e}"));
    found.expect((0.7..=1.3).contains(&order), || format!("of order {order:.2}, not 1"));
    found
}

/// 4: where the rows of the net lose rank.
pub fn flat<R: Real>(at: At) -> Found {
    let void = WorldSpec { gravity: [0.0; 3], ..WorldSpec::default() };
    let mut still = lone::<R, G11x8>(&LeafSpec::default(), &void, at);
    let start = still.leaf().clone();
    let report = still.step();
    let moved = apart(Some(&start), Some(still.leaf()));
    let mut found = Found { figure: moved, faults: Vec::new() };
    found.expect(moved < 1e-6, || format!("a flat leaf in the void moved {moved:.1e}"));
    found.expect(!report.status.failed(), || format!("{report:?}"));
    // And from there under its weight: the first step is of the size of free fall.
    let mut leaf = lone::<R, G11x8>(&LeafSpec::default(), &WorldSpec::default(), at);
    let report = leaf.step();
    let fell = apart(Some(&start), Some(leaf.leaf()));
    found.expect(leaf.leaf().x.finite() && fell < 0.05, || format!("fell {fell:.2} at once"));
    found.expect(!report.status.failed(), || format!("{report:?}"));
    found.figure = fell;
    found
}
