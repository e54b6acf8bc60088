//! The factor's kernels one number at a time: the same sums as [`tile`](super::tile), to the bit, where
//! there is no vector unit. Blocks of four by four stay in registers.

use super::solve::tree;
use super::tile::pivot;
use crate::real::{LANES, Real};

/// Rows and columns whose sums are kept in registers.
const QUAD: usize = 4;
/// A block of eight by eight, column by column.
type Block<R> = [R; LANES * LANES];
/// A column of a panel: its first and its second four rows.
type Column<R> = [[R; QUAD]; 2];
/// Columns that pass between two looks at the end of the loop.
pub(super) const STRIDE: usize = 2;

/// `block = (block - own · factorsᵀ) · inverseᵀ`; of the second four rows of `own` and of `factors` the first
/// `later` columns are zeros. The columns come in whole strides.
#[inline(never)]
pub(super) fn eliminate<R: Real>(
    block: &mut [R],
    own: &[R],
    factors: &[R],
    inverse: &[R],
    [own_later, factors_later]: [usize; 2],
) {
    let Some(block) = block.first_chunk_mut() else { return };
    let Some(inverse) = inverse.first_chunk() else { return };
    let (own, factors) = (columns(own), columns(factors));
    subtract(block, own, factors, 0, [0, 0]);
    subtract(block, own, factors, own_later, [1, 0]);
    subtract(block, own, factors, factors_later, [0, 1]);
    subtract(block, own, factors, own_later.max(factors_later), [1, 1]);
    for r in (0..LANES).step_by(2) {
        times_transposed(block, inverse, r);
    }
}

/// `block = (factor of (block - own · ownᵀ))⁻¹`, row by row; how many pivots were replaced. `later` as
/// [`eliminate`] has it.
#[inline(never)]
pub(super) fn factor_diagonal<R: Real>(block: &mut [R], own: &[R], later: usize) -> u32 {
    let Some(block) = block.first_chunk_mut() else { return 0 };
    let entries = core::array::from_fn(|j| get(block, j, j));
    let own = columns(own);
    subtract(block, own, own, 0, [0, 0]);
    subtract(block, own, own, later, [1, 0]);
    subtract(block, own, own, later, [1, 1]);
    invert_factor(block, &entries)
}

#[inline(always)]
fn columns<R: Real>(numbers: &[R]) -> &[[Column<R>; STRIDE]] {
    numbers.as_chunks::<QUAD>().0.as_chunks().0.as_chunks().0
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

/// `block[i, j] -= Σ_k own[i, k] · upper[j, k]` for a quarter of the block, `k` ascending from the stride `from` is in.
#[inline(never)]
fn subtract<R: Real>(
    block: &mut Block<R>,
    own: &[[Column<R>; STRIDE]],
    upper: &[[Column<R>; STRIDE]],
    from: usize,
    [i, j]: [usize; 2],
) {
    let (halves, _) = block.as_chunks_mut::<QUAD>();
    let (columns, _) = halves.as_chunks_mut::<2>();
    let Some(columns) = columns.get_mut(j * QUAD..).and_then(<[_]>::first_chunk_mut::<QUAD>) else {
        return;
    };
    let mut acc = columns.each_ref().map(|column| column[i % 2]);
    let own = own.get(from / STRIDE..).unwrap_or(&[]);
    let upper = upper.get(from / STRIDE..).unwrap_or(&[]);
    for (own, upper) in own.iter().zip(upper) {
        for (rows, factors) in own.iter().zip(upper) {
            take_product(&mut acc, &rows[i % 2], &factors[j % 2]);
        }
    }
    for (column, sums) in columns.iter_mut().zip(acc) {
        column[i % 2] = sums;
    }
}

#[inline(always)]
fn take_product<R: Real>(acc: &mut [[R; QUAD]; QUAD], rows: &[R; QUAD], factors: &[R; QUAD]) {
    for (column, &f) in acc.iter_mut().zip(factors) {
        for (a, &x) in column.iter_mut().zip(rows) {
            *a -= x * f;
        }
    }
}

/// Rows `r` and `r + 1` of `block · inverseᵀ`: entry `j` is `Σ_{m ≤ j} block[m] · inverse[j, m]`. Not inlined:
/// the loop over the rows would keep the inverse's numbers on the stack.
#[inline(never)]
fn times_transposed<R: Real>(block: &mut Block<R>, inverse: &Block<R>, r: usize) {
    let rows: [[R; 2]; LANES] = core::array::from_fn(|m| [get(block, r, m), get(block, r + 1, m)]);
    for j in 0..LANES {
        let factors = inverse.get(j * LANES..).unwrap_or(&[]);
        let mut sums = [R::ZERO; 2];
        for (row, &f) in rows.iter().zip(factors).take(j + 1) {
            sums[0] += row[0] * f;
            sums[1] += row[1] * f;
        }
        set(block, r, j, sums[0]);
        set(block, r + 1, j, sums[1]);
    }
}

/// Inverse of the Cholesky factor of the block, row by row, in its place.
#[inline(never)]
fn invert_factor<R: Real>(block: &mut Block<R>, entries: &[R; LANES]) -> u32 {
    let mut replaced = 0;
    replaced += invert_column::<R, 0>(block, entries);
    replaced += invert_column::<R, 1>(block, entries);
    replaced += invert_column::<R, 2>(block, entries);
    replaced += invert_column::<R, 3>(block, entries);
    replaced += invert_column::<R, 4>(block, entries);
    replaced += invert_column::<R, 5>(block, entries);
    replaced += invert_column::<R, 6>(block, entries);
    replaced += invert_column::<R, 7>(block, entries);
    for c in 0..LANES {
        for r in c + 1..LANES {
            set(block, r, c, R::ZERO);
        }
    }
    replaced
}

/// Column `J` of the block becomes column `J` of `L` and is taken out of the columns after it; row `J` of the
/// inverse follows from the rows before it and lies where `Lᵀ` would. The trip counts are constants: no loop is
/// left.
#[inline(always)]
fn invert_column<R: Real, const J: usize>(block: &mut Block<R>, entries: &[R; LANES]) -> u32 {
    let entry = entries.get(J).copied().unwrap_or(R::ZERO);
    let (used, bad) = pivot(get(block, J, J), entry);
    let scale = R::of(1.0) / used.root();
    let own: [R; LANES] =
        core::array::from_fn(|r| if r > J { get(block, r, J) * scale } else { R::ZERO });
    for m in J + 1..LANES {
        set(block, m, J, own[m]);
        for r in m..LANES {
            set(block, r, m, get(block, r, m) - own[r] * own[m]);
        }
    }
    let mut row = [R::ZERO; LANES];
    row[J] = R::of(1.0);
    for m in 0..J {
        let factor = get(block, J, m);
        for (c, v) in row.iter_mut().enumerate().take(m + 1) {
            *v -= get(block, c, m) * factor;
        }
    }
    for (c, &v) in row.iter().enumerate().take(J + 1) {
        set(block, c, J, v * scale);
    }
    u32::from(bad)
}

/// `L_pp⁻¹ (b - Σ_k L_pk y_k)` of one panel, four partial sums a row.
#[inline(never)]
pub(super) fn forward<R: Real>(panel: &[R], known: &[R], b: [R; LANES]) -> [R; LANES] {
    let (columns, _) = panel.as_chunks::<LANES>();
    let (columns, _) = columns.as_chunks();
    let (known, _) = known.as_chunks();
    let [one, two, three, four] = [0, 1, 2, 3].map(|n| partial(columns, known, n));
    let mut rest = b;
    for ((((rest, a), b), c), d) in rest.iter_mut().zip(one).zip(two).zip(three).zip(four) {
        *rest -= (a + b) + (c + d);
    }
    let Some(inverse) = inverse(panel) else { return b };
    core::array::from_fn(|j| {
        tree(core::array::from_fn(|m| get(inverse, m, j) * rest.get(m).copied().unwrap_or(R::ZERO)))
    })
}

/// `Σ L_pk y_k` over every fourth column from the `n`-th.
#[inline(never)]
fn partial<R: Real>(columns: &[[[R; LANES]; QUAD]], known: &[[R; QUAD]], n: usize) -> [R; LANES] {
    let mut sum = [R::ZERO; LANES];
    for (four, y) in columns.iter().zip(known) {
        let (column, y) = (four[n % QUAD], y[n % QUAD]);
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
