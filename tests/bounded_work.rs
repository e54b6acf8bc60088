//! Promise: work is bounded. Whatever the hand does and however long a frame was, a step takes no more Newton
//! steps, trials and collision passes than its fidelity says, and a call no more than eight steps.

use dogleaf_core::LoneLeaf;
use dogleaf_core::book::InputError;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::scene::{Fidelity, LeafSpec, Settings, WorldSpec};
use dogleaf_core::step::StepReport;
use dogleaf_tests::gesture::{Eye, Rng, Scene};

/// World steps one call may take.
const MOST_STEPS: u32 = 8;
/// Nodes a pass may move: those of the leaf, and twelve of blocks and four of boards beside it.
const NODES: u32 = 88 + 12 + 4;

/// What is over its bound in a report over `steps` world steps.
fn excess(report: &StepReport, settings: &Settings, steps: u32) -> Option<String> {
    // Each taken once, or once and then in four parts.
    let substeps = steps * settings.substeps + 4 * report.parted;
    let bounds = [
        ("steps in parts", report.parted, steps * settings.substeps),
        ("steps", report.steps, steps),
        ("Newton steps", report.newton_steps, substeps * settings.newton),
        ("trials", report.cuts, settings.trials * report.newton_steps),
        ("passes", report.passes, substeps * settings.passes),
        ("chain solves", report.chain_solves, substeps * 4),
        ("nodes pushed", report.pushed, substeps * NODES),
        ("nudges", report.nudged, steps),
        ("forced rests", report.forced_rests, steps),
    ];
    let over = bounds.into_iter().find(|(_, found, most)| found > most);
    over.map(|(name, found, most)| format!("{found} {name}, at most {most}"))
}

/// A frantic hand: presses, moves, lets go, anywhere, at any time.
fn frantic(rng: &mut Rng, eye: &Eye, now_us: u64) -> Sample {
    let phase = match rng.bits() % 16 {
        0 | 1 => Phase::Down,
        2 => Phase::Up,
        3 => Phase::Cancel,
        _ => Phase::Move,
    };
    let at = eye.above(rng.within(-1.4, 1.4), rng.within(-0.2, 0.8), rng.within(-1.2, 1.2));
    let [x, y] = at.map(|p| (p * 256.0) as i32);
    Sample {
        t_us: now_us,
        id: (rng.bits() % 2) as u8,
        phase,
        x,
        y,
        leaves: (rng.bits() % 4) as u16,
    }
}

fn steps() -> u32 {
    if cfg!(debug_assertions) { 1_500 } else { 12_000 }
}

/// Plays a frantic hand on a scene, call by call of whatever length; answers all the work.
fn frenzy(scene: &Scene, seed: u64, frame: impl Fn(&mut Rng) -> u32) -> StepReport {
    let settings = scene.fidelity.settings();
    let mut book = scene.open::<f32, G11x8>().expect("a sound scene");
    let (mut rng, eye, mut all) = (Rng::new(seed), scene.eye(), StepReport::default());
    while all.steps < steps() / settings.substeps {
        for _ in 0..rng.bits() % 3 {
            let answer = book.input(frantic(&mut rng, &eye, book.now_us()));
            assert_ne!(answer, Err(InputError::OutOfOrder), "now is never too early");
        }
        let report = book.advance(frame(&mut rng));
        assert_eq!(excess(&report, &settings, MOST_STEPS), None, "{report:?}");
        all.add(&report);
        while book.take_event().is_some() {}
    }
    all
}

#[test]
fn of_every_fidelity() {
    for (name, fidelity) in Fidelity::ALL {
        let scene = Scene { fidelity, ..Scene::default() };
        let all = frenzy(&scene, 1, |_| 16_667);
        assert_eq!(excess(&all, &fidelity.settings(), all.steps), None, "{name}");
        assert!(all.newton_steps > all.steps / 4, "{name}: a leaf was in the air: {all:?}");
        println!("{name:10} {all:?}");
    }
}

#[test]
fn of_the_seeds_weights() {
    let all = frenzy(&Scene::seed(), 2, |_| 16_667);
    assert!(all.newton_steps > all.steps / 4, "a leaf was in the air: {all:?}");
}

/// Frames from nothing to longer than a life.
#[test]
fn of_any_frame() {
    let lengths = [0, 1, 16_666, 16_667, 16_668, 100_000, 1_000_000, 30_000_000, u32::MAX];
    let all = frenzy(&Scene::default(), 3, |rng| lengths[(rng.bits() % 9) as usize]);
    assert!(all.newton_steps > all.steps / 4, "a leaf was in the air: {all:?}");
}

/// One step at a time: each within its own bound.
#[test]
fn of_every_single_step() {
    let scene = Scene::default();
    let settings = scene.fidelity.settings();
    let mut book = scene.open::<f64, G11x8>().expect("a sound scene");
    let (mut rng, eye) = (Rng::new(4), scene.eye());
    for _ in 0..steps() / 4 {
        let _ = book.input(frantic(&mut rng, &eye, book.now_us()));
        let report = book.step();
        assert_eq!(excess(&report, &settings, 1), None, "{report:?}");
    }
}

#[test]
fn of_a_lone_leaf() {
    for (name, fidelity) in Fidelity::ALL {
        let (scene, world) =
            (Scene::default(), WorldSpec { gravity: [0.0, -981.0, 3.0], ..WorldSpec::default() });
        let mut lone = Box::new(LoneLeaf::<f32, G11x8>::EMPTY);
        lone.open(&LeafSpec::default(), &scene.paper, &world, fidelity).expect("a sound leaf");
        for dt_us in [16_667, 0, u32::MAX, 40_000, 1].into_iter().cycle().take(60) {
            let report = lone.advance(dt_us);
            let settings = Settings { passes: 0, ..fidelity.settings() };
            assert_eq!(excess(&report, &settings, MOST_STEPS), None, "{name}: {report:?}");
        }
    }
}

/// What the check is worth: one Newton step, trial, pass or step more is seen.
#[test]
fn the_check_can_fail() {
    let settings = Fidelity::Standard.settings();
    let full = StepReport {
        steps: 8,
        newton_steps: 8,
        cuts: 160,
        passes: 24,
        chain_solves: 32,
        ..StepReport::default()
    };
    assert_eq!(excess(&full, &settings, MOST_STEPS), None, "the bounds can be reached");
    let changes: [fn(&mut StepReport); 5] = [
        |r| r.steps += 1,
        |r| r.newton_steps += 1,
        |r| r.cuts += 1,
        |r| r.passes += 1,
        |r| r.chain_solves += 1,
    ];
    for change in changes {
        let mut over = full;
        change(&mut over);
        assert!(excess(&over, &settings, MOST_STEPS).is_some(), "{over:?}");
    }
}
