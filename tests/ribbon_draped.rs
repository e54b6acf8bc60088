//! Promise: a bookmark lies where a finger leaves it: it hangs over the fore-edge, in nothing solid; on a page that is
//! tilted it does not slide; drawn from between leaves over an open page it marks that.

use crate::ribbon_bookmark::{DEEP, Read, Sewn, depth, lie, places, seen, sew};
use dogleaf_core::effect::ribbon::Status;
use dogleaf_core::effect::ribbon::bookmark::{BookmarkSpec, Layer, SEGMENTS};
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::real::{Real, V3};
use dogleaf_core::scene::{BookSpec, Cover};
use dogleaf_tests::gesture::{FRAME_US, Scene};

/// Pictures from one place of the finger to the next.
const PICTURES: u32 = 40;
/// Between its vertices a ribbon is straight and cuts the edge that it hangs over by this at most, metres.
const CUT: f64 = 1e-3;

/// Carries what is seen at `from` through places, and lets go; answers the most it was in anything on the way.
fn pull<R: Real>(book: &Read<R>, mark: &mut Sewn<R>, from: V3<f64>, through: &[V3<f64>]) -> f64 {
    let touch = |mark: &mut Sewn<R>, phase, at| {
        let [x, y] = seen(book, at);
        mark.touch(book, &Sample { t_us: 0, id: 0, phase, x, y, leaves: 1 })
    };
    assert!(touch(mark, Phase::Down, from), "its end is taken");
    let (mut at, mut deepest) = (from, 0.0_f64);
    for &to in through {
        for n in 1..=PICTURES {
            let on = at + (to - at) * (f64::from(n) / f64::from(PICTURES));
            assert!(touch(mark, Phase::Move, on), "it is held");
            assert_ne!(mark.follow(book, FRAME_US).status, Status::Held, "numbers");
            deepest = deepest.max(depth(mark));
        }
        at = to;
    }
    assert!(touch(mark, Phase::Up, at), "it is let go");
    deepest
}

/// How deep the ribbon is in the block of leaves on the right, between its vertices too.
fn in_the_leaves(spec: &BookSpec, top: f64, ribbon: &[V3<f64>]) -> f64 {
    let mut deepest = 0.0_f64;
    for (a, b) in ribbon.iter().zip(ribbon.iter().skip(2)) {
        for n in 0..=8 {
            let p = *a + (*b - *a) * (f64::from(n) / 8.0);
            let [x, y, z] = p.0;
            let beside = x > 0.5 * spec.width_m && z.abs() < 0.5 * spec.height_m;
            if beside {
                deepest = deepest.max((spec.width_m - x).min(top - y));
            }
        }
    }
    deepest
}

fn hangs_over<R: Real>(name: &str, spec: BookSpec) {
    let scene = Scene::of(spec);
    let (book, mut mark) = sew::<R>(&scene, spec.read());
    lie(&book, &mut mark);
    let all = places(&mark);
    let end = (all[all.len() - 2] + all[all.len() - 1]) * 0.5;
    let over = V3([0.02, 0.03, 0.07]);
    let beyond = V3([spec.width_m + 0.035, 0.03, 0.03]);
    let deep = pull(&book, &mut mark, end, &[over, beyond]);
    let steps = lie(&book, &mut mark);
    let (all, at_rest) = (places(&mark), depth(&mark));
    let top = scene.paper.thickness_mm * 1e-3 * f64::from(spec.leaves() - spec.read());
    let hanging = all.iter().filter(|p| p.0[0] > spec.width_m && p.0[1] < 0.5 * top).count();
    let cut = in_the_leaves(&spec, top, &all);
    println!(
        "{name} {}: {hanging} vertices hang, after {steps} steps; {at_rest:.1e} m in something, {cut:.1e} m in the leaves, \
         on the way {deep:.1e} m",
        R::NAME
    );
    assert!(hanging >= 4, "{name}: its end hangs over the fore-edge");
    assert!(at_rest <= DEEP, "{name}: {at_rest} m inside something");
    assert!(cut <= CUT, "{name}: {cut} m in the leaves");
    assert!(!mark.needs_frame(), "it sleeps");
}

#[test]
fn it_hangs_over_the_fore_edge() {
    for (name, cover) in [("hard", Cover::Hard), ("soft", Cover::Soft)] {
        let spec = BookSpec { cover, ..BookSpec::default() };
        hangs_over::<f32>(name, spec);
        hangs_over::<f64>(name, spec);
    }
}

/// How far the end slides on a page tilted towards the spine by ten degrees, from half a second after it was let go.
fn slides<R: Real>(friction: f64) -> f64 {
    let mut scene = Scene::default();
    let tilt = 10.0_f64.to_radians();
    scene.world.gravity = [-9.81 * tilt.sin(), -9.81 * tilt.cos(), 0.0];
    let (book, mut mark) = sew::<R>(&scene, scene.book.read());
    let spec = BookmarkSpec { friction, place: scene.book.read(), ..BookmarkSpec::default() };
    mark.open(&spec, &book).expect("a sound ribbon");
    for _ in 0..90 {
        let _ = mark.follow(&book, FRAME_US);
    }
    let middle = |mark: &Sewn<R>, j: usize| {
        let all = places(mark);
        (all[2 * j] + all[2 * j + 1]) * 0.5
    };
    let last = SEGMENTS;
    let end = middle(&mark, last);
    let _ = pull(&book, &mut mark, end, &[V3([0.02, 0.03, 0.07]), V3([0.09, 0.02, 0.05])]);
    for _ in 0..30 {
        let _ = mark.follow(&book, FRAME_US);
    }
    let landed = middle(&mark, last);
    for _ in 0..120 {
        let _ = mark.follow(&book, FRAME_US);
    }
    let slid = (middle(&mark, last) - landed).norm();
    println!("{} at a friction of {friction}: {:.2} mm", R::NAME, 1e3 * slid);
    slid
}

#[test]
fn it_does_not_slide_on_a_tilted_page() {
    for slides in [slides::<f32>, slides::<f64>] {
        assert!(slides(0.3) < 1e-3, "friction holds it");
        assert!(slides(0.0) > 5e-3, "without friction it slides");
    }
}

/// Draws the end of a bookmark between leaves through places, and lets go.
fn drawn<R: Real>(through: &[V3<f64>]) -> (Read<R>, Sewn<R>) {
    let scene = Scene::default();
    let (book, mut mark) = sew::<R>(&scene, scene.book.read() / 2);
    lie(&book, &mut mark);
    assert_eq!(mark.layer(), Layer::Block(0), "it lies between leaves");
    let all = places(&mark);
    let end = (all[all.len() - 2] + all[all.len() - 1]) * 0.5;
    let _ = pull(&book, &mut mark, end, through);
    lie(&book, &mut mark);
    (book, mark)
}

fn comes_out<R: Real>() {
    let (book, mark) = drawn::<R>(&[V3([0.0, 0.02, 0.11]), V3([0.02, 0.02, 0.05])]);
    assert_eq!(mark.place(), book.spec().read(), "it marks the open page");
    assert_eq!(mark.layer(), Layer::Open(true), "on which it lies");
    assert!(depth(&mark) <= DEEP, "{} m inside something", depth(&mark));
    assert_eq!(mark.pressed(), 0, "none of it is between leaves");
    let (book, mark) = drawn::<R>(&[V3([-0.03, 0.0, 0.12])]);
    assert_eq!(
        mark.place(),
        book.spec().read() / 2,
        "pulled at beside the book it stays where it is"
    );
}

#[test]
fn it_comes_out_from_between_leaves() {
    comes_out::<f32>();
    comes_out::<f64>();
}
