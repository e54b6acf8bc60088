//! The ribbon bookmark: hangs from the head of the spine, lies in the gutter or between leaves, drapes over tail or
//! fore-edge.
//!
//! It is moved by the book and does not move it: a sixth of a gram beside leaves of two. A step looks at the book
//! as it is, then takes one step of the ribbon against it; asleep with the book it costs a comparison.
//!
//! | file | question |
//! |---|---|
//! | `curve` | how far is a point of a plane from a line of edges |
//! | `solid` | blocks and boards as prisms |
//! | `curtain` | the leaf in the air |
//! | `ground` | what a bookmark lies on, and between which leaves |
//! | `hold` | what keeps it where it lies |
//! | `root` | where it comes out of the spine |
//! | `finger` | what a reader pulls at |

pub mod curve;
pub mod solid;
pub mod curtain;
pub mod ground;
mod finger;
mod hold;
mod root;

pub use ground::{Ground, Layer};

use super::contact::{Cushion, Near};
use super::frame::Frame;
use super::joint::Crease;
use super::resample::Pair;
use super::{Report, Ribbon, RibbonSpec, Settings};
use crate::book::Book;
use crate::grid::Grid;
use crate::hand::view::Ray;
use crate::hand::{Phase, Sample};
use crate::real::{Real, V3};
use crate::scene::SpecError;
use crate::state::Fnv;
use finger::Finger;
use hold::{Hold, Touching};

/// Segments of a bookmark.
pub const SEGMENTS: usize = 48;
/// Pushes of the ground on it.
const PUSHES: usize = 512;
/// How near the paper it lies, metres, and how hard that is, newton per metre.
const CUSHION: Cushion = Cushion { reach_m: 4e-4, stiffness: 0.5 };
/// What the eye can tell of a ribbon that narrow. The barrier keeps its rulings well away from their bounds: in single
/// precision those that are pushed hard against one another would jam.
const STEP: Settings =
    Settings { iterations: 12, tolerance: 3e-3, trials: 8, barrier: 0.1, ..Settings::STEP };
/// What a slope of its rulings costs: it is too narrow to show one, and without a cost a flat ribbon's are left open.
const SLOPES: f64 = 0.05;
/// So far from head and tail a finger is over the pages, metres.
const OVER: f64 = 0.02;
/// Friction at most.
const MOST_FRICTION: f64 = 10.0;
/// Rate at which its root follows the leaves, per second.
const FOLLOWS: f64 = 12.0;
/// Slower than this it lies still, metres per second, after so many microseconds.
const STILL: f64 = 4e-3;
const STILL_US: u64 = 250_000;
/// A bookmark that was laid anew moves at most this long, microseconds.
const LAYING_US: u64 = 4_000_000;

/// A ribbon sewn to a book.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BookmarkSpec {
    /// Length from the head of the spine, metres; nothing for a quarter more than the leaves are high.
    pub length_m: f64,
    /// Width, metres.
    pub width_m: f64,
    /// Flexural rigidity, newton metres: satin.
    pub rigidity_nm: f64,
    /// Grams per square metre.
    pub areal_mass_gsm: f64,
    /// Coefficient of friction on a page at rest.
    pub friction: f64,
    /// Leaves on its left.
    pub place: u32,
}

impl Default for BookmarkSpec {
    fn default() -> Self {
        Self {
            length_m: 0.0,
            width_m: 6e-3,
            rigidity_nm: 4e-7,
            areal_mass_gsm: 110.0,
            friction: 0.3,
            place: 0,
        }
    }
}

impl BookmarkSpec {
    fn ribbon(&self, height_m: f64) -> RibbonSpec {
        let length_m = if self.length_m == 0.0 { 1.25 * height_m } else { self.length_m };
        RibbonSpec {
            length_m,
            width_m: self.width_m,
            segments: SEGMENTS,
            rigidity_nm: self.rigidity_nm,
            areal_mass_gsm: self.areal_mass_gsm,
            regularisation: SLOPES,
            damping_per_s: 5.0,
            perturbation: 1e-4,
            ..RibbonSpec::default()
        }
    }
}

/// A bookmark, placed by the caller: some 84 kB in `f32`.
#[derive(Debug, Clone)]
pub struct Bookmark<R: Real, G: Grid> {
    ribbon: Ribbon<R, SEGMENTS>,
    near: Near<R, Ground<R, G>, SEGMENTS, 1, PUSHES>,
    hold: Hold<R, SEGMENTS>,
    root: Frame<R>,
    friction: f64,
    place: u32,
    finger: Option<Finger<R>>,
    still_us: u64,
    awake_us: u64,
    asleep: bool,
    /// Vertices between leaves at the last step.
    pressed: u32,
}

impl<R: Real, G: Grid> Bookmark<R, G> {
    /// None: for the caller to place.
    pub const EMPTY: Self = Self {
        ribbon: Ribbon::EMPTY,
        near: Near::over(Ground::NONE, CUSHION),
        hold: Hold::NONE,
        root: Frame::WORLD,
        friction: 0.0,
        place: 0,
        finger: None,
        still_us: 0,
        awake_us: 0,
        asleep: true,
        pressed: 0,
    };

    /// Sews it to a book, and lays it straight over its place, from where it comes to lie.
    ///
    /// # Errors
    ///
    /// The first bad field; then nothing was changed.
    pub fn open(&mut self, spec: &BookmarkSpec, book: &Book<R, G>) -> Result<(), SpecError> {
        let ribbon = spec.ribbon(book.spec().height_m);
        if spec.place > book.binding().all() {
            return Err(SpecError::OutOfRange("bookmark.place"));
        }
        if !spec.friction.is_finite() {
            return Err(SpecError::NotFinite("bookmark.friction"));
        }
        if !(0.0..=MOST_FRICTION).contains(&spec.friction) {
            return Err(SpecError::OutOfRange("bookmark.friction"));
        }
        self.ribbon.open(&ribbon, [0.0; 3])?;
        (self.near.itself, self.ribbon.settings) = (false, STEP);
        self.friction = spec.friction;
        self.put(spec.place, book);
        Ok(())
    }

    /// Puts it to another place: `leaves` on its left. It falls there from just above.
    pub fn put(&mut self, leaves: u32, book: &Book<R, G>) {
        self.finger = None;
        self.lay(leaves, book);
    }

    fn lay(&mut self, leaves: u32, book: &Book<R, G>) {
        self.place = leaves.min(book.binding().all());
        self.hold.forget();
        self.ribbon.gravity = book.gravity_m();
        self.near.surface.look(book, self.place);
        self.root = self.target(book);
        self.ribbon.lay(&self.root, |j| Crease { psi: R::of(bend(j)), c: R::ZERO });
        self.wake();
    }

    fn target(&self, book: &Book<R, G>) -> Frame<R> {
        let width = R::of(self.ribbon.spec().width_m);
        root::root(book, self.place, self.near.surface.layer, width)
    }

    fn wake(&mut self) {
        (self.asleep, self.still_us, self.awake_us) = (false, 0, 0);
    }

    /// Whether it moves: when false, nothing has to be stepped or drawn for it until the book moves or a finger comes.
    pub fn needs_frame(&self) -> bool {
        !self.asleep
    }

    /// Lets time pass beside a book that has already moved on. A book that sleeps beside a bookmark that sleeps costs
    /// nothing.
    ///
    /// # Cost
    ///
    /// One step of a ribbon of [`SEGMENTS`] segments; at each trial the distances of a vertex to what it could have
    /// come near to since the step began.
    pub fn follow(&mut self, book: &Book<R, G>, dt_us: u32) -> Report<R> {
        if book.needs_frame() {
            (self.asleep, self.awake_us) = (false, 0);
        }
        if self.asleep || dt_us == 0 {
            return Report::NONE;
        }
        let h = f64::from(dt_us) * 1e-6;
        self.near.surface.look(book, self.place);
        let arrived = self.lead_root(book, h);
        self.ribbon.ask.springs.clear();
        if let Some(finger) = &self.finger {
            finger.pull(&mut self.ribbon.ask);
        }
        self.near.begin(&self.ribbon, h);
        self.near.surface.sight(self.ribbon.pairs());
        let spec = self.ribbon.spec();
        let area = 0.5 * spec.width_m * spec.length_m / SEGMENTS as f64;
        let inertia = R::of(spec.areal_mass_gsm * 1e-3 * area / (h * h));
        let (reach, friction) = (R::of(CUSHION.reach_m), R::of(self.friction));
        let touching = Touching { inertia, reach, friction };
        self.pressed = self.hold.find(&self.near.surface, self.ribbon.pairs(), &touching);
        let report = self.ribbon.step_touching(h, &self.hold, &mut self.near);
        self.doze(book, arrived, dt_us);
        report
    }

    /// The root follows the leaves it is between. Answers whether it has arrived.
    fn lead_root(&mut self, book: &Book<R, G>, h: f64) -> bool {
        let target = self.target(book);
        let way = target.p - self.root.p;
        let share = R::of(FOLLOWS * h).smaller(R::one());
        self.root.p = self.root.p + way * share;
        self.ribbon.carry(&self.root);
        way.norm_sq() < R::of(1e-8)
    }

    fn doze(&mut self, book: &Book<R, G>, arrived: bool, dt_us: u32) {
        let limit = R::of(STILL * STILL);
        let still = arrived
            && self.finger.is_none()
            && !book.needs_frame()
            && self.ribbon.velocities_now().flatten().all(|v| v.norm_sq() < limit);
        self.still_us = if still { self.still_us + u64::from(dt_us) } else { 0 };
        self.awake_us += u64::from(dt_us);
        let tired = self.awake_us > LAYING_US && self.finger.is_none() && !book.needs_frame();
        if self.still_us >= STILL_US || tired {
            self.ribbon.launch(|_| V3([R::ZERO; 3]));
            self.asleep = true;
        }
    }

    /// What a pointer does: answers whether it is the bookmark's. A press that is not goes to the book.
    pub fn touch(&mut self, book: &Book<R, G>, sample: &Sample) -> bool {
        let metres = R::of(book.units().metres);
        let ray = book.camera().ray(sample.x, sample.y);
        let ray = Ray { from: ray.from * metres, along: ray.along };
        if let Some(finger) = self.finger.as_mut() {
            if finger.id != sample.id {
                return false;
            }
            match sample.phase {
                Phase::Up | Phase::Cancel => self.finger = None,
                Phase::Down | Phase::Move => finger.follow(&ray),
            }
            self.wake();
            self.draw_out(book);
            return true;
        }
        if sample.phase != Phase::Down {
            return false;
        }
        self.take(book, sample.id, &ray)
    }

    /// A finger that draws the end of a bookmark from between leaves over the pages that lie open marks those: it comes
    /// out at once, from the gutter, for it cannot be drawn around the edge of every leaf above it.
    fn draw_out(&mut self, book: &Book<R, G>) {
        let [left, _] = book.binding().leaves;
        let within = |f: &Finger<R>| {
            let half = 0.5 * book.spec().height_m - OVER;
            f.to.0[2].magnitude() < R::of(half)
                && f.to.0[0].magnitude() < R::of(book.spec().width_m)
        };
        let shut = matches!(Layer::of(book, self.place), Layer::Block(_));
        if shut && !book.needs_frame() && self.finger.as_ref().is_some_and(within) {
            self.lay(left, book);
        }
    }

    fn take(&mut self, book: &Book<R, G>, id: u8, ray: &Ray<R>) -> bool {
        self.near.surface.look(book, self.place);
        let ground = &self.near.surface;
        let hidden = finger::hidden(ground.layer);
        let covered = |p: V3<R>| hidden && ground.blocks.iter().any(|b| b.within(p) > R::ZERO);
        let towards = -book.camera().forward;
        self.finger = Finger::take(id, ray, towards, self.ribbon.pairs(), covered);
        if self.finger.is_some() {
            self.wake();
        }
        self.finger.is_some()
    }

    /// Leaves on its left.
    pub fn place(&self) -> u32 {
        self.place
    }
    /// Between which leaves it is, as the book was when it last looked.
    pub fn layer(&self) -> Layer {
        self.near.surface.layer
    }
    /// Vertices between leaves, where nobody sees them, at the last step.
    pub fn pressed(&self) -> u32 {
        self.pressed
    }
    /// Its vertex pairs from the spine on, metres, book frame.
    pub fn pairs(&self) -> impl Iterator<Item = Pair<R>> {
        self.ribbon.pairs()
    }
    /// Whether a pair lies between leaves, where nobody sees it.
    pub fn hidden(&self, crease: usize) -> bool {
        self.hold.pressed(crease)
    }
    /// The ribbon itself.
    pub fn ribbon(&self) -> &Ribbon<R, SEGMENTS> {
        &self.ribbon
    }
    /// What it last lay on.
    pub fn ground(&self) -> &Ground<R, G> {
        &self.near.surface
    }
    /// The hash of everything that decides its future beside the book's.
    pub fn state_hash(&self) -> u64 {
        let mut hash = Fnv::default();
        hash.word(self.ribbon.state_hash());
        hash.word(u64::from(self.place) | u64::from(self.asleep) << 32);
        hash.word(self.still_us);
        self.root.p.0.iter().for_each(|&x| hash.real(x));
        self.hold.anchors().flat_map(|a| a.0).for_each(|x| hash.real(x));
        hash.value()
    }
}

/// The shape it falls from: up out of the spine, over the head of the leaves, along them.
fn bend(crease: usize) -> f64 {
    if (1..=3).contains(&crease) { -0.309 } else { 0.0 }
}
