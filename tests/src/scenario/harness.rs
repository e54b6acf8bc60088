//! A book under the rules: plays a gesture and says which rule was broken.

use super::At;
use crate::gesture::{FRAME_US, Scene};
use crate::watch::Watch;
use dogleaf_core::Book;
use dogleaf_core::grid::{G11x8, Grid};
use dogleaf_core::hand::Sample;
use dogleaf_core::real::{Real, V3};
use dogleaf_core::scene::{Settings, SpecError};
use dogleaf_core::state::{Fnv, Leaf};
use dogleaf_core::step::{StepReport, StepStatus};

/// A page in model units.
pub const WIDTH: f64 = 12.0;
/// Seconds to rest.
const REST_S: f64 = 4.0;
/// Fastest a node may be, widths per second: across the spread within a hundredth of a second.
const FASTEST: f64 = 200.0;
/// How far a star may be from a flat one in a step that says it went well: a difference of cosines.
const STAR: f64 = 0.5;

/// The book of the scenarios.
pub type Pages<R> = Book<R, G11x8>;

/// What is asked beyond the rules.
#[derive(Debug, Clone, Copy)]
pub struct Rules {
    /// Largest stretch.
    pub stretch: f64,
    /// Seconds to rest; nothing where it need not come to rest.
    pub rest_s: Option<f64>,
    /// The blocks fold over themselves: depth has no answer.
    pub folded: bool,
    /// The sheet is no paper: its weights are too weak to hold it together.
    pub rubber: bool,
}

impl Rules {
    /// For a hand that means well.
    pub const GENTLE: Self =
        Self { stretch: 0.15, rest_s: Some(REST_S), folded: false, rubber: false };
    /// For a hand that does not: only the band of paper.
    pub const WILD: Self = Self { stretch: 0.6, ..Self::GENTLE };
    /// For worlds in which nothing is promised but numbers.
    pub const NUMBERS: Self = Self { stretch: 0.61, rest_s: None, folded: true, rubber: true };
}

/// What was seen of a run.
#[derive(Debug)]
pub struct Seen<R: Real> {
    /// The book after it.
    pub book: Box<Pages<R>>,
    /// Everything counted.
    pub watch: Watch,
    /// Hash of the hashes of all pictures.
    pub way: u64,
    /// Fastest node, widths per second.
    pub fastest: f64,
    /// Most steps in one picture.
    pub busiest: u32,
    /// Seconds from the last sample to rest.
    pub rest_s: Option<f64>,
    /// Rules that were broken.
    pub faults: Vec<String>,
}

/// A scene at a fidelity.
pub fn at(scene: &Scene, at: At) -> Scene {
    Scene { fidelity: at.fidelity, ..*scene }
}

/// A book opened with a scene.
///
/// # Errors
///
/// What is refused.
pub fn open<R: Real>(scene: &Scene) -> Result<Box<Pages<R>>, SpecError> {
    scene.open::<R, G11x8>()
}

/// Plays a gesture and lets the book come to rest.
pub fn play<R: Real>(scene: &Scene, samples: &[Sample], rules: &Rules) -> Seen<R> {
    play_for(scene, samples, rules, |_, _| ())
}

/// The same, with someone who sees every picture.
pub fn play_for<R: Real>(
    scene: &Scene,
    samples: &[Sample],
    rules: &Rules,
    mut watch: impl FnMut(u32, &mut Pages<R>),
) -> Seen<R> {
    let mut book = Box::new(Pages::<R>::EMPTY);
    let opened = book.open(&scene.book, &scene.paper, &scene.world, &scene.view, scene.fidelity);
    let mut seen = Seen::new(book, rules);
    seen.faults.extend(opened.err().map(|e| e.to_string()));
    let last_us = samples.last().map_or(0, |s| s.t_us);
    let drag = (last_us / u64::from(FRAME_US)) as u32 + 1;
    let patience = (60.0 * rules.rest_s.unwrap_or(2.0)) as u32 + 60;
    let mut next = samples.iter().copied().peekable();
    for n in 0..drag + patience {
        let until = seen.book.now_us() + u64::from(FRAME_US);
        while let Some(sample) = next.next_if(|s| s.t_us <= until) {
            if seen.book.input(sample).is_err() {
                break;
            }
        }
        seen.frame(FRAME_US, rules, &scene.fidelity.settings());
        watch(n, &mut seen.book);
        if n > drag && !seen.book.needs_frame() {
            break;
        }
    }
    seen.rest(drag, rules);
    seen
}

impl<R: Real> Seen<R> {
    /// A book that nothing has been seen of yet.
    pub fn new(book: Box<Pages<R>>, rules: &Rules) -> Self {
        let watch = Watch { folded: rules.folded, ..Watch::default() };
        let (way, fastest, busiest) = (0, 0.0, 0);
        Self { book, watch, way, fastest, busiest, rest_s: None, faults: Vec::new() }
    }

    /// Lets one picture pass, and judges it.
    pub fn frame(&mut self, dt_us: u32, rules: &Rules, settings: &Settings) -> StepReport {
        let report = self.book.advance(dt_us);
        self.watch.see(&mut self.book, &report);
        self.busiest = self.busiest.max(report.steps);
        let mut hash = Fnv::default();
        hash.word(self.way);
        hash.word(self.book.state_hash());
        self.way = hash.value();
        if let Some(leaf) = self.book.leaf() {
            self.fastest = self.fastest.max(leaf.fastest().wide() / WIDTH);
        }
        let broken = self.broken(&report, rules, settings);
        if self.faults.len() < 3 {
            self.faults.extend(broken.map(|what| format!("picture {}: {what}", self.watch.frames)));
        }
        report
    }

    fn broken(&self, report: &StepReport, rules: &Rules, settings: &Settings) -> Option<String> {
        let stretch = self.book.stretch().max().wide();
        if stretch > rules.stretch {
            let most = 100.0 * rules.stretch;
            return Some(format!("I3: stretched {:.1} %, at most {most:.0} %", 100.0 * stretch));
        }
        let leaf = self.book.leaf();
        let well = report.status == StepStatus::Converged && !rules.rubber;
        let bent = leaf.filter(|_| well).map_or(0.0, |leaf| defect::<R, G11x8>(leaf));
        if bent > STAR {
            return Some(format!("I2: converged, but a star is off by {bent:.2}"));
        }
        if self.fastest > FASTEST && !rules.rubber {
            return Some(format!("I6: {:.0} widths/s", self.fastest));
        }
        excess(report, settings)
    }

    /// Judges what is left over: Watch's complaint, and rest.
    pub fn rest(&mut self, drag: u32, rules: &Rules) {
        self.faults.extend(self.watch.complaint.take().map(|what| format!("I1, I4: {what}")));
        self.rest_s = self.watch.rest.map(|n| f64::from(n.saturating_sub(drag)) / 60.0);
        if let Some(most) = rules.rest_s {
            match self.rest_s {
                None => self.faults.push(format!("I9: not at rest after {most} s")),
                Some(s) if s > most => self.faults.push(format!("I9: at rest after {s:.2} s")),
                Some(_) => {}
            }
        }
    }

    /// Seconds to rest; endless where it did not come.
    pub fn rested(&self) -> f64 {
        self.rest_s.unwrap_or(f64::INFINITY)
    }
}

/// I8: more work than is allowed.
pub fn excess(report: &StepReport, settings: &Settings) -> Option<String> {
    // Each once, or once and then in four parts.
    let once = report.steps * settings.substeps;
    let substeps = once + 4 * report.parted.min(once);
    let searches = report.newton_steps * (1 + settings.refinements);
    let over = report.steps > 8
        || report.newton_steps > substeps * settings.newton
        || report.passes > substeps * settings.passes
        || report.cuts > searches * settings.trials;
    over.then(|| format!("I8: {report:?}"))
}

/// Largest difference between cosines that are equal in a star of a discrete orthogonal geodesic net.
pub fn defect<R: Real, G: Grid>(leaf: &Leaf<R, G>) -> f64 {
    let place = |i: usize, k: usize| V3(leaf.x.at(i, k).0.map(Real::wide));
    let mut worst = 0f64;
    for (i, k) in (1..G::NX - 1).flat_map(|i| (1..G::NZ - 1).map(move |k| (i, k))) {
        let around = [(i + 1, k), (i, k + 1), (i - 1, k), (i, k - 1)];
        let arms = around.map(|(i2, k2)| {
            let arm = place(i2, k2) - place(i, k);
            arm * (1.0 / arm.norm().max(1e-12))
        });
        let cos = |a: usize, b: usize| arms[a].dot(arms[b]);
        let corners = [cos(0, 1), cos(1, 2), cos(2, 3), cos(3, 0)];
        let off = (0..3).map(|c| (corners[c] - corners[c + 1]).abs());
        worst = off.fold(worst, f64::max);
    }
    worst
}

/// Largest distance between the nodes of two leaves, page widths; endless where only one is there.
pub fn apart<R: Real, S: Real, G: Grid>(a: Option<&Leaf<R, G>>, b: Option<&Leaf<S, G>>) -> f64 {
    let (a, b) = match (a, b) {
        (Some(a), Some(b)) => (a, b),
        (None, None) => return 0.0,
        _ => return f64::INFINITY,
    };
    let nodes = (0..G::NX).flat_map(|i| (0..G::NZ).map(move |k| (i, k)));
    let far = nodes.map(|(i, k)| {
        let (p, q) = (a.x.at(i, k).0.map(Real::wide), b.x.at(i, k).0.map(Real::wide));
        (0..3).map(|c| (p[c] - q[c]) * (p[c] - q[c])).sum::<f64>().sqrt()
    });
    far.fold(0.0, |m: f64, d| if d > m || d.is_nan() { d } else { m }) / WIDTH
}
