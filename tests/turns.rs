//! Promise: a corner carried over the spine in a second turns one leaf, whoever's hand it is, without
//! stretching it more than paper may be seen to stretch, and then the book lies still for good.

use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;
use dogleaf_core::scene::Weights;
use dogleaf_core::step::StepStatus;
use dogleaf_tests::gesture::{Gesture, Scene, play};
use dogleaf_tests::watch::{Figures, Watch};

/// Pictures of the drag: a press after 20 ms, then a second.
const DRAG: u32 = 62;
/// Pictures a leaf may take from letting go to rest: four seconds.
const REST: u32 = 240;
/// Pictures a sleeping book is looked at.
const ASLEEP: u32 = 600;
/// Largest mean over pictures of the largest stretch, root mean square, largest ever.
const BOUNDS: [f64; 3] = [0.015, 0.003, 0.20];

/// Gestures: enough for the figures in release, a sample in debug.
fn count() -> u64 {
    if cfg!(debug_assertions) { 24 } else { 200 }
}

/// Every gesture on one scene.
#[derive(Default)]
struct Ensemble {
    air: Figures,
    drag: Figures,
    slowest: u32,
    kept: u32,
    complaints: Vec<String>,
}

impl Ensemble {
    fn of(scene: &Scene, gestures: u64) -> Self {
        let mut all = Self::default();
        for seed in 0..gestures {
            all.turn(scene, seed);
        }
        for ((name, found), bound) in all.figures().into_iter().zip(BOUNDS) {
            if found > bound {
                all.complain(format!("{name} {:.3} % > {:.3} %", 100.0 * found, 100.0 * bound));
            }
        }
        all
    }
    fn complain(&mut self, what: impl Into<String>) {
        self.complaints.push(what.into());
    }
    fn figures(&self) -> [(&'static str, f64); 3] {
        [("mean max", self.air.mean_max()), ("rms", self.air.rms()), ("worst", self.air.worst)]
    }

    fn turn(&mut self, scene: &Scene, seed: u64) {
        let mut book = scene.open::<f32, G11x8>().expect("a sound scene");
        let mut seen = Watch::default();
        let samples = Gesture::corner_turn(&scene.eye(), seed);
        play(&mut book, &samples, DRAG + REST, &mut |b, r| seen.see(b, r));
        self.air.add(&seen.air);
        self.drag.add(&seen.drag);
        self.kept += seen.kept();
        self.slowest = self.slowest.max(seen.rest.unwrap_or(u32::MAX).saturating_sub(DRAG));
        for what in faults(&seen, scene.book.open_at + 2) {
            self.complain(format!("gesture {seed}: {what}"));
        }
        if let Some(what) = stirs(&mut book) {
            self.complain(format!("gesture {seed}: {what}"));
        }
    }
}

impl core::fmt::Display for Ensemble {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        for (name, s) in [("in the air", &self.air), ("dragged", &self.drag)] {
            let [mean, rms, worst] = [s.mean_max(), s.rms(), s.worst].map(|v| 100.0 * v);
            let n = s.frames;
            writeln!(
                f,
                "  {name:10} {n:6} pictures  mean max {mean:6.3} %  rms {rms:6.3} %  worst {worst:6.2} %"
            )?;
        }
        write!(f, "  at rest after {} pictures at most, pose kept in {}", self.slowest, self.kept)
    }
}

/// What is wrong with one turn.
fn faults(seen: &Watch, page: u32) -> Vec<String> {
    let mut all: Vec<_> = seen.complaint.iter().cloned().collect();
    if seen.turns() != [1, 1, 0] || seen.page() != Some(page) {
        all.push(format!(
            "lifted, committed, cancelled {:?}, page {:?}",
            seen.turns(),
            seen.page()
        ));
    }
    if seen.rest.is_none() {
        all.push("not at rest four seconds after it was let go".into());
    }
    if seen.work.forced_rests > 0 {
        all.push("had to be laid to rest".into());
    }
    if matches!(seen.last, StepStatus::Held | StepStatus::Recovered) {
        all.push(format!("ends {}", seen.last.name()));
    }
    all
}

/// Whether a book that should sleep does anything.
fn stirs(book: &mut Book<f32, G11x8>) -> Option<String> {
    let hash = book.state_hash();
    for n in 0..ASLEEP {
        let report = book.step();
        if report.steps != 0 || book.needs_frame() || book.state_hash() != hash {
            return Some(format!("stirs {n} steps after it fell asleep"));
        }
    }
    None
}

fn keeps_its_promise(name: &str, scene: &Scene) {
    let all = Ensemble::of(scene, count());
    println!("{name}, {} gestures\n{all}", count());
    assert!(all.complaints.is_empty(), "{name}:\n{}", all.complaints.join("\n"));
}

#[test]
fn of_paper() {
    keeps_its_promise("paper", &Scene::default());
}

#[test]
fn with_the_seeds_weights() {
    keeps_its_promise("seed's weights", &Scene::seed());
}

/// What the check is worth: rubber, a turn given up half way, and a book that was never let sleep are seen.
#[test]
fn the_check_can_fail() {
    let mut rubber = Scene::seed();
    rubber.paper.weights = Some(Weights { iso_3d: 40.0, ..Weights::default() });
    let all = Ensemble::of(&rubber, 8);
    println!("rubber\n{all}");
    assert!(all.complaints.iter().any(|c| c.starts_with("mean max")), "{:?}", all.complaints);

    let scene = Scene::default();
    let eye = scene.eye();
    let half = Gesture::press(eye.page(0.9, 0.8)).to(eye.page(0.4, 0.8), 500_000).up();
    let mut book = scene.open::<f32, G11x8>().expect("a sound scene");
    let mut seen = Watch::default();
    play(&mut book, &half, DRAG + REST, &mut |b, r| seen.see(b, r));
    assert_eq!(faults(&seen, 122).len(), 1, "a turn given up: {:?}", faults(&seen, 122));

    let mut seen = Watch::default();
    let whole = Gesture::corner_turn(&eye, 1);
    play(&mut book, &whole, DRAG, &mut |b, r| seen.see(b, r));
    assert_eq!(faults(&seen, 122).len(), 2, "still in the air: {:?}", faults(&seen, 122));
    assert!(stirs(&mut book).is_some(), "a book that is still awake");
}
