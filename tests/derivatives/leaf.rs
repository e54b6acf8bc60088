//! The whole leaf: what a step assembles is the gradient of the merit the line search judges by, and
//! `H + JᵀJ/δ`.

use dogleaf_core::constraint::dog::Star;
use dogleaf_core::grid::{G6x5, G11x8, G12x9, Grid};
use dogleaf_core::potential::isometry;
use dogleaf_core::real::{Real, V3};
use dogleaf_core::scene::PaperSpec;
use dogleaf_core::state::Root;
use dogleaf_tests::dense::Dense;
use dogleaf_tests::differences::{self, Doubt, agree, jacobian};
use dogleaf_tests::posed::{Posed, free, seed_paper, unknowns};
use dogleaf_tests::random::Pcg;
use dogleaf_tests::stack::roomy;

/// A part of the merit.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Part {
    Inertia,
    Weight,
    Bending,
    Isometry,
    Stars,
    Contact,
    Hand,
}

const PARTS: [Part; 7] = [
    Part::Inertia,
    Part::Weight,
    Part::Bending,
    Part::Isometry,
    Part::Stars,
    Part::Contact,
    Part::Hand,
];

/// Papers and roots: plate and seed, hinged and clamped.
fn leaves<G: Grid>() -> Vec<Posed<f64, G>> {
    let mut random = Pcg::new(20);
    let clamp = Root::Clamp(V3([0.8, 0.6, 0.0]));
    let kinds = [(PaperSpec::default(), Root::Hinge), (PaperSpec::default(), clamp)];
    let kinds = kinds.into_iter().chain([(seed_paper(), Root::Hinge), (seed_paper(), clamp)]);
    let made = kinds.map(|(paper, root)| {
        let mut posed = Posed::curved(&paper, &mut random);
        posed.ask.root = root;
        posed
    });
    made.collect()
}

/// The leaf with nothing but one part of its merit.
fn only<G: Grid>(posed: &Posed<f64, G>, part: Part) -> Posed<f64, G> {
    let mut one = posed.clone();
    let sheet = &mut one.sheet;
    match part {
        Part::Inertia => one.ask.gravity = V3::zero(),
        Part::Weight => one.aim.copy_from(&one.leaf.x),
        _ => sheet.mass.clear(),
    }
    if part != Part::Bending {
        sheet.across.clear();
        sheet.along.clear();
        sheet.twist.clear();
        sheet.hinge = 0.0;
    }
    if part != Part::Isometry {
        sheet.isometry = [0.0; 2];
    }
    if part != Part::Stars {
        sheet.star.clear();
    }
    if part != Part::Contact {
        one.leaf.holding.clear();
    }
    if part != Part::Hand {
        one.ask.grab = None;
    }
    one
}

fn gradient<G: Grid>(posed: &Posed<f64, G>) -> Vec<f64> {
    unknowns(&posed.assembled().1)
}

fn matrix<G: Grid>(posed: &Posed<f64, G>) -> Dense {
    Dense::of_matrix(&posed.assembled().0)
}

/// Differences of the merit by every free coordinate.
fn slope<G: Grid>(posed: &Posed<f64, G>) -> Vec<f64> {
    differences::gradient(|x| posed.at(x).energy(), &posed.unknowns())
}

/// Differences of the assembled gradient by every free coordinate.
fn slope_of_gradient<G: Grid>(posed: &Posed<f64, G>) -> Vec<f64> {
    jacobian(|x| gradient(&posed.at(x)), &posed.unknowns())
}

fn each_part_is_its_difference<G: Grid>() {
    for posed in leaves::<G>() {
        for part in PARTS {
            let one = only(&posed, part);
            assert_eq!(agree(&gradient(&one), &slope(&one), 1e-8), Ok(()), "{part:?}");
        }
    }
}

#[test]
fn the_gradient_of_each_part_is_the_difference_of_the_merit() {
    roomy(|| {
        each_part_is_its_difference::<G6x5>();
        each_part_is_its_difference::<G11x8>();
        each_part_is_its_difference::<G12x9>();
    });
}

#[test]
fn the_gradient_of_the_whole_leaf_is_the_difference_of_the_merit() {
    roomy(|| {
        for posed in leaves::<G11x8>() {
            assert_eq!(agree(&gradient(&posed), &slope(&posed), 1e-8), Ok(()));
        }
    });
}

#[test]
fn a_gradient_that_forgets_a_part_is_caught() {
    roomy(|| {
        for posed in leaves::<G11x8>() {
            let mut forgetful = posed.clone();
            forgetful.leaf.holding.clear();
            let found = agree(&gradient(&forgetful), &slope(&posed), 1e-8);
            assert!(matches!(found, Err(Doubt::Differs(..))), "{found:?}");
        }
    });
}

fn quadratic_parts_are_exact<G: Grid>() {
    for posed in leaves::<G>() {
        for part in [Part::Inertia, Part::Bending, Part::Contact, Part::Hand] {
            let one = only(&posed, part);
            let found = agree(matrix(&one).numbers(), &slope_of_gradient(&one), 1e-9);
            assert_eq!(found, Ok(()), "{part:?}");
        }
    }
}

#[test]
fn the_matrix_of_each_quadratic_part_is_the_difference_of_its_gradient() {
    roomy(|| {
        quadratic_parts_are_exact::<G6x5>();
        quadratic_parts_are_exact::<G12x9>();
    });
}

#[test]
fn the_matrix_of_isometry_is_exact_on_a_stretched_leaf() {
    roomy(|| {
        for posed in leaves::<G6x5>() {
            let mut one = only(&posed, Part::Isometry);
            one.sheet.spacing = one.sheet.spacing.map(|l| 0.5 * l);
            let found = agree(matrix(&one).numbers(), &slope_of_gradient(&one), 1e-9);
            assert_eq!(found, Ok(()));
        }
    });
}

#[test]
fn the_matrix_of_isometry_is_never_indefinite_on_a_compressed_leaf() {
    roomy(|| {
        for posed in leaves::<G6x5>() {
            let mut one = only(&posed, Part::Isometry);
            one.sheet.spacing = one.sheet.spacing.map(|l| 1.5 * l);
            let projected = matrix(&one);
            assert!(projected.norm() > 0.0);
            assert!(projected.shifted(1e-12).cholesky().is_some());
            let exact = Dense::of(slope_of_gradient(&one));
            assert!(exact.shifted(1e-6).cholesky().is_none(), "the control is indefinite");
        }
    });
}

/// All rows of all stars, unscaled by `δ`.
fn residuals<G: Grid>(posed: &Posed<f64, G>) -> Vec<f64> {
    let x = &posed.leaf.x;
    let inner = (1..G::NX - 1).flat_map(|i| (1..G::NZ - 1).map(move |k| (i, k)));
    let rows = inner.flat_map(|(i, k)| {
        let around = [x.at(i + 1, k), x.at(i, k + 1), x.at(i - 1, k), x.at(i, k - 1)];
        Star::new(x.at(i, k), around).values(posed.sheet.row_scales())
    });
    rows.collect()
}

/// `JᵀJ/δ` with J by differences.
fn stars<G: Grid>(posed: &Posed<f64, G>) -> Dense {
    let j = jacobian(|x| residuals(&posed.at(x)), &posed.unknowns());
    let size = G::UNKNOWNS;
    let column = |n: usize| j.iter().skip(n).step_by(size).copied().collect::<Vec<_>>();
    let columns: Vec<_> = (0..size).map(column).collect();
    let inner = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut dense = Dense::zeros(size);
    for (r, a) in columns.iter().enumerate() {
        for (c, b) in columns.iter().enumerate() {
            *dense.entry(r, c) = inner(a, b) / posed.sheet.delta;
        }
    }
    dense
}

#[test]
fn the_matrix_of_the_stars_is_their_jacobians_square() {
    roomy(|| {
        for posed in leaves::<G12x9>() {
            let found = matrix(&only(&posed, Part::Stars));
            assert_eq!(agree(found.numbers(), stars(&posed).numbers(), 1e-9), Ok(()));
        }
    });
}

/// The projected isometry, edge by edge.
fn isometry_of<G: Grid>(posed: &Posed<f64, G>) -> Dense {
    let mut dense = Dense::zeros(G::UNKNOWNS);
    let [lx, lz] = posed.sheet.spacing;
    for (i, k) in free::<f64, G>() {
        let weights = posed.sheet.isometry;
        add_edge(posed, &mut dense, [(i, k), (i - 1, k)], (lx * lx, weights[0]));
        if k + 1 < G::NZ {
            add_edge(posed, &mut dense, [(i, k), (i, k + 1)], (lz * lz, weights[1]));
        }
    }
    dense
}

fn add_edge<G: Grid>(
    posed: &Posed<f64, G>,
    dense: &mut Dense,
    ends: [(usize, usize); 2],
    (rest_sq, weight): (f64, f64),
) {
    let [a, b] = ends.map(|(i, k)| posed.leaf.x.at(i, k));
    let h = isometry::edge(a - b, rest_sq, weight, false).hessian;
    let unknown = |(i, k): (usize, usize)| (i > 0).then(|| 3 * ((i - 1) * G::NZ + k));
    for (n, m) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let (Some(row), Some(column)) = (unknown(ends[n]), unknown(ends[m])) else { continue };
        let sign = if n == m { 1.0 } else { -1.0 };
        for (c, line) in h.iter().enumerate() {
            for (d, value) in line.iter().enumerate() {
                *dense.entry(row + c, column + d) += sign * value;
            }
        }
    }
}

#[test]
fn the_whole_matrix_is_the_sum_of_its_parts() {
    roomy(|| {
        for posed in leaves::<G11x8>() {
            let quadratic = [Part::Inertia, Part::Bending, Part::Contact, Part::Hand];
            let parts = quadratic.map(|part| matrix(&only(&posed, part)));
            let others = [isometry_of(&posed), stars(&posed)];
            let mut sum = vec![0.0; G11x8::UNKNOWNS * G11x8::UNKNOWNS];
            for part in parts.iter().chain(&others) {
                sum.iter_mut().zip(part.numbers()).for_each(|(s, v)| *s += v);
            }
            assert_eq!(agree(matrix(&posed).numbers(), &sum, 1e-9), Ok(()));
        }
    });
}

fn is_positive_definite<R: Real, G: Grid>(posed: &Posed<R, G>) {
    let (s, _) = posed.assembled();
    assert!(Dense::of_matrix(&s).cholesky().is_some(), "{}", R::NAME);
}

#[test]
fn the_whole_matrix_is_positive_definite() {
    roomy(|| {
        leaves::<G6x5>().iter().for_each(is_positive_definite);
        leaves::<G12x9>().iter().for_each(is_positive_definite);
        let mut random = Pcg::new(21);
        is_positive_definite(&Posed::<f32, G11x8>::curved(&seed_paper(), &mut random));
    });
}

#[test]
fn the_matrix_of_a_flat_leaf_is_positive_definite_though_its_rows_lose_rank() {
    roomy(|| {
        let flat = Posed::<f64, G11x8>::flat(&PaperSpec::default());
        let stars = matrix(&only(&flat, Part::Stars));
        assert!(stars.norm() > 0.0);
        assert!(stars.cholesky().is_none(), "the rows alone leave the leaf free");
        is_positive_definite(&flat);
    });
}
