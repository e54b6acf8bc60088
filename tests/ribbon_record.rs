//! Promise: a ribbon's recording plays again hash by hash, names the first step that differs, and is refused with one line
//! where anything in it was changed.

use dogleaf_core::effect::ribbon::contact::{Cushion, HalfSpace, Near};
use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::record::{Reader, Recorder, replay};
use dogleaf_core::effect::ribbon::{Closure, Report, Ribbon, RibbonSpec};
use dogleaf_core::real::{Real, V3};
use dogleaf_core::record::{RecordError, SliceSink, Verdict};
use dogleaf_tests::crc::crc32;
use dogleaf_tests::ribbons::{falling, helix, pulled, spec, twist};

const STEPS: u32 = 12;

/// Records some steps; before each something is asked.
fn record<R: Real, const N: usize>(
    ribbon: &mut Ribbon<R, N>,
    mut ask: impl FnMut(&mut Ribbon<R, N>, u32),
    mut step: impl FnMut(&mut Ribbon<R, N>, f64) -> Report<R>,
) -> Vec<u8> {
    let mut room = vec![0; 100_000];
    let mut recorder = Recorder::start(SliceSink::new(&mut room), ribbon).expect("it fits");
    for k in 0..STEPS {
        ask(ribbon, k);
        recorder.step(ribbon, 0.01, &mut step).1.expect("it fits");
    }
    recorder.finish().expect("a sound sink").written().to_vec()
}

fn again<R: Real, const N: usize>(
    bytes: &[u8],
    step: impl FnMut(&mut Ribbon<R, N>, f64) -> Report<R>,
) -> Verdict {
    let reader = Reader::open(bytes).expect("a sound recording");
    assert_eq!(reader.steps(), STEPS, "all of them");
    replay(&reader, &mut Box::new(Ribbon::<R, N>::EMPTY), step).expect("it fits")
}

/// A helix under way that is twisted in between, and its start carried off.
fn busy<R: Real>() -> Vec<u8> {
    let mut ribbon = helix::<R, 20>(&spec(20));
    for _ in 0..5 {
        ribbon.step(0.01);
    }
    let ask = |r: &mut Ribbon<R, 20>, k: u32| {
        if k % 3 == 1 {
            twist(r, 0.1 * f64::from(k), 1.0);
        }
        if k == 7 {
            r.carry(&Frame::at(V3([0.0, 1e-3 * f64::from(k), 0.0].map(R::of))));
        }
        r.gravity[1] = if k == 9 { 0.0 } else { r.gravity[1] };
    };
    record(&mut ribbon, ask, |r, h| r.step(h))
}

fn plays<R: Real>() {
    let verdict = again::<R, 20>(&busy::<R>(), |r, h| r.step(h));
    assert_eq!((verdict.steps, verdict.diverged), (STEPS, None), "{}", R::NAME);
    assert!(verdict.same_build, "made here");
    // What is not asked again is missed: the control.
    let missed = again::<R, 20>(&busy::<R>(), |r, h| {
        r.ask.guides.clear();
        r.step(h)
    });
    assert_eq!(missed.diverged.map(|d| d.step), Some(1), "the first twist is in step 1");
}

#[test]
fn what_was_recorded_plays_again() {
    plays::<f32>();
    plays::<f64>();
}

#[test]
fn a_loop_that_was_wound_and_pulled_plays_again() {
    let mut band = pulled::<f64, 24>(24, Closure::Moebius, 100.0);
    let bytes = record(&mut band, |_, _| {}, |r, h| r.step(h));
    assert_eq!(again::<f64, 24>(&bytes, |r, h| r.step(h)).diverged, None);
    assert_eq!(again::<f64, 30>(&bytes, |r, h| r.step(h)).diverged, None, "with room to spare");
}

#[test]
fn a_fall_plays_again_with_the_same_ground_and_with_no_other() {
    let touching = |z: f32| {
        let ground = HalfSpace { point: V3([0.0, 0.0, z]), normal: V3([0.0, 0.0, 1.0]) };
        let mut near = Box::new(Near::<f32, _, 40, 1, 1024>::over(ground, Cushion::default()));
        move |r: &mut Ribbon<f32, 40>, h: f64| {
            near.begin(r, h);
            r.step_touching(h, &(), &mut *near)
        }
    };
    let mut ribbon = falling::<f32, 40>(40);
    let bytes = record(&mut ribbon, |_, _| {}, touching(0.47));
    assert_eq!(again(&bytes, touching(0.47)).diverged, None);
    let other = again(&bytes, touching(0.2)).diverged.expect("it falls further");
    assert!(other.step > 0 && other.found != other.expected, "{other}");
}

/// The checksum made to fit what was forged.
fn resealed(bytes: &mut [u8]) {
    let (body, sum) = bytes.split_at_mut(bytes.len() - 4);
    sum.copy_from_slice(&crc32(body).to_le_bytes());
}

/// Where the hash of a step stands: the last one is before the end's tag, its count and the checksum.
fn last_hash(bytes: &[u8]) -> usize {
    bytes.len() - 4 - 5 - 8
}

#[test]
fn the_first_step_that_differs_is_named() {
    let mut bytes = busy::<f32>();
    let (at, step) = (last_hash(&bytes), 1 + 8 + 8);
    for back in [0, 1] {
        let mut forged = bytes.clone();
        forged[at - back * step] ^= 1;
        resealed(&mut forged);
        let found = again::<f32, 20>(&forged, |r, h| r.step(h)).diverged.expect("it differs");
        assert_eq!(found.step as usize, STEPS as usize - 1 - back);
        assert!(found.to_string().starts_with(&format!("step {} diverges", found.step)));
    }
    bytes[at] ^= 1;
    assert_eq!(Reader::open(&bytes).map(|_| ()), Err(RecordError::Checksum), "not resealed");
}

fn refused(bytes: &[u8]) -> RecordError {
    let error = Reader::open(bytes).expect_err("it is forged");
    assert!(!error.to_string().contains('\n') && !error.to_string().is_empty(), "one line");
    error
}

#[test]
fn forged_bits_are_refused() {
    let sound = busy::<f32>();
    for at in 0..sound.len() {
        let mut forged = sound.clone();
        forged[at] ^= 1 << (at % 8);
        let error = refused(&forged);
        let wanted = match at {
            0..4 => matches!(error, RecordError::NotARecording),
            4..6 => matches!(error, RecordError::Version(_)),
            _ => error == RecordError::Checksum,
        };
        assert!(wanted, "byte {at}: {error}");
    }
    for length in 0..sound.len() {
        refused(&sound[..length]);
    }
    refused(&[&sound[..], &[0]].concat());
}

#[test]
fn forged_and_resealed_it_is_refused_or_plays() {
    let sound = busy::<f32>();
    let mut ribbon = Box::new(Ribbon::<f32, 20>::EMPTY);
    let mut told = std::collections::BTreeMap::<String, u32>::new();
    for at in 0..sound.len() - 4 {
        let mut forged = sound.clone();
        forged[at] ^= 0x80 >> (at % 8);
        resealed(&mut forged);
        match Reader::open(&forged) {
            Err(error) => *told.entry(error.to_string()).or_default() += 1,
            Ok(reader) => {
                // Whatever is in it, it ends, and never in a panic. Segments may be fewer, so steps are few.
                let mut left = 1;
                let played = replay(&reader, &mut ribbon, |r, h| {
                    left -= 1;
                    if left < 0 { r.hold() } else { r.step(h) }
                });
                let way = if played.is_ok() { "plays" } else { "does not fit" };
                *told.entry(way.into()).or_default() += 1;
            }
        }
    }
    println!("{told:#?}");
    assert!(told.len() >= 6 && told.contains_key("the recording ends too early"), "{told:#?}");
}

#[test]
fn what_does_not_fit_is_refused() {
    let bytes = busy::<f32>();
    let reader = Reader::open(&bytes).expect("a sound recording");
    let mut other = Box::new(Ribbon::<f64, 20>::EMPTY);
    let tier = replay(&reader, &mut other, |r, h| r.step(h)).expect_err("f64");
    assert_eq!(tier.to_string(), "the recording was made with f32, not f64");
    let mut short = Box::new(Ribbon::<f32, 10>::EMPTY);
    let room = replay(&reader, &mut short, |r, h| r.step(h)).expect_err("ten segments");
    assert!(room.to_string().contains("ribbon.segments"), "{room}");

    let mut ribbon = helix::<f32, 20>(&RibbonSpec { segments: 20, ..spec(20) });
    let mut little = [0; 1000];
    let start = Recorder::start(SliceSink::new(&mut little), &mut ribbon);
    assert_eq!(start.map(|_| ()), Err(RecordError::Full), "no room for the start");
    let mut little = vec![0; 2000];
    let mut recorder = Recorder::start(SliceSink::new(&mut little), &mut ribbon).expect("it fits");
    let ends = (0..100).find(|_| recorder.step(&mut ribbon, 0.01, |r, h| r.step(h)).1.is_err());
    let kept = recorder.finish().expect("it can be finished").written().to_vec();
    assert_eq!(Reader::open(&kept).map(|r| r.steps()), Ok(ends.expect("it is full")), "no holes");
}
