//! `Σ λ_l ∇²C_l`: the constraint Hessian, which the seed leaves out.
//!
//! For one DOG row `C = s (⟨a,b⟩|c| - ⟨b,c⟩|a|)` with unit vectors `â`, `ĉ`:
//!
//! ```text
//! ∂²C/∂a² = -s ⟨b,c⟩ (I - â âᵀ)/|a|     ∂²C/∂a∂b = s (|c| I - â cᵀ)
//! ∂²C/∂c² =  s ⟨a,b⟩ (I - ĉ ĉᵀ)/|c|     ∂²C/∂b∂c = s (a ĉᵀ - |a| I)
//! ∂²C/∂b² =  0                          ∂²C/∂a∂c = s (b ĉᵀ - â bᵀ)
//! ```
//!
//! A length row has `2/r I` by its edge. Source: Book Eq. 3; derivatives ours. Checked by `tests/seed_agrees.rs`.

use crate::constraint::dog::{ROWS, Star};
use crate::real::{Num, V3};

/// A 3x3 block, by rows.
pub type Block<T> = [[T; 3]; 3];

/// `Σ λ_r ∇²C_r` of one star by its arms `x⁺, z⁺, x⁻, z⁻` and its centre: all 25 blocks.
///
/// # Shapes and units
///
/// `scales`: `1/l³` of each row, as [`Star::rows`] takes them. `lambda`: the rows' multipliers.
pub fn star<T: Num>(star: &Star<T>, scales: [T; 3], lambda: [T; 3]) -> [[Block<T>; 5]; 5] {
    let mut sum = [[[[T::zero(); 3]; 3]; 5]; 5];
    for ((named, s), l) in ROWS.into_iter().zip(scales).zip(lambda) {
        let pick = |n: usize| (star.arms.get(n), star.lengths.get(n));
        let [(Some(&a), Some(&la)), (Some(&b), _), (Some(&c), Some(&lc))] = named.map(pick) else {
            continue;
        };
        add_row(&mut sum, named, &row([a, b, c], [la, lc], s * l));
    }
    sum
}

/// `λ 2/r`, the factor of `I` in `λ ∇²C` of a length row by its edge.
pub fn length<T: Num>(rest_sq: T, lambda: T) -> T {
    T::of(2.0) * lambda / rest_sq
}

/// Blocks of one row by its three arms: `aa, ab, ac, bc, cc`; `bb` is nothing.
fn row<T: Num>([a, b, c]: [V3<T>; 3], [la, lc]: [T; 2], s: T) -> [Block<T>; 5] {
    let (ua, uc) = (a * (T::one() / la), c * (T::one() / lc));
    let (ab, bc) = (a.dot(b), b.dot(c));
    let across = |u: V3<T>, f: T| plus(&scaled(f), &outer(u, u * -f));
    [
        across(ua, -(s * bc / la)),
        plus(&scaled(s * lc), &outer(ua, c * -s)),
        plus(&outer(b, uc * s), &outer(ua, b * -s)),
        plus(&outer(a, uc * s), &scaled(-(s * la))),
        across(uc, s * ab / lc),
    ]
}

/// Spreads a row's blocks by edges over its nodes; the centre moves against all three arms.
fn add_row<T: Num>(sum: &mut [[Block<T>; 5]; 5], [a, b, c]: [usize; 3], h: &[Block<T>; 5]) {
    let [aa, ab, ac, bc, cc] = h;
    let pairs = [
        (a, a, *aa),
        (a, b, *ab),
        (b, a, transposed(ab)),
        (a, c, *ac),
        (c, a, transposed(ac)),
        (b, c, *bc),
        (c, b, transposed(bc)),
        (c, c, *cc),
    ];
    for (n, m, block) in pairs {
        let against = block.map(|line| line.map(|v| -v));
        for (i, j, part) in [(n, m, block), (n, 4, against), (4, m, against), (4, 4, block)] {
            if let Some(slot) = sum.get_mut(i).and_then(|line| line.get_mut(j)) {
                *slot = plus(slot, &part);
            }
        }
    }
}

fn outer<T: Num>(a: V3<T>, b: V3<T>) -> Block<T> {
    a.0.map(|a| b.0.map(|b| a * b))
}

fn scaled<T: Num>(d: T) -> Block<T> {
    let o = T::zero();
    [[d, o, o], [o, d, o], [o, o, d]]
}

fn plus<T: Num>(a: &Block<T>, b: &Block<T>) -> Block<T> {
    let mut sum = *a;
    for (line, other) in sum.iter_mut().zip(b) {
        for (v, &o) in line.iter_mut().zip(other) {
            *v = *v + o;
        }
    }
    sum
}

fn transposed<T: Num>([[a, b, c], [d, e, f], [g, h, i]]: &Block<T>) -> Block<T> {
    [[*a, *d, *g], [*b, *e, *h], [*c, *f, *i]]
}
