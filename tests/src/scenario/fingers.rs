//! Scenarios 33-35: pointers without rules, and eyes in odd places.

use super::harness::{Rules, at as with, open, play, play_for};
use super::stream::half_way;
use super::{At, Found};
use crate::gesture::{FRAME_US, Gesture, Rng, Scene};
use dogleaf_core::hand::{Phase, Sample, View};
use dogleaf_core::real::Real;

/// 33: ups without downs, downs and cancels twice, ids used again, ten pointers. Whatever came before, a proper
/// turn afterwards turns.
pub fn confused<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let eye = scene.eye();
    let settings = scene.fidelity.settings();
    let mut found = Found::default();
    for seed in 0..u64::from(at.count(20, 3)) {
        let mut rng = Rng::new(seed);
        let book = open::<R>(&scene).expect("a sound scene");
        let mut seen = super::harness::Seen::new(book, &Rules::WILD);
        for _ in 0..90 {
            let phase = Phase::ALL[(rng.bits() % 4) as usize].1;
            let place =
                eye.above(rng.within(-1.2, 1.2), rng.within(0.0, 0.6), rng.within(-1.0, 1.0));
            let [x, y] = place.map(|p| (p * 256.0) as i32);
            let (t_us, id) = (seen.book.now_us(), (rng.bits() % 10) as u8);
            let _ = seen.book.input(Sample { t_us, id, phase, x, y, leaves: 1 });
            let _ = seen.frame(FRAME_US, &Rules::WILD, &settings);
        }
        for id in 0..10 {
            let t_us = seen.book.now_us();
            let cancel = Sample { t_us, id, phase: Phase::Cancel, x: 0, y: 0, leaves: 1 };
            let _ = (seen.book.input(cancel), seen.book.input(cancel));
        }
        let start = seen.watch.frames;
        super::stream::settle(&mut seen, &scene, &Rules::WILD);
        seen.rest(start, &Rules::WILD);
        found.figure = found.figure.max(f64::from(seen.watch.work.refused));
        found.faults.extend(seen.faults.iter().map(|f| format!("seed {seed}: {f}")));
        let page = seen.book.spec().open_at;
        let (start, turn) = (seen.book.now_us(), Gesture::corner_turn(&eye, seed));
        for sample in turn {
            let due = Sample { t_us: sample.t_us + start, ..sample };
            while seen.book.now_us() + 20_000 < due.t_us {
                let _ = seen.book.advance(FRAME_US);
            }
            let _ = seen.book.input(due);
        }
        for _ in 0..300 {
            let _ = seen.book.advance(FRAME_US);
        }
        let after = seen.book.spec().open_at;
        found.expect(after == page + 2, || format!("seed {seed}: stuck at page {after}"));
    }
    found
}

/// 34: rotation, another size, another density; the physics does not see it.
pub fn looks<R: Real>(at: At) -> Found {
    let scene = with(&Scene::default(), at);
    let views = [
        View::reading(0.13, 0.20, 720, 960),
        View::reading(0.13, 0.20, 2880, 2160),
        View { eye_m: [0.4, 0.1, 0.4], ..scene.view },
        View { fov_y_deg: 120.0, ..scene.view },
    ];
    let mut found = Found::default();
    for view in views {
        let (mut still, rest) = half_way::<R>(&scene);
        let mut turned = still.book.clone();
        found.expect(turned.look(&view).is_ok(), || "a view was refused".into());
        for _ in 0..60 {
            let _ = (still.book.advance(FRAME_US), turned.advance(FRAME_US));
            let same = still.book.state_hash() == turned.state_hash();
            found.figure += f64::from(u32::from(!same));
        }
        // The drag goes on where the finger is seen now.
        still.book = turned;
        for sample in &rest {
            let t_us = sample.t_us.max(still.book.now_us());
            let _ = still.book.input(Sample { t_us, ..*sample });
            let _ = still.frame(FRAME_US, &Rules::WILD, &scene.fidelity.settings());
        }
        let start = still.watch.frames;
        super::stream::settle(&mut still, &scene, &Rules::WILD);
        still.rest(start, &Rules::WILD);
        found.faults.extend(still.faults);
    }
    found.expect(found.figure == 0.0, || "looking changed the physics".into());
    found
}

/// 35: the eye in the page's plane, straight above, at the spine, and with next to no opening; what has no
/// direction is refused.
pub fn edge_on<R: Real>(at: At) -> Found {
    let base = with(&Scene::default(), at);
    let flat = View { eye_m: [0.0, 0.01, 0.6], target_m: [0.0, 0.01, 0.0], ..base.view };
    let views = [
        flat,
        View { eye_m: [0.6, 0.01, 0.0], target_m: [0.0, 0.01, 0.0], ..base.view },
        View { eye_m: [0.0, 0.6, 0.0], target_m: [0.0; 3], ..base.view },
        View { eye_m: [0.0, -0.5, 0.1], target_m: [0.0; 3], ..base.view },
        View { eye_m: [0.0, 0.02, 0.0], target_m: [0.1, 0.02, 0.0], fov_y_deg: 149.0, ..base.view },
        View { fov_y_deg: 1.0, ..base.view },
    ];
    let mut found = Found::default();
    for (n, view) in views.into_iter().enumerate() {
        let scene = Scene { view, ..base };
        let mut gesture = Gesture::press([700.0, 400.0]);
        for place in [[100.0, 400.0], [480.0, 360.0], [480.0, -1e5], [-1e5, 360.0], [900.0, 700.0]]
        {
            gesture = gesture.to(place, 250_000);
        }
        // The press may meet no paper: then the leaf is in the air already.
        let samples = gesture.up();
        let seen = play::<R>(&scene, &samples, &Rules::WILD);
        found.figure = found.figure.max(seen.watch.air.worst);
        found.faults.extend(seen.faults.into_iter().map(|f| format!("view {n}: {f}")));
        let usual = Gesture::corner_turn(&base.eye(), 3);
        let seen = play_for::<R>(&base, &usual, &Rules::WILD, |frame, book| {
            if frame == 25 {
                let _ = book.look(&view);
            }
        });
        found.figure = found.figure.max(seen.watch.air.worst);
        found.faults.extend(seen.faults.into_iter().map(|f| format!("view {n} in mid drag: {f}")));
    }
    let mut book = open::<R>(&base).expect("a sound scene");
    let hash = book.state_hash();
    for view in [
        View { target_m: base.view.eye_m, ..base.view },
        View { fov_y_deg: 0.0, ..base.view },
        View { width_px: 0, ..base.view },
        View { eye_m: [f64::NAN, 0.0, 0.0], ..base.view },
    ] {
        found.expect(book.look(&view).is_err(), || format!("{view:?} was taken"));
    }
    found.expect(book.state_hash() == hash, || "a refused view changed the book".into());
    found
}
