//! The chain of a page block: its step solves `(H + JᵀJ/δ) dx = -(g + JᵀC/δ)`.

use super::v2;
use dogleaf_core::constraint::length;
use dogleaf_core::potential::{bending, contact, glue};
use dogleaf_core::real::{V2, V3};
use dogleaf_core::state::strip::{BLOCK, Fibre, Strip};
use dogleaf_core::step::strip::{StripAsk, step};
use dogleaf_tests::dense::Dense;
use dogleaf_tests::differences::{agree, gradient, jacobian};
use dogleaf_tests::random::Pcg;

const ASK: StripAsk<f64> =
    StripAsk { h: 1.0 / 60.0, keep: 0.98, gravity: V2([0.0, -98.1]), delta: 1e-6, contact: 4000.0 };
const FIBRE: Fibre<f64> = Fibre { edge: 2.0, mass: 0.15, bend: 7.0, glue: 600.0 };
/// Free coordinates of a block.
const FREE: usize = 2 * (BLOCK - 1);

/// A bent, moving block with contacts.
fn bent(random: &mut Pcg) -> Strip<f64, BLOCK> {
    let mut strip = Strip::ZERO;
    strip.lay(1.0, 12.0);
    for n in 1..BLOCK {
        let small = |r: &mut Pcg| V2([0.05 * r.within(-1.0, 1.0), 0.1 * r.within(-1.0, 1.0)]);
        strip.x[n] = strip.x[n] + small(random);
        strip.v[n] = small(random) * 10.0;
        strip.pushed[n] = V2([0.6, 0.8]);
        strip.offset[n] = strip.pushed[n].dot(strip.x[n]) + 0.01;
        strip.holding[n] = f64::from(u8::from(n % 2 == 0));
    }
    strip
}

/// Places of all nodes from the free coordinates.
fn places(strip: &Strip<f64, BLOCK>, free: &[f64]) -> [V2<f64>; BLOCK] {
    core::array::from_fn(|n| if n == 0 { strip.x[0] } else { v2(free, n - 1) })
}

fn mass(n: usize) -> f64 {
    if n + 1 == BLOCK { 0.5 * FIBRE.mass } else { FIBRE.mass }
}

/// Inertia and potentials; quadratic, as the glue is.
fn energy(strip: &Strip<f64, BLOCK>, free: &[f64]) -> f64 {
    let x = places(strip, free);
    let node = |n: usize| {
        let aim = strip.x[n] + strip.v[n] * (ASK.h * ASK.keep);
        let inertia = 0.5 * mass(n) / (ASK.h * ASK.h) * (x[n] - aim).norm_sq();
        let on = strip.holding[n] * ASK.contact;
        inertia - mass(n) * ASK.gravity.dot(x[n])
            + contact::value(x[n], strip.pushed[n], strip.offset[n], on)
    };
    let flat = |p: V2<f64>| V3([p.0[0], p.0[1], 0.0]);
    let bend = |w: &[V2<f64>; 3]| {
        bending::second(flat(w[1]), flat(w[2]), flat(w[0]), FIBRE.bend).norm_sq()
    };
    (1..BLOCK).map(node).sum::<f64>()
        + x.array_windows().map(bend).sum::<f64>()
        + glue::edge(x[1] - x[0], V2([0.0, 1.0]), FIBRE.edge, FIBRE.glue).value
}

fn rows(strip: &Strip<f64, BLOCK>, free: &[f64]) -> Vec<f64> {
    let rest_sq = FIBRE.edge * FIBRE.edge;
    let row = |[a, b]: &[V2<f64>; 2]| length::row(*b - *a, rest_sq).0;
    places(strip, free).array_windows().map(row).collect()
}

/// The condensed matrix and right-hand side, by differences.
fn system(strip: &Strip<f64, BLOCK>, free: &[f64]) -> (Dense, Vec<f64>) {
    let slope = |x: &[f64]| gradient(|x| energy(strip, x), x);
    let hessian = jacobian(slope, free);
    let (j, c) = (jacobian(|x| rows(strip, x), free), rows(strip, free));
    let product =
        |n: usize, m: usize| j.chunks(FREE).map(|row| row[n] * row[m]).sum::<f64>() / ASK.delta;
    let matrix = (0..FREE * FREE).map(|n| hessian[n] + product(n / FREE, n % FREE)).collect();
    let push = |n: usize| j.chunks(FREE).zip(&c).map(|(row, c)| row[n] * c).sum::<f64>();
    let right = slope(free).iter().enumerate().map(|(n, g)| -g - push(n) / ASK.delta).collect();
    (Dense::of(matrix), right)
}

#[test]
fn the_step_of_a_chain_solves_its_condensed_system() {
    let mut random = Pcg::new(30);
    for _ in 0..20 {
        let before = bent(&mut random);
        let free: Vec<f64> = before.x.iter().skip(1).flat_map(|p| p.0).collect();
        let (matrix, right) = system(&before, &free);
        let expected = matrix.cholesky().expect("positive definite").solve(&right);
        let mut after = before;
        assert!(step::<f64, BLOCK, FREE>(&mut after, &FIBRE, &ASK));
        let moved = after.x.iter().zip(&before.x).skip(1).flat_map(|(a, b)| (*a - *b).0);
        assert_eq!(agree(&moved.collect::<Vec<_>>(), &expected, 1e-6), Ok(()));
    }
}
