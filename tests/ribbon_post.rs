//! Promise: the seed's correction after the step is the optimum it says it is, keeps a falling ribbon out of the ground and
//! two ribbons apart, and stops in time.

use dogleaf_core::effect::ribbon::contact::post::STIFFNESS;
use dogleaf_core::effect::ribbon::contact::{Cushion, HalfSpace, Near, Post};
use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::joint::Crease;
use dogleaf_core::effect::ribbon::{Ribbon, Root};
use dogleaf_core::real::{Real, V3};
use dogleaf_tests::ribbons::{finite, open, spec};

/// Segments, vertices, overlaps.
const N: usize = 20;
const V: usize = 2 * (N + 1);
const M: usize = 64;
type Around<R> = Near<R, [HalfSpace<R>; 1], N, 64, 2048>;

const CUSHION: Cushion = Cushion { reach_m: 2e-3, stiffness: 200.0 };

fn floor<R: Real>(height: f64) -> [HalfSpace<R>; 1] {
    let up = V3([R::ZERO, R::ZERO, R::one()]);
    [HalfSpace { point: up * R::of(height), normal: up }]
}

fn free<R: Real>(height: f64, wavy: f64) -> Box<Ribbon<R, N>> {
    let mut own = spec(N);
    (own.root, own.damping_per_s) = (Root::Free, 2.0);
    let mut ribbon = open::<R, N>(&own);
    ribbon.lay(&Frame::at(V3([0.0, 0.0, height].map(R::of))), |j| Crease {
        psi: R::of(wavy * (j as f64).sin()),
        c: R::ZERO,
    });
    ribbon.gravity = [0.0, 0.0, -9.81];
    ribbon
}

/// `H δ` by the edges themselves.
fn gradient(shift: &[V3<f64>]) -> Vec<V3<f64>> {
    let mut g = shift.to_vec();
    let mut edge = |i: usize, j: usize| {
        let pull = (shift[i] - shift[j]) * STIFFNESS;
        (g[i], g[j]) = (g[i] + pull, g[j] - pull);
    };
    for s in 0..=N {
        edge(2 * s, 2 * s + 1);
        if s < N {
            edge(2 * s, 2 * s + 2);
            edge(2 * s + 1, 2 * s + 3);
            edge(2 * s + 1, 2 * s + 2);
        }
    }
    g
}

fn flat<R>(pairs: impl Iterator<Item = [V3<R>; 2]>) -> Vec<V3<R>> {
    pairs.flatten().collect()
}

/// The conditions of Karush, Kuhn and Tucker on a plane; answers how many vertices it bears.
fn bears(before: &[V3<f64>], after: &[V3<f64>], height: f64) -> usize {
    let shift: Vec<_> = after.iter().zip(before).map(|(a, b)| *a - *b).collect();
    let thickness = CUSHION.reach_m;
    let mut borne = 0;
    for (g, x) in gradient(&shift).iter().zip(after) {
        let gap = x.0[2] - height - thickness;
        assert!(gap > -2e-3 * thickness, "a vertex is too deep by {gap}");
        assert!(g.0[0].abs() + g.0[1].abs() < 1e-9, "nothing pushes sideways");
        assert!(g.0[2] > -1e-9, "the ground does not pull: {}", g.0[2]);
        assert!(g.0[2] < 1e-9 || gap < 2e-3 * thickness, "nor from afar: {} at {gap}", g.0[2]);
        borne += usize::from(g.0[2] > 1e-9);
    }
    borne
}

#[test]
fn it_is_the_optimum() {
    let mut ribbon = free::<f64>(0.01, 0.1);
    let mut near = Box::new(Around::<f64>::over(floor(0.0), CUSHION));
    let mut post = Box::new(Post::<f64, V, M>::EMPTY);
    let mut borne = 0;
    for _ in 0..100 {
        near.begin(&ribbon, 0.01);
        let _ = ribbon.step(0.01);
        let before = flat(ribbon.pairs());
        let report = post.resolve(&mut ribbon, &near, 0.01);
        assert!(!report.capped && report.crowded == 0, "{report:?}");
        let found = bears(&before, &flat(post.corrected(&ribbon)), 0.0);
        assert!(found <= report.active as usize, "{found} of {report:?}");
        borne = borne.max(found);
    }
    assert!(borne > 4, "it comes to lie on the ground");
}

fn lies<R: Real>() {
    let mut ribbon = free::<R>(0.3, 0.1);
    let mut near = Box::new(Around::<R>::over(floor(0.0), CUSHION));
    let mut post = Box::new(Post::<R, V, M>::EMPTY);
    for step in 0..300 {
        near.begin(&ribbon, 0.01);
        let _ = ribbon.step(0.01);
        let report = post.resolve(&mut ribbon, &near, 0.01);
        assert!(finite(&ribbon), "step {step}");
        assert!(report.changes <= 4 * M as u32 + M as u32, "it stops in time: {report:?}");
        let low = post.corrected(&ribbon).flatten().fold(1.0, |m, p| p.0[2].wide().min(m));
        assert!(low > 0.9 * CUSHION.reach_m, "{}: step {step}, {low} m above the ground", R::NAME);
    }
}

#[test]
fn a_falling_ribbon_lies_on_the_ground() {
    lies::<f64>();
    lies::<f32>();
}

#[test]
fn another_ribbon_is_kept_away() {
    let mut above = free::<f32>(0.004, 1e-4);
    let mut below = free::<f32>(0.0, 1e-4);
    below.gravity = [0.0; 3];
    let mut near = Box::new(Around::<f32>::over(floor(-1.0), CUSHION));
    let mut post = Box::new(Post::<f32, V, 300>::EMPTY);
    let mut touched = 0;
    for step in 0..40 {
        near.begin(&above, 0.005);
        near.add(&below);
        let _ = above.step(0.005);
        let report = post.resolve(&mut above, &near, 0.005);
        assert_eq!(report.crowded, 0, "{report:?}");
        touched += report.active;
        let least = flat(post.corrected(&above))
            .iter()
            .zip(flat(below.pairs()))
            .fold(1.0_f32, |m, (a, b)| m.min(a.0[2] - b.0[2]));
        assert!(least > 0.5 * CUSHION.reach_m as f32, "step {step}: {least} m apart");
    }
    assert!(touched > 0, "it has come near");
}

/// What the checks are worth: without the correction the ribbon falls through.
#[test]
fn the_check_can_fail() {
    let mut ribbon = free::<f64>(0.01, 0.1);
    for _ in 0..30 {
        let _ = ribbon.step(0.01);
    }
    let low = ribbon.pairs().flatten().fold(1.0, |m, p| p.0[2].min(m));
    assert!(low < -0.1, "it fell through: {low}");
}
