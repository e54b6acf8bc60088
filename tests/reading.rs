//! Promise: an app drives the book, and is told exactly once what came of each turn, whatever it shows of it. What it
//! shows changes neither the pages nor the bits.

use dogleaf_core::Reading;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::reading::{EINK_US, Motion, MotionPolicy, Notice, Refusal, SNAPSHOT_BYTES, Tick};
use dogleaf_core::record::SliceSink;
use dogleaf_core::scene::Direction;
use dogleaf_tests::app::{FRAME_US, Hashes, Read, START_US, Seen, open, played, run, setup, turn};

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

/// A screen that is slower than a turn sees it whole and at once, to the same page and the same bits.
#[test]
fn a_turn_can_be_seen_ahead_of_time() {
    let mut read = open(&setup());
    let mut seen = Seen::default();
    read.turn(true, 1).expect("a page");
    let mut other = Box::new(read.clone());
    let (mut steps, mut aloft) = (0, 0);
    read.ahead(&mut (), |book| {
        steps += 1;
        aloft += u32::from(book.leaf().is_some());
    });
    let _ = run(&mut other, &[], &mut seen, START_US);
    assert!(steps > aloft && aloft > 40, "{aloft} of {steps} steps with a leaf");
    assert_eq!(read.book().state_hash(), other.book().state_hash(), "the same end");
    assert_eq!(read.page(), 22);
    read.ahead(&mut (), |_| panic!("nothing moves any more"));
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
