//! Rows of C, each by every point it names.

use super::{CLOSE, TRIES, v2, v3};
use dogleaf_core::constraint::{binding, dog, fix, length};
use dogleaf_core::real::V2;
use dogleaf_tests::differences::{agree, gradient, jacobian};
use dogleaf_tests::random::Pcg;

/// A star from five nodes: centre, `x⁺`, `z⁺`, `x⁻`, `z⁻`.
fn star(x: &[f64]) -> dog::Star<f64> {
    dog::Star::new(v3(x, 0), [v3(x, 1), v3(x, 2), v3(x, 3), v3(x, 4)])
}

/// The three rows by all five nodes.
fn star_rows(x: &[f64], scales: [f64; 3]) -> Vec<f64> {
    let mut numbers = vec![0.0; 45];
    for ((r, row), named) in star(x).rows(scales).iter().enumerate().zip(dog::ROWS) {
        for (arm, g) in named.into_iter().zip(&row.gradient) {
            for (c, value) in g.0.into_iter().enumerate() {
                numbers[15 * r + 3 * (arm + 1) + c] += value;
                numbers[15 * r + c] -= value;
            }
        }
    }
    numbers
}

#[test]
fn each_dog_row_is_its_differences_by_all_five_nodes() {
    let mut random = Pcg::new(4);
    for _ in 0..TRIES {
        let (x, scales) = (random.numbers(15), [0.7, 1.3, 2.0]);
        let expected = jacobian(|x| star(x).values(scales).to_vec(), &x);
        let found = star_rows(&x, scales);
        for (row, differences) in found.chunks(15).zip(expected.chunks(15)) {
            assert_eq!(agree(row, differences, CLOSE), Ok(()), "at {x:?}");
        }
    }
}

#[test]
fn the_two_values_of_a_dog_row_are_one() {
    let x = Pcg::new(5).numbers(15);
    let scales = [0.7, 1.3, 2.0];
    assert_eq!(star(&x).values(scales), star(&x).rows(scales).map(|r| r.value));
}

#[test]
fn dog_rows_vanish_on_a_rolled_star_and_not_on_a_sheared_one() {
    let rolled = [0.0, 0.0, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 2.0, -0.8, 0.6, 0.0, 0.0, 0.0, -2.0];
    assert!(star(&rolled).values([1.0; 3]).iter().all(|c| c.abs() < 1e-15));
    let mut sheared = rolled;
    sheared[8] = 1.0;
    sheared[6] = 1.0;
    assert!(star(&sheared).values([1.0; 3]).iter().any(|c| c.abs() > 0.1));
}

#[test]
fn the_length_row_is_its_differences() {
    let mut random = Pcg::new(6);
    for _ in 0..TRIES {
        let (x, rest_sq) = (random.numbers(4), random.within(0.5, 4.0));
        let edge = |x: &[f64]| v2(x, 0) - v2(x, 1);
        let g = length::row(edge(&x), rest_sq).1;
        let found: Vec<f64> = g.0.into_iter().chain((-g).0).collect();
        let expected = gradient(|x| length::row(edge(x), rest_sq).0, &x);
        assert_eq!(agree(&found, &expected, CLOSE), Ok(()));
    }
}

/// A row whose derivatives by each of its points are the same number for X and Y.
fn agree_by_points(points: &[f64], residual: impl Fn(&[f64]) -> V2<f64>, x: &[f64]) {
    let count = x.len();
    let entry = |c: usize, n: usize| if n % 2 == c { points[n / 2] } else { 0.0 };
    let found: Vec<f64> = (0..2 * count).map(|n| entry(n / count, n % count)).collect();
    assert_eq!(agree(&found, &jacobian(|x| residual(x).0.to_vec(), x), CLOSE), Ok(()), "{x:?}");
}

#[test]
fn the_binding_row_is_its_differences() {
    let mut random = Pcg::new(8);
    for q in [0.0, 0.25, 0.5, 1.0] {
        let residual = |x: &[f64]| binding::residual(v2(x, 0), v2(x, 1), v2(x, 2), q);
        agree_by_points(&binding::gradient(q), residual, &random.numbers(6));
    }
}

#[test]
fn the_fix_row_is_its_differences() {
    let centre = V2([0.3, -0.2]);
    let residual = |x: &[f64]| fix::residual(v2(x, 0), v2(x, 1), centre);
    agree_by_points(&[fix::gradient(); 2], residual, &Pcg::new(9).numbers(4));
}
