//! A book being read: what an e-reader's app holds. It owns a [`Book`] and knows nothing of a platform.
//!
//! The app feeds pointer samples in its own clock, asks [`Reading::needs_frame`], calls [`Reading::step`], uploads one
//! mesh when [`Frame::draw`] says so, and drains [`Notice`]s. Gestures and navigation stay the app's: it hands over
//! the samples it wants a page to feel, and is told exactly once a turn what came of it.
//!
//! ```text
//! pointer ─► clock ─► Book (physics) ─► policy: what of it is seen ─► mesh, faces
//!                        └► events ─► notices: pages, announcements, ticks
//! ```

mod auto;
mod clock;
mod faces;
mod frame;
mod keep;
mod notice;
mod policy;
mod step;
mod trail;

pub use faces::{Face, faces};
pub use frame::{FACES, Piece, Shape};
pub use keep::SNAPSHOT_BYTES;
pub use notice::{NOTICES, Notice, Tick};
pub use policy::{EINK_US, Motion, MotionPolicy};
pub use step::{Frame, Tape};

use crate::book::{Book, InputError};
use crate::grid::Grid;
use crate::hand::{Phase, Sample, View};
use crate::real::Real;
use crate::record::{RecordError, Setup};
use crate::scene::SpecError;
use auto::Auto;
use clock::Clock;
use notice::Notices;
use trail::Trail;

/// Why a call was refused. Nothing was changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Refusal {
    /// A leaf is in the air.
    Busy,
    /// There is no page that way.
    NoSuchPage,
    /// The app paused the book.
    Paused,
}

impl core::fmt::Display for Refusal {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Busy => "a leaf is in the air",
            Self::NoSuchPage => "there is no page that way",
            Self::Paused => "the book is paused",
        })
    }
}

impl core::error::Error for Refusal {}

/// A book being read. Some 90 kB at 11x8 in `f32`: for the caller to place.
#[derive(Debug, Clone)]
pub struct Reading<R: Real, G: Grid> {
    book: Book<R, G>,
    setup: Setup,
    motion: Motion,
    clock: Clock,
    notices: Notices,
    auto: Option<Auto>,
    trail: Trail<R, G>,
    /// Fingers that are down, by the bits of their numbers modulo 64.
    down: u64,
    /// Something to be drawn changed since the app last drew.
    dirty: bool,
    /// The mesh last asked to be drawn was of a leaf in the air.
    aloft: bool,
    /// The leaf passed the vertical since it was taken up.
    over: bool,
    /// Host time since nobody holds the leaf any more, microseconds.
    free_us: u64,
    /// Host time since the last picture, microseconds.
    shown_us: u64,
    paused: bool,
}

impl<R: Real, G: Grid> Reading<R, G> {
    /// Nothing open yet: for the caller to place.
    pub const EMPTY: Self = Self {
        book: Book::EMPTY,
        setup: Setup::NONE,
        motion: Motion::FULL,
        clock: Clock::START,
        notices: Notices::EMPTY,
        auto: None,
        trail: Trail::EMPTY,
        down: 0,
        dirty: false,
        aloft: false,
        over: false,
        free_us: 0,
        shown_us: 0,
        paused: false,
    };

    /// Opens a book in place, at rest. What it looked like is to be drawn.
    ///
    /// # Errors
    ///
    /// As [`Setup::open`]; then nothing was changed.
    pub fn open(&mut self, setup: &Setup) -> Result<(), RecordError> {
        setup.open(&mut self.book)?;
        self.setup = *setup;
        self.begin();
        Ok(())
    }

    fn begin(&mut self) {
        self.clock = Clock::START;
        self.notices = Notices::EMPTY;
        self.auto = None;
        self.trail.clear();
        self.down = 0;
        self.dirty = true;
        self.aloft = false;
        self.over = false;
        self.free_us = 0;
        self.shown_us = u64::from(u32::MAX);
        self.paused = false;
    }

    /// What moves, and for how long at most.
    pub fn motion(&self) -> Motion {
        self.motion
    }

    /// Changes it, also in the middle of a turn.
    ///
    /// # Errors
    ///
    /// A cap that no turn keeps.
    pub fn set_motion(&mut self, motion: Motion) -> Result<(), SpecError> {
        motion.check()?;
        self.motion = motion;
        self.dirty = true;
        Ok(())
    }

    /// The book itself, to look at.
    pub fn book(&self) -> &Book<R, G> {
        &self.book
    }

    /// What it was opened with; `open_at` follows the reading.
    pub fn setup(&self) -> Setup {
        let mut setup = self.setup;
        setup.book.open_at = self.page();
        setup
    }

    /// Page the book is open at.
    pub fn page(&self) -> u32 {
        self.book.spec().open_at
    }

    /// Pages of the book.
    pub fn pages(&self) -> u32 {
        self.book.spec().pages
    }

    /// Share of the book that is read, 0 to 1: what the two fore-edges show.
    pub fn progress(&self) -> f64 {
        f64::from(self.book.spec().read()) / f64::from(self.book.spec().leaves().max(1))
    }

    /// The next notice nobody has read.
    pub fn take_notice(&mut self) -> Option<Notice> {
        self.notices.take()
    }

    /// Notices lost because nobody read them.
    pub fn notices_dropped(&self) -> u32 {
        self.notices.dropped()
    }

    /// Whether the app has to call [`Reading::step`] again. False while everything is at rest or paused.
    pub fn needs_frame(&self) -> bool {
        let moving = self.book.needs_frame() || self.auto.is_some() || !self.trail.still();
        self.dirty || (moving && !self.paused)
    }

    /// Takes a pointer sample; `t_us` is in the app's own clock, the one [`Reading::step`] is called with.
    ///
    /// Fingers are told apart by `id` modulo 64.
    ///
    /// # Errors
    ///
    /// [`InputError`]; the book is unchanged. A paused book takes none and says nothing.
    pub fn pointer(&mut self, sample: Sample, tape: &mut impl Tape) -> Result<(), InputError> {
        if self.paused {
            return Ok(());
        }
        self.stop_auto(tape);
        let id = sample.id & 63;
        let bit = 1_u64 << id;
        match sample.phase {
            Phase::Down => self.down |= bit,
            Phase::Up | Phase::Cancel => self.down &= !bit,
            Phase::Move => {}
        }
        let t_us = self.clock.of_sample(sample.t_us, &self.book);
        self.feed(Sample { t_us, id, ..sample }, tape)
    }

    /// Hands a sample in the book's own time to the book and the tape.
    fn feed(&mut self, sample: Sample, tape: &mut impl Tape) -> Result<(), InputError> {
        tape.input(&sample);
        self.book.input(sample)
    }

    /// Looks from elsewhere: after a resize, say. Everything is to be drawn again.
    ///
    /// # Errors
    ///
    /// As [`Book::look`].
    pub fn look(&mut self, view: &View, tape: &mut impl Tape) -> Result<(), SpecError> {
        self.book.look(view)?;
        self.setup.view = *view;
        self.dirty = true;
        tape.look(view);
        Ok(())
    }

    /// The app goes into the background: fingers are taken away, the leaf comes to rest, nothing moves until
    /// [`Reading::resume`].
    pub fn pause(&mut self, tape: &mut impl Tape) {
        self.lift_fingers(tape);
        self.finish(tape);
        self.paused = true;
    }

    /// The app is back. Time that passed meanwhile does not count.
    pub fn resume(&mut self) {
        self.paused = false;
        self.clock.forget();
        self.dirty = true;
    }

    /// Whether the app paused the book.
    pub fn paused(&self) -> bool {
        self.paused
    }

    /// The picture the app has is lost (a GL context, say): everything is to be drawn again.
    pub fn redraw(&mut self) {
        self.dirty = true;
    }
}
