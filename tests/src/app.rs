//! An app in miniature: it hands samples over in its own clock, steps, draws when told, and listens.

use dogleaf_core::Reading;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Sample, View};
use dogleaf_core::reading::{Motion, Notice, Tape, Tick};
use dogleaf_core::record::Setup;
use dogleaf_core::scene::BookSpec;

use crate::gesture::{Gesture, Scene};

/// What an app holds on a phone.
pub type Read = Reading<f32, G11x8>;

/// Where the app's clock stands when it opens a book.
pub const START_US: u64 = 7_000_000_000;
/// Time of one picture.
pub const FRAME_US: u64 = 16_667;

/// A book of sixty pages as an app opens it.
pub fn setup() -> Setup {
    let book = BookSpec { pages: 60, open_at: 20, ..BookSpec::default() };
    Setup::fingers(book, 960, 720)
}

/// Opens a book.
pub fn open(setup: &Setup) -> Box<Read> {
    let mut read = Box::new(Read::EMPTY);
    read.open(setup).expect("a book");
    read
}

/// A turn of the right leaf, in the app's clock.
pub fn turn(setup: &Setup, seed: u64) -> Vec<Sample> {
    let scene = Scene { view: setup.view, ..Scene::of(setup.book) };
    let mut samples = Gesture::corner_turn(&scene.eye(), seed);
    samples.iter_mut().for_each(|s| s.t_us += START_US);
    samples
}

/// Every hash after a step.
#[derive(Debug, Default)]
pub struct Hashes(pub Vec<u64>);

impl Tape for Hashes {
    fn input(&mut self, _: &Sample) {}
    fn look(&mut self, _: &View) {}
    fn step(&mut self, hash: impl FnOnce() -> u64) {
        self.0.push(hash());
    }
}

/// What an app saw.
#[derive(Debug, Default)]
pub struct Seen {
    /// Everything it was told.
    pub notices: Vec<Notice>,
    /// Times of the pictures, microseconds since the start.
    pub pictures: Vec<u64>,
    /// Every hash after a step.
    pub hashes: Hashes,
    /// Times it stepped.
    pub frames: u32,
}

impl Seen {
    /// How many turns began, were committed, were cancelled.
    pub fn ends(&self) -> [usize; 3] {
        let count = |f: fn(&Notice) -> bool| self.notices.iter().filter(|n| f(n)).count();
        [
            count(|n| matches!(n, Notice::Lifted { .. })),
            count(|n| matches!(n, Notice::Committed { .. })),
            count(|n| matches!(n, Notice::Cancelled)),
        ]
    }
    /// What a finger felt.
    pub fn ticks(&self) -> Vec<Tick> {
        let tick = |n: &Notice| if let Notice::Tick(t) = n { Some(*t) } else { None };
        self.notices.iter().filter_map(tick).collect()
    }
}

/// Hands samples over as their time comes and steps until nothing is left to do.
pub fn run(read: &mut Read, samples: &[Sample], seen: &mut Seen, from_us: u64) -> u64 {
    let (mut now, mut left) = (from_us, samples.iter().peekable());
    for _ in 0..2000 {
        now += FRAME_US;
        while let Some(s) = left.next_if(|s| s.t_us <= now) {
            read.pointer(*s, &mut seen.hashes).expect("in order");
        }
        if left.peek().is_none() && !read.needs_frame() {
            break;
        }
        seen.frames += 1;
        if read.step(now, &mut seen.hashes).draw {
            seen.pictures.push(now - START_US);
        }
        seen.notices.extend(std::iter::from_fn(|| read.take_notice()));
    }
    now
}

/// As `run`, but stops with the last sample.
pub fn run_to(read: &mut Read, samples: &[Sample], seen: &mut Seen, from_us: u64) -> u64 {
    let mut now = from_us;
    let mut left = samples.iter().peekable();
    while left.peek().is_some() {
        now += FRAME_US;
        while let Some(s) = left.next_if(|s| s.t_us <= now) {
            read.pointer(*s, &mut seen.hashes).expect("in order");
        }
        if read.step(now, &mut seen.hashes).draw {
            seen.pictures.push(now - START_US);
        }
        seen.notices.extend(std::iter::from_fn(|| read.take_notice()));
    }
    now
}

/// Plays samples on a fresh book under a policy.
pub fn played(motion: Motion, samples: &[Sample]) -> (Box<Read>, Seen) {
    let mut read = open(&setup());
    read.set_motion(motion).expect("a policy");
    let mut seen = Seen::default();
    let _ = run(&mut read, samples, &mut seen, START_US);
    (read, seen)
}
