//! The factor's kernels one number at a time: the same sums as [`tile`](super::tile), to the bit, where
//! there is no vector unit. Blocks of four by four stay in registers.

use super::solve::tree;
use super::tile::pivot;
use crate::real::{LANES, Real};

/// Rows and columns whose sums are kept in registers.
const QUAD: usize = 4;
/// A block of eight by eight, column by column.
type Block<R> = [R; LANES * LANES];

/// `block = (block - own · factorsᵀ) · inverseᵀ`.
#[inline(never)]
pub(super) fn eliminate<R: Real>(block: &mut [R], own: &[R], factors: &[R], inverse: &[R]) {
    let Some(block) = block.first_chunk_mut() else { return };
    let Some(inverse) = inverse.first_chunk() else { return };
    let ((own, _), (factors, _)) = (own.as_chunks(), factors.as_chunks());
    subtract::<R, 0, 0>(block, own, factors);
    subtract::<R, QUAD, 0>(block, own, factors);
    subtract::<R, 0, QUAD>(block, own, factors);
    subtract::<R, QUAD, QUAD>(block, own, factors);
    times_transposed(block, inverse);
}

/// `block = (factor of (block - own · ownᵀ))⁻¹`, row by row; how many pivots were replaced.
#[inline(never)]
pub(super) fn factor_diagonal<R: Real>(block: &mut [R], own: &[R]) -> u32 {
    let Some(block) = block.first_chunk_mut() else { return 0 };
    let entries = core::array::from_fn(|j| get(block, j, j));
    let (own, _) = own.as_chunks();
    subtract::<R, 0, 0>(block, own, own);
    subtract::<R, QUAD, 0>(block, own, own);
    subtract::<R, QUAD, QUAD>(block, own, own);
    invert_factor(block, &entries)
}

#[inline(always)]
fn get<R: Real>(block: &Block<R>, row: usize, column: usize) -> R {
    block.get(column * LANES + row).copied().unwrap_or(R::ZERO)
}
#[inline(always)]
fn set<R: Real>(block: &mut Block<R>, row: usize, column: usize, value: R) {
    if let Some(slot) = block.get_mut(column * LANES + row) {
        *slot = value;
    }
}

/// `block[I.., J..] -= Σ_k own[I.., k] · upper[J.., k]` for four rows and columns, `k` ascending.
#[inline(never)]
fn subtract<R: Real, const I: usize, const J: usize>(
    block: &mut Block<R>,
    own: &[[R; LANES]],
    upper: &[[R; LANES]],
) {
    let (columns, _) = block.as_chunks_mut::<LANES>();
    let mut acc = [[R::ZERO; QUAD]; QUAD];
    for (a, column) in acc.iter_mut().zip(columns.iter().skip(J)) {
        *a = quad::<R, I>(column);
    }
    for (rows, factors) in own.iter().zip(upper) {
        let (rows, factors) = (quad::<R, I>(rows), quad::<R, J>(factors));
        for (column, f) in acc.iter_mut().zip(factors) {
            for (a, x) in column.iter_mut().zip(rows) {
                *a -= x * f;
            }
        }
    }
    for (a, column) in acc.iter().zip(columns.iter_mut().skip(J)) {
        if let Some(four) = column.get_mut(I..I + QUAD) {
            four.copy_from_slice(a);
        }
    }
}

/// Four numbers of a column.
#[inline(always)]
fn quad<R: Real, const I: usize>(column: &[R; LANES]) -> [R; QUAD] {
    core::array::from_fn(|m| column.get(I + m).copied().unwrap_or(R::ZERO))
}

/// `block · inverseᵀ`, row by row: entry `j` is `Σ_{m ≤ j} block[m] · inverse[j, m]`.
#[inline(always)]
fn times_transposed<R: Real>(block: &mut Block<R>, inverse: &Block<R>) {
    for r in 0..LANES {
        let row: [R; LANES] = core::array::from_fn(|m| get(block, r, m));
        for j in 0..LANES {
            let (Some(known), Some(factors)) = (row.get(..=j), inverse.get(j * LANES..)) else {
                continue;
            };
            let sum = known.iter().zip(factors).fold(R::ZERO, |sum, (&t, &f)| sum + t * f);
            set(block, r, j, sum);
        }
    }
}

/// Inverse of the Cholesky factor of the block, row by row, in its place.
///
/// Column `j` of the block becomes column `j` of `L` and is taken out of the columns after it; row `j` of the
/// inverse follows from the rows before it.
#[inline(never)]
fn invert_factor<R: Real>(block: &mut Block<R>, entries: &[R; LANES]) -> u32 {
    let mut inverse = [[R::ZERO; LANES]; LANES];
    let mut replaced = 0;
    let (columns, _) = block.as_chunks_mut::<LANES>();
    for (j, &entry) in entries.iter().enumerate() {
        let (done, rest) = columns.split_at_mut_checked(j).unwrap_or_default();
        let Some((own, after)) = rest.split_first_mut() else { continue };
        let (used, bad) = pivot(own.get(j).copied().unwrap_or(R::ZERO), entry);
        let scale = R::of(1.0) / used.root();
        replaced += u32::from(bad);
        own.iter_mut().skip(j).for_each(|v| *v *= scale);
        for (m, column) in (j + 1..).zip(after) {
            let factor = own.get(m).copied().unwrap_or(R::ZERO);
            let pairs = column.iter_mut().zip(own.iter()).skip(m);
            pairs.for_each(|(c, &l)| *c -= l * factor);
        }
        let (known, rest) = inverse.split_at_mut_checked(j).unwrap_or_default();
        let Some(row) = rest.first_mut() else { continue };
        if let Some(own) = row.get_mut(j) {
            *own = R::of(1.0);
        }
        for (m, (known, column)) in known.iter().zip(done).enumerate() {
            let factor = column.get(j).copied().unwrap_or(R::ZERO);
            row.iter_mut().zip(known).take(m + 1).for_each(|(r, &k)| *r -= k * factor);
        }
        row.iter_mut().take(j + 1).for_each(|r| *r *= scale);
    }
    columns.copy_from_slice(&inverse);
    replaced
}

/// `L_pp⁻¹ (b - Σ_k L_pk y_k)` of one panel, four partial sums a row.
#[inline(never)]
pub(super) fn forward<R: Real>(panel: &[R], known: &[R], b: [R; LANES]) -> [R; LANES] {
    let (columns, _) = panel.as_chunks::<{ QUAD * LANES }>();
    let (known, _) = known.as_chunks::<QUAD>();
    let one = partial::<R, 0>(columns, known);
    let two = partial::<R, 1>(columns, known);
    let three = partial::<R, 2>(columns, known);
    let four = partial::<R, 3>(columns, known);
    let mut rest = b;
    for ((((rest, a), b), c), d) in rest.iter_mut().zip(one).zip(two).zip(three).zip(four) {
        *rest -= (a + b) + (c + d);
    }
    let Some(inverse) = inverse(panel) else { return b };
    core::array::from_fn(|j| {
        tree(core::array::from_fn(|m| get(inverse, m, j) * rest.get(m).copied().unwrap_or(R::ZERO)))
    })
}

/// `Σ L_pk y_k` over every fourth column from the `N`-th.
#[inline(never)]
fn partial<R: Real, const N: usize>(
    columns: &[[R; QUAD * LANES]],
    known: &[[R; QUAD]],
) -> [R; LANES] {
    let mut sum = [R::ZERO; LANES];
    for (four, y) in columns.iter().zip(known) {
        let y = y.get(N).copied().unwrap_or(R::ZERO);
        let column: [R; LANES] =
            core::array::from_fn(|r| four.get(N * LANES + r).copied().unwrap_or(R::ZERO));
        sum.iter_mut().zip(column).for_each(|(s, l)| *s += l * y);
    }
    sum
}

/// `L_pp⁻ᵀ y`.
#[inline(never)]
pub(super) fn backward<R: Real>(panel: &[R], y: [R; LANES]) -> [R; LANES] {
    let Some(inverse) = inverse(panel) else { return y };
    core::array::from_fn(|m| {
        tree(core::array::from_fn(|j| get(inverse, m, j) * y.get(j).copied().unwrap_or(R::ZERO)))
    })
}

/// Takes a panel's share out of the earlier unknowns it touches.
#[inline(never)]
pub(super) fn take_out<R: Real>(panel: &[R], own: &[R; LANES], touched: &mut [R]) {
    let (columns, _) = panel.as_chunks::<LANES>();
    for (x, column) in touched.iter_mut().zip(columns) {
        *x -= tree(core::array::from_fn(|r| {
            column.get(r).copied().unwrap_or(R::ZERO) * own.get(r).copied().unwrap_or(R::ZERO)
        }));
    }
}

/// The inverse of a panel's diagonal block, row by row.
fn inverse<R: Real>(panel: &[R]) -> Option<&Block<R>> {
    panel.last_chunk()
}
