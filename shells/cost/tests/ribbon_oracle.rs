//! Promise: Newton's method and the seed's Algorithm 2 minimise the same objective and come to the same minimum; that
//! the oracle's gradient is the objective's is seen by finite differences.

use dogleaf_core::effect::ribbon::Settings;
use dogleaf_core::scene::SpecError;
use dogleaf_cost::ribbon::algorithm::algorithm_2;
use dogleaf_cost::ribbon::lbfgsb::{Limits, Objective};
use dogleaf_cost::ribbon::race::race;
use dogleaf_cost::ribbon::scenes::{Scene, fall, helix, torsion};
use dogleaf_cost::ribbon::unknowns::{Unknowns, set_out};

/// A scene some steps on.
fn after(scene: Result<Scene, SpecError>, steps: u32) -> Scene {
    let mut scene = scene.expect("a sound scene");
    for step in 0..steps {
        scene.ask(step);
        scene.ribbon.step_under(scene.h, &scene.floor);
    }
    scene.ask(steps);
    scene
}

/// Both ends of a step's objective and where both put the vertices.
fn both(scene: &Scene, lighter: f64) -> ([f64; 2], f64) {
    let mut ours = Box::new(scene.ribbon.clone());
    ours.settings = Settings { iterations: 500, tolerance: 1e-10, ..Settings::EXACT };
    let report = ours.step_under(scene.h, &scene.floor);
    let mut theirs = Box::new(scene.ribbon.clone());
    theirs.gravity = theirs.gravity.map(|g| g * lighter);
    let ask = theirs.ask.clone();
    set_out(&mut theirs, scene.h);
    let mut unknowns = Unknowns::new(theirs.body(), ask, &scene.floor);
    let limits = Limits { iterations: 60_000, factor: 0.0, ..Limits::default() };
    let answer = algorithm_2(&mut unknowns, &limits, |_, _| true);
    println!("{}: Newton {:?}, {answer:?}", scene.name, report);
    assert!(answer.violation <= 1e-9, "its rows hold: {}", answer.violation);
    let far = ours.pairs().flatten().zip(theirs.pairs().flatten());
    let apart = far.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
    ([report.objective, answer.objective], apart)
}

fn start_value(scene: &Scene) -> f64 {
    let mut copy = Box::new(scene.ribbon.clone());
    set_out(&mut copy, scene.h);
    let ask = copy.ask.clone();
    copy.body().evaluate(&ask, &scene.floor).objective
}

#[test]
fn both_methods_come_to_the_same_minimum() {
    // Where the clamped helix has just been let go, there is one minimum near; far from it, there are several.
    for scene in [after(helix("helix", 0.01), 1), after(fall(), 3)] {
        let ([newton, seed], apart) = both(&scene, 1.0);
        let way = start_value(&scene) - newton;
        assert!(way > 0.0, "{}: there was something to do", scene.name);
        let gap = (seed - newton).abs() / way;
        println!("{}: gap {gap:.1e}, apart by {apart:.1e} m", scene.name);
        assert!(gap <= 1e-6, "{}: {newton} and {seed}, gap {gap}", scene.name);
        assert!(apart <= 1e-4, "{}: apart by {apart} m", scene.name);
    }
}

#[test]
fn another_objective_has_another_minimum() {
    let scene = after(helix("helix", 0.01), 1);
    let ([newton, seed], apart) = both(&scene, 0.98);
    let gap = (seed - newton).abs() / (start_value(&scene) - newton);
    assert!(gap > 1e-6 && apart > 1e-5, "noticed: {gap}, {apart}");
}

#[test]
fn the_gradient_is_the_objectives() {
    for scene in [after(helix("helix", 0.01), 5), after(fall(), 5), after(torsion(0.05), 20)] {
        let mut copy = Box::new(scene.ribbon.clone());
        let ask = copy.ask.clone();
        set_out(&mut copy, scene.h);
        let mut unknowns = Unknowns::new(copy.body(), ask, &scene.floor);
        unknowns.lambda = [-0.3, -0.2];
        let (mut x, _) = unknowns.start();
        // Off the kinks of nothing: the start's own turn, too, is not zero.
        let count = x.len();
        for (i, x) in x.iter_mut().enumerate() {
            *x += if i + 6 >= count { 0.02 } else { 1e-3 } * (i as f64).sin();
        }
        let mut gradient = vec![0.0; count];
        unknowns.evaluate(&x, &mut gradient);
        let size = gradient.iter().map(|g| g.abs()).fold(0.0, f64::max);
        assert!(size > 1e-3, "{}: a gradient", scene.name);
        let mut scratch = vec![0.0; count];
        for i in (0..count).step_by(7).chain(count - 6..count) {
            let mut at = |by: f64| {
                let mut x = x.clone();
                x[i] += by;
                unknowns.evaluate(&x, &mut scratch)
            };
            let h = 1e-6;
            let found = (at(h) - at(-h)) / (2.0 * h);
            let error = (found - gradient[i]).abs() / size;
            assert!(error < 1e-6, "{}, {i}: {found} against {}", scene.name, gradient[i]);
        }
    }
}

#[test]
fn a_race_counts_the_same_each_time() {
    let run = || {
        let mut scene = helix("helix", 0.05).expect("a sound scene");
        scene.steps = 4;
        race(scene, 2)
    };
    let (a, b) = (run(), run());
    let counts = |r: &dogleaf_cost::ribbon::race::Race| {
        (r.steps, r.newton_arrives, r.seed_arrives, r.better, r.newton_iterations.to_bits())
    };
    assert_eq!(counts(&a), counts(&b), "{a:?}");
    assert_eq!(a.seed_iterations.to_bits(), b.seed_iterations.to_bits(), "{a:?}");
    assert_eq!(a.steps, 2, "every second");
    assert!(a.newton_arrives == 2 && a.newton_iterations < 20.0, "{a:?}");
}

#[test]
fn every_row_of_the_report_has_figures() {
    let rows = dogleaf_cost::ribbon::claims::claims().expect("sound scenes");
    assert_eq!(rows.len(), 10, "Table 1 without its double chain, Figs 8, 11 and 13");
    for row in rows {
        println!("{}: {} | {} | {}", row.what, row.seed, row.rebuilt, row.ours);
        assert!(row.ours.contains(|c: char| c.is_ascii_digit()), "{}", row.what);
        assert!(!row.ours.contains("NaN") && !row.rebuilt.contains("NaN"), "{}", row.what);
    }
}
