//! Promise: an app drives the book, and is told exactly once what came of each turn, whatever it shows of it. What it
//! shows changes neither the pages nor the bits.

use dogleaf_core::Reading;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Phase, Sample, View};
use dogleaf_core::mesh::Vertex;
use dogleaf_core::reading::{
    EINK_US, FACES, Face, Motion, MotionPolicy, Notice, Refusal, SNAPSHOT_BYTES, Shape, Tape, Tick,
};
use dogleaf_core::record::{Setup, SliceSink};
use dogleaf_core::scene::{BookSpec, Direction, Fidelity, Handling, Pages};
use dogleaf_tests::gesture::{Gesture, Scene};

type Read = Reading<f32, G11x8>;

/// Where the app's clock stands when it opens a book.
const START_US: u64 = 7_000_000_000;
const FRAME_US: u64 = 16_667;

fn setup() -> Setup {
    let book = BookSpec { pages: 60, open_at: 20, ..BookSpec::default() };
    Setup { fidelity: Fidelity::Fine, handling: Handling::FINGER, ..Setup::reading(book, 960, 720) }
}

fn open(setup: &Setup) -> Box<Read> {
    let mut read = Box::new(Read::EMPTY);
    read.open(setup).expect("a book");
    read
}

/// A turn of the right leaf, in the app's clock.
fn turn(setup: &Setup, seed: u64) -> Vec<Sample> {
    let scene = Scene { view: setup.view, ..Scene::of(setup.book) };
    let mut samples = Gesture::corner_turn(&scene.eye(), seed);
    samples.iter_mut().for_each(|s| s.t_us += START_US);
    samples
}

/// Every hash after a step.
#[derive(Default)]
struct Hashes(Vec<u64>);

impl Tape for Hashes {
    fn input(&mut self, _: &Sample) {}
    fn look(&mut self, _: &View) {}
    fn step(&mut self, hash: impl FnOnce() -> u64) {
        self.0.push(hash());
    }
}

/// What an app saw.
#[derive(Default)]
struct Seen {
    notices: Vec<Notice>,
    /// Times of the pictures, microseconds since the start.
    pictures: Vec<u64>,
    hashes: Hashes,
    frames: u32,
}

impl Seen {
    fn ends(&self) -> [usize; 3] {
        let count = |f: fn(&Notice) -> bool| self.notices.iter().filter(|n| f(n)).count();
        [
            count(|n| matches!(n, Notice::Lifted { .. })),
            count(|n| matches!(n, Notice::Committed { .. })),
            count(|n| matches!(n, Notice::Cancelled)),
        ]
    }
    fn ticks(&self) -> Vec<Tick> {
        let tick = |n: &Notice| if let Notice::Tick(t) = n { Some(*t) } else { None };
        self.notices.iter().filter_map(tick).collect()
    }
}

/// Hands samples over as their time comes and steps until nothing is left to do.
fn run(read: &mut Read, samples: &[Sample], seen: &mut Seen, from_us: u64) -> u64 {
    let (mut now, mut left) = (from_us, samples.iter().peekable());
    for _ in 0..2000 {
        now += FRAME_US;
        while let Some(s) = left.next_if(|s| s.t_us <= now) {
            read.pointer(*s, &mut seen.hashes).expect("in order");
        }
        if left.peek().is_none() && !read.needs_frame() {
            break;
        }
        seen.frames += 1;
        if read.step(now, &mut seen.hashes).draw {
            seen.pictures.push(now - START_US);
        }
        seen.notices.extend(std::iter::from_fn(|| read.take_notice()));
    }
    now
}

fn played(motion: Motion, samples: &[Sample]) -> (Box<Read>, Seen) {
    let mut read = open(&setup());
    read.set_motion(motion).expect("a policy");
    let mut seen = Seen::default();
    let _ = run(&mut read, samples, &mut seen, START_US);
    (read, seen)
}

fn policy(policy: MotionPolicy) -> Motion {
    Motion { policy, cap_us: None }
}

#[test]
fn a_turn_is_told_once_and_in_order() {
    let (read, seen) = played(Motion::FULL, &turn(&setup(), 1));
    assert_eq!(seen.ends(), [1, 1, 0]);
    assert_eq!(seen.ticks(), [Tick::Lift, Tick::Over, Tick::Land]);
    assert_eq!(read.page(), 22);
    let place = |wanted: Notice| seen.notices.iter().position(|n| *n == wanted);
    let committed = place(Notice::Committed { page: 22 }).expect("committed");
    let announced = place(Notice::Announce { page: 22, pages: 60 }).expect("announced");
    assert!(committed < announced, "the page settles before it is read out");
    assert_eq!(seen.notices.last(), Some(&Notice::Asleep));
    assert!(!read.needs_frame(), "asleep is asleep");
    assert!((read.progress() - 11.0 / 30.0).abs() < 1e-12, "{}", read.progress());
}

#[test]
fn every_policy_ends_on_the_same_page() {
    for seed in 0..12 {
        let mut samples = turn(&setup(), seed);
        // Some are let go early.
        samples.truncate(samples.len() * (4 + seed as usize % 7) / 10);
        let last = samples.last_mut().expect("a sample");
        last.phase = Phase::Up;
        let (full, first) = played(Motion::FULL, &samples);
        for (name, other) in MotionPolicy::ALL {
            let (read, seen) = played(policy(other), &samples);
            assert_eq!(seen.ends(), first.ends(), "{name}, gesture {seed}");
            assert_eq!(read.page(), full.page(), "{name}, gesture {seed}");
            let common = seen.hashes.0.len().min(first.hashes.0.len());
            assert_eq!(seen.hashes.0[..common], first.hashes.0[..common], "{name}: the bits");
        }
    }
}

#[test]
fn a_policy_says_how_many_pictures_there_are() {
    let samples = turn(&setup(), 2);
    let pictures = |p| played(policy(p), &samples).1.pictures;
    // The book as it was opened is always drawn.
    assert!(pictures(MotionPolicy::Full).len() > 60, "every frame");
    assert_eq!(pictures(MotionPolicy::None).len(), 2, "the page before and the page after");
    assert_eq!(pictures(MotionPolicy::Reduced).len(), 3, "and the leaf as it was let go");
    let eink = pictures(MotionPolicy::EInk);
    let last = eink.len() - 1;
    assert!((4..40).contains(&eink.len()), "{}", eink.len());
    assert!(eink[..last].windows(2).all(|w| w[1] - w[0] >= EINK_US), "{eink:?}");
}

#[test]
fn a_cap_is_kept() {
    let mut samples = turn(&setup(), 2);
    // Let go over the spine: a long way to fall.
    samples.truncate(samples.len() * 6 / 10);
    let last = samples.last_mut().expect("a sample");
    last.phase = Phase::Up;
    let freed = last.t_us - START_US;
    let after = |cap_us| {
        let (_, seen) = played(Motion { cap_us, ..Motion::FULL }, &samples);
        assert_eq!(seen.ends()[0], 1);
        seen.pictures.last().expect("pictures") - freed
    };
    let free = after(None);
    for cap in [100_000, 250_000, 400_000] {
        let took = after(Some(cap));
        assert!(took <= u64::from(cap) + 2 * FRAME_US, "{took} µs under a cap of {cap}");
        assert!(took < free, "{took} of {free}");
    }
    let bad = Motion { cap_us: Some(1), ..Motion::FULL };
    assert!(open(&setup()).set_motion(bad).is_err(), "no turn is over in a microsecond");
}

#[test]
fn skipping_ends_a_turn_at_once() {
    let mut read = open(&setup());
    let mut seen = Seen::default();
    let samples = turn(&setup(), 4);
    let now = {
        let mut now = START_US;
        for s in &samples {
            now = s.t_us;
            read.pointer(*s, &mut seen.hashes).expect("in order");
            let _ = read.step(now, &mut seen.hashes);
        }
        now
    };
    read.skip(&mut seen.hashes);
    assert!(read.step(now + FRAME_US, &mut seen.hashes).draw, "the page after is drawn");
    assert!(!read.needs_frame(), "nothing is left to do");
    assert_eq!(read.page(), 22);
}

#[test]
fn a_key_turns_on_and_back_and_stops_at_the_covers() {
    for direction in [Direction::Ltr, Direction::Rtl] {
        let mut setup = setup();
        setup.book.direction = direction;
        setup.book.pages = 6;
        setup.book.open_at = 0;
        let mut read = open(&setup);
        let mut seen = Seen::default();
        let mut now = START_US;
        for page in [2, 4, 6] {
            read.turn(true, 1).expect("a page");
            assert_eq!(read.turn(true, 1), Err(Refusal::Busy));
            now = run(&mut read, &[], &mut seen, now);
            assert_eq!(read.page(), page, "{direction:?}");
        }
        assert_eq!(read.turn(true, 1), Err(Refusal::NoSuchPage));
        read.turn(false, 2).expect("two leaves back");
        now = run(&mut read, &[], &mut seen, now);
        assert_eq!(read.page(), 2, "{direction:?}");
        read.turn(false, 1).expect("a page");
        let _ = run(&mut read, &[], &mut seen, now);
        assert_eq!((read.page(), read.turn(false, 1)), (0, Err(Refusal::NoSuchPage)));
        assert_eq!(seen.ends(), [5, 5, 0], "{direction:?}");
    }
}

#[test]
fn a_pause_ends_everything_and_no_time_passes() {
    let mut read = open(&setup());
    let mut seen = Seen::default();
    let samples = turn(&setup(), 5);
    let half = samples.len() / 2;
    for s in &samples[..half] {
        read.pointer(*s, &mut seen.hashes).expect("in order");
        let _ = read.step(s.t_us, &mut seen.hashes);
    }
    assert!(read.book().leaf().is_some(), "a leaf is in the air");
    read.pause(&mut seen.hashes);
    seen.notices.extend(std::iter::from_fn(|| read.take_notice()));
    let [lifted, committed, cancelled] = seen.ends();
    assert_eq!((lifted, committed + cancelled), (1, 1), "told once what became of it");
    let hash = read.book().state_hash();
    read.pointer(samples[half], &mut seen.hashes).expect("ignored");
    assert_eq!(read.turn(true, 1), Err(Refusal::Paused));
    read.resume();
    let hour = samples[half].t_us + 3_600_000_000;
    assert!(read.step(hour, &mut seen.hashes).draw, "drawn again");
    assert_eq!(read.book().state_hash(), hash, "an hour changes nothing");
    let later: Vec<Sample> = turn(&setup(), 6)
        .into_iter()
        .map(|s| Sample { t_us: s.t_us - START_US + hour, ..s })
        .collect();
    let page = read.page();
    let _ = run(&mut read, &later, &mut seen, hour);
    assert_eq!(read.page(), page + 2, "and it turns as before");
}

#[test]
fn a_snapshot_brings_the_book_back() {
    let (read, _) = played(Motion::FULL, &turn(&setup(), 1));
    let mut room = [0; SNAPSHOT_BYTES];
    let sink = read.snapshot(SliceSink::new(&mut room)).expect("room");
    let bytes = sink.written().to_vec();
    let mut other = Box::new(Read::EMPTY);
    other.restore(&bytes).expect("a snapshot");
    assert_eq!((other.page(), other.setup()), (22, read.setup()));
    let hash = other.book().state_hash();
    for cut in 0..bytes.len() {
        assert!(other.restore(&bytes[..cut]).is_err(), "{cut} bytes are no snapshot");
    }
    assert_eq!(other.book().state_hash(), hash, "and change nothing");
    let mut wide = Box::new(Reading::<f64, G11x8>::EMPTY);
    assert!(wide.restore(&bytes).is_err(), "another scalar");
}

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

/// As `run`, but stops with the last sample.
fn run_to(read: &mut Read, samples: &[Sample], seen: &mut Seen, from_us: u64) -> u64 {
    let mut now = from_us;
    let mut left = samples.iter().peekable();
    while left.peek().is_some() {
        now += FRAME_US;
        while let Some(s) = left.next_if(|s| s.t_us <= now) {
            read.pointer(*s, &mut seen.hashes).expect("in order");
        }
        let _ = read.step(now, &mut seen.hashes);
        seen.notices.extend(std::iter::from_fn(|| read.take_notice()));
    }
    now
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

/// A display a little off sixty pictures a second moves the page by one step each, never none and two.
#[test]
fn a_display_that_is_a_little_off_does_not_stutter() {
    for frame in [16_400, 16_667, 16_683, 17_000] {
        let mut read = open(&setup());
        let mut seen = Hashes::default();
        let mut now = START_US;
        let _ = read.turn(true, 1);
        let mut uneven = 0;
        for n in 0..36 {
            let before = seen.0.len();
            now += frame;
            // Up to three milliseconds late.
            let _ = read.step(now + [0, 2900, 700, 1800][n % 4], &mut seen);
            uneven += u64::from(seen.0.len() - before != 1);
        }
        // What the display is off in that time is one step or none.
        assert!(uneven <= 2, "{uneven} uneven pictures of {frame} µs");
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
