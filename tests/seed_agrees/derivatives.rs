//! Central differences of the whole system: energy to gradient, gradient and residual to matrix, and the
//! constraint Hessian.

use super::{flat_book, model, towards};
use dogleaf_core::constraint::dog::{ROWS, Star};
use dogleaf_core::grid::G6x5;
use dogleaf_core::real::{V2, V3};
use dogleaf_core::seed::curvature;
use dogleaf_core::seed::{Pose, SeedGrid, SeedSettings, Solver};
use dogleaf_core::step::StepReport;
use dogleaf_tests::differences::{agree, gradient, jacobian};
use dogleaf_tests::posed::{Posed, seed_paper};
use dogleaf_tests::random::Pcg;

type Grid = G6x5;

/// A system at one pose, to be asked at poses around it.
struct Around {
    posed: Posed<f64, Grid>,
    pose: Box<Pose<f64, Grid>>,
    aim: Box<Pose<f64, Grid>>,
    settings: SeedSettings,
    solver: Box<Solver<f64, Grid>>,
}

impl Around {
    /// A random leaf over a book that is all bent, its spine turned.
    fn new(seed: u64) -> Self {
        let mut random = Pcg::new(seed);
        let mut posed = Posed::curved(&seed_paper(), &mut random);
        posed.leaf.holding.clear();
        let mut pose = flat_book(&posed.leaf.x);
        let mut shake = |p: &mut V2<f64>| {
            *p = *p + V2([random.within(-0.2, 0.2), random.within(0.0, 0.4)]);
        };
        pose.blocks.as_flattened_mut().iter_mut().for_each(&mut shake);
        pose.boards.iter_mut().for_each(&mut shake);
        shake(&mut pose.centre);
        for k in 0..5 {
            let at = pose.leaf.at(0, k);
            pose.leaf.set(0, k, at + V3([random.within(-0.1, 0.1), random.within(-0.1, 0.1), 0.0]));
        }
        let mut aim = Box::new(Pose::ZERO);
        aim.sum(&pose, &Pose::ZERO, 0.0);
        aim.leaf.copy_from(&posed.aim);
        let settings = SeedSettings { lock_spine: false, ..SeedSettings::default() };
        Self { posed, pose, aim, settings, solver: Box::new(Solver::ZERO) }
    }
    /// Moves by `dx` and linearises there.
    fn at(&mut self, dx: &[f64]) -> (Box<Pose<f64, Grid>>, &Solver<f64, Grid>) {
        let (mut by, mut to) = (Box::new(Pose::ZERO), Box::new(Pose::ZERO));
        by.spread(dx);
        to.sum(&self.pose, &by, 1.0);
        let velocity = towards(&to, &self.aim, &self.posed.ask);
        let asked = model(&self.posed.sheet, &self.posed.leaf, self.posed.ask);
        self.solver.linearise(&asked, &self.settings, &to, &velocity);
        (to, &self.solver)
    }
    /// `∇Φ` and `C`.
    fn residual(&mut self, dx: &[f64]) -> Vec<f64> {
        self.at(dx).1.rhs().iter().map(|v| -v).collect()
    }
    /// `Φ` and `‖C‖`.
    fn merit(&mut self, dx: &[f64]) -> [f64; 2] {
        let (to, _) = self.at(dx);
        let asked = model(&self.posed.sheet, &self.posed.leaf, self.posed.ask);
        let merit = self.solver.merit(&asked, &self.settings, &to);
        [merit.energy, merit.residual]
    }
    /// `K` by rows.
    fn matrix(&mut self) -> Vec<f64> {
        let (n, most) = (Grid::N, 2 * Grid::ENTRIES[1] - Grid::N);
        let (mut starts, mut rows, mut values) = (vec![0; n + 1], vec![0; most], vec![0.0; most]);
        let (_, solver) = self.at(&[]);
        solver.matrix().export(&mut starts, &mut rows, &mut values).expect("room");
        let mut k = vec![0.0; n * n];
        for c in 0..n {
            (starts[c] as usize..starts[c + 1] as usize)
                .for_each(|at| k[rows[at] as usize * n + c] = values[at]);
        }
        k
    }
}

const UNKNOWNS: usize = Grid::N - (3 * 4 * 3 + 15 + 12 + 2);

#[test]
fn the_gradient_is_the_difference_of_the_energy() {
    for seed in 1..3 {
        let around = core::cell::RefCell::new(Around::new(seed));
        let zero = vec![0.0; UNKNOWNS];
        let found = around.borrow_mut().residual(&zero)[..UNKNOWNS].to_vec();
        let expected = gradient(|dx| around.borrow_mut().merit(dx)[0], &zero);
        assert_eq!(agree(&found, &expected, 1e-7), Ok(()), "seed {seed}");
    }
}

#[test]
fn the_merits_residual_is_the_norm_of_the_rows() {
    let mut around = Around::new(3);
    let rows = around.residual(&[])[UNKNOWNS..].to_vec();
    let norm = rows.iter().map(|c| c * c).sum::<f64>().sqrt();
    let [_, found] = around.merit(&[]);
    assert!(norm > 0.1 && (found - norm).abs() < 1e-9 * norm, "{found} is not {norm}");
}

#[test]
fn the_matrix_is_the_difference_of_gradient_and_rows() {
    for seed in 1..3 {
        let around = core::cell::RefCell::new(Around::new(seed));
        let k = around.borrow_mut().matrix();
        let expected = jacobian(|dx| around.borrow_mut().residual(dx), &vec![0.0; UNKNOWNS]);
        let found: Vec<f64> =
            (0..Grid::N * UNKNOWNS).map(|at| k[at / UNKNOWNS * Grid::N + at % UNKNOWNS]).collect();
        let (h, j) = (0..UNKNOWNS * UNKNOWNS, UNKNOWNS * UNKNOWNS..found.len());
        assert_eq!(agree(&found[h.clone()], &expected[h], 1e-7), Ok(()), "H, seed {seed}");
        assert_eq!(agree(&found[j.clone()], &expected[j], 1e-7), Ok(()), "J, seed {seed}");
    }
}

/// A star from fifteen numbers: arms' ends `x⁺, z⁺, x⁻, z⁻`, then the centre.
fn star(x: &[f64]) -> Star<f64> {
    let node = |n: usize| V3([x[3 * n], x[3 * n + 1], x[3 * n + 2]]);
    Star::new(node(4), [node(0), node(1), node(2), node(3)])
}

/// `Σ λ_r ∇C_r` by the fifteen numbers.
fn pull(x: &[f64], scales: [f64; 3], lambda: [f64; 3]) -> Vec<f64> {
    let mut sum = vec![0.0; 15];
    for ((row, named), l) in star(x).rows(scales).iter().zip(ROWS).zip(lambda) {
        for (n, g) in named.into_iter().zip(row.gradient) {
            for c in 0..3 {
                sum[3 * n + c] += l * g.0[c];
                sum[12 + c] -= l * g.0[c];
            }
        }
    }
    sum
}

#[test]
fn the_stars_hessian_is_its_differences() {
    let mut random = Pcg::new(5);
    for _ in 0..200 {
        let x = random.numbers(15);
        let numbers = random.numbers(6);
        let scales = [0, 1, 2].map(|n: usize| 1.5 + numbers[n]);
        let lambda = [3, 4, 5].map(|n: usize| 10.0 * numbers[n]);
        let blocks = curvature::star(&star(&x), scales, lambda);
        let found: Vec<f64> = (0..225)
            .map(|at| (at / 15, at % 15))
            .map(|(r, c)| blocks[r / 3][c / 3][r % 3][c % 3])
            .collect();
        let expected = jacobian(|x| pull(x, scales, lambda), &x);
        // Short arms curve much: their differences are worth fewer digits.
        assert_eq!(agree(&found, &expected, 1e-5), Ok(()), "at {x:?}");
    }
}

#[test]
fn the_lengths_hessian_is_its_differences() {
    use dogleaf_core::constraint::length;
    let row = |x: &[f64]| length::row(V2([x[0], x[1]]), 2.5).1.0.map(|g| 7.0 * g).to_vec();
    let d = curvature::length(2.5, 7.0);
    assert_eq!(agree(&[d, 0.0, 0.0, d], &jacobian(row, &[0.3, -1.1]), 1e-9), Ok(()));
}

/// What is left of Eq. 3 after so many Newton steps from a gently curved leaf: the largest of `∇Φ + Jᵀλ`, and of C.
fn left_after(newton: u32, constraint_hessian: bool) -> [f64; 2] {
    let mut posed = Posed::<f64, Grid>::flat(&seed_paper());
    posed.ask.gravity = V3([0.0, -98.1, 0.0]);
    for i in 1..6 {
        for k in 0..5 {
            let angle = 0.05 * 2.4 * i as f64;
            let twist = 0.01 * (k as f64 - 2.0) * i as f64;
            let place = [angle.sin() / 0.05, (1.0 - angle.cos()) / 0.05 + twist];
            posed.leaf.x.set(i, k, V3([place[0], place[1], posed.leaf.x.at(i, k).0[2]]));
        }
    }
    let mut pose = flat_book(&posed.leaf.x);
    let asked = model(&posed.sheet, &posed.leaf, posed.ask);
    let delta = 1e-11;
    let settings =
        SeedSettings { newton: newton + 1, constraint_hessian, delta, ..SeedSettings::default() };
    let mut solver = Box::new(Solver::<f64, Grid>::ZERO);
    let mut report = StepReport::default();
    solver.step(&asked, &settings, &mut pose, &Pose::ZERO, &mut report);
    let largest = |v: &[f64]| v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let (forces, rows) = solver.rhs().split_at(UNKNOWNS);
    [largest(forces), largest(rows)]
}

#[test]
fn the_constraint_hessian_acts_from_the_second_newton_step_on() {
    for newton in 0..10 {
        let [without, with] = [false, true].map(|on| left_after(newton, on));
        println!("after {newton} Newton steps: without {without:?}, with {with:?}");
        if newton < 2 {
            assert_eq!(without, with, "the first step knows no multipliers");
        } else {
            assert_ne!(without, with, "from the second on they count");
        }
    }
}

#[test]
fn newton_converges_quadratically_only_with_the_constraint_hessian() {
    let [without, with] = [false, true].map(|on| left_after(8, on));
    assert!(with[0] < 1e-6 && with[1] < 1e-10, "{with:?}");
    assert!(without[0] > 100.0 * with[0], "{without:?} without, {with:?} with");
}
