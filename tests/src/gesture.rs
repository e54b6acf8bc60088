//! Hands for tests: where a finger is on the screen, and when. Seeded, so that a failing one can be named.

use dogleaf_core::Book;
use dogleaf_core::grid::Grid;
use dogleaf_core::hand::{Camera, Phase, Sample, View};
use dogleaf_core::real::{Real, V3};
use dogleaf_core::scene::{BookSpec, Direction, Fidelity, PaperSpec, SpecError, WorldSpec};
use dogleaf_core::scene::{Units, Weights};
use dogleaf_core::step::StepReport;

/// Time of one picture at 60 Hz.
pub const FRAME_US: u32 = 16_667;
/// Time between samples of a touch screen at 120 Hz.
pub const TOUCH_US: u64 = 8_333;
/// When the first finger comes down.
const FIRST_US: u64 = 20_000;
/// 1/256 pixels in one.
const FINE: f64 = 256.0;

/// SplitMix64: a number for everything a gesture leaves open.
#[derive(Debug, Clone)]
pub struct Rng(u64);

impl Rng {
    /// A stream of its own for every seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }
    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    /// The next number from `least` to `most`.
    pub fn within(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Everything a book is opened with.
#[derive(Debug, Clone, Copy)]
pub struct Scene {
    /// The book.
    pub book: BookSpec,
    /// Its paper.
    pub paper: PaperSpec,
    /// The world.
    pub world: WorldSpec,
    /// The reader.
    pub view: View,
    /// What accuracy is bought.
    pub fidelity: Fidelity,
}

impl Default for Scene {
    /// The default book on a table, seen on 960 by 720 pixels.
    fn default() -> Self {
        Self::of(BookSpec::default())
    }
}

impl Scene {
    /// A book on a table, its spread filling the picture.
    pub fn of(book: BookSpec) -> Self {
        let view = View::reading(book.width_m, book.height_m, 960, 720);
        let (paper, world) = (PaperSpec::default(), WorldSpec::default());
        Self { book, paper, world, view, fidelity: Fidelity::default() }
    }
    /// The default book with the seed's raw weights, at the gravity they belong to.
    pub fn seed() -> Self {
        let mut scene = Self::default();
        let unit = scene.book.width_m / 12.0;
        scene.paper.weights = Some(Weights::default());
        scene.paper.thickness_mm = 7.5 * unit;
        scene.world.gravity = [0.0, -98.1 * unit, 0.0];
        scene
    }
    /// A book of so many pages, open at one of them.
    pub fn open_at(pages: u32, open_at: u32) -> Self {
        Self::of(BookSpec { pages, open_at, ..BookSpec::default() })
    }
    /// The opened book, on the heap: it is too big for a stack.
    ///
    /// # Errors
    ///
    /// What [`Book::open`] refuses.
    pub fn open<R: Real, G: Grid>(&self) -> Result<Box<Book<R, G>>, SpecError> {
        let mut book = Box::new(Book::<R, G>::EMPTY);
        book.open(&self.book, &self.paper, &self.world, &self.view, self.fidelity)?;
        Ok(book)
    }
    /// Where things on the table are seen.
    pub fn eye(&self) -> Eye {
        let book = &self.book;
        let units = Units::of_leaf(book.width_m, book.height_m, self.paper.areal_mass_gsm);
        let thick = |leaves| units.length(self.paper.thickness_mm * 1e-3) * f64::from(leaves);
        let [read, unread] = [book.read(), book.leaves() - book.read()].map(thick);
        Eye {
            camera: self.view.camera(&units),
            half_height: 0.5 * units.length(book.height_m),
            tops: if book.direction == Direction::Ltr { [read, unread] } else { [unread, read] },
            middle: 0.5 * f64::from(self.view.width_px),
        }
    }
}

/// From a place on the book to a place on the screen.
#[derive(Debug, Clone, Copy)]
pub struct Eye {
    camera: Camera<f64>,
    half_height: f64,
    tops: [f64; 2],
    middle: f64,
}

impl Eye {
    /// Pixels of a place on the pages: `across` from -1 at the left fore-edge to 1 at the right one,
    /// `along` from -1 at the head to 1 at the tail.
    pub fn page(&self, across: f64, along: f64) -> [f64; 2] {
        self.above(across, 0.0, along)
    }
    /// The same so many page widths above the pages.
    pub fn above(&self, across: f64, height: f64, along: f64) -> [f64; 2] {
        let top = self.tops[usize::from(across > 0.0)];
        let p = V3([12.0 * across, top + 12.0 * height, self.half_height * along]);
        self.camera.project(p).unwrap_or([self.middle, 0.0])
    }
    /// The mirror image of a gesture.
    pub fn mirror(&self, samples: &[Sample]) -> Vec<Sample> {
        let width = (2.0 * self.middle * FINE) as i32;
        samples.iter().map(|s| Sample { x: width - s.x, ..*s }).collect()
    }
}

/// A gesture while it is written down: a press, moves, and how it ends.
#[derive(Debug, Clone)]
pub struct Gesture {
    samples: Vec<Sample>,
    at: [f64; 2],
    now_us: u64,
    id: u8,
}

impl Gesture {
    /// Presses at a place, in pixels.
    pub fn press(at: [f64; 2]) -> Self {
        Self::press_stack(at, 1)
    }
    /// Presses on so many leaves at once.
    pub fn press_stack(at: [f64; 2], leaves: u16) -> Self {
        let mut new = Self { samples: Vec::new(), at, now_us: FIRST_US, id: 0 };
        new.put(Phase::Down);
        new.samples.iter_mut().for_each(|s| s.leaves = leaves);
        new
    }
    /// The same by another finger, so much later.
    #[must_use]
    pub fn by(mut self, id: u8, later_us: u64) -> Self {
        self.id = id;
        self.now_us += later_us;
        self.samples.iter_mut().for_each(|s| (s.id, s.t_us) = (id, s.t_us + later_us));
        self
    }
    fn put(&mut self, phase: Phase) {
        let [x, y] = self.at.map(|p| (p * FINE) as i32);
        self.samples.push(Sample { t_us: self.now_us, id: self.id, phase, x, y, leaves: 1 });
    }
    /// Moves for so long, through `place(share of the time)`.
    #[must_use]
    pub fn along(mut self, us: u64, place: impl Fn(f64) -> [f64; 2]) -> Self {
        let count = (us / TOUCH_US).max(1);
        for n in 1..=count {
            self.now_us += us / count;
            self.at = place(n as f64 / count as f64);
            self.put(Phase::Move);
        }
        self
    }
    /// Moves straight to a place.
    #[must_use]
    pub fn to(self, end: [f64; 2], us: u64) -> Self {
        let from = self.at;
        self.along(us, |t| [0, 1].map(|c: usize| from[c] + (end[c] - from[c]) * t))
    }
    /// Stays where it is.
    #[must_use]
    pub fn hold(self, us: u64) -> Self {
        let at = self.at;
        self.to(at, us)
    }
    /// Lets go.
    pub fn up(mut self) -> Vec<Sample> {
        self.put(Phase::Up);
        self.samples
    }
    /// Is taken away by the system.
    pub fn cancel(mut self) -> Vec<Sample> {
        self.put(Phase::Cancel);
        self.samples
    }

    /// A corner carried over the spine to the other fore-edge in one second; everything else by the seed.
    pub fn corner_turn(eye: &Eye, seed: u64) -> Vec<Sample> {
        let mut rng = Rng::new(seed);
        let side = if rng.bits().is_multiple_of(2) { 1.0 } else { -1.0 };
        let along = side * rng.within(0.75, 0.95);
        let drift = rng.within(-2.0, 2.0) / eye.half_height;
        let a = eye.page(rng.within(0.83, 0.96), along);
        let b = eye.page(-rng.within(0.83, 0.96), (along + drift).clamp(-1.0, 1.0));
        let (bow, ease) = (rng.within(-36.0, 84.0), rng.within(0.0, 1.0));
        let place = |t: f64| {
            let e = ease * t * t * (3.0 - 2.0 * t) + (1.0 - ease) * t;
            let lift = bow * 4.0 * t * (1.0 - t);
            [a[0] + (b[0] - a[0]) * e, a[1] + (b[1] - a[1]) * e - lift]
        };
        Self::press(a).along(1_000_000, place).up()
    }
}

/// Plays a gesture for so many pictures, handing over each sample just before it is due; `watch` sees the
/// book after every picture.
pub fn play<R: Real, G: Grid>(
    book: &mut Book<R, G>,
    samples: &[Sample],
    frames: u32,
    watch: &mut impl FnMut(&mut Book<R, G>, &StepReport),
) {
    let start = book.now_us();
    let mut next = samples.iter().map(|s| Sample { t_us: s.t_us + start, ..*s }).peekable();
    for _ in 0..frames {
        let until = book.now_us() + u64::from(FRAME_US);
        while let Some(sample) = next.next_if(|s| s.t_us <= until) {
            if book.input(sample).is_err() {
                break;
            }
        }
        let report = book.advance(FRAME_US);
        watch(book, &report);
    }
}
