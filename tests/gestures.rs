//! Promise: what fingers mean. One leads a leaf and its last speed decides; a second flips leaves behind it; where one page
//! is seen it turns both ways; an app that was busy catches up; pages of every shape turn.

use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Phase, Sample, View};
use dogleaf_core::mesh::Vertex;
use dogleaf_core::reading::{FACES, Face, Motion, MotionPolicy, Shape, Tick};
use dogleaf_core::record::Setup;
use dogleaf_core::scene::{Direction, Pages};
use dogleaf_tests::app::{FRAME_US, Read, START_US, Seen, open, played, run, run_to, setup, turn};

/// A finger holds a leaf while a second one flips further leaves to it and back.
#[test]
fn a_finger_marks_a_page_while_others_are_flipped() {
    let mut read = open(&setup());
    let mut seen = Seen::default();
    let samples = turn(&setup(), 8);
    let half = samples.len() * 45 / 100;
    let mut now = run_to(&mut read, &samples[..half], &mut seen, START_US);
    let second =
        |t_us, phase, x: i32| Sample { t_us, id: 1, phase, x: x * 256, y: 300 * 256, leaves: 0 };
    let swipe = |read: &mut Read, seen: &mut Seen, now: &mut u64, from: i32, to: i32| {
        let steps = 8;
        let mut samples = vec![second(*now, Phase::Down, from)];
        for n in 1..=steps {
            let x = from + (to - from) * n / steps;
            samples.push(second(*now + 10_000 * n as u64, Phase::Move, x));
        }
        samples.push(second(*now + 90_000, Phase::Up, to));
        *now = run_to(read, &samples, seen, *now);
    };
    let held = |read: &Read| read.book().binding().held;
    let lying = read.book().binding().leaves;
    swipe(&mut read, &mut seen, &mut now, 900, 700);
    assert_eq!(held(&read), 4, "three swipes' lengths towards the middle add three");
    assert_eq!(read.book().binding().leaves[1], lying[1] - 3, "taken from the block behind");
    let mut mesh = vec![Vertex::default(); Shape::<G11x8>::VERTICES];
    let pieces = read.vertices(&mut mesh).expect("room");
    assert_eq!(pieces.len(), FACES);
    let flying: Vec<_> = pieces.iter().filter(|p| p.flying && p.visible).collect();
    assert_eq!(flying.len(), 3, "one is seen on its way");
    assert_eq!(flying[0].face, Face::Page(26), "the leaf that was added last");
    swipe(&mut read, &mut seen, &mut now, 700, 830);
    assert_eq!(held(&read), 2, "away from the middle gives them back");
    swipe(&mut read, &mut seen, &mut now, 500, 950);
    assert_eq!(held(&read), 1, "but never the one the finger holds");
    let up = Sample { t_us: now, phase: Phase::Cancel, ..samples[half] };
    let _ = run(&mut read, &[up], &mut seen, now);
    assert_eq!(read.book().binding().all(), 30, "no leaf is lost");
    assert_eq!(seen.ends()[0], 1);
    assert!(seen.ticks().iter().filter(|t| **t == Tick::Flip).count() >= 6, "each is felt");
}

/// What is not to be seen moving is not drawn because a second finger moves it.
#[test]
fn no_leaf_flies_where_nothing_is_to_move() {
    for (name, policy) in [("reduced", MotionPolicy::Reduced), ("none", MotionPolicy::None)] {
        let mut read = open(&setup());
        read.set_motion(Motion { policy, cap_us: None }).expect("a policy");
        let mut seen = Seen::default();
        let whole = turn(&setup(), 8);
        let mut samples = whole[..whole.len() * 45 / 100].to_vec();
        let last = samples[samples.len() - 1];
        for n in 0..=20_i32 {
            let phase = if n == 0 { Phase::Down } else { Phase::Move };
            let t_us = last.t_us + 20_000 * n as u64;
            samples.push(Sample {
                t_us,
                id: 1,
                phase,
                x: (900 - 10 * n) * 256,
                y: 300 * 256,
                leaves: 0,
            });
        }
        let now = run_to(&mut read, &samples[..1], &mut seen, START_US);
        let _ = read.step(now, &mut seen.hashes);
        let pictures = seen.pictures.len();
        let _ = run_to(&mut read, &samples[1..], &mut seen, now);
        assert_eq!(read.book().binding().held, 4, "{name}: three were flipped");
        assert_eq!(seen.pictures.len(), pictures, "{name}: and nothing drawn");
    }
}

/// Where one page is seen, a drag inwards turns on and a drag outwards pulls the last page back.
#[test]
fn one_page_turns_both_ways() {
    for direction in [Direction::Ltr, Direction::Rtl] {
        let mut setup = setup();
        let right = direction == Direction::Ltr;
        setup.book.direction = direction;
        setup.handling.pages = Pages::Single;
        setup.view = View::page(setup.book.width_m, setup.book.height_m, 600, 900, right);
        let mut read = open(&setup);
        let mut seen = Seen::default();
        let drag = |from: f64, to: f64, start: u64| -> Vec<Sample> {
            let x = |share: f64| if right { share * 600.0 } else { (1.0 - share) * 600.0 };
            let sample = |n: u64| {
                let share = from + (to - from) * n as f64 / 40.0;
                let phase = [Phase::Down, Phase::Move, Phase::Up]
                    [usize::from(n > 0) + usize::from(n == 40)];
                let place = [(x(share) * 256.0) as i32, 500 * 256];
                Sample {
                    t_us: start + n * 12_000,
                    id: 3,
                    phase,
                    x: place[0],
                    y: place[1],
                    leaves: 0,
                }
            };
            (0..=40).map(sample).collect()
        };
        let now = run(&mut read, &drag(0.95, -0.4, START_US), &mut seen, START_US);
        assert_eq!(read.page(), 22, "{direction:?}: on");
        let now = run(&mut read, &drag(0.05, 0.9, now), &mut seen, now);
        assert_eq!(read.page(), 20, "{direction:?}: and back");
        let tap = drag(0.5, 0.5, now);
        let _ = run(&mut read, &tap, &mut seen, now);
        assert_eq!(
            (read.page(), seen.ends()),
            (20, [2, 2, 0]),
            "{direction:?}: a tap is the app's"
        );
    }
}

/// A finger at the middle of the fore-edge, then so many page widths inwards in so many milliseconds, and so on.
fn flick(setup: &Setup, ways: &[(f64, u64)]) -> Vec<Sample> {
    let view = setup.view;
    let (x0, page) = (f64::from(view.width_px) * 0.80, f64::from(view.width_px) * 0.33);
    let y = (f64::from(view.height_px) * 0.55 * 256.0) as i32;
    let at = |t_us: u64, phase, share: f64| {
        let x = ((x0 - share * page) * 256.0) as i32;
        Sample { t_us: START_US + t_us, id: 0, phase, x, y, leaves: 0 }
    };
    let (mut t, mut share) = (50_000, 0.0);
    let mut samples = vec![at(t, Phase::Down, 0.0)];
    for &(to, ms) in ways {
        let steps = (ms / 4).max(1);
        for n in 1..=steps {
            let s = share + (to - share) * n as f64 / steps as f64;
            samples.push(at(t + 4000 * n, Phase::Move, s));
        }
        (t, share) = (t + 4000 * steps, to);
    }
    samples.push(at(t + 1000, Phase::Up, share));
    samples
}

#[test]
fn what_a_release_means() {
    let setup = setup();
    let pages = |ways: &[(f64, u64)]| {
        let (read, seen) = played(Motion::FULL, &flick(&setup, ways));
        assert_eq!(seen.ends()[0], seen.ends()[1] + seen.ends()[2], "each lifting ends once");
        read.page() - 20
    };
    assert_eq!(pages(&[(0.3, 120)]), 2, "a flick turns");
    assert_eq!(pages(&[(0.015, 20)]), 0, "a fast tiny twitch does not");
    assert_eq!(pages(&[(0.3, 400), (0.12, 80)]), 0, "the finger's way back cancels");
    assert_eq!(
        pages(&[(0.3, 120), (0.3, 400)]),
        0,
        "what counts is the speed at the end: it stopped"
    );
    assert_eq!(pages(&[(0.1, 800), (0.35, 100)]), 2, "or got fast at last");
    assert_eq!(pages(&[(1.75, 900)]), 2, "slowly, but over the spine");
}

/// An app that was busy hands over everything at once: the leaf catches up with the finger.
#[test]
fn buffered_samples_are_caught_up() {
    let setup = setup();
    let samples = flick(&setup, &[(0.4, 200)]);
    let mut read = open(&setup);
    for s in &samples[..samples.len() - 1] {
        read.pointer(*s, &mut ()).expect("room");
    }
    let now = samples.last().expect("one").t_us;
    let mut frames = 0;
    for n in 0..20 {
        let _ = read.step(now + n * FRAME_US, &mut ());
        frames += 1;
        let (paper, inside) = read.book().touched().expect("held");
        let seen = read.book().camera().project(paper).expect("before the eye");
        let finger = samples[samples.len() - 2];
        let off = (seen[0] - finger.x as f32 / 256.0).hypot(seen[1] - finger.y as f32 / 256.0);
        if inside && off < 1.5 {
            break;
        }
    }
    assert!(frames <= 16, "{frames} frames until the paper is under the finger");
}

#[test]
fn every_shape_of_page_turns() {
    for aspect in [0.5, 0.7, 1.0, 1.4, 2.0, 4.0] {
        let mut setup = setup();
        setup.book.height_m = setup.book.width_m * aspect;
        setup.view = View::reading(setup.book.width_m, setup.book.height_m, 960, 720);
        for seed in 0..4 {
            let mut read = open(&setup);
            let mut seen = Seen::default();
            let _ = run(&mut read, &turn(&setup, seed), &mut seen, START_US);
            assert_eq!(seen.ends(), [1, 1, 0], "height {aspect} times the width, gesture {seed}");
        }
    }
}

/// The system takes the finger away (a call, a swipe of its own): no page turns by that, wherever the leaf is.
#[test]
fn a_finger_that_is_taken_away_puts_the_leaf_back() {
    for direction in [Direction::Ltr, Direction::Rtl] {
        let mut setup = setup();
        setup.book.direction = direction;
        let whole = turn(&setup, 3);
        for tenth in 1..10 {
            let mut samples = whole[..whole.len() * tenth / 10].to_vec();
            samples.last_mut().expect("a sample").phase = Phase::Cancel;
            let mut read = open(&setup);
            let mut seen = Seen::default();
            let _ = run(&mut read, &samples, &mut seen, START_US);
            assert_eq!(
                (seen.ends(), read.page()),
                ([1, 0, 1], 20),
                "{tenth} tenths, {direction:?}"
            );
        }
    }
}
