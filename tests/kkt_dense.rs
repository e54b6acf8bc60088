//! Promise: on every grid and in both scalars the factor on its fixed pattern solves what a dense
//! Cholesky solves; the pattern holds every entry once; a bad pivot is replaced and counted.

use dogleaf_core::grid::{G6x5, G8x6, G11x8, G12x9, G16x12, G22x16, G32x24, Grid, Store};
use dogleaf_core::kkt::Factor;
use dogleaf_core::kkt::solve::Unknowns;
use dogleaf_core::real::{LANES, Real};
use dogleaf_core::scene::PaperSpec;
use dogleaf_tests::dense::Dense;
use dogleaf_tests::posed::{Posed, seed_paper};
use dogleaf_tests::random::Pcg;
use dogleaf_tests::stack::roomy;
use std::collections::HashSet;

/// Runs a generic check on every grid in both scalars; the largest only where it is fast enough.
macro_rules! on_every_grid {
    ($check:ident) => {
        roomy(|| {
            on_every_grid!(in_both $check G6x5 G8x6 G11x8 G12x9 G16x12 G22x16);
            if !cfg!(debug_assertions) {
                on_every_grid!(in_both $check G32x24);
            }
        })
    };
    (in_both $check:ident $($grid:ident)+) => {
        $($check::<f32, $grid>(); $check::<f64, $grid>();)+
    };
}

/// Off-diagonal noise, and a diagonal that outweighs its row.
fn dominant<R: Real, G: Grid>(random: &mut Pcg) -> Factor<R, G> {
    let mut s = empty();
    for (row, column) in pattern(&s) {
        let own = if row == column { 45.0 } else { 0.0 };
        s.set(row, column, R::of(random.within(-1.0, 1.0) + own));
    }
    s
}

fn empty<R: Real, G: Grid>() -> Factor<R, G> {
    let mut s = Factor::ZERO;
    s.clear();
    s
}

fn pattern<R: Real, G: Grid>(s: &Factor<R, G>) -> Vec<(usize, usize)> {
    let mut places = Vec::new();
    s.entries(|row, column, _| places.push((row, column)));
    places
}

fn diagonal<R: Real, G: Grid>(mut value: impl FnMut(usize) -> f64) -> Factor<R, G> {
    let mut s = empty();
    (0..G::UNKNOWNS).for_each(|n| s.set(n, n, R::of(value(n))));
    s
}

fn solve<R: Real, G: Grid>(s: &Factor<R, G>, b: &[f64]) -> (Vec<f64>, u32) {
    let (mut factor, mut x) = (s.clone(), Unknowns::<R, G>::ZERO);
    x.numbers_mut().iter_mut().zip(b).for_each(|(x, &b)| *x = R::of(b));
    factor.decompose();
    factor.solve(&mut x);
    let padding = &x.numbers()[G::UNKNOWNS..];
    assert!(padding.iter().all(|&v| v == R::ZERO), "the padding stays empty");
    (x.numbers()[..G::UNKNOWNS].iter().map(|v| v.wide()).collect(), factor.regularised)
}

fn largest(v: &[f64]) -> f64 {
    v.iter().fold(0.0, |m, x| m.max(x.abs()))
}

/// Share of `b` a solution leaves over, measured as backward error.
fn left_over(dense: &Dense, x: &[f64], b: &[f64]) -> f64 {
    let gap: Vec<f64> = dense.times(x).iter().zip(b).map(|(found, b)| found - b).collect();
    largest(&gap) / (dense.norm() * largest(x) + largest(b))
}

fn agrees_with_dense<R: Real, G: Grid>() {
    let mut random = Pcg::new(40);
    let s = dominant::<R, G>(&mut random);
    let dense = Dense::of_matrix(&s);
    let b: Vec<f64> = random.numbers(G::UNKNOWNS).iter().map(|&v| R::of(v).wide()).collect();
    let expected = dense.cholesky().expect("it is dominant").solve(&b);
    let (found, replaced) = solve(&s, &b);
    let gap = found.iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let (share, name) = (gap / largest(&expected), R::NAME);
    assert!(largest(&expected) > 1e-3, "a solution that is zero proves nothing");
    assert!(share < 20.0 * R::EPSILON, "{name} {}x{}: {share:e}", G::NX, G::NZ);
    assert_eq!(replaced, 0, "no pivot is bad");
}

#[test]
fn every_grid_solves_as_a_dense_cholesky_does() {
    on_every_grid!(agrees_with_dense);
}

fn leaves_nothing_over<R: Real, G: Grid>() {
    let mut random = Pcg::new(41);
    for paper in [PaperSpec::default(), seed_paper()] {
        let (s, _) = Posed::<R, G>::curved(&paper, &mut random).assembled();
        let dense = Dense::of_matrix(&s);
        let b: Vec<f64> = random.numbers(G::UNKNOWNS).iter().map(|&v| R::of(v).wide()).collect();
        let (x, replaced) = solve(&s, &b);
        let share = left_over(&dense, &x, &b);
        assert!(share < 20.0 * R::EPSILON, "{} {}x{}: {share:e}", R::NAME, G::NX, G::NZ);
        assert_eq!(replaced, 0, "{} {}x{}", R::NAME, G::NX, G::NZ);
    }
}

#[test]
fn the_matrix_of_a_curved_leaf_is_solved_to_rounding_on_every_grid() {
    on_every_grid!(leaves_nothing_over);
}

#[test]
fn a_wrong_solution_leaves_something_over() {
    let s = dominant::<f64, G6x5>(&mut Pcg::new(42));
    let b = Pcg::new(43).numbers(G6x5::UNKNOWNS);
    let (mut x, _) = solve(&s, &b);
    x[17] *= 1.000_001;
    assert!(left_over(&Dense::of_matrix(&s), &x, &b) > 20.0 * f64::EPSILON);
}

fn pattern_holds<R: Real, G: Grid>() {
    let mut seen = HashSet::new();
    diagonal::<R, G>(|_| 1.0).entries(|row, column, _| {
        let first = usize::from(G::PANELS[row / LANES].first);
        assert!(column <= row && row < G::UNKNOWNS, "({row}, {column}) is in the lower triangle");
        assert!(first <= column, "({row}, {column}) is in its panel's envelope");
        assert!(seen.insert((row, column)), "({row}, {column}) is visited once");
    });
    assert_eq!(seen, pairs::<G>(), "{}x{}", G::NX, G::NZ);
}

/// Pairs of unknowns whose nodes are at most two steps apart, and in one star or one cell.
fn pairs<G: Grid>() -> HashSet<(usize, usize)> {
    let node = |u: usize| (u / 3 / G::NZ, u / 3 % G::NZ);
    let near = |(row, column): &(usize, usize)| {
        let ((i, k), (j, l)) = (node(*row), node(*column));
        i.abs_diff(j) + k.abs_diff(l) <= 2
    };
    let row = |row: usize| (row.saturating_sub(6 * G::NZ + 8)..=row).map(move |c| (row, c));
    (0..G::UNKNOWNS).flat_map(row).filter(near).collect()
}

#[test]
fn every_entry_is_visited_once_and_lies_in_its_panels_envelope() {
    on_every_grid!(pattern_holds);
}

fn panels_are_sound<R: Real, G: Grid>() {
    let mut vectors = 0;
    for (p, panel) in G::PANELS.iter().enumerate() {
        assert_eq!(panel.offset as usize, vectors, "panel {p} begins where the last ended");
        vectors += (p + 1) * LANES - usize::from(panel.first) / LANES * LANES;
    }
    assert_eq!(vectors, G::VECTORS, "the factor is as long as its panels");
    assert_eq!(G::PANELS.len() * LANES, G::ROWS, "panels cover all rows");
    assert!((G::UNKNOWNS..G::UNKNOWNS + LANES).contains(&G::ROWS), "padded to whole panels");
    assert_eq!(
        <G::Factor<R> as Store<R>>::ZERO.as_ref().len(),
        G::VECTORS * LANES,
        "the array is as long"
    );
}

#[test]
fn panels_follow_one_another_without_gaps() {
    on_every_grid!(panels_are_sound);
}

fn counts_bad_pivots<R: Real, G: Grid>() {
    let bad = [1, 8, 20, G::UNKNOWNS - 1];
    for value in [-1.0, 0.0, f64::NAN] {
        let s = diagonal::<R, G>(|n| if bad.contains(&n) { value } else { 4.0 });
        let (x, replaced) = solve(&s, &vec![1.0; G::UNKNOWNS]);
        assert_eq!(replaced, 4, "{value} on the diagonal, {}", R::NAME);
        for (n, x) in x.into_iter().enumerate() {
            assert_eq!(x, if bad.contains(&n) { 1.0 } else { 0.25 }, "unknown {n}");
        }
    }
}

#[test]
fn each_bad_pivot_is_replaced_and_counted() {
    on_every_grid!(counts_bad_pivots);
}

/// Ones but for the pair of unknowns 7 and 8, which is `[[1, off], [off, 1]]`: across two panels.
fn paired<R: Real, G: Grid>(off: f64) -> Factor<R, G> {
    let mut s = diagonal(|_| 1.0);
    s.set(8, 7, R::of(off));
    s
}

fn survives_an_indefinite_matrix<R: Real, G: Grid>() {
    let (x, replaced) = solve(&paired::<R, G>(2.0), &vec![1.0; G::UNKNOWNS]);
    assert_eq!(replaced, 1, "{}", R::NAME);
    assert!(x.iter().all(|v| v.is_finite()), "{}", R::NAME);
    let (_, replaced) = solve(&paired::<R, G>(0.5), &vec![1.0; G::UNKNOWNS]);
    assert_eq!(replaced, 0, "the same pair, definite");
}

#[test]
fn an_indefinite_matrix_is_counted_and_its_solution_finite() {
    on_every_grid!(survives_an_indefinite_matrix);
}

/// A pivot that is rounding's leavings is bad whether its row begins a panel or lies inside one.
#[test]
fn a_pivot_left_over_by_rounding_is_replaced_in_every_place_of_a_panel() {
    let pairs = [(0, 1, 0), (1, 1, 0), (2, 2, 1), (4, 2, 1)];
    for (node, later, earlier) in pairs {
        let mut s = diagonal::<f64, G6x5>(|_| 1.0);
        s.set(3 * node + later, 3 * node + earlier, 1.0 - 1e-9);
        let (_, replaced) = solve(&s, &vec![1.0; G6x5::UNKNOWNS]);
        assert_eq!(replaced, 1, "unknowns {} and {}", 3 * node + earlier, 3 * node + later);
    }
}

#[test]
fn the_count_of_bad_pivots_begins_anew() {
    let mut factor = paired::<f64, G6x5>(2.0);
    factor.decompose();
    assert_eq!(factor.regularised, 1);
    factor.clear();
    (0..G6x5::UNKNOWNS).for_each(|n| factor.set(n, n, 1.0));
    factor.decompose();
    assert_eq!(factor.regularised, 0);
}
