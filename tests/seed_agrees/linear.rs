//! The sparse factor against a dense one, the generated sizes against what is found, the exported matrix.

use super::{flat_book, model};
use dogleaf_core::grid::{G6x5, G8x6, G11x8, G12x9, G16x12};
use dogleaf_core::seed::{Pose, SeedGrid, SeedSettings, Solver};
use dogleaf_tests::posed::{Posed, seed_paper};
use dogleaf_tests::random::Pcg;

/// A system `K x = b` as it is exported: dense, by rows.
struct Exported {
    n: usize,
    entries: usize,
    k: Vec<f64>,
    b: Vec<f64>,
    /// What the sparse solver makes of it.
    x: Vec<f64>,
}

fn export<G: SeedGrid>(seed: u64, settings: &SeedSettings) -> Exported {
    let posed = Posed::<f64, G>::curved(&seed_paper(), &mut Pcg::new(seed));
    let mut solver = Box::new(Solver::<f64, G>::ZERO);
    let pose = flat_book(&posed.leaf.x);
    solver.linearise(&model(&posed.sheet, &posed.leaf, posed.ask), settings, &pose, &Pose::ZERO);
    assert!(solver.complete(), "slots.rs is stale: run `cargo ci slots`");
    let (n, most) = (G::N, 2 * G::ENTRIES[1] - G::N);
    let (mut starts, mut rows, mut values) = (vec![0; n + 1], vec![0; most], vec![0.0; most]);
    let entries = solver.matrix().export(&mut starts, &mut rows, &mut values).expect("room");
    let mut k = vec![0.0; n * n];
    for column in 0..n {
        let range = starts[column] as usize..starts[column + 1] as usize;
        assert!(rows[range.clone()].is_sorted_by(|a, b| a < b), "rows rise in column {column}");
        range.for_each(|at| k[rows[at] as usize * n + column] = values[at]);
    }
    assert_eq!(starts[n] as usize, entries, "the last start is the count");
    Exported { n, entries, k, b: solver.rhs().to_vec(), x: solver.direction().to_vec() }
}

/// Gaussian elimination with row exchange.
fn solve_dense(n: usize, mut a: Vec<f64>, mut b: Vec<f64>) -> Vec<f64> {
    for c in 0..n {
        let best = (c..n).max_by(|&p, &q| a[p * n + c].abs().total_cmp(&a[q * n + c].abs()));
        let best = best.expect("rows are left");
        (0..n).for_each(|j| a.swap(c * n + j, best * n + j));
        b.swap(c, best);
        let (top, below) = a.split_at_mut((c + 1) * n);
        let pivot = &top[c * n..];
        for (row, line) in below.chunks_mut(n).enumerate().filter(|(_, line)| line[c] != 0.0) {
            let f = line[c] / pivot[c];
            line[c..].iter_mut().zip(&pivot[c..]).for_each(|(v, p)| *v -= f * p);
            b[c + 1 + row] -= f * b[c];
        }
    }
    for c in (0..n).rev() {
        let known: f64 = (c + 1..n).map(|j| a[c * n + j] * b[j]).sum();
        b[c] = (b[c] - known) / a[c * n + c];
    }
    b
}

fn largest(v: impl IntoIterator<Item = f64>) -> f64 {
    v.into_iter().fold(0.0, |m, x| if x.is_nan() { f64::INFINITY } else { f64::max(m, x.abs()) })
}

fn agrees_with_dense<G: SeedGrid>(settings: &SeedSettings) {
    for seed in 0..3 {
        let found = export::<G>(seed, settings);
        let n = found.n;
        for at in 0..n * n {
            let (r, c) = (at / n, at % n);
            assert!(found.k[at].to_bits() == found.k[c * n + r].to_bits(), "symmetric at {r} {c}");
        }
        let expected = solve_dense(n, found.k.clone(), found.b.clone());
        assert!(largest(expected.iter().copied()) > 1e-3, "a solution that is zero proves nothing");
        let unknowns = n - multipliers::<G>();
        for part in [0..unknowns, unknowns..n] {
            let scale = largest(expected[part.clone()].iter().copied());
            let gap = largest(part.map(|i| found.x[i] - expected[i])) / scale;
            assert!(gap < 1e-9, "{} of {n}: {gap:.1e}", if gap.is_nan() { "NaN" } else { "gap" });
        }
    }
}

fn multipliers<G: SeedGrid>() -> usize {
    3 * (G::NX - 2) * (G::NZ - 2) + 15 + 2 * (G::NZ + 1) + 2
}

#[test]
fn the_sparse_factor_agrees_with_a_dense_one() {
    for (exact, lock_spine) in [(true, false), (true, true), (false, false)] {
        let settings = SeedSettings { exact, lock_spine, ..SeedSettings::default() };
        agrees_with_dense::<G6x5>(&settings);
        agrees_with_dense::<G11x8>(&settings);
    }
}

#[test]
fn the_generated_sizes_are_those_found_on_every_grid() {
    fn ask<G: SeedGrid>() {
        for (at, constraint_hessian) in [false, true].into_iter().enumerate() {
            let settings = SeedSettings { constraint_hessian, ..SeedSettings::default() };
            let found = export::<G>(1, &settings);
            assert_eq!(found.entries, 2 * G::ENTRIES[at] - G::N, "entries of both triangles");
            if !constraint_hessian {
                println!(
                    "{:2} x {:2}: n {}, nnz(K) {}, nnz(L) {}",
                    G::NX,
                    G::NZ,
                    G::N,
                    found.entries,
                    G::FILL[0]
                );
            }
        }
        let mut order = G::ORDER.to_vec();
        order.sort_unstable();
        assert!(order.iter().enumerate().all(|(at, &i)| at == usize::from(i)), "a permutation");
        assert_eq!(order.len(), G::N, "of every unknown and multiplier");
    }
    ask::<G6x5>();
    ask::<G8x6>();
    ask::<G11x8>();
    ask::<G12x9>();
    ask::<G16x12>();
}

#[test]
fn a_buffer_too_short_is_refused() {
    let posed = Posed::<f64, G6x5>::curved(&seed_paper(), &mut Pcg::new(1));
    let mut solver = Box::new(Solver::<f64, G6x5>::ZERO);
    let pose = flat_book(&posed.leaf.x);
    let asked = model(&posed.sheet, &posed.leaf, posed.ask);
    solver.linearise(&asked, &SeedSettings::default(), &pose, &Pose::ZERO);
    let most = 2 * G6x5::ENTRIES[0] - G6x5::N;
    let ask = |starts: usize, entries: usize| {
        let (mut s, mut r, mut v) = (vec![0; starts], vec![0; entries], vec![0.0; entries]);
        solver.matrix().export(&mut s, &mut r, &mut v)
    };
    assert_eq!(ask(G6x5::N + 1, most), Some(most), "just enough");
    assert_eq!(ask(G6x5::N, most), None, "no room for the starts");
    assert_eq!(ask(G6x5::N + 1, most - 1), None, "no room for the entries");
}
