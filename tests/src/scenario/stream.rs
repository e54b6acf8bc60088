//! Scenarios 27-32: the same hand, reported in other ways.

use super::harness::{Rules, Seen, WIDTH, apart, at as with, open, play, play_for};
use super::{At, Found};
use crate::gesture::{FRAME_US, Rng, Scene};
use dogleaf_core::book::InputError;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::real::Real;
use dogleaf_core::state::Leaf;

/// A turn reported so many times a second.
fn reported(scene: &Scene, hertz: u64) -> Vec<Sample> {
    let eye = scene.eye();
    let (a, b) = (eye.page(0.9, 0.8), eye.page(-0.9, 0.7));
    let sample = |n: u64| {
        let t = n as f64 / hertz as f64;
        let e = t * t * (3.0 - 2.0 * t);
        let place = [0, 1].map(|c: usize| ((a[c] + (b[c] - a[c]) * e) * 256.0) as i32);
        let phase = match n {
            0 => Phase::Down,
            n if n == hertz => Phase::Up,
            _ => Phase::Move,
        };
        let t_us = 20_000 + n * 1_000_000 / hertz;
        Sample { t_us, id: 0, phase, x: place[0], y: place[1], leaves: 1 }
    };
    (0..=hertz).map(sample).collect()
}

/// The leaf at a picture of a run, and the run.
fn at_picture<R: Real>(
    scene: &Scene,
    samples: &[Sample],
    picture: u32,
) -> (Option<Leaf<R, G11x8>>, Seen<R>) {
    let mut leaf = None;
    let seen = play_for::<R>(scene, samples, &Rules::GENTLE, |n, book| {
        if n == picture {
            leaf = book.leaf().cloned();
        }
    });
    (leaf, seen)
}

/// How far apart two books lie at rest, page widths, and endless where they are open at different pages.
fn ends_apart<R: Real>(a: &Seen<R>, b: &Seen<R>) -> f64 {
    if a.book.spec() != b.book.spec() {
        return f64::INFINITY;
    }
    let nodes = |s: &Seen<R>| -> Vec<f64> {
        s.book.blocks().iter().flat_map(|b| b.x.iter().flat_map(|p| p.0.map(Real::wide))).collect()
    };
    let (x, y) = (nodes(a), nodes(b));
    x.iter().zip(&y).map(|(p, q)| (p - q).abs()).fold(0.0, f64::max) / WIDTH
}

/// 27: what a screen reports between two pictures changes nothing; only the last of it counts.
pub fn rates<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let often = reported(&scene, 240);
    let picture = |s: &Sample| s.t_us.div_ceil(u64::from(FRAME_US));
    let last = |n: usize| often.get(n + 1).is_none_or(|next| picture(next) > picture(&often[n]));
    let keep = |n: &usize| often[*n].phase != Phase::Move || last(*n);
    let resampled: Vec<_> = (0..often.len()).filter(keep).map(|n| often[n]).collect();
    let (usual, seen) = at_picture::<R>(&scene, &resampled, 45);
    let (fast, other) = at_picture::<R>(&scene, &often, 45);
    let far = apart(usual.as_ref(), fast.as_ref());
    let mut found = Found::within(far, 1e-6).with(seen.faults).with(other.faults);
    let same = seen.book.spec() == other.book.spec();
    found.expect(same, || "another page".into());
    found
}

/// 28: only the ends of the stroke are sure to arrive.
pub fn dropped<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let whole = reported(&scene, 120);
    let all = play::<R>(&scene, &whole, &Rules::GENTLE);
    let mut found = Found::default().with(all.faults.iter().cloned());
    for share in [10, 30, 50, 70, 90] {
        let mut rng = Rng::new(share);
        // The last of what arrives says how fast the finger was; without it a turn is a press.
        let near_end = |s: &Sample| s.t_us > 900_000;
        let keep = |s: &&Sample| s.phase != Phase::Move || near_end(s) || rng.bits() % 100 >= share;
        let left: Vec<_> = whole.iter().filter(keep).copied().collect();
        let seen = play::<R>(&scene, &left, &Rules::WILD);
        let far = ends_apart(&all, &seen);
        found.figure = found.figure.max(far);
        found.expect(far <= 1e-3, || format!("{share} % lost: {far:.1e} widths apart at the end"));
        found.faults.extend(seen.faults.into_iter().map(|f| format!("{share} % lost: {f}")));
    }
    found
}

/// 29: every sample twice, to the bit.
pub fn doubled<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let once = reported(&scene, 120);
    let twice: Vec<_> = once.iter().flat_map(|&s| [s, s]).collect();
    let [a, b] = [&once, &twice].map(|s| play::<R>(&scene, s, &Rules::GENTLE));
    let mut found = Found { figure: ends_apart(&a, &b), faults: Vec::new() };
    found.expect(a.way == b.way, || "I7: another way".into());
    // And the same input once more is the same way once more.
    let again = play::<R>(&scene, &once, &Rules::GENTLE);
    found.expect(a.way == again.way, || "I7: the same input, another way".into());
    found.with(a.faults)
}

/// 30: what is older than what was taken is refused by name, and changes nothing.
pub fn unordered<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let samples = reported(&scene, 120);
    let mut shuffled = samples.clone();
    let mut rng = Rng::new(3);
    for n in (2..shuffled.len() - 2).step_by(3) {
        shuffled.swap(n, n + (rng.bits() % 2) as usize);
    }
    let mut book = open::<R>(&scene).expect("a sound scene");
    let mut found = Found::default();
    let mut latest = 0;
    for sample in &shuffled {
        let hash = book.state_hash();
        let late = sample.t_us < latest;
        let answer = book.input(*sample);
        let due = if late { Err(InputError::OutOfOrder) } else { Ok(()) };
        found.expect(answer == due, || format!("{answer:?} at {}", sample.t_us));
        found.expect(book.state_hash() == hash, || "input changed the state".into());
        found.figure += f64::from(u32::from(answer.is_err()));
        latest = latest.max(sample.t_us);
        // Not quite as fast as the samples come, so that some always wait.
        while book.now_us() + 40_000 < sample.t_us {
            let _ = book.advance(FRAME_US);
        }
    }
    let sorted: Vec<_> = {
        let mut latest = 0;
        let in_order = |s: &&Sample| {
            let fits = s.t_us >= latest;
            latest = latest.max(s.t_us);
            fits
        };
        shuffled.iter().filter(in_order).copied().collect()
    };
    let seen = play::<R>(&scene, &sorted, &Rules::GENTLE);
    found.expect(found.figure > 5.0, || "nothing was out of order".into());
    found.with(seen.faults)
}

/// A book in the middle of a turn, and what the hand does then.
pub fn half_way<R: Real>(scene: &Scene) -> (Seen<R>, Vec<Sample>) {
    let samples = reported(scene, 120);
    let mut seen = Seen::new(open::<R>(scene).expect("a sound scene"), &Rules::WILD);
    let mut next = samples.iter().copied().peekable();
    while seen.book.now_us() < 450_000 {
        let until = seen.book.now_us() + u64::from(FRAME_US);
        while let Some(sample) = next.next_if(|s| s.t_us <= until) {
            let _ = seen.book.input(sample);
        }
        let _ = seen.frame(FRAME_US, &Rules::WILD, &scene.fidelity.settings());
    }
    (seen, next.collect())
}

/// Lets a book come to rest, under the rules.
pub fn settle<R: Real>(seen: &mut Seen<R>, scene: &Scene, rules: &Rules) {
    for _ in 0..300 {
        let _ = seen.frame(FRAME_US, rules, &scene.fidelity.settings());
        if !seen.book.needs_frame() {
            break;
        }
    }
}

/// 31: a frame of half a minute, and a sample half a minute ahead. Microseconds in 64 bits do not wrap.
pub fn jump<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let settings = scene.fidelity.settings();
    let (mut seen, rest) = half_way::<R>(&scene);
    let report = seen.frame(30_000_000, &Rules::WILD, &settings);
    let mut found = Found::within(f64::from(report.steps), 8.0);
    let next = seen.frame(FRAME_US, &Rules::WILD, &settings);
    found.expect(next.steps <= 2, || format!("{} steps are caught up later", next.steps));
    let now = seen.book.now_us();
    for (ahead, due) in [(61_000_000, Err(InputError::TooEarly)), (30_000_000, Ok(()))] {
        let answer = seen.book.input(Sample { t_us: now + ahead, phase: Phase::Up, ..rest[0] });
        found.expect(answer == due, || format!("{answer:?} for a sample {ahead} us ahead"));
    }
    for _ in 0..31 * 60 {
        let _ = seen.frame(FRAME_US, &Rules::WILD, &settings);
    }
    settle(&mut seen, &scene, &Rules::WILD);
    seen.rest(seen.watch.frames, &Rules::WILD);
    found.with(seen.faults)
}

/// 32: half a minute of nothing in mid drag; a snapshot goes on as the book itself; then the system takes over.
pub fn pause<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let settings = scene.fidelity.settings();
    let (mut seen, rest) = half_way::<R>(&scene);
    let _ = seen.frame(30_000_000, &Rules::WILD, &settings);
    let mut copy = Seen::new(seen.book.clone(), &Rules::WILD);
    let start = seen.watch.frames;
    for seen in [&mut seen, &mut copy] {
        let cancel = Sample { t_us: seen.book.now_us(), phase: Phase::Cancel, ..rest[0] };
        let _ = seen.book.input(cancel);
        seen.way = 0;
        settle(seen, &scene, &Rules::WILD);
    }
    let mut found = Found::default();
    found.expect(seen.way == copy.way, || "I7: a snapshot goes another way".into());
    seen.rest(start, &Rules::WILD);
    found.figure = seen.rested();
    found.with(seen.faults)
}
