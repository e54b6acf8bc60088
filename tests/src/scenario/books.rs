//! Scenarios 14-19: books of every make.

use super::harness::{Rules, Seen, apart, at as with, open, play, play_for};
use super::{At, Found};
use crate::gesture::{Gesture, Scene};
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::Sample;
use dogleaf_core::real::Real;
use dogleaf_core::scene::BookSpec;
use dogleaf_core::state::Leaf;

fn turn(scene: &Scene) -> Vec<Sample> {
    Gesture::corner_turn(&scene.eye(), 7)
}

/// Plays a turn of each scene; answers what `figure` makes of them at its largest.
fn each<R: Real>(
    scenes: impl IntoIterator<Item = (String, Scene, Vec<Sample>)>,
    rules: &Rules,
    figure: impl Fn(&Seen<R>) -> f64,
) -> Found {
    let mut found = Found::default();
    for (name, scene, samples) in scenes {
        let seen = play::<R>(&scene, &samples, rules);
        found.figure = found.figure.max(figure(&seen));
        found.faults.extend(seen.faults.into_iter().map(|f| format!("{name}: {f}")));
    }
    found
}

/// 14: one leaf off a block of one to ten thousand, and a stack of them.
pub fn masses<R: Real>(at: At) -> Found {
    let scenes = [(4, 1), (20, 1), (200, 1), (2_000, 1), (20_000, 1), (20_000, 5_000)];
    let scenes = scenes.into_iter().map(|(pages, leaves)| {
        let mut scene = with(&Scene::open_at(pages, pages / 4 * 2), at);
        scene.paper.thickness_mm = if pages > 1_000 { 0.01 } else { 0.104 };
        let samples = turn(&scene).into_iter().map(|s| Sample { leaves, ..s }).collect();
        (format!("{leaves} of {} leaves", pages / 2), scene, samples)
    });
    each::<R>(scenes, &Rules::WILD, Seen::rested)
}

/// 15: blocks of no thickness at all.
pub fn counts<R: Real>(at: At) -> Found {
    let scenes = [1, 2, 3, 10_000].into_iter().flat_map(|pages| {
        [0, pages / 2].map(|place| {
            let mut scene = with(&Scene::open_at(pages, place), at);
            scene.paper.thickness_mm = if pages > 1_000 { 0.02 } else { 0.104 };
            (format!("{pages} pages at {place}"), scene, turn(&scene))
        })
    });
    each::<R>(scenes, &Rules::WILD, Seen::rested)
}

/// 16: nothing lies on one side; a press there takes nothing up.
pub fn ends<R: Real>(at: At) -> Found {
    let mut found = Found::default();
    for (pages, place) in [(320, 0), (320, 1), (320, 2), (320, 318), (320, 320), (2, 0), (2, 2)] {
        let scene = with(&Scene::open_at(pages, place), at);
        let there = [place / 2 > 0, place / 2 < pages.div_ceil(2)];
        let onwards = turn(&scene);
        for (side, samples) in [(0, scene.eye().mirror(&onwards)), (1, onwards.clone())] {
            let seen = play::<R>(&scene, &samples, &Rules::GENTLE);
            let name = format!("page {place} of {pages}, side {side}");
            let [lifted, committed, _] = seen.watch.turns();
            let right = lifted == usize::from(there[side]) && committed == lifted;
            found.expect(right, || format!("{name}: {lifted} lifted, {committed} turned"));
            found.figure = found.figure.max(seen.rest_s.unwrap_or(0.0));
            found.faults.extend(seen.faults.into_iter().map(|f| format!("{name}: {f}")));
        }
    }
    found
}

/// 17: what is no thickness is refused; what is one is simulated.
pub fn thickness<R: Real>(at: At) -> Found {
    let mut found = Found::default();
    let of = |mm: f64, pages: u32| {
        let mut scene = with(&Scene::open_at(pages, pages / 4 * 2), at);
        scene.paper.thickness_mm = mm;
        scene
    };
    for mm in [0.0, 1e-9, 1e-6, -0.1, f64::NAN, f64::INFINITY, 10.001, 1e9, f64::MIN_POSITIVE] {
        found.expect(open::<R>(&of(mm, 40)).is_err(), || format!("{mm} mm was taken"));
    }
    for (mm, pages) in [(0.001, 320), (0.0075, 320), (0.0813, 320), (1.0, 40), (10.0, 4)] {
        let scene = of(mm, pages);
        // Foil is as limp as nothing else, a plank is turned by nobody: both stay what they are.
        let rules = if (0.05..1.0).contains(&mm) { Rules::GENTLE } else { Rules::WILD };
        let seen = play::<R>(&scene, &turn(&scene), &rules);
        found.figure = found.figure.max(seen.watch.air.worst);
        found.faults.extend(seen.faults.into_iter().map(|f| format!("{mm} mm: {f}")));
    }
    found
}

/// 18: from a fifth to five; beyond is refused.
pub fn aspects<R: Real>(at: At) -> Found {
    let of = |aspect: f64| {
        let book = BookSpec { width_m: 0.1, height_m: 0.1 * aspect, ..BookSpec::default() };
        with(&Scene::of(book), at)
    };
    let taken = [0.2, 0.5, 1.0, core::f64::consts::SQRT_2, 2.0, 5.0];
    let scenes = taken.map(|a| (format!("1:{a}"), of(a), turn(&of(a))));
    let mut found = each::<R>(scenes, &Rules::GENTLE, |seen| seen.watch.air.worst);
    for aspect in [0.01, 0.1, 0.199, 5.01, 10.0, 100.0, 0.0, -1.0] {
        found.expect(open::<R>(&of(aspect)).is_err(), || format!("1:{aspect} was taken"));
    }
    found
}

/// A book `s` times as large of paper that bends as far under its weight: thickness as the size, and stiffness
/// and gravity so that lengths alone change.
fn scaled(s: f64, at: At) -> Scene {
    let mut scene = with(&Scene::default(), at);
    scene.book.width_m *= s;
    scene.book.height_m *= s;
    scene.paper.thickness_mm *= s;
    scene.paper.youngs_gpa *= s;
    scene.world.gravity[1] *= s;
    let (w, h) = (scene.book.width_m, scene.book.height_m);
    scene.view = dogleaf_core::hand::View::reading(w, h, 960, 720);
    scene
}

/// 19: from a stamp to a barn door. Sides below a millimetre and above ten metres are refused.
pub fn sizes<R: Real>(at: At) -> Found {
    let shape = |s: f64| -> (Option<Leaf<R, G11x8>>, Vec<String>) {
        let mut shape = None;
        let scene = scaled(s, at);
        // Half way over: later the ways part where the leaf is let go.
        let seen = play_for::<R>(&scene, &turn(&scene), &Rules::GENTLE, |n, book| {
            if n == 30 {
                shape = book.leaf().cloned();
            }
        });
        (shape, seen.faults)
    };
    let (usual, faults) = shape(1.0);
    let mut found = Found::default().with(faults);
    found.expect(usual.is_some(), || "no leaf half way".into());
    for s in [0.02, 0.1, 10.0, 49.0] {
        let (other, faults) = shape(s);
        found.figure = found.figure.max(apart(usual.as_ref(), other.as_ref()));
        found.faults.extend(faults.into_iter().map(|f| format!("x {s}: {f}")));
    }
    let far = found.figure;
    found.expect(far <= 1e-3, || format!("{far:.1e} widths apart"));
    for s in [1e-6, 0.004, 100.0, 1e6] {
        found.expect(open::<R>(&scaled(s, at)).is_err(), || format!("x {s} was taken"));
    }
    found
}
