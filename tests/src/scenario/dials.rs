//! Scenarios 41-43 and 48: what each dial buys, one step at a time, so that chaos has no part in it.

use super::harness::{Pages, Rules, apart, at as with, play_for};
use super::lone::lone;
use super::{At, Found};
use crate::depth::deepest;
use crate::gesture::{FRAME_US, Gesture, Scene};
use dogleaf_core::grid::G11x8;
use dogleaf_core::real::Real;
use dogleaf_core::scene::{LeafSpec, Settings, WorldSpec};
use dogleaf_core::seed::{SeedBook, SeedSettings};

/// Books at every fourth picture of a turn.
fn moments<R: Real>(at: At) -> Vec<Box<Pages<R>>> {
    let scene = with(&Scene::default(), at);
    let mut all = Vec::new();
    for seed in 0..u64::from(at.count(4, 1)) {
        let samples = Gesture::corner_turn(&scene.eye(), seed);
        let _ = play_for::<R>(&scene, &samples, &Rules::WILD, |n, book| {
            if n % 4 == 3 && book.leaf().is_some() {
                all.push(Box::new(book.clone()));
            }
        });
    }
    all
}

fn median(mut all: Vec<f64>) -> f64 {
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or(0.0)
}

/// The book after one step with other dials.
fn stepped<R: Real>(book: &Pages<R>, turn: impl Fn(&mut Settings)) -> Box<Pages<R>> {
    let mut copy = Box::new(book.clone());
    let mut settings = copy.settings();
    turn(&mut settings);
    copy.set_settings(settings).expect("dials in range");
    let _ = copy.step();
    copy
}

/// 41: each Newton step more brings the pose nearer to where they all lead.
pub fn newton<R: Real>(at: At) -> Found {
    let moments = moments::<R>(at);
    let off = |newton: u32| {
        let errors = moments.iter().map(|book| {
            let exact = stepped(book, |s| s.newton = 30);
            apart(stepped(book, |s| s.newton = newton).leaf(), exact.leaf())
        });
        median(errors.filter(|e| e.is_finite()).collect())
    };
    let [one, two, five] = [1, 2, 5].map(off);
    let mut found = Found { figure: one, faults: Vec::new() };
    found.expect(moments.len() > 10, || format!("{} moments", moments.len()));
    found.expect(two <= one && five <= two, || format!("{one:.2e}, {two:.2e}, {five:.2e}"));
    found
}

/// 42: a dial of the seed's own formulation; the product's matrix has no such part to leave out. From the same
/// pose, at every picture of a turn: leaving it out moves the step by no more than leaving out a Newton step does.
pub fn hessian<R: Real>(at: At) -> Found {
    let scene = Scene::seed();
    let settings = SeedSettings { newton: 2, ..SeedSettings::default() };
    let mut book = Box::new(SeedBook::<R, G11x8>::EMPTY);
    let s = &scene;
    let opened = book.open(&s.book, &s.paper, &s.world, &s.view, s.fidelity, settings);
    let mut found = Found::default().with(opened.err().map(|e| e.to_string()));
    let samples = Gesture::corner_turn(&scene.eye(), 2);
    let mut next = samples.iter().copied().peekable();
    let (mut without, mut fewer) = (Vec::new(), Vec::new());
    for n in 0..at.count(40, 20) {
        let until = book.book().now_us() + u64::from(FRAME_US);
        while let Some(sample) = next.next_if(|s| s.t_us <= until) {
            let _ = book.book_mut().input(sample);
        }
        if n % 3 == 2 && book.book().leaf().is_some() {
            let after = |newton, constraint_hessian| {
                let mut copy = Box::new((*book).clone());
                *copy.settings_mut() = SeedSettings { newton, constraint_hessian, ..settings };
                let _ = copy.advance(FRAME_US);
                copy
            };
            let [whole, off, one] = [after(2, true), after(2, false), after(1, false)];
            without.push(apart(whole.book().leaf(), off.book().leaf()));
            fewer.push(apart(whole.book().leaf(), one.book().leaf()));
        }
        let _ = book.advance(FRAME_US);
    }
    found.expect(without.len() > 3, || format!("{} moments", without.len()));
    let [without, fewer] = [median(without), median(fewer)];
    found.figure = without;
    found
        .expect(without <= fewer, || format!("{without:.2e} without it, {fewer:.2e} a step fewer"));
    found
}

/// 43: more passes leave less depth, and three leave less than half a leaf.
pub fn passes<R: Real>(at: At) -> Found {
    let moments = moments::<R>(at);
    let depth = |passes: u32| -> Vec<f64> {
        let of = |book: &Pages<R>| {
            let after = stepped(book, |s| s.passes = passes);
            let leaf = 2.0 * after.binding().half_held().wide();
            (deepest(&after) / leaf.max(1e-12)).max(0.0)
        };
        moments.iter().map(|book| of(book)).collect()
    };
    let all = [0, 1, 2, 3].map(depth);
    let worst = all.each_ref().map(|d| d.iter().copied().fold(0.0, f64::max));
    let mean = all.each_ref().map(|d| d.iter().sum::<f64>() / d.len().max(1) as f64);
    let mut found = Found::within(worst[3], 0.5);
    let shrinks = mean.windows(2).all(|w| w[1] <= w[0] * (1.0 + 1e-9) + 1e-9);
    found.expect(shrinks, || format!("mean depths {mean:?}"));
    found.expect(worst[0] > worst[3], || format!("no pass at all is as good: {worst:?}"));
    found
}

/// 48: five seconds of a swinging leaf, beside the same in `f64`; and a third of a second of a drag.
pub fn scalars<R: Real>(at: At) -> Found {
    let spec = LeafSpec { clamp_angle_deg: 30.0, curl_per_m: 2.0, ..LeafSpec::default() };
    let mut narrow = lone::<R, G11x8>(&spec, &WorldSpec::default(), at);
    let mut wide = lone::<f64, G11x8>(&spec, &WorldSpec::default(), at);
    let mut far = 0f64;
    for _ in 0..300 {
        let _ = (narrow.step(), wide.step());
        far = far.max(apart(Some(narrow.leaf()), Some(wide.leaf())));
    }
    let scene = with(&Scene::default(), at);
    let samples = Gesture::corner_turn(&scene.eye(), 4);
    let (mut ours, mut theirs) = (Vec::new(), Vec::new());
    let _ = play_for::<R>(&scene, &samples, &Rules::WILD, |n, book| {
        if n < 20 {
            ours.extend(book.leaf().cloned());
        }
    });
    let _ = play_for::<f64>(&scene, &samples, &Rules::WILD, |n, book| {
        if n < 20 {
            theirs.extend(book.leaf().cloned());
        }
    });
    for (a, b) in ours.iter().zip(&theirs) {
        far = far.max(apart(Some(a), Some(b)));
    }
    let mut found = Found::within(far, 1e-3);
    found.expect(ours.len() == theirs.len(), || "taken up at different times".into());
    found
}
