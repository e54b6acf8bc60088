//! The book: one [`Book::advance`] that reads like Section 3 of the seed.
//!
//! The binding, the two blocks and the boards always are; the leaf exists from a press until it has
//! settled on a block. Nothing here allocates, and nothing big is ever returned: the caller places a
//! [`Book::EMPTY`] and opens it.

mod beside;
mod binding;
#[cfg(feature = "faults")]
mod fault;
mod lone;
mod open;
#[cfg(feature = "seed")]
mod parts;
mod settle;
mod step;
mod touch;

use beside::Beside;
pub use binding::Binding;
#[cfg(feature = "faults")]
pub use fault::Fault;
pub use lone::LoneLeaf;
pub use open::InputError;
#[cfg(feature = "seed")]
pub(crate) use parts::Parts;

use crate::event::{Event, Events};
use crate::grid::Grid;
use crate::hand::{Camera, Guide, Sample};
use crate::real::{Real, V3};
use crate::scene::{BookSpec, Handling, PaperSpec, Settings, Units};
use crate::state::strip::{BLOCK, BOARD, Fibre, Strip};
use crate::state::{Field, Fnv, Grab, Leaf, Sheet, Stretch};
use crate::step::{Solver, StepReport};

/// Samples a book keeps until their time has come.
pub const SAMPLES: usize = 64;

/// A book with, at times, one leaf (or a stack held as one) in the air.
#[derive(Debug, Clone)]
pub struct Book<R: Real, G: Grid> {
    spec: BookSpec,
    paper: PaperSpec,
    units: Units,
    settings: Settings,
    damping_per_s: f64,
    step_us: u32,
    /// Time step of one substep, seconds.
    h: R,
    /// `e^(-c h)`.
    keep: R,
    /// The same with the air under a landing leaf.
    keep_squeezed: R,
    gravity: V3<R>,
    seed: u64,
    camera: Camera<R>,
    binding: Binding<R>,
    /// Left and right block, and boards, outward coordinates.
    blocks: [Strip<R, BLOCK>; 2],
    boards: [Strip<R, BOARD>; 2],
    fibre: Fibre<R>,
    board: Fibre<R>,
    sheet: Sheet<R, G>,
    leaf: Leaf<R, G>,
    active: bool,
    handling: Handling,
    guide: Option<Guide<R>>,
    /// A second finger beside the one that holds the leaf.
    beside: Option<Beside>,
    /// A press that has not said yet which leaf it means.
    undecided: Option<Sample>,
    grab: Option<Grab<R>>,
    samples: heapless::Deque<Sample, SAMPLES>,
    events: Events,
    now_us: u64,
    owed_us: u64,
    still_us: u64,
    /// Time since anything was last held, microseconds.
    idle_us: u64,
    /// Strain of the leaf's most stretched edge.
    strain: R,
    /// How much the most compressed one is.
    squeeze: R,
    /// Steps taken back since the last that was not.
    stuck: u32,
    /// The last step had to be taken back: the next is taken without the hand's pull.
    eased: bool,
    /// Nudges since the leaf was last seen off its edge.
    nudges: u32,
    /// Extra weight, in weights of the leaf, that lays a landed leaf flat.
    press: R,
    /// The most of it; nothing with the seed's raw weights, whose leaf merges as it lies.
    most_press: R,
    /// The free leaf has come down on a block.
    landed: bool,
    asleep: bool,
    solver: Solver<R, G>,
    before: Field<R, G>,
    /// The leaf before the step, should it have to be taken again.
    kept: Leaf<R, G>,
    scratch: Field<R, G>,
}

impl<R: Real, G: Grid> Book<R, G> {
    /// Whether anything still moves: when false, nothing has to be stepped or drawn until the next input.
    pub fn needs_frame(&self) -> bool {
        !self.asleep || !self.samples.is_empty()
    }
    /// Time inside the book, microseconds.
    pub fn now_us(&self) -> u64 {
        self.now_us
    }
    /// What was asked for; `open_at` follows the reading.
    pub fn spec(&self) -> &BookSpec {
        &self.spec
    }
    /// The dials of its step.
    pub fn settings(&self) -> Settings {
        self.settings
    }
    /// Scales between the model and SI.
    pub fn units(&self) -> &Units {
        &self.units
    }
    /// Where leaves are bound and how many lie where.
    pub fn binding(&self) -> &Binding<R> {
        &self.binding
    }
    /// The leaf in the air, if there is one. Model units, book frame.
    pub fn leaf(&self) -> Option<&Leaf<R, G>> {
        self.active.then_some(&self.leaf)
    }
    /// What the hand holds, and where it wants it.
    pub fn held(&self) -> Option<Grab<R>> {
        self.grab
    }
    /// Gravity, metres per second squared.
    pub fn gravity_m(&self) -> [f64; 3] {
        self.gravity.0.map(|g| self.units.to_metres(g.wide()))
    }
    /// Where the reader looks from. Model units.
    pub fn camera(&self) -> &Camera<R> {
        &self.camera
    }
    /// The paper a finger holds, and whether it is held where the finger asks: not beyond the sheet's reach.
    pub fn touched(&self) -> Option<(V3<R>, bool)> {
        let guide = self.guide.as_ref().filter(|g| g.dragging())?;
        Some((guide.place().on(&self.leaf), !guide.beyond()))
    }
    /// What the leaf is made of.
    pub fn sheet(&self) -> &Sheet<R, G> {
        &self.sheet
    }
    /// Left and right page block. Model units, outward coordinates.
    pub fn blocks(&self) -> &[Strip<R, BLOCK>; 2] {
        &self.blocks
    }
    /// Left and right board; `None` for a soft cover. Model units, outward coordinates.
    pub fn boards(&self) -> Option<&[Strip<R, BOARD>; 2]> {
        self.has_boards().then_some(&self.boards)
    }
    /// The next event nobody has read.
    pub fn take_event(&mut self) -> Option<Event> {
        self.events.take()
    }
    /// How far the leaf's edges are from their rest length; nothing without a leaf.
    pub fn stretch(&self) -> Stretch<R> {
        self.leaf().map_or(Stretch::default(), |leaf| leaf.stretch(self.sheet.spacing))
    }
    /// Kinetic energy and height energy of the leaf, model units.
    pub fn energy(&self) -> [R; 2] {
        let mut sums = [R::ZERO; 2];
        if self.active {
            for (i, k) in Field::<R, G>::nodes() {
                let m = self.sheet.mass.at(i, k);
                sums[0] += m * R::of(0.5) * self.leaf.v.at(i, k).norm_sq();
                sums[1] -= m * self.gravity.dot(self.leaf.x.at(i, k));
            }
        }
        sums
    }
    /// The hash of everything that decides the future, except input not yet due.
    ///
    /// # Determinism
    ///
    /// Equal on every target for equal inputs. Time is left out, so it is constant while asleep.
    pub fn state_hash(&self) -> u64 {
        let mut hash = Fnv::default();
        let flags = u64::from(self.active)
            | u64::from(self.asleep) << 1
            | u64::from(self.binding.from_right) << 2
            | u64::from(self.landed) << 3;
        hash.word(flags | u64::from(self.nudges) << 8);
        hash.word(u64::from(self.binding.leaves[0]) | u64::from(self.binding.held) << 32);
        hash.word(self.still_us);
        hash.word(self.idle_us << 1 | u64::from(self.eased));
        hash.word(u64::from(self.stuck));
        hash.real(self.press);
        if let Some(guide) = &self.guide {
            guide.digest(&mut hash);
        }
        if let Some(beside) = &self.beside {
            hash.word(1 + beside.digest());
        }
        if let Some(press) = &self.undecided {
            hash.word(1 + (u64::from(press.id) << 32));
            hash.word(press.x as u64);
            hash.word(press.y as u64);
        }
        for strip in &self.blocks {
            for v in strip.x.iter().chain(&strip.v) {
                v.0.iter().for_each(|&c| hash.real(c));
            }
        }
        for strip in &self.boards {
            for v in strip.x.iter().chain(&strip.v) {
                v.0.iter().for_each(|&c| hash.real(c));
            }
        }
        if self.active {
            for (i, k) in Field::<R, G>::nodes() {
                let node = [self.leaf.x.at(i, k), self.leaf.v.at(i, k), self.leaf.pushed.at(i, k)];
                node.iter().flat_map(|v| v.0).for_each(|c| hash.real(c));
                hash.real(self.leaf.holding.at(i, k));
            }
        }
        hash.value()
    }

    fn has_boards(&self) -> bool {
        self.spec.cover == crate::scene::Cover::Hard
    }
    fn note(&mut self, event: Event) {
        self.events.push(event);
    }
    /// Wakes the book: something may move.
    fn wake(&mut self) {
        self.asleep = false;
        self.still_us = 0;
        self.idle_us = 0;
        self.eased = false;
        self.nudges = 0;
        self.press = R::ZERO;
        self.landed = false;
        self.stuck = 0;
    }
}

/// A report for a call that did nothing.
fn nothing() -> StepReport {
    StepReport::default()
}
