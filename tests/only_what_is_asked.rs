//! Promise: only what a scene asks for is simulated. A book asleep takes no step and next to no time; drawing and
//! recording change nothing; without a leaf in the air the leaf's solver is not touched.
//!
//! That what nobody asked for is not even in an image is seen by `cargo ci size`.

use crate::meshes::Mesh;
use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::Sample;
use dogleaf_core::step::StepReport;
use dogleaf_tests::gesture::{FRAME_US, Gesture, Scene, play};
use std::hint::black_box;
use std::time::Instant;

/// Pictures of the turn that is compared.
const FRAMES: u32 = 150;
/// A sleeping picture may take this share of one with a leaf.
const SHARE: f64 = 0.01;

fn turned(leaves: u16, mut look: impl FnMut(&Book<f32, G11x8>, &StepReport)) -> (u64, StepReport) {
    let scene = Scene::default();
    let mut book = scene.open::<f32, G11x8>().expect("a sound scene");
    let one = Gesture::corner_turn(&scene.eye(), 9);
    let samples: Vec<_> = one.into_iter().map(|s| Sample { leaves, ..s }).collect();
    let mut sum = StepReport::default();
    play(&mut book, &samples, FRAMES, &mut |book, report| {
        sum.add(report);
        look(book, report);
    });
    (book.state_hash(), sum)
}

#[test]
fn drawing_changes_nothing() {
    let mut mesh = Mesh::new::<G11x8>();
    let plain = turned(1, |_, _| {});
    let drawn = turned(1, |book, _| mesh.draw(book));
    assert_eq!(plain, drawn, "the same state and the same work, drawn or not");
}

#[test]
fn without_a_leaf_in_the_air_its_solver_rests() {
    let (mut flat, mut flying) = (StepReport::default(), StepReport::default());
    let (mut had_leaf, mut without) = (false, 0);
    let _ = turned(60, |book, report| {
        let has_leaf = book.leaf().is_some();
        if has_leaf || had_leaf { &mut flying } else { &mut flat }.add(report);
        without += u32::from(!has_leaf && !had_leaf);
        had_leaf = has_leaf;
    });
    assert!(flying.newton_steps > 0 && flying.passes > 0, "there was a leaf, and it is counted");
    assert!(without > 20, "there were pictures without it: {without}");
    assert_eq!((flat.newton_steps, flat.passes, flat.cuts), (0, 0, 0), "and its solver did not");
}

/// Least time of an `advance` over many, microseconds.
fn least(rounds: u32, mut one: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..rounds {
        let start = Instant::now();
        one();
        least = least.min(start.elapsed().as_secs_f64() * 1e6);
    }
    least
}

#[test]
fn a_sleeping_picture_costs_next_to_nothing() {
    let scene = Scene::default();
    let mut book = scene.open::<f32, G11x8>().expect("a sound scene");
    let many = 1000;
    let asleep = least(200, || {
        for _ in 0..many {
            black_box(book.advance(FRAME_US));
        }
    }) / f64::from(many);
    let mut active = f64::INFINITY;
    for _ in 0..20 {
        assert!(book.take_up(true, 1), "there are leaves on the right");
        while book.needs_frame() {
            let mut steps = 0;
            let time = least(1, || steps = black_box(book.advance(FRAME_US)).newton_steps);
            active = if steps > 0 { active.min(time) } else { active };
        }
    }
    println!("asleep {asleep:.4} us, with a leaf {active:.1} us: {:.4}", asleep / active);
    assert!(active.is_finite(), "a leaf was in the air");
    let next_to_nothing = |time: f64| time < SHARE * active;
    assert!(next_to_nothing(asleep), "{asleep} us asleep, {active} us awake");
    let mut restless = scene.open::<f32, G11x8>().expect("a sound scene");
    let awake = least(20, || {
        restless.take_up(true, 1);
        black_box(restless.step());
    });
    assert!(!next_to_nothing(awake), "a book that does not sleep is noticed: {awake} us");
}
