//! The hand, and a recording's bytes: tent, camera, ray, checksum.

use crate::fold::Fold;
use crate::random::Random;
use crate::work::Pick;
use crate::{CASES, Row};
use dogleaf_core::grid::G6x5;
use dogleaf_core::hand::tent::Tent;
use dogleaf_core::hand::view::Ray;
use dogleaf_core::hand::{Phase, Sample, View};
use dogleaf_core::real::{Real, V3};
use dogleaf_core::record::{Reader, Recorder, Setup, SliceSink};
use dogleaf_core::scene::{BookSpec, Units};

/// Recordings of ten samples.
const RECORDINGS: usize = 40;

/// All of them.
pub(crate) fn table<R: Pick>() -> [Row; 5] {
    [
        ("hand.tent", |_| tents::<R>()),
        ("hand.aim", |_| aims::<R>()),
        ("hand.ray", |_| rays::<R>()),
        ("hand.camera", |_| cameras::<R>()),
        ("record.crc", |_| recordings::<R>()),
    ]
}

fn tent<R: Real>(random: &mut Random) -> Tent<R> {
    let mut some = |least: f64, size: f64| R::of(least) + random.within(size);
    Tent {
        root: some(0.0, 1.0),
        radius: some(5.0, 4.5),
        floor: [some(1.0, 1.0), some(1.0, 1.0)],
        ends: [some(6.0, 6.0), some(6.0, 6.0)],
        lain: V3([R::ZERO; 3]),
    }
}

fn tents<R: Real>() -> u64 {
    let (mut random, mut fold) = (Random::named("tent"), Fold::START);
    for _ in 0..CASES {
        let tent = tent::<R>(&mut random);
        let x = R::of(0.0) + random.within(12.0);
        let height = tent.height(x);
        fold.real(tent.reach(x));
        fold.real(height);
        tent.sideways(x, height).into_iter().for_each(|v| fold.real(v));
    }
    fold.value()
}

/// Where a firm hand wants its node under rays from all around, on the tent and below it.
fn aims<R: Real>() -> u64 {
    let (mut random, mut fold) = (Random::named("aim"), Fold::START);
    for _ in 0..CASES {
        let tent = Tent { lain: random.v3(8.0), ..tent::<R>(&mut random) };
        let from = random.v3(10.0) + V3([R::ZERO, R::of(30.0), R::of(12.0)]);
        let aim = tent.aim(&Ray { from, along: random.v3(8.0) - from });
        fold.v3(aim.at);
        fold.word(u64::from(aim.clamped));
    }
    fold.value()
}

fn rays<R: Real>() -> u64 {
    let (mut random, mut fold) = (Random::named("ray"), Fold::START);
    let spec = BookSpec::default();
    let units = Units::of_leaf(spec.width_m, spec.height_m, 80.0);
    let camera = View::reading(spec.width_m, spec.height_m, 960, 720).camera::<R>(&units);
    for _ in 0..CASES {
        let (x, y) = (random.below(960 * 256).cast_signed(), random.below(720 * 256).cast_signed());
        let ray = camera.ray(x, y);
        fold.v3(ray.along);
        let point = random.v3(10.0);
        fold.real(ray.distance_sq(point));
        if let Some(found) = ray.meet(point, random.v3(1.0)) {
            fold.v3(found);
        }
        if let Some([a, b]) = camera.project(random.v3(10.0)) {
            fold.real(a);
            fold.real(b);
        }
    }
    fold.value()
}

/// Cameras are made in `f64` on every target, also for a book in `f32`.
fn cameras<R: Real>() -> u64 {
    let (mut random, mut fold) = (Random::named("camera"), Fold::START);
    let units = Units::of_leaf(0.15, 0.2, 80.0);
    for _ in 0..CASES / 10 {
        let view = View {
            eye_m: [random.unit(), 1.5 + random.unit(), random.unit()],
            target_m: [0.1 * random.unit(), 0.0, 0.1 * random.unit()],
            fov_y_deg: 50.0 + 30.0 * random.unit(),
            width_px: 960,
            height_px: 720,
        };
        let c = view.camera::<R>(&units);
        [c.eye, c.right, c.up, c.forward].into_iter().for_each(|v| fold.v3(v));
        fold.real(c.focal);
    }
    fold.value()
}

/// The checksum is private; it stands at the end of every recording, and the reader checks it.
fn recordings<R: Real>() -> u64 {
    let (mut random, mut fold) = (Random::named("crc"), Fold::START);
    let setup = Setup::reading(BookSpec::default(), 960, 720);
    for n in 0..RECORDINGS {
        let mut buffer = [0; 1024];
        let mut sink = SliceSink::new(&mut buffer);
        let made = record::<R>(&setup, &mut random, &mut sink, n as u64).is_some();
        let bytes = sink.written();
        fold.word(u64::from(made) | u64::from(Reader::open(bytes).is_ok()) << 1);
        bytes.iter().for_each(|&b| fold.word(u64::from(b)));
    }
    fold.value()
}

fn record<R: Real>(
    setup: &Setup,
    random: &mut Random,
    sink: &mut SliceSink<'_>,
    n: u64,
) -> Option<()> {
    let mut recorder = Recorder::start::<R, G6x5>(sink, setup).ok()?;
    for t in 0..10 {
        let (x, y) = (random.next().cast_signed(), random.next().cast_signed());
        let sample = Sample { t_us: n + t * 1000, id: 0, phase: Phase::Move, x, y, leaves: 1 };
        recorder.input(&sample).ok()?;
        recorder.step(u64::from(random.next())).ok()?;
    }
    recorder.finish().ok()?;
    Some(())
}
