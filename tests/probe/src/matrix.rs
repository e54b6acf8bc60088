//! The leaf's matrix: assembly, factor, solve, merit and collision, at random poses of a small net.

use crate::Row;
use crate::fold::Fold;
use crate::random::Random;
use crate::strip::random_profile;
use crate::work::Pick;
use dogleaf_core::collision::leaf;
use dogleaf_core::grid::{G6x5, Grid};
use dogleaf_core::kkt::solve::Unknowns;
use dogleaf_core::kkt::{Factor, Stencil};
use dogleaf_core::real::{Real, V2, V3};
use dogleaf_core::scene::{PaperSpec, Units};
use dogleaf_core::state::{Field, Grab, Leaf, Root, Sheet};
use dogleaf_core::step::Ask;
use dogleaf_core::step::assemble::assemble;
use dogleaf_core::step::constant::Constant;
use dogleaf_core::step::matrix::Matrix as Filled;
use dogleaf_core::step::merit::merit;

/// Poses of each operation here: a pose of the net is 20 nodes times seven blocks of the matrix.
const POSES: usize = 100;
/// Right-hand sides a factor is asked for.
const SIDES: usize = 20;

/// Memory for one matrix.
#[derive(Debug)]
pub struct Matrix<R: Real, G: Grid> {
    sheet: Sheet<R, G>,
    leaf: Leaf<R, G>,
    aim: Field<R, G>,
    gradient: Field<R, G>,
    constant: Constant<R, G>,
    stencil: Stencil<R, G>,
    factor: Factor<R, G>,
    unknowns: Unknowns<R, G>,
}

impl<R: Real, G: Grid> Matrix<R, G> {
    /// For the caller to place.
    pub const EMPTY: Self = Self {
        sheet: Sheet::ZERO,
        leaf: Leaf::ZERO,
        aim: Field::ZERO,
        gradient: Field::ZERO,
        constant: Constant::ZERO,
        stencil: Stencil::ZERO,
        factor: Factor::ZERO,
        unknowns: Unknowns::ZERO,
    };
}

/// All of them.
pub(crate) fn table<R: Pick>() -> [Row; 6] {
    [
        ("step.constant", |w| run(&mut R::of_work(w).matrix, "constant", 1, constant)),
        ("step.assemble", |w| run(&mut R::of_work(w).matrix, "assemble", POSES, assembled)),
        ("kkt.factor", |w| run(&mut R::of_work(w).matrix, "factor", POSES, factored)),
        ("kkt.solve", |w| run(&mut R::of_work(w).matrix, "solve", POSES / SIDES, solved)),
        ("step.merit", |w| run(&mut R::of_work(w).matrix, "merit", POSES, judged)),
        ("collision.leaf", |w| run(&mut R::of_work(w).matrix, "collision", POSES, collided)),
    ]
}

type Step<R, G> = fn(&mut Matrix<R, G>, &mut Random, &mut Fold);

fn run<R: Real>(m: &mut Matrix<R, G6x5>, name: &str, poses: usize, step: Step<R, G6x5>) -> u64 {
    let (mut random, mut fold) = (Random::named(name), Fold::START);
    let paper = PaperSpec::default();
    let units = Units::of_leaf(0.15, 0.2, paper.areal_mass_gsm);
    m.sheet.fill(12.0, 16.0, &paper, &units, 1.0);
    for _ in 0..poses {
        pose(m, &mut random);
        step(m, &mut random, &mut fold);
    }
    fold.value()
}

/// A leaf that leans, bent and shaken, with contacts here and there.
fn pose<R: Real, G: Grid>(m: &mut Matrix<R, G>, random: &mut Random) {
    let (dx, dy) = (random.within::<R>(2.0), random.within::<R>(2.0));
    let line = (0..G::NX).map(|i| V2([dx * R::of(i as f64), dy * R::of(i as f64)]));
    m.leaf.lay(m.sheet.spacing, line);
    for (i, k) in Field::<R, G>::nodes() {
        m.leaf.x.set(i, k, m.leaf.x.at(i, k) + random.v3(0.3));
        m.leaf.v.set(i, k, random.v3(5.0));
        m.leaf.pushed.set(i, k, random.v3(1.0));
        m.leaf.holding.set(i, k, R::of(f64::from(random.below(2))));
        m.aim.set(i, k, m.leaf.x.at(i, k) + random.v3(0.1));
    }
}

fn ask<R: Real>(random: &mut Random) -> Ask<R> {
    let clamp = random.below(2) == 0;
    Ask {
        h: R::of(1.0 / 60.0),
        keep: R::of(0.98),
        gravity: V3([R::ZERO, R::of(-650.0), R::ZERO]),
        root: if clamp { Root::Clamp(random.v3(1.0)) } else { Root::Hinge },
        grab: Some(Grab {
            node: (4, random.below(5) as usize),
            target: random.v3(10.0),
            firm: R::of(1.0),
        }),
    }
}

fn constant<R: Real, G: Grid>(m: &mut Matrix<R, G>, random: &mut Random, fold: &mut Fold) {
    for root in [Root::Hinge, Root::Clamp(random.v3(1.0))] {
        m.constant.fill(&m.sheet, R::of(1.0 / 60.0), root);
        m.factor.clear();
        for i in 1..G::NX {
            m.constant.copy_into(&mut m.stencil, i);
            m.factor.take(&m.stencil, i);
        }
        m.factor.entries(|_, _, v| fold.real(v));
    }
}

fn fill<R: Real, G: Grid>(m: &mut Matrix<R, G>, random: &mut Random) {
    let ask = ask(random);
    m.constant.fill(&m.sheet, ask.h, ask.root);
    let Matrix { constant, stencil, factor, .. } = m;
    let mut filled = Filled { constant, stencil, factor };
    assemble(&m.sheet, &m.leaf, &m.aim, &ask, &mut filled, &mut m.gradient);
}

fn assembled<R: Real, G: Grid>(m: &mut Matrix<R, G>, random: &mut Random, fold: &mut Fold) {
    fill(m, random);
    m.factor.entries(|_, _, v| fold.real(v));
    m.gradient.raw().iter().for_each(|&v| fold.real(v));
}

fn right_side<R: Real, G: Grid>(m: &mut Matrix<R, G>, random: &mut Random) {
    let numbers = m.unknowns.numbers_mut();
    for (n, slot) in numbers.iter_mut().enumerate() {
        *slot = if n < G::UNKNOWNS { random.within(100.0) } else { R::ZERO };
    }
}

fn factored<R: Real, G: Grid>(m: &mut Matrix<R, G>, random: &mut Random, fold: &mut Fold) {
    fill(m, random);
    m.factor.decompose();
    fold.word(u64::from(m.factor.regularised));
    m.factor.entries(|_, _, v| fold.real(v));
}

fn solved<R: Real, G: Grid>(m: &mut Matrix<R, G>, random: &mut Random, fold: &mut Fold) {
    fill(m, random);
    m.factor.decompose();
    for _ in 0..SIDES {
        right_side(m, random);
        m.factor.solve(&mut m.unknowns);
        m.unknowns.numbers().iter().for_each(|&v| fold.real(v));
    }
}

fn judged<R: Real, G: Grid>(m: &mut Matrix<R, G>, random: &mut Random, fold: &mut Fold) {
    let judged = merit(&m.sheet, &m.leaf, &m.leaf.x, &m.aim, &ask(random));
    fold.real(judged.energy);
    fold.real(judged.residual);
}

fn collided<R: Real, G: Grid>(m: &mut Matrix<R, G>, random: &mut Random, fold: &mut Fold) {
    let sides = [random_profile(random), random_profile(random)];
    let half = R::of(0.01);
    let done = leaf::resolve(&mut m.leaf, [&sides[0], &sides[1]], half, 3, &mut m.gradient);
    fold.word(u64::from(done.passes) << 32 | u64::from(done.pushed));
    for (i, k) in Field::<R, G>::nodes() {
        fold.v3(m.leaf.x.at(i, k));
        fold.v3(m.leaf.pushed.at(i, k));
        fold.real(m.leaf.holding.at(i, k));
    }
}
