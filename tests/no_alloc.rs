//! Promise: nothing allocates. Ten thousand steps of every gesture, events and hashes included, ask the
//! allocator for nothing.

use crate::tally::asked;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::Sample;
use dogleaf_core::real::Real;
use dogleaf_core::scene::{Fidelity, LeafSpec};
use dogleaf_core::{Book, LoneLeaf};
use dogleaf_tests::gesture::{Eye, Gesture, Rng, Scene};
use std::hint::black_box;

/// Steps of a book under watch.
const STEPS: u32 = 10_000;

/// Gestures of every kind, one after the other.
fn gestures(eye: &Eye) -> Vec<Vec<Sample>> {
    let mut rng = Rng::new(1);
    let mut all: Vec<_> = (0..6).map(|seed| Gesture::corner_turn(eye, seed)).collect();
    for _ in 0..6 {
        let mut gesture = Gesture::press_stack(eye.page(0.9, rng.within(-0.9, 0.9)), 5);
        for _ in 0..8 {
            let to = eye.above(rng.within(-1.3, 1.3), rng.within(0.0, 0.8), rng.within(-1.2, 1.2));
            gesture = gesture.to(to, 100_000);
        }
        all.push(gesture.clone().up());
        all.push(gesture.cancel());
        all.push(
            eye.mirror(&Gesture::press(eye.page(0.9, 0.5)).to(eye.page(0.3, 0.5), 90_000).up()),
        );
    }
    all
}

/// Takes a book through the gestures for [`STEPS`] steps; answers a digest, so that nothing is left out.
fn read<R: Real>(book: &mut Book<R, G11x8>, gestures: &[Vec<Sample>]) -> u64 {
    let (mut digest, mut step) = (0u64, 0);
    for gesture in gestures.iter().cycle() {
        let start = book.now_us();
        let mut next = gesture.iter().map(|s| Sample { t_us: s.t_us + start, ..*s }).peekable();
        while next.peek().is_some() || book.needs_frame() {
            while let Some(sample) = next.next_if(|s| s.t_us <= book.now_us() + 16_667) {
                digest ^= u64::from(book.input(sample).is_err());
            }
            let report = book.advance(16_667);
            while let Some(event) = book.take_event() {
                digest = digest.wrapping_add(u64::from(
                    black_box(event) == dogleaf_core::event::Event::Asleep,
                ));
            }
            let stretch = book.stretch().max().wide() + book.energy()[0].wide();
            digest = digest.rotate_left(5)
                ^ book.state_hash()
                ^ stretch.to_bits()
                ^ u64::from(report.pushed);
            step += 1;
            if step >= STEPS {
                return digest;
            }
        }
    }
    digest
}

fn asks_for_nothing<R: Real>(scene: &Scene) {
    let gestures = gestures(&scene.eye());
    let mut book = Box::new(Book::<R, G11x8>::EMPTY);
    let times = asked(|| {
        let s = scene;
        book.open(&s.book, &s.paper, &s.world, &s.view, s.fidelity).expect("a sound scene");
        black_box(read(&mut book, &gestures));
        book.look(&s.view).expect("a view");
    });
    assert_eq!(times, 0, "{} {:?}", R::NAME, scene.fidelity);
    assert!(book.spec().open_at != scene.book.open_at, "leaves were turned");
}

#[test]
fn a_book_asks_for_nothing() {
    asks_for_nothing::<f32>(&Scene::default());
    asks_for_nothing::<f64>(&Scene::default());
    asks_for_nothing::<f32>(&Scene::seed());
}

#[test]
fn a_lone_leaf_asks_for_nothing() {
    let scene = Scene::default();
    let mut lone = Box::new(LoneLeaf::<f32, G11x8>::EMPTY);
    let times = asked(|| {
        lone.open(&LeafSpec::default(), &scene.paper, &scene.world, Fidelity::Fine)
            .expect("a sound leaf");
        for _ in 0..STEPS / 10 {
            let _ = lone.advance(16_667);
            black_box((lone.state_hash(), lone.energy(), lone.stretch()));
        }
    });
    assert_eq!(times, 0);
}

/// What the check is worth: the tally sees a list grow, a text, and a box.
#[test]
fn the_check_can_fail() {
    assert_eq!(asked(|| drop(black_box(Vec::<u8>::new()))), 0, "an empty list is nothing");
    assert!(asked(|| drop(black_box(vec![1u8; 8]))) >= 1, "a list");
    assert!(asked(|| drop(black_box(7.to_string()))) >= 1, "a text");
    let mut list = Vec::<u64>::with_capacity(1);
    assert!(asked(|| list.extend(0..100)) >= 1, "a list that grows");
}

#[test]
fn a_ribbon_asks_for_nothing() {
    use dogleaf_core::effect::ribbon::Closure;
    let mut loose = dogleaf_tests::ribbons::helix::<f32, 50>(&dogleaf_tests::ribbons::spec(50));
    let mut band = dogleaf_tests::ribbons::pulled::<f64, 50>(50, Closure::Moebius, 1e3);
    let times = asked(|| {
        for _ in 0..STEPS / 100 {
            black_box((loose.step(0.01), band.step(0.01)));
            black_box((loose.state_hash(), band.state_hash()));
        }
    });
    assert_eq!(times, 0);
}
