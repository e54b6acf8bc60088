//! Five scenes, each some sixty steps of one kind of trouble. The hash takes in every step, not only the last.

use crate::Row;
use crate::fold::Fold;
use crate::random::Random;
use crate::work::Pick;
use dogleaf_core::Book;
use dogleaf_core::grid::Grid;
use dogleaf_core::hand::{Phase, Sample, View};
use dogleaf_core::real::Real;
use dogleaf_core::scene::{BookSpec, Cover, Direction, Fidelity, LeafSpec, PaperSpec, WorldSpec};
use dogleaf_core::step::StepReport;

/// Their names, in order.
pub const SCENES: [&str; 5] = ["slow_turn", "top_release", "stack_peek", "lone_leaf", "storm"];

/// Length of a world step, microseconds.
const STEP_US: u64 = 16_667;
/// The middle of the picture, 1/256 pixel.
const MIDDLE: i32 = 480 * 256;
/// From there to the fore-edge of a page.
const HALF: i32 = 316 * 256;
/// Half way up the page.
const ROW: i32 = 453 * 256;

/// All of them.
pub(crate) fn table<R: Pick>() -> [Row; 5] {
    let [turn, top, stack, lone, storm] = SCENES;
    [
        (turn, |w| slow_turn(&mut R::of_work(w).book).hash),
        (top, |w| top_release(&mut R::of_work(w).small).hash),
        (stack, |w| stack_peek(&mut R::of_work(w).small).hash),
        (lone, |w| lone_leaf::<R>(R::of_work(w)).hash),
        (storm, |w| storm_drag(&mut R::of_work(w).small).hash),
    ]
}

/// A book of 11x8 nodes, its page drawn all the way over and let go.
fn slow_turn<R: Real, G: Grid>(book: &mut Book<R, G>) -> Ran {
    let mut run = Run::open(book, BookSpec::default(), Fidelity::Standard);
    run.press(HALF, 0, 1);
    for n in 1..=48 {
        // From one fore-edge to the other, highest in the middle.
        let way = n * 2 * HALF / 48;
        let rise = way / 256 * (2 * HALF - way) / (HALF / 128);
        run.draw(HALF - way, -rise);
    }
    run.lift(-HALF, 0);
    run.wait(11)
}

/// A page stood up over the binding and let go there, where it could fall to either side.
fn top_release<R: Real, G: Grid>(book: &mut Book<R, G>) -> Ran {
    let spec = BookSpec { pages: 320, open_at: 160, ..BookSpec::default() };
    let mut run = Run::open(book, spec, Fidelity::Draft);
    run.press(HALF, 0, 1);
    for n in 1..=16 {
        run.draw(HALF - n * HALF / 16, -n * 240 * 16);
    }
    for _ in 0..8 {
        run.draw(0, -240 * 256);
    }
    run.lift(0, -240 * 256);
    run.wait(39)
}

/// Twenty leaves at once, lifted by a corner, looked under, and put back; then taken away by the system.
fn stack_peek<R: Real, G: Grid>(book: &mut Book<R, G>) -> Ran {
    let spec =
        BookSpec { pages: 400, open_at: 40, direction: Direction::Rtl, ..BookSpec::default() };
    let mut run = Run::open(book, spec, Fidelity::Fine);
    run.press(HALF - 4096, 30_000, 20);
    for n in 1..=12 {
        run.draw(HALF - 4096 - n * 4000, 30_000 - n * 3500);
    }
    for n in (1..=12).rev() {
        run.draw(HALF - 4096 - n * 4000, 30_000 - n * 3500);
    }
    run.send(Phase::Cancel, HALF, 30_000, 0);
    run.wait(16)
}

/// A curled leaf in a clamp that points upwards, left to fall.
fn lone_leaf<R: Pick>(tier: &mut crate::Tier<R>) -> Ran {
    let spec = LeafSpec { width_m: 0.15, height_m: 0.20, clamp_angle_deg: 72.5, curl_per_m: 4.0 };
    let (paper, world) = (PaperSpec::default(), WorldSpec::default());
    let opened = tier.lone.open(&spec, &paper, &world, Fidelity::Standard).is_ok();
    let mut fold = Fold::START;
    fold.word(u64::from(opened));
    let mut newton = 0;
    for _ in 0..60 {
        let report = tier.lone.step();
        newton += report.newton_steps;
        note(&mut fold, &report, tier.lone.state_hash());
    }
    Ran { hash: fold.value(), newton }
}

/// A soft-covered book, and a hand that is everywhere at once.
fn storm_drag<R: Real, G: Grid>(book: &mut Book<R, G>) -> Ran {
    let spec = BookSpec { cover: Cover::Soft, pages: 60, open_at: 30, ..BookSpec::default() };
    let mut run = Run::open(book, spec, Fidelity::Standard);
    let mut random = Random::named("storm");
    run.press(HALF, 0, 1);
    for n in 0..60 {
        let x = random.below(1 << 18).cast_signed() - (1 << 17);
        let y = random.below(1 << 17).cast_signed() - (1 << 16);
        match random.below(12) {
            0 => run.lift(x, y),
            1 => run.press(if n % 2 == 0 { HALF } else { -HALF }, y / 2, 1 + n as u16 % 3),
            _ => run.draw(x, y),
        }
    }
    run.lift(0, 0);
    run.wait(12)
}

/// What a scene came to.
struct Ran {
    hash: u64,
    /// Newton steps of its leaf: that something moved.
    #[cfg_attr(not(test), expect(dead_code, reason = "asked for by tests only"))]
    newton: u32,
}

fn note(fold: &mut Fold, report: &StepReport, hash: u64) {
    fold.word(hash);
    fold.word(report.status as u64);
    fold.word(u64::from(report.newton_steps) << 32 | u64::from(report.pushed));
}

/// A book under way: one sample, then one step.
struct Run<'b, R: Real, G: Grid> {
    book: &'b mut Book<R, G>,
    fold: Fold,
    t_us: u64,
    newton: u32,
}

impl<'b, R: Real, G: Grid> Run<'b, R, G> {
    fn open(book: &'b mut Book<R, G>, spec: BookSpec, fidelity: Fidelity) -> Self {
        let view = View::reading(spec.width_m, spec.height_m, 960, 720);
        let (paper, world) = (PaperSpec::default(), WorldSpec::default());
        let opened = book.open(&spec, &paper, &world, &view, fidelity).is_ok();
        let mut fold = Fold::START;
        fold.word(u64::from(opened));
        Self { book, fold, t_us: 0, newton: 0 }
    }
    /// One sample, relative to the middle of the page's edge, and the step it falls into.
    fn send(&mut self, phase: Phase, x: i32, y: i32, leaves: u16) {
        self.t_us += STEP_US;
        let sample = Sample { t_us: self.t_us, id: 0, phase, x: MIDDLE + x, y: ROW + y, leaves };
        self.fold.word(u64::from(self.book.input(sample).is_ok()));
        self.step();
    }
    fn press(&mut self, x: i32, y: i32, leaves: u16) {
        self.send(Phase::Down, x, y, leaves);
    }
    fn draw(&mut self, x: i32, y: i32) {
        self.send(Phase::Move, x, y, 0);
    }
    fn lift(&mut self, x: i32, y: i32) {
        self.send(Phase::Up, x, y, 0);
    }
    fn step(&mut self) {
        let report = self.book.step();
        self.newton += report.newton_steps;
        note(&mut self.fold, &report, self.book.state_hash());
    }
    /// Steps without input, and the hash of all.
    fn wait(mut self, steps: u32) -> Ran {
        for _ in 0..steps {
            self.step();
        }
        Ran { hash: self.fold.value(), newton: self.newton }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::{lone_leaf, slow_turn, stack_peek, storm_drag, top_release};
    use crate::Work;
    use crate::work::Pick;
    use std::boxed::Box;

    #[test]
    fn in_every_scene_a_leaf_moves() {
        let mut work = Box::new(Work::EMPTY);
        let tier = f32::of_work(&mut work);
        let runs = [
            slow_turn(&mut tier.book),
            top_release(&mut tier.small),
            stack_peek(&mut tier.small),
            lone_leaf::<f32>(tier),
            storm_drag(&mut tier.small),
        ];
        let newton = runs.map(|r| r.newton);
        assert!(newton.iter().all(|&n| n >= 30), "Newton steps: {newton:?}");
    }
}
