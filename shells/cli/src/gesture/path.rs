//! A finger's way over a book, as a camera sees it.

use dogleaf_core::hand::{Camera, Phase, Sample, View};
use dogleaf_core::real::V3;
use dogleaf_core::scene::{BookSpec, Direction, PaperSpec, Units};

/// Time between two samples of a finger, microseconds: 120 a second.
const EVERY_US: u64 = 8_333;
/// Metres as they are: the camera's model units are not needed here.
const METRES: Units = Units { metres: 1.0, kilograms: 1.0 };

/// A book before a camera, in the reader's own directions.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Desk {
    camera: Camera<f64>,
    width_m: f64,
    height_m: f64,
    /// Height of the block a leaf is taken from, and of the one it goes to.
    tops_m: [f64; 2],
    /// 1 where leaves are taken from the right, else -1.
    sign: f64,
}

impl Desk {
    pub(crate) fn new(view: &View, book: &BookSpec, paper: &PaperSpec) -> Self {
        let (all, read) = (f64::from(book.leaves()), f64::from(book.read()));
        let thickness = paper.thickness_mm * 1e-3;
        Self {
            camera: view.camera(&METRES),
            width_m: book.width_m,
            height_m: book.height_m,
            tops_m: [(all - read) * thickness, read * thickness],
            sign: if book.direction == Direction::Ltr { 1.0 } else { -1.0 },
        }
    }

    /// Where a place is seen, in 1/256 pixel: `out` in widths from the spine towards where the leaf is taken
    /// from, `down` in half heights towards the tail, `lift` in widths above the paper.
    pub(crate) fn seen(&self, [out, down, lift]: [f64; 3]) -> [i32; 2] {
        let share = 0.5 * (1.0 + out.clamp(-1.0, 1.0));
        let top = self.tops_m[0] * share + self.tops_m[1] * (1.0 - share);
        let x = self.sign * out * self.width_m;
        let place = V3([x, top + lift * self.width_m, 0.5 * down * self.height_m]);
        let pixel = self.camera.project(place).unwrap_or(self.camera.centre);
        pixel.map(|p| (p * 256.0).round() as i32)
    }
}

/// A press, moves along a way, a release.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stroke {
    pub(crate) start_us: u64,
    pub(crate) time_us: u64,
    /// Leaves to take up.
    pub(crate) leaves: u16,
    /// How it ends.
    pub(crate) end: Phase,
}

impl Stroke {
    /// The samples of a finger that is at `way(t)`, `t` from 0 to 1.
    pub(crate) fn along(self, desk: &Desk, way: impl Fn(f64) -> [f64; 3]) -> Vec<Sample> {
        let count = (self.time_us / EVERY_US).max(2);
        let sample = |n: u64| {
            let t = n as f64 / count as f64;
            let [x, y] = desk.seen(way(t));
            let phase = if n == 0 {
                Phase::Down
            } else if n == count {
                self.end
            } else {
                Phase::Move
            };
            let leaves = if n == 0 { self.leaves } else { 0 };
            Sample { t_us: self.start_us + n * self.time_us / count, id: 0, phase, x, y, leaves }
        };
        (0..=count).map(sample).collect()
    }
}

/// From 0 to 1, starting and stopping gently.
pub(crate) fn ease(t: f64) -> f64 {
    t * t * t * (10.0 + t * (6.0 * t - 15.0))
}

/// From one place to another, lifted on the way as a held leaf lifts the finger.
pub(crate) fn over(from: [f64; 2], to: [f64; 2], lift: f64, share: f64) -> [f64; 3] {
    let at = |c: usize| from[c] + (to[c] - from[c]) * share;
    let out = at(0);
    [out, at(1), lift * (1.0 - out * out).max(0.0)]
}
