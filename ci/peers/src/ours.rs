//! Ours: the leaf's condensed matrix, and the whole step of the book.
//!
//! Both solve another system than Eigen does, for the same step of the same book: they have no error to
//! show in its terms.

use std::hint::black_box;
use std::time::Instant;

use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;
use dogleaf_core::kkt::solve::Unknowns;
use dogleaf_core::kkt::{Factor, Stencil};
use dogleaf_core::real::{Real, V3};
use dogleaf_core::state::{Field, Leaf, Root, Sheet};
use dogleaf_core::step::Ask;
use dogleaf_core::step::assemble::assemble;
use dogleaf_core::step::constant::Constant;
use dogleaf_core::step::matrix::Matrix;
use dogleaf_tests::gesture::Scene;

use crate::bench::{Contender, Pass, ns};
use crate::matrices::Matrices;

/// `S dx = r` of one pose.
#[derive(Debug, Clone)]
struct System<R: Real> {
    /// The matrix, which becomes its factor.
    matrix: Factor<R, G11x8>,
    rhs: Unknowns<R, G11x8>,
}

/// Factor and solve of the condensed matrix of the leaf, all else left out.
#[derive(Debug)]
pub(crate) struct Condensed<R: Real> {
    name: &'static str,
    systems: Vec<Box<System<R>>>,
    /// The system at hand: copied before the clock starts, as Eigen's are.
    at_hand: Box<System<R>>,
}

impl<R: Real> Condensed<R> {
    /// Assembles the matrix of every pose.
    pub(crate) fn new(name: &'static str, scene: &Scene, poses: &[Box<Book<R, G11x8>>]) -> Self {
        let mut constant = Box::new(Constant::ZERO);
        let mut growing = Box::new(Stencil::ZERO);
        let mut systems = Vec::new();
        for book in poses {
            let ask = ask(scene, book);
            let Some(leaf) = book.leaf() else { continue };
            constant.fill(book.sheet(), ask.h, ask.root);
            let mut system = Box::new(System { matrix: Factor::ZERO, rhs: Unknowns::ZERO });
            let mut gradient = Field::ZERO;
            let inertia = inertia(book.sheet(), leaf, &ask);
            let (stencil, factor) = (&mut *growing, &mut system.matrix);
            let mut matrix = Matrix { constant: &constant, stencil, factor };
            assemble(book.sheet(), leaf, &inertia, &ask, &mut matrix, &mut gradient);
            gather(&gradient, &mut system.rhs);
            systems.push(system);
        }
        let at_hand = Box::new(System { matrix: Factor::ZERO, rhs: Unknowns::ZERO });
        Self { name, systems, at_hand }
    }
}

/// What the book's next step is asked.
fn ask<R: Real>(scene: &Scene, book: &Book<R, G11x8>) -> Ask<R> {
    let substeps = f64::from(scene.fidelity.settings().substeps);
    let h = f64::from(scene.world.step_us) * 1e-6 / substeps;
    Ask {
        h: R::of(h),
        keep: R::of((-scene.world.damping_per_s * h).exp()),
        gravity: V3(scene.world.gravity.map(|g| R::of(book.units().length(g)))),
        root: Root::Hinge,
        grab: book.held(),
    }
}

/// `M (x - x̃) / h²` with `x̃ = x + h e^(-ch) v`.
fn inertia<R: Real>(
    sheet: &Sheet<R, G11x8>,
    leaf: &Leaf<R, G11x8>,
    ask: &Ask<R>,
) -> Field<R, G11x8> {
    let mut field = Field::ZERO;
    for (i, k) in Field::<R, G11x8>::nodes() {
        field.set(i, k, leaf.v.at(i, k) * (-sheet.mass.at(i, k) * ask.keep / ask.h));
    }
    field
}

/// `-g` in the order of the unknowns: the free nodes, column by column.
fn gather<R: Real>(gradient: &Field<R, G11x8>, rhs: &mut Unknowns<R, G11x8>) {
    let free = Field::<R, G11x8>::nodes().filter(|(i, _)| *i > 0);
    let numbers = free.flat_map(|(i, k)| (-gradient.at(i, k)).0);
    rhs.numbers_mut().iter_mut().zip(numbers).for_each(|(to, from)| *to = from);
}

impl<R: Real> Contender for Condensed<R> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn pass(&mut self, _: &Matrices, pass: &mut Pass) -> Result<(), String> {
        pass.clear();
        for system in &self.systems {
            self.at_hand.clone_from(system);
            let System { matrix, rhs } = &mut *self.at_hand;
            let start = Instant::now();
            black_box(&mut *matrix).decompose();
            let factored = Instant::now();
            matrix.solve(black_box(rhs));
            pass.solve_ns.push(ns(factored));
            pass.factor_ns.push((factored - start).as_nanos() as u64);
            if black_box(rhs).numbers().iter().any(|v| !v.finite()) {
                return Err("a solution that is not finite".into());
            }
        }
        Ok(())
    }
}

/// The complete step of the book: hand, blocks, boards, leaf, contact, merit, velocities, events.
#[derive(Debug)]
pub(crate) struct Step<'a, R: Real> {
    name: &'static str,
    wanted: Option<f64>,
    poses: &'a [Box<Book<R, G11x8>>],
    /// The book that is stepped: copied before the clock starts.
    book: Box<Book<R, G11x8>>,
}

impl<'a, R: Real> Step<'a, R> {
    /// A step from every pose; `wanted` is how many times faster than the baseline it has to be.
    pub(crate) fn new(
        name: &'static str,
        wanted: Option<f64>,
        poses: &'a [Box<Book<R, G11x8>>],
    ) -> Self {
        Self { name, wanted, poses, book: Box::new(Book::EMPTY) }
    }
}

impl<R: Real> Contender for Step<'_, R> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn wanted(&self) -> Option<f64> {
        self.wanted
    }

    fn pass(&mut self, _: &Matrices, pass: &mut Pass) -> Result<(), String> {
        pass.clear();
        for pose in self.poses {
            self.book.clone_from(pose);
            let book = black_box(&mut *self.book);
            let start = Instant::now();
            let report = black_box(book.step());
            pass.whole_ns.push(ns(start));
            black_box(&mut *self.book);
            if report.steps != 1 || report.newton_steps == 0 {
                return Err("a step that did nothing".into());
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use dogleaf_core::real::Real;

    use super::{Condensed, Step};
    use crate::bench::{Contender, Pass};
    use crate::turn::corner_turn;

    /// The largest `|S x - b|` of a pose over the largest `|S| |x| + |b|`.
    fn error<R: Real>(contender: &Condensed<R>, n: usize) -> f64 {
        let system = contender.systems[n].clone();
        let mut factor = system.matrix.clone();
        factor.decompose();
        let mut x = system.rhs.clone();
        factor.solve(&mut x);
        let x: Vec<f64> = x.numbers().iter().map(|v| v.wide()).collect();
        let mut left: Vec<f64> = system.rhs.numbers().iter().map(|v| v.wide()).collect();
        let mut size: Vec<f64> = left.iter().map(|v| v.abs()).collect();
        system.matrix.entries(|row, col, v| {
            let mut subtract = |row: usize, col: usize| {
                left[row] -= v.wide() * x[col];
                size[row] += (v.wide() * x[col]).abs();
            };
            subtract(row, col);
            if row != col {
                subtract(col, row);
            }
        });
        let largest = |v: &[f64]| v.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        assert!(largest(&x) > 1e-6, "pose {n} asks for nothing");
        largest(&left) / largest(&size)
    }

    #[test]
    fn every_condensed_system_is_solved_and_every_step_steps() {
        let turn = corner_turn().expect("a sound scene");
        let mut single = Condensed::new("single", &turn.scene, &turn.single);
        let double = Condensed::new("double", &turn.scene, &turn.double);
        assert_eq!((single.systems.len(), double.systems.len()), (turn.single.len(), 80));
        for n in 0..turn.single.len() {
            let errors = (error(&single, n), error(&double, n));
            assert!(errors.0 < 1e-5 && errors.1 < 1e-13, "pose {n}: {errors:?}");
        }
        let mut pass = Pass::default();
        single.pass(&turn.set, &mut pass).expect("finite");
        assert_eq!((pass.factor_ns.len(), pass.whole_ns.len()), (80, 0));
        let mut step = Step::new("step", None, &turn.single);
        for _ in 0..2 {
            step.pass(&turn.set, &mut pass).expect("a leaf in the air");
            assert_eq!((pass.factor_ns.len(), pass.whole_ns.len()), (0, 80));
        }
        assert_ne!(step.book.state_hash(), turn.single[79].state_hash(), "the leaf moved");
    }
}
