//! Opening a book: from what is asked to a book at rest.

use super::{Binding, Book, nothing};
use crate::event::Events;
use crate::grid::Grid;
use crate::hand::{Camera, Phase, Sample, View};
use crate::real::{Real, V3};
use crate::scene::units::WIDTH;
use crate::scene::{
    BookSpec, Direction, Fidelity, Handling, PaperSpec, Settings, SpecError, Units, WorldSpec,
};
use crate::state::strip::{BLOCK, Fibre, Strip};
use crate::state::{Field, Leaf, Sheet};
use crate::step::Solver;
use core::fmt;

/// Steps a new book is given to come to rest before anyone sees it.
const SETTLING: u32 = 600;
/// Steps it takes at least, and the speed below which it has come to rest, model units/s.
const LEAST_SETTLING: u32 = 10;
const SETTLED: f64 = 1e-3;
/// Rate at which the air between a leaf and the block it lands on takes speed, 1/s.
const SQUEEZE: f64 = 12.0;
/// Most extra weight that lays a landed leaf flat, in its own weights.
const PRESS: f64 = 24.0;
/// Furthest a sample may be ahead, microseconds.
const AHEAD_US: u64 = 60_000_000;
/// How far a board stands out beyond the leaves, model units.
const SQUARE: f64 = 0.3;
/// Mass of a board, in leaves.
const BOARD_MASS: f64 = 20.0;
/// The model's gravity at which the seed's weights were found to give the seed's figures.
pub(crate) const SEED_GRAVITY: f64 = 98.1;
/// Glue of one leaf in physical units, as a share of the seed's block.
const GLUE: f64 = 0.05;

/// Why an input was refused. The book is unchanged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InputError {
    /// Too many samples wait for their time.
    Full,
    /// The sample is older than one already taken.
    OutOfOrder,
    /// The sample is more than a minute ahead of the book's time: a clock is wrong.
    TooEarly,
}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Full => "too many pointer samples wait for their time",
            Self::OutOfOrder => "the pointer sample is older than one already taken",
            Self::TooEarly => "the pointer sample is more than a minute ahead of the book's time",
        })
    }
}

impl core::error::Error for InputError {}

impl<R: Real, G: Grid> Book<R, G> {
    /// A book that was never opened: for the caller to place. It sleeps.
    pub const EMPTY: Self = Self {
        spec: BookSpec::ONE_LEAF,
        paper: PaperSpec::OFFICE,
        units: Units { metres: 1.0, kilograms: 1.0 },
        settings: Settings::STANDARD,
        damping_per_s: 0.0,
        step_us: 16_667,
        h: R::ZERO,
        keep: R::ZERO,
        keep_squeezed: R::ZERO,
        gravity: V3([R::ZERO; 3]),
        seed: 0,
        camera: Camera {
            eye: V3([R::ZERO; 3]),
            right: V3([R::ZERO; 3]),
            up: V3([R::ZERO; 3]),
            forward: V3([R::ZERO; 3]),
            focal: R::ZERO,
            centre: [R::ZERO; 2],
        },
        binding: Binding::ZERO,
        blocks: [Strip::ZERO; 2],
        boards: [Strip::ZERO; 2],
        fibre: Fibre::ZERO,
        board: Fibre::ZERO,
        sheet: Sheet::ZERO,
        leaf: Leaf::ZERO,
        active: false,
        handling: Handling::SPRING,
        guide: None,
        beside: None,
        undecided: None,
        grab: None,
        samples: heapless::Deque::new(),
        events: Events::EMPTY,
        now_us: 0,
        owed_us: 0,
        still_us: 0,
        idle_us: 0,
        strain: R::ZERO,
        squeeze: R::ZERO,
        stuck: 0,
        eased: false,
        nudges: 0,
        press: R::ZERO,
        most_press: R::ZERO,
        landed: false,
        asleep: true,
        solver: Solver::ZERO,
        before: Field::ZERO,
        kept: Leaf::ZERO,
        scratch: Field::ZERO,
    };

    /// Opens a book in place, at rest.
    ///
    /// # Errors
    ///
    /// The first bad field; then nothing was changed.
    pub fn open(
        &mut self,
        spec: &BookSpec,
        paper: &PaperSpec,
        world: &WorldSpec,
        view: &View,
        fidelity: Fidelity,
    ) -> Result<(), SpecError> {
        spec.check()?;
        paper.check()?;
        world.check()?;
        view.check()?;
        self.spec = *spec;
        self.paper = *paper;
        self.most_press = R::of(if paper.weights.is_some() { 0.0 } else { PRESS });
        self.handling = Handling::default();
        self.units = Units::of_leaf(spec.width_m, spec.height_m, paper.areal_mass_gsm);
        self.set_world(world);
        self.camera = view.camera(&self.units);
        self.bind(paper);
        let height = self.units.length(spec.height_m);
        let pull = self.gravity.norm().wide() / SEED_GRAVITY;
        self.sheet.fill(WIDTH, height, paper, &self.units, pull);
        self.set_settings(fidelity.settings())?;
        self.set_fibres(paper, height, pull);
        self.lay_blocks();
        self.now_us = 0;
        self.rest();
        Ok(())
    }

    /// Looks from elsewhere. Never changes the physics; a drag goes on from where it is.
    ///
    /// # Errors
    ///
    /// A view that sees nothing is refused and the old one kept.
    pub fn look(&mut self, view: &View) -> Result<(), SpecError> {
        view.check()?;
        self.camera = view.camera(&self.units);
        Ok(())
    }

    /// Says how a finger and a page meet; [`Book::open`] says [`Handling::default`].
    ///
    /// # Errors
    ///
    /// A hand that cannot be; then the old one is kept.
    pub fn handle(&mut self, handling: Handling) -> Result<(), SpecError> {
        handling.check()?;
        self.handling = handling;
        Ok(())
    }

    /// Takes a pointer sample; it acts when its time has come.
    ///
    /// # Errors
    ///
    /// See [`InputError`]; the state hash is unchanged.
    pub fn input(&mut self, sample: Sample) -> Result<(), InputError> {
        if self.samples.back().is_some_and(|last| last.t_us > sample.t_us) {
            return Err(InputError::OutOfOrder);
        }
        if sample.t_us > self.now_us.saturating_add(AHEAD_US) {
            return Err(InputError::TooEarly);
        }
        // A move that waits behind another of the same pointer at the same time replaces it.
        if let Some(last) = self.samples.back_mut()
            && last.phase == Phase::Move
            && *last == (Sample { x: last.x, y: last.y, ..sample })
        {
            *last = sample;
            return Ok(());
        }
        self.samples.push_back(sample).map_err(|_| InputError::Full)
    }

    fn set_world(&mut self, world: &WorldSpec) {
        self.step_us = world.step_us;
        self.seed = world.seed;
        self.damping_per_s = world.damping_per_s;
        self.gravity = V3(world.gravity.map(|g| R::of(self.units.length(g))));
    }

    /// Turns the dials of the step by hand, between any two steps; [`Book::open`] sets those of a fidelity.
    ///
    /// # Errors
    ///
    /// The first dial out of range; then nothing was changed.
    pub fn set_settings(&mut self, settings: Settings) -> Result<(), SpecError> {
        settings.check()?;
        self.settings = settings;
        let h = f64::from(self.step_us) * 1e-6 / f64::from(settings.substeps);
        self.h = R::of(h);
        self.keep = R::of(-self.damping_per_s * h).exponential();
        self.keep_squeezed = R::of(-(self.damping_per_s + SQUEEZE) * h).exponential();
        self.sheet.regularise(settings.delta);
        self.solver.forget();
        Ok(())
    }

    fn bind(&mut self, paper: &PaperSpec) {
        let (all, read) = (self.spec.leaves(), self.spec.read());
        let left = if self.spec.direction == Direction::Ltr { read } else { all - read };
        self.binding = Binding {
            leaf: R::of(self.units.length(paper.thickness_mm * 1e-3)),
            leaves: [left, all - left],
            held: 0,
            from_right: true,
        };
    }

    /// Fibres of one leaf's share of a block, and of a board.
    fn set_fibres(&mut self, paper: &PaperSpec, height: f64, pull: f64) {
        let edges = (BLOCK - 1) as f64;
        let edge = WIDTH / edges;
        let (bend, glue) = match paper.weights {
            Some(w) => (R::of(w.bend_2d).root() / R::of(edge), w.glue),
            None => {
                let d = self.units.energy(paper.rigidity_nm());
                (R::of(0.5 * d * height / (edge * edge * edge)).root(), 600.0 * pull * GLUE)
            }
        };
        self.fibre = Fibre { edge: R::of(edge), mass: R::of(1.0 / edges), bend, glue: R::of(glue) };
        self.board = Fibre {
            edge: R::of(WIDTH + SQUARE),
            mass: R::of(BOARD_MASS),
            bend: R::ZERO,
            glue: R::ZERO,
        };
    }

    fn lay_blocks(&mut self) {
        let half = self.binding.half();
        for (block, board) in self.blocks.iter_mut().zip(&mut self.boards) {
            block.lay(half, R::of(WIDTH));
            board.lay(half, R::of(WIDTH + SQUARE));
        }
        self.active = false;
        self.free_hand();
        self.samples.clear();
        self.events = Events::EMPTY;
        self.owed_us = 0;
    }

    /// Lets the blocks come to rest before anyone looks.
    fn rest(&mut self) {
        self.wake();
        let mut report = nothing();
        for n in 0..SETTLING {
            self.step_midline(&mut report);
            if n > LEAST_SETTLING && self.midline_speed() < R::of(SETTLED) {
                break;
            }
        }
        for strip in &mut self.blocks {
            strip.stop();
        }
        for strip in &mut self.boards {
            strip.stop();
        }
        self.asleep = true;
    }
}
