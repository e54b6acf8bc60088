//! Promise: sweeps stay stable. Whatever the book, the paper, the world and the hand: every number is
//! finite, every status has a name, no edge leaves the band, no leaf is lost, every leaf taken up comes to
//! lie once, and the book comes to rest in time.

use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::scene::{BookSpec, Cover, Direction, Fidelity, PaperSpec, Preset};
use dogleaf_tests::case::{Case, Ends, judge};
use dogleaf_tests::depth::deepest;
use dogleaf_tests::gesture::{Eye, Gesture, Rng, Scene, TOUCH_US};

/// A second's turn from right to left of the same corner in every case.
fn turn(scene: &Scene) -> Vec<Sample> {
    Gesture::corner_turn(&scene.eye(), 7)
}
/// The same of several leaves.
fn turn_stack(scene: &Scene, leaves: u16) -> Vec<Sample> {
    turn(scene).into_iter().map(|s| Sample { leaves, ..s }).collect()
}
/// The same from left to right.
fn back(scene: &Scene) -> Vec<Sample> {
    scene.eye().mirror(&turn(scene))
}
fn press(eye: &Eye) -> Gesture {
    Gesture::press(eye.page(0.9, 0.8))
}

fn finish(cases: &[Case]) {
    let failed = judge(cases);
    let names: Vec<_> = failed.iter().map(ToString::to_string).collect();
    assert!(failed.is_empty(), "failed:\n{}", names.join("\n"));
}

/// From the first page to the last, both ways.
fn progress() -> Vec<Case> {
    let mut cases = Vec::new();
    for percent in (0..=100).step_by(5) {
        let scene = Scene::open_at(320, 320 * percent / 100);
        let ends = |leaf: bool| if leaf { Ends::Turned } else { Ends::Nothing };
        let case = |way: &str, samples, there| {
            Case::new(format!("q {percent} %, {way}"), &scene, samples, ends(there))
        };
        cases.push(case("onwards", turn(&scene), percent < 100));
        cases.push(case("back", back(&scene), percent > 0));
    }
    for (name, at) in [("first page", 1), ("first leaf turned", 2), ("before the last leaf", 318)] {
        let scene = Scene::open_at(320, at);
        cases.push(Case::new(name, &scene, turn(&scene), Ends::Turned));
    }
    cases
}

fn page_counts() -> Vec<Case> {
    let mut cases = Vec::new();
    for pages in [1, 2, 3, 4, 10, 100, 1000, 10_000] {
        for (place, at) in [("start", 0), ("middle", pages / 2)] {
            let mut scene = Scene::open_at(pages, at);
            // A book of 5,000 sheets of copier paper would be taller than it is wide; bible paper is not.
            scene.paper.thickness_mm = if pages > 1000 { 0.02 } else { 0.1 };
            let case =
                Case::new(format!("{pages} pages, {place}"), &scene, turn(&scene), Ends::Turned);
            cases.push(case);
        }
    }
    cases
}

fn stacks() -> Vec<Case> {
    let scene = Scene::open_at(160, 60);
    let step = if cfg!(debug_assertions) { 11 } else { 1 };
    let case =
        |n| Case::new(format!("{n} of 80 leaves"), &scene, turn_stack(&scene, n), Ends::Turned);
    let mut cases: Vec<_> = (1..=45).step_by(step).map(case).collect();
    let all = turn_stack(&scene, u16::MAX);
    cases.push(Case::new("more leaves than there are", &scene, all, Ends::Turned));
    cases.push(Case::new("no leaf means one", &scene, turn_stack(&scene, 0), Ends::Turned));
    cases
}

fn books() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, cover) in [("hard cover", Cover::Hard), ("soft cover", Cover::Soft)] {
        for direction in [Direction::Ltr, Direction::Rtl] {
            let scene = Scene::of(BookSpec { cover, direction, ..BookSpec::default() });
            let samples = if direction == Direction::Ltr { turn(&scene) } else { back(&scene) };
            cases.push(Case::new(format!("{name}, {direction:?}"), &scene, samples, Ends::Turned));
        }
    }
    for aspect in [0.2, 0.35, 0.5, 0.75, 1.0, 1.414, 2.0, 3.0, 5.0] {
        let (width_m, height_m) = (0.1, 0.1 * aspect);
        let scene = Scene::of(BookSpec { width_m, height_m, ..BookSpec::default() });
        cases.push(Case::new(
            format!("height {aspect} widths"),
            &scene,
            turn(&scene),
            Ends::Turned,
        ));
    }
    for width_m in [0.001, 0.01, 0.5, 10.0] {
        let mut scene = Scene::of(BookSpec { width_m, height_m: width_m, ..BookSpec::default() });
        // Paper of another size: only the size of the numbers is in question.
        scene.paper.thickness_mm = (0.8 * width_m).max(0.001);
        scene.world.gravity[1] *= width_m / 0.13;
        let case = Case::new(format!("{width_m} m wide"), &scene, turn(&scene), Ends::Turned);
        cases.push(case);
    }
    for (name, preset) in Preset::ALL {
        let mut scene = Scene { paper: PaperSpec::from(preset), ..Scene::default() };
        // Card makes a book of fewer leaves.
        scene.book.pages = if preset == Preset::Cardboard { 40 } else { 320 };
        scene.book.open_at = scene.book.pages / 4 * 2;
        cases.push(Case::new(name, &scene, turn(&scene), Ends::Turned));
    }
    cases
}

fn worlds() -> Vec<Case> {
    let mut cases = Vec::new();
    let mut world = |name: &str, change: &dyn Fn(&mut Scene), ends, rest_s| {
        let mut scene = Scene::default();
        change(&mut scene);
        cases.push(Case::new(name, &scene, turn(&scene), ends).within(rest_s));
    };
    world("no gravity", &|s| s.world.gravity = [0.0; 3], Ends::Hangs, 20.0);
    // A hand is only so strong: what weighs ten times as much may slip from it.
    world("gravity x 10", &|s| s.world.gravity[1] *= 10.0, Ends::Either, 4.0);
    world("gravity x 100", &|s| s.world.gravity[1] *= 100.0, Ends::Either, 4.0);
    world("gravity / 10", &|s| s.world.gravity[1] *= 0.1, Ends::Hangs, 20.0);
    world("upside down", &|s| s.world.gravity[1] *= -1.0, Ends::Hangs, 20.0);
    world("gravity aside", &|s| s.world.gravity = [9.81, 0.0, 0.0], Ends::Hangs, 20.0);
    world("gravity along the spine", &|s| s.world.gravity = [0.0, -7.0, 7.0], Ends::Turned, 4.0);
    world("no air", &|s| s.world.damping_per_s = 0.0, Ends::Turned, 4.0);
    world("damping 100 /s", &|s| s.world.damping_per_s = 100.0, Ends::Turned, 4.0);
    for rate in [15, 30, 60, 120, 240, 480] {
        let step = &|s: &mut Scene| s.world.step_us = 1_000_000 / rate;
        // At 1/15 s the leaf follows the hand too slowly to be turned in a second.
        let ends = if rate > 15 { Ends::Turned } else { Ends::Either };
        world(&format!("step 1/{rate} s"), step, ends, 4.0);
    }
    for (name, fidelity) in Fidelity::ALL {
        world(
            name,
            &|s| s.fidelity = fidelity,
            Ends::Turned,
            if name == "reference" { 10.0 } else { 6.0 },
        );
    }
    cases
}

fn wild_hands() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, scene) in [("", Scene::default()), (", seed's weights", Scene::seed())] {
        let eye = scene.eye();
        let mut add = |what: &str, samples| {
            cases.push(Case::new(format!("{what}{name}"), &scene, samples, Ends::Either));
        };
        add("scribble 20 Hz for 20 s", scribble(&eye));
        for seed in 0..3 {
            add(&format!("teleports every frame, {seed}"), teleports(&eye, seed));
        }
        add("far beyond the screen", far(&eye));
        add("whole range of the numbers", extremes(&eye));
        let up = press(&eye).to(eye.above(0.0, 0.7, 0.8), 500_000).hold(20_000_000).up();
        add("held at the top for 20 s", up);
        let over_spine = press(&eye).to(eye.above(0.0, 0.7, 0.0), 700_000).hold(700_000).up();
        add("let go exactly over the spine", over_spine);
        let over = press(&eye).to(eye.page(-0.9, 0.8), 1).up();
        add("across in one sample", over);
        let under = press(&eye).to(eye.above(-0.5, -0.6, 0.8), 800_000).up();
        add("down through the other block", under);
        let behind = press(&eye).to(eye.above(0.0, 0.2, -3.0), 800_000).hold(300_000).up();
        add("behind the spine", behind);
    }
    cases
}

/// A circle over the spine, twenty times a second.
fn scribble(eye: &Eye) -> Vec<Sample> {
    let (a, b) = (eye.above(-0.6, 0.4, 0.8), eye.above(0.6, 0.4, 0.8));
    let middle = [0, 1].map(|c: usize| 0.5 * (a[c] + b[c]));
    let radius = 0.5 * (b[0] - a[0]);
    let round = |t: f64| {
        let angle = core::f64::consts::TAU * 400.0 * t;
        [middle[0] + radius * angle.cos(), middle[1] + radius * angle.sin()]
    };
    press(eye).to(round(0.0), 200_000).along(20_000_000, round).up()
}

/// From corner to corner in no time, two seconds long.
fn teleports(eye: &Eye, seed: u64) -> Vec<Sample> {
    let mut rng = Rng::new(seed);
    let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)].map(|(x, z)| eye.page(x, z));
    let mut gesture = press(eye);
    for _ in 0..240 {
        gesture = gesture.to(corners[(rng.bits() % 4) as usize], TOUCH_US);
    }
    gesture.up()
}

fn far(eye: &Eye) -> Vec<Sample> {
    let mut gesture = press(eye);
    for to in [[-5e6, 300.0], [5e6, 300.0], [480.0, -5e6], [480.0, 5e6], [-5e6, -5e6], [5e6, 5e6]] {
        gesture = gesture.to(to, 250_000);
    }
    gesture.up()
}

/// Numbers at the ends of their range.
fn extremes(eye: &Eye) -> Vec<Sample> {
    let mut samples = press(eye).hold(2_000_000).up();
    let ends = [i32::MIN, i32::MAX, 0, -1, i32::MIN + 1, i32::MAX - 1];
    let mut rng = Rng::new(1);
    let last = samples.len() - 1;
    for sample in &mut samples[1..last] {
        (sample.x, sample.y) = (ends[(rng.bits() % 6) as usize], ends[(rng.bits() % 6) as usize]);
    }
    samples
}

fn intents() -> Vec<Case> {
    let scene = Scene::default();
    let eye = scene.eye();
    let page = |x: f64| eye.page(x, 0.8);
    let lift = |x: f64| eye.above(x, 0.3, 0.8);
    let taken = press(&eye).to(lift(0.2), 500_000).cancel();
    let reversed = press(&eye).to(lift(-0.3), 600_000).hold(300_000).to(lift(0.3), 80_000).up();
    let cases = [
        ("a press and nothing more", press(&eye).up(), Ends::Back),
        ("a second's press", press(&eye).hold(1_000_000).up(), Ends::Back),
        ("a twitch", press(&eye).to(page(0.88), 25_000).up(), Ends::Back),
        ("a flick", press(&eye).to(page(0.3), 100_000).up(), Ends::Turned),
        (
            "a flick from the left",
            eye.mirror(&press(&eye).to(page(0.3), 100_000).up()),
            Ends::Turned,
        ),
        ("a flick the wrong way", press(&eye).to(page(1.4), 100_000).up(), Ends::Back),
        ("a reverse flick", reversed, Ends::Back),
        (
            "peek and put back",
            press(&eye).to(lift(0.4), 700_000).to(page(0.9), 700_000).up(),
            Ends::Back,
        ),
        (
            "let go a third of the way",
            press(&eye).to(page(0.5), 900_000).hold(200_000).up(),
            Ends::Back,
        ),
        (
            "let go beyond the spine",
            press(&eye).to(lift(-0.4), 900_000).hold(200_000).up(),
            Ends::Turned,
        ),
        ("taken away by the system", taken, Ends::Back),
        ("a turn in 5 s", press(&eye).to(page(-0.9), 5_000_000).up(), Ends::Turned),
        ("a turn in 0.1 s", press(&eye).to(page(-0.9), 100_000).up(), Ends::Turned),
        ("a turn by the middle of the edge", middle(&eye), Ends::Turned),
    ];
    cases.into_iter().map(|(name, samples, ends)| Case::new(name, &scene, samples, ends)).collect()
}

fn middle(eye: &Eye) -> Vec<Sample> {
    Gesture::press(eye.page(0.9, 0.0)).to(eye.page(-0.9, 0.0), 1_000_000).up()
}

/// Fingers that do not keep to the rules.
fn confusions() -> Vec<Case> {
    let scene = Scene::default();
    let eye = scene.eye();
    let whole = turn(&scene);
    let other = |id, later| Gesture::press(eye.page(-0.9, 0.5)).by(id, later);
    let mix = |parts: &[&[Sample]]| {
        let mut all = parts.concat();
        all.sort_by_key(|s| s.t_us);
        all
    };
    let twice: Vec<_> = whole.iter().flat_map(|&s| [s, s]).collect();
    let pressed_twice =
        mix(&[&whole, &Gesture::press(eye.page(0.5, 0.5)).by(0, 500_000).up()[..1]]);
    let no_down: Vec<_> = whole.iter().copied().filter(|s| s.phase != Phase::Down).collect();
    let no_up: Vec<_> = whole.iter().copied().filter(|s| s.phase != Phase::Up).collect();
    let ends = Gesture::press(eye.page(0.9, 0.8)).by(0, 3_000_000).cancel();
    let second = other(1, 300_000).to(eye.page(0.9, 0.5), 500_000).up();
    let ten: Vec<_> =
        (1..11).flat_map(|id| other(id, 40_000 * u64::from(id)).hold(500_000).up()).collect();
    let every_fifth: Vec<_> = whole
        .iter()
        .enumerate()
        .filter(|(n, s)| n % 5 == 0 || s.phase != Phase::Move)
        .map(|(_, s)| *s)
        .collect();
    let ends_only: Vec<_> = whole.iter().copied().filter(|s| s.phase != Phase::Move).collect();
    let cases = [
        ("every sample twice", twice, Ends::Turned),
        ("pressed twice", pressed_twice, Ends::Turned),
        ("up without down", no_down, Ends::Nothing),
        ("never let go, pressed again, cancelled", mix(&[&no_up, &ends]), Ends::Balanced),
        ("a second finger on the other side", mix(&[&whole, &second]), Ends::Turned),
        ("ten more fingers", mix(&[&whole, &ten]), Ends::Turned),
        ("four samples of five lost", every_fifth, Ends::Turned),
        ("every move lost", ends_only, Ends::Either),
    ];
    cases.into_iter().map(|(name, samples, ends)| Case::new(name, &scene, samples, ends)).collect()
}

#[test]
fn sweeps() {
    let all = [
        progress(),
        page_counts(),
        stacks(),
        books(),
        worlds(),
        wild_hands(),
        intents(),
        confusions(),
    ];
    finish(&all.concat());
}

/// What the table is worth: a leaf that lies on its block is seen to touch it, not to be in it.
#[test]
fn the_depth_is_seen() {
    let mut book = Scene::default().open::<f64, G11x8>().expect("a sound scene");
    assert!(book.take_up(true, 1), "there is a leaf");
    let thickness = book.binding().leaf;
    assert!(deepest(&book).abs() < 0.5 * thickness, "touches: {}", deepest(&book));
    let table =
        Case::new("no leaf", &Scene::open_at(2, 2), turn(&Scene::open_at(2, 2)), Ends::Turned);
    assert_eq!(table.run::<f32>().faults.len(), 1, "a turn that cannot be is seen");
}
