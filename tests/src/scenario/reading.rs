//! Scenarios 46 and 47: many hands, and a long time.

use super::harness::{Rules, Seen, at as with, open};
use super::{At, Found};
use crate::gesture::{FRAME_US, Gesture, Scene};
use crate::soak::{Case, case::Nobody, case::STRETCHED, draw::World, sum::SHARE};
use dogleaf_core::hand::Sample;
use dogleaf_core::real::Real;

/// 46: the readers' cases of the soak, at this fidelity. Ten million steps of them are the soak's own affair.
pub fn random<R: Real>(at: At) -> Found {
    let mut found = Found::default();
    let (mut all, mut under) = (0u32, 0u32);
    let cases = (0..).map(|n| Case::new(46, n)).filter(|c| c.world == World::Readers);
    for mut case in cases.take(at.count(30, 4) as usize) {
        case.scene.fidelity = at.fidelity;
        let outcome = case.run::<R>(&mut Nobody);
        all += outcome.stretches.len() as u32;
        under += outcome.stretches.iter().filter(|s| **s < STRETCHED).count() as u32;
        let named = |f| format!("case {} of seed 46: {f}", case.number);
        found.faults.extend(outcome.faults.into_iter().map(named));
    }
    found.figure = f64::from(under) / f64::from(all.max(1));
    let share = found.figure;
    found.expect(share >= SHARE, || format!("{:.1} % under 15 % stretch", 100.0 * share));
    found
}

/// 47: a page every ten seconds, there and back through the book; the hash of every ten seconds goes into one.
pub fn hour<R: Real>(at: At) -> Found {
    let scene = with(&Scene::open_at(320, 0), at);
    let eye = scene.eye();
    let read = |minutes: u32| {
        let mut seen = Seen::<R>::new(open(&scene).expect("a sound scene"), &Rules::GENTLE);
        let mut back = false;
        for n in 0..u64::from(6 * minutes) {
            let page = seen.book.spec().open_at;
            back = if back { page > 0 } else { page >= 320 };
            let onwards = Gesture::corner_turn(&eye, n);
            let samples = if back { eye.mirror(&onwards) } else { onwards };
            ten_seconds(&mut seen, &scene, &samples);
        }
        seen
    };
    let minutes = at.count(60, 1);
    let seen = read(minutes);
    let pages = seen.watch.events.iter();
    let turned =
        pages.filter(|e| matches!(e, dogleaf_core::event::Event::Committed { .. })).count();
    let due = 6 * minutes as usize;
    let mut found = Found { figure: (seen.way >> 44) as f64, faults: seen.faults };
    found.expect(turned == due, || format!("{turned} pages of {due}"));
    // The same again: I7 over all of it at small length, over a share of it at full.
    let [a, b] = [0, 1].map(|_| read(minutes.min(4)).way);
    found.expect(a == b, || "I7: another way".into());
    found
}

fn ten_seconds<R: Real>(seen: &mut Seen<R>, scene: &Scene, samples: &[Sample]) {
    let start = seen.book.now_us();
    let mut next = samples.iter().map(|s| Sample { t_us: s.t_us + start, ..*s }).peekable();
    for _ in 0..600 {
        let until = seen.book.now_us() + u64::from(FRAME_US);
        while let Some(sample) = next.next_if(|s| s.t_us <= until) {
            let _ = seen.book.input(sample);
        }
        // Asleep with nothing due: what is left of the ten seconds passes at once, and changes nothing.
        let _ = seen.frame(FRAME_US, &Rules::GENTLE, &scene.fidelity.settings());
    }
}
