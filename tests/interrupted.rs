//! Promise: what interrupts a turn does not break it. A pause, a late frame, late or doubled samples, a reader
//! who turns the screen: the book goes on from where it is, in bounded work, and comes to rest.

use dogleaf_core::Book;
use dogleaf_core::book::InputError;
use dogleaf_core::event::Event;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Phase, Sample, View};
use dogleaf_tests::gesture::{FRAME_US, Gesture, Rng, Scene, play};
use dogleaf_tests::watch::{Watch, fault};

type Pages = Book<f32, G11x8>;

fn open(scene: &Scene) -> Box<Pages> {
    scene.open().expect("a sound scene")
}
fn scene() -> Scene {
    Scene::default()
}
fn turn() -> Vec<Sample> {
    Gesture::corner_turn(&scene().eye(), 11)
}

/// A book half way through a turn, and the samples it has not had yet.
fn half_way() -> (Box<Pages>, Vec<Sample>) {
    let (mut book, samples) = (open(&scene()), turn());
    play(&mut book, &samples, 30, &mut |_, _| ());
    assert!(book.held().is_some(), "a finger holds it");
    let now = book.now_us();
    (book, samples.into_iter().filter(|s| s.t_us > now).collect())
}

/// Plays samples whose times are the book's own; answers what was seen.
fn play_on(book: &mut Pages, samples: &[Sample], frames: u32) -> Watch {
    let mut seen = Watch::default();
    let mut next = samples.iter().copied().peekable();
    for _ in 0..frames {
        let until = book.now_us() + u64::from(FRAME_US);
        while let Some(sample) = next.next_if(|s| s.t_us <= until) {
            book.input(sample).expect("in order");
        }
        let report = book.advance(FRAME_US);
        seen.see(book, &report);
    }
    seen
}

fn came_to_rest(seen: &Watch) {
    assert_eq!(seen.complaint, None, "a state no book may be in");
    assert!(seen.rest.is_some(), "at rest in the end");
    let [_, committed, cancelled] = seen.turns();
    assert_eq!(committed + cancelled, 1, "{:?}", seen.events);
}

#[test]
fn a_pause_is_capped() {
    for pause_us in [1_000_000, 30_000_000, u32::MAX] {
        let (mut book, rest) = half_way();
        let before = book.now_us();
        let report = book.advance(pause_us);
        assert!(report.steps <= 8, "{} steps for {pause_us} µs", report.steps);
        assert!(book.now_us() - before <= 8 * 16_667, "time goes on as far as the steps went");
        assert_eq!(fault(&book), None);
        let next = book.advance(FRAME_US);
        assert!(next.steps <= 2, "nothing is caught up later: {} steps", next.steps);
        let later: Vec<_> = rest.into_iter().filter(|s| s.t_us >= book.now_us()).collect();
        came_to_rest(&play_on(&mut book, &later, 400));
    }
}

/// A pause, then the system takes the pointer; or the finger has long gone and nobody says so until then.
#[test]
fn a_pause_and_then_the_end() {
    for phase in [Phase::Cancel, Phase::Up] {
        let (mut book, rest) = half_way();
        let _ = book.advance(30_000_000);
        let end = Sample { t_us: book.now_us() + 30_000_000, phase, ..rest[0] };
        book.input(end).expect("in order");
        let seen = play_on(&mut book, &[], 40 * 60);
        came_to_rest(&seen);
    }
}

#[test]
fn late_samples_act_at_once() {
    let (mut book, rest) = half_way();
    for _ in 0..60 {
        let _ = book.advance(FRAME_US);
    }
    // The whole rest of the turn arrives a second late, all at once.
    rest.iter().for_each(|s| book.input(*s).expect("in order"));
    let report = book.advance(FRAME_US);
    assert_eq!(report.refused, 0, "late, not wrong");
    assert!(book.held().is_none() || report.steps == 1, "all in one step");
    came_to_rest(&play_on(&mut book, &[], 400));
}

#[test]
fn out_of_order_is_refused() {
    let (mut book, rest) = half_way();
    book.input(rest[3]).expect("in order");
    let hash = book.state_hash();
    for earlier in &rest[..3] {
        assert_eq!(book.input(*earlier), Err(InputError::OutOfOrder));
    }
    assert_eq!(book.state_hash(), hash, "unchanged");
    came_to_rest(&play_on(&mut book, &rest[4..], 400));
}

#[test]
fn doubled_samples_change_nothing() {
    let (mut one, rest) = half_way();
    let (mut two, _) = half_way();
    let twice: Vec<_> = rest.iter().flat_map(|&s| [s, s]).collect();
    let [a, b] = [play_on(&mut one, &rest, 400), play_on(&mut two, &twice, 400)];
    came_to_rest(&a);
    assert_eq!(a.events, b.events);
    assert_eq!(one.state_hash(), two.state_hash(), "to the last bit");
    assert_eq!(b.work.refused, 1, "only the second letting go finds nothing");
}

#[test]
fn a_full_queue_refuses() {
    let (mut book, rest) = half_way();
    let hash = book.state_hash();
    let mut taken = 0;
    let refused = (0..1000).find_map(|n| {
        let sample = Sample { t_us: book.now_us() + 1 + n, x: rest[0].x + n as i32, ..rest[0] };
        taken += 1;
        book.input(sample).err()
    });
    assert_eq!((refused, taken), (Some(InputError::Full), 65), "sixty-four samples wait");
    assert_eq!(book.state_hash(), hash, "unchanged");
    // When they have been taken there is room again.
    let _ = book.advance(FRAME_US);
    let up = Sample { t_us: book.now_us(), phase: Phase::Up, ..rest[0] };
    book.input(up).expect("room");
    came_to_rest(&play_on(&mut book, &[], 400));
}

/// A clock gone wild must not make the book deaf.
#[test]
fn a_sample_from_the_end_of_time() {
    for t_us in [u64::MAX, u64::MAX / 2, 1 << 40] {
        let (mut book, rest) = half_way();
        let wild = Sample { t_us, ..rest[0] };
        let refused = book.input(wild).is_err();
        for sample in &rest {
            let answer = book.input(*sample);
            assert!(answer.is_ok(), "{answer:?} after a sample at {t_us} (refused: {refused})");
            let _ = book.advance(FRAME_US);
        }
        came_to_rest(&play_on(&mut book, &[], 400));
    }
}

/// Looking from elsewhere in the middle of a drag leaves the leaf alone, step by step, to the last bit.
#[test]
fn looking_elsewhere_changes_nothing() {
    let views = [
        View::reading(0.13, 0.20, 300, 1200),
        View { eye_m: [0.4, 0.1, 0.4], ..scene().view },
        View { eye_m: [0.0, 0.0, 1.0], target_m: [0.0; 3], ..scene().view },
        View { fov_y_deg: 120.0, ..scene().view },
    ];
    for view in views {
        let ((mut still, _), (mut looks, _)) = (half_way(), half_way());
        looks.look(&view).expect("a view");
        for n in 0..60 {
            let [a, b] = [&mut still, &mut looks].map(|b| b.advance(FRAME_US));
            assert_eq!(a, b, "picture {n}");
            assert_eq!(still.state_hash(), looks.state_hash(), "picture {n}");
        }
    }
}

/// A screen that turns under the finger: the same places mean others now, and the leaf stays a leaf.
#[test]
fn a_drag_goes_on_in_another_view() {
    let mut rng = Rng::new(5);
    for _ in 0..20 {
        let (mut book, rest) = half_way();
        let [width, height] = [0, 1].map(|_| rng.within(200.0, 2000.0) as u32);
        let mut view = View::reading(0.13, 0.20, width, height);
        view.eye_m[0] = rng.within(-0.3, 0.3);
        book.look(&view).expect("a view");
        came_to_rest(&play_on(&mut book, &rest, 500));
    }
}

/// Frames of any length, as a busy machine gives them.
#[test]
fn frames_of_any_length() {
    let mut rng = Rng::new(9);
    for _ in 0..20 {
        let mut book = open(&scene());
        let samples = turn();
        let (mut wall, mut given) = (0u64, 0);
        let mut seen = Watch::default();
        while wall < 8_000_000 {
            let frame = rng.within(0.0, 9.0).exp2() as u32 * 250;
            wall += u64::from(frame);
            let due = samples[given..].iter().take_while(|s| s.t_us <= wall).count();
            samples[given..given + due].iter().for_each(|s| book.input(*s).expect("in order"));
            given += due;
            let report = book.advance(frame);
            seen.see(&mut book, &report);
        }
        came_to_rest(&seen);
        assert!(seen.events.contains(&Event::Asleep), "{:?}", seen.events);
    }
}
