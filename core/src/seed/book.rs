//! A [`Book`] that is stepped by the seed's own form: same hand, same collisions, same ends of a turn.

use super::model::Model;
use super::pose::Pose;
use super::{SeedGrid, SeedSettings, Solver};
use crate::book::{Book, Parts};
use crate::collision::{block, leaf};
use crate::hand::View;
use crate::real::{Real, V2};
use crate::scene::{BookSpec, Fidelity, PaperSpec, SpecError, WorldSpec};
use crate::state::Root;
use crate::state::strip::BLOCK;
use crate::step::Ask;
use crate::step::{StepReport, StepStatus};

/// Steps a new book is given to come to rest.
const SETTLING: u32 = 120;

/// A book and the seed's solver. Input, events and everything to look at are the book's.
#[derive(Debug, Clone)]
pub struct SeedBook<R: Real, G: SeedGrid> {
    book: Book<R, G>,
    engine: Engine<R, G>,
}

/// What the seed's form has beside the book's own state.
#[derive(Debug, Clone)]
struct Engine<R: Real, G: SeedGrid> {
    settings: SeedSettings,
    solver: Solver<R, G>,
    pose: Pose<R, G>,
    velocity: Pose<R, G>,
    /// Place and velocity of the middle of the binding.
    centre: [V2<R>; 2],
}

impl<R: Real, G: SeedGrid> SeedBook<R, G> {
    /// A book that was never opened: for the caller to place.
    pub const EMPTY: Self = Self {
        book: Book::EMPTY,
        engine: Engine {
            settings: SeedSettings {
                newton: 1,
                exact: true,
                constraint_hessian: false,
                lock_spine: true,
                delta: 1e-8,
                refinements: 1,
            },
            solver: Solver::ZERO,
            pose: Pose::ZERO,
            velocity: Pose::ZERO,
            centre: [V2([R::ZERO; 2]); 2],
        },
    };

    /// Opens a book in place, at rest.
    ///
    /// # Errors
    ///
    /// As [`Book::open`].
    pub fn open(
        &mut self,
        spec: &BookSpec,
        paper: &PaperSpec,
        world: &WorldSpec,
        view: &View,
        fidelity: Fidelity,
        settings: SeedSettings,
    ) -> Result<(), SpecError> {
        self.book.open(spec, paper, world, view, fidelity)?;
        let Self { book, engine } = self;
        engine.settings = settings;
        engine.centre = [V2::zero(); 2];
        lay_flat(&mut book.parts());
        let mut report = StepReport::default();
        for _ in 0..SETTLING {
            engine.substep(book, &mut report);
        }
        let parts = book.parts();
        parts.blocks.iter_mut().for_each(|b| b.stop());
        parts.boards.iter_mut().for_each(|b| b.stop());
        engine.centre = [engine.pose.centre, V2::zero()];
        Ok(())
    }

    /// The book: to look at.
    pub fn book(&self) -> &Book<R, G> {
        &self.book
    }
    /// The book: for its input and events. Advancing it directly takes the product's step.
    pub fn book_mut(&mut self) -> &mut Book<R, G> {
        &mut self.book
    }
    /// The options, to change between steps.
    pub fn settings_mut(&mut self) -> &mut SeedSettings {
        &mut self.engine.settings
    }
    /// Matrix, right-hand side, factor and direction of the last Newton step.
    pub fn solver(&self) -> &Solver<R, G> {
        &self.engine.solver
    }

    /// Lets `dt_us` microseconds pass; as [`Book::advance`].
    ///
    /// # Cost
    ///
    /// A step at 11x8 is some twenty times the product's.
    pub fn advance(&mut self, dt_us: u32) -> StepReport {
        let Self { book, engine } = self;
        book.advance_by(dt_us, |book, report| {
            book.lead(report);
            engine.substep(book, report);
        })
    }

    /// Assembles, factors and solves the first Newton step of the book as it is; nothing moves.
    ///
    /// [`SeedBook::solver`] then holds all of it.
    pub fn linearise(&mut self) {
        let Self { book, engine } = self;
        let mut parts = book.parts();
        engine.load(&mut parts);
        let model = engine.model(&parts);
        engine.solver.linearise(&model, &engine.settings, &engine.pose, &engine.velocity);
    }

    /// The linear system of [`SeedBook::linearise`] for other solvers: `K` by columns, both triangles, rows
    /// rising within a column, and the right-hand side. Answers the count of entries.
    ///
    /// # Shapes and units
    ///
    /// `col_ptr`: `N + 1`. `row_idx`, `values`: at least [`SeedBook::entries`]. `rhs`: `N`. `None` where one is shorter.
    ///
    /// With [`SeedSettings::lock_spine`] the rows of what is held are the identity's but keep their slots:
    /// unlock it before this call to have the seed's matrix as it stands in Eq. 3.
    pub fn export(
        &mut self,
        col_ptr: &mut [i32],
        row_idx: &mut [i32],
        values: &mut [f64],
        rhs: &mut [f64],
    ) -> Option<usize> {
        self.linearise();
        let solver = &self.engine.solver;
        let rhs = rhs.get_mut(..G::N)?;
        rhs.iter_mut().zip(solver.rhs()).for_each(|(to, from)| *to = from.wide());
        solver.matrix().export(col_ptr, row_idx, values)
    }

    /// Entries of both triangles of `K`, without or with the constraint Hessian's.
    pub fn entries(constraint_hessian: bool) -> usize {
        let [plain, curved] = G::ENTRIES;
        2 * if constraint_hessian { curved } else { plain } - G::N
    }
}

impl<R: Real, G: SeedGrid> Engine<R, G> {
    /// Solve, project, velocities: for leaf, blocks and boards together.
    fn substep(&mut self, book: &mut Book<R, G>, report: &mut StepReport) {
        let mut parts = book.parts();
        self.load(&mut parts);
        parts.before.copy_from(&self.pose.leaf);
        let mut own = StepReport::default();
        let model = self.model(&parts);
        let Self { settings, solver, pose, velocity, .. } = self;
        solver.step(&model, settings, pose, velocity, &mut own);
        if self.pose.finite() {
            self.place(&mut parts, &mut own);
        } else {
            own.status = StepStatus::Held;
            parts.leaf.v.clear();
            parts.blocks.iter_mut().for_each(|b| b.stop());
            parts.boards.iter_mut().for_each(|b| b.stop());
        }
        report.add(&own);
    }

    /// Reads the book. Contacts of the last pass are forgotten: here they act after the solve only.
    fn load(&mut self, parts: &mut Parts<'_, R, G>) {
        parts.leaf.holding.clear();
        let (blocks, boards) = (&*parts.blocks, &*parts.boards);
        self.pose.load(blocks, boards, |b| b.x, |b| b.x);
        self.velocity.load(blocks, boards, |b| b.v, |b| b.v);
        self.pose.leaf.copy_from(&parts.leaf.x);
        self.velocity.leaf.copy_from(&parts.leaf.v);
        [self.pose.centre, self.velocity.centre] = self.centre;
    }

    fn model<'a>(&self, parts: &'a Parts<'_, R, G>) -> Model<'a, R, G> {
        let ask = Ask {
            h: parts.h,
            keep: parts.keep,
            gravity: parts.gravity,
            root: Root::Hinge,
            grab: parts.grab,
        };
        let [left, right] = parts.binding.leaves;
        let seeds = parts.paper.weights.is_some();
        let block = |leaves| Model::<R, G>::block(parts.fibre, leaves, seeds);
        Model {
            sheet: parts.sheet,
            leaf: &*parts.leaf,
            ask,
            active: parts.active,
            q: R::of(parts.binding.q()),
            binding: parts.binding.half() * R::of(2.0),
            blocks: [block(left), block(right)],
            centre: Model::<R, G>::centre(parts.binding),
            board: Model::<R, G>::board(parts.board, parts.cover),
        }
    }

    /// Gives the solved pose to the book, projects, and takes velocities from where things end up.
    fn place(&mut self, parts: &mut Parts<'_, R, G>, report: &mut StepReport) {
        let before = (*parts.blocks, *parts.boards);
        self.pose.store(parts.blocks, parts.boards);
        let rate = R::of(1.0) / parts.h;
        let [was, _] = self.centre;
        self.centre = [self.pose.centre, (self.pose.centre - was) * rate];
        for (side, (strip, board)) in
            parts.blocks.iter_mut().zip(parts.boards.iter_mut()).enumerate()
        {
            let mut ground = block::Ground::table();
            if parts.cover == crate::scene::Cover::Hard {
                report.pushed += block::resolve(board, &ground);
                ground = block::Ground::board(board);
            }
            report.pushed += block::resolve(strip, &ground);
            let (blocks, boards) = &before;
            if let (Some(b), Some(c)) = (blocks.get(side), boards.get(side)) {
                block::velocities(strip, &b.x, parts.h);
                block::velocities(board, &c.x, parts.h);
            }
        }
        if parts.active {
            self.place_leaf(parts, report);
        }
    }

    fn place_leaf(&self, parts: &mut Parts<'_, R, G>, report: &mut StepReport) {
        parts.leaf.x.copy_from(&self.pose.leaf);
        let [left, right] = parts.binding.profiles(parts.blocks);
        let half = parts.binding.half_held();
        let done = leaf::resolve(parts.leaf, [&left, &right], half, parts.passes, parts.scratch);
        parts.leaf.holding.clear();
        report.passes = done.passes;
        report.pushed += done.pushed;
        let rate = R::of(1.0) / parts.h;
        let (x, before) = (parts.leaf.x.raw(), parts.before.raw());
        for ((v, &x), &b) in parts.leaf.v.raw_mut().iter_mut().zip(x).zip(before) {
            *v = (x - b) * rate;
        }
    }
}

/// Both blocks and boards flat: the product's rest is another, where each leaf has glue of its own.
fn lay_flat<R: Real, G: SeedGrid>(parts: &mut Parts<'_, R, G>) {
    let half = parts.binding.half();
    let width = parts.fibre.edge * R::of((BLOCK - 1) as f64);
    parts.blocks.iter_mut().for_each(|b| b.lay(half, width));
    parts.boards.iter_mut().for_each(|b| b.lay(half, parts.board.edge));
}
