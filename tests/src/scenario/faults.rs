//! Scenarios 38-40: what cannot happen is made to happen.

use super::harness::{Rules, at as with, excess};
use super::stream::{half_way, settle};
use super::{At, Found};
use crate::gesture::{FRAME_US, Gesture, Scene};
use crate::watch::fault;
use dogleaf_core::book::Fault;
use dogleaf_core::hand::Sample;
use dogleaf_core::real::Real;
use dogleaf_core::step::StepStatus;

/// 38: a number of the leaf is lost. The next step says so and has none that is none; a step later all is well.
pub fn nan<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let mut found = Found::default();
    let nodes = [(1, 0), (5, 3), (9, 6), (10, 7), (10, 0)];
    for (node, velocity) in nodes.into_iter().flat_map(|n| [(n, true), (n, false)]) {
        let (mut seen, _) = half_way::<R>(&scene);
        seen.book.plant(Fault::Nan { node, velocity });
        let first = seen.book.step();
        let place = format!("{node:?}, {}", if velocity { "velocity" } else { "position" });
        found.expect(fault(&seen.book).is_none(), || format!("{place}: {:?}", fault(&seen.book)));
        found.expect(first.status == StepStatus::Held, || format!("{place}: {:?}", first.status));
        let mut steps = 1u32;
        while seen.book.step().status.failed() && steps < 60 {
            steps += 1;
        }
        found.figure = found.figure.max(f64::from(steps));
        found.expect(steps <= 1, || format!("{place}: {steps} steps to recover"));
        let start = seen.watch.frames;
        let cancel = Sample { t_us: seen.book.now_us(), ..cancelled() };
        let _ = seen.book.input(cancel);
        settle(&mut seen, &scene, &Rules::WILD);
        seen.rest(start, &Rules::WILD);
        found.faults.extend(seen.faults.into_iter().map(|f| format!("{place}: {f}")));
    }
    found
}

fn cancelled() -> Sample {
    Sample { t_us: 0, id: 0, phase: dogleaf_core::hand::Phase::Cancel, x: 0, y: 0, leaves: 0 }
}

/// 39: at every step of a long drag and of the fall after it, on a copy of the book: the pose is kept, and the
/// step after that is a step like any other.
pub fn factor<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let eye = scene.eye();
    let press = Gesture::press(eye.page(0.9, 0.8));
    let led = press.to(eye.above(0.3, 0.4, 0.7), 900_000).hold(6_000_000);
    let samples = led.to(eye.page(-0.9, 0.7), 800_000).up();
    let mut book = super::harness::open::<R>(&scene).expect("a sound scene");
    let mut next = samples.iter().copied().peekable();
    let mut found = Found::default();
    let every = at.count(1, 10);
    let mut taken = 0u32;
    for n in 0..600 {
        while let Some(sample) = next.next_if(|s| s.t_us <= book.now_us() + u64::from(FRAME_US)) {
            let _ = book.input(sample);
        }
        if book.leaf().is_some() && taken < 500 && n % every == 0 {
            taken += 1;
            let mut copy = book.clone();
            copy.plant(Fault::Factor { after: 0 });
            let status = copy.step().status;
            found.expect(status == StepStatus::Held, || format!("step {n}: {status:?}"));
            found.expect(fault(&copy).is_none(), || format!("step {n}: {:?}", fault(&copy)));
            let after = copy.step().status;
            found.expect(!after.failed(), || format!("step {n}: {after:?} a step later"));
        }
        let _ = book.step();
    }
    found.figure = f64::from(taken);
    found
}

/// 40: no trial is ever good enough: trials are bounded, the pose is kept, and when searches work again so does
/// the leaf.
pub fn search<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let settings = scene.fidelity.settings();
    let (mut seen, _) = half_way::<R>(&scene);
    let mut found = Found::default();
    for n in 0..120 {
        for _ in 0..settings.substeps {
            seen.book.plant(Fault::Search { after: 0 });
        }
        let report = seen.book.step();
        found.figure = found.figure.max(f64::from(report.cuts));
        found.faults.extend(excess(&report, &settings));
        found.expect(fault(&seen.book).is_none(), || format!("step {n}: {:?}", fault(&seen.book)));
        let named = report.status == StepStatus::Stalled || report.newton_steps == 0;
        found.expect(named, || format!("step {n}: {:?}", report.status));
        if found.faults.len() > 3 {
            break;
        }
    }
    seen.book.plant(Fault::Search { after: u32::MAX });
    let start = seen.watch.frames;
    let _ = seen.book.input(Sample { t_us: seen.book.now_us(), ..cancelled() });
    settle(&mut seen, &scene, &Rules::WILD);
    seen.rest(start, &Rules::WILD);
    found.with(seen.faults)
}
