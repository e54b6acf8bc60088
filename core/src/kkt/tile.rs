//! Blocks of eight by eight with eight lanes: the factor's kernels where there is a vector unit.

use super::factor::SMALLEST_PIVOT;
use crate::real::{Eight, LANES, Lanes, Num, Real};

/// Eight columns of a block, as vectors over its rows.
pub(super) type Tile<R> = [<R as Real>::Eight; LANES];

/// `block = (block - own · factorsᵀ) · inverseᵀ`, `own` and `factors` column by column.
#[inline(always)]
pub(super) fn eliminate<R: Real>(block: &mut [R], own: &[R], factors: &[R], inverse: &[R]) {
    let mut tile = load::<R>(block);
    subtract::<R>(&mut tile, own, factors);
    store::<R>(&times_transposed::<R>(&tile, &load::<R>(inverse)), block);
}

/// `block = (factor of (block - own · ownᵀ))⁻¹`, row by row; how many pivots were replaced.
///
/// A pivot is small against the matrix's own entry, what it was before elimination.
#[inline(always)]
pub(super) fn factor_diagonal<R: Real>(block: &mut [R], own: &[R]) -> u32 {
    let mut tile = load::<R>(block);
    let diagonal =
        core::array::from_fn(|j| tile.get(j).map_or(R::ZERO, |c| lane::<R>(&c.array(), j)));
    subtract::<R>(&mut tile, own, own);
    let (inverse, replaced) = invert_factor::<R>(&tile, &diagonal);
    store::<R>(&inverse, block);
    replaced
}

#[inline(always)]
pub(super) fn load<R: Real>(from: &[R]) -> Tile<R> {
    match from.first_chunk::<{ LANES * LANES }>() {
        Some(block) => core::array::from_fn(|j| R::Eight::load(block, j * LANES)),
        None => [R::Eight::zero(); LANES],
    }
}

#[inline(always)]
fn store<R: Real>(tile: &Tile<R>, to: &mut [R]) {
    if let Some(block) = to.first_chunk_mut::<{ LANES * LANES }>() {
        for (j, lanes) in tile.iter().enumerate() {
            lanes.store(block, j * LANES);
        }
    }
}

/// `tile[:, j] -= Σ_k own[:, k] · upper[j, k]`, columns in ascending order.
#[inline(always)]
fn subtract<R: Real>(tile: &mut Tile<R>, own: &[R], upper: &[R]) {
    let mut acc = *tile;
    let (own, _) = own.as_chunks::<LANES>();
    let (upper, _) = upper.as_chunks::<LANES>();
    for (rows, factors) in own.iter().zip(upper) {
        let rows = R::Eight::from_array(*rows);
        for (a, &f) in acc.iter_mut().zip(factors) {
            *a = *a - rows * R::Eight::all(f);
        }
    }
    *tile = acc;
}

/// `tile · inverseᵀ`: column `j` is `Σ_{m ≤ j} tile[:, m] · inverse[j, m]`.
#[inline(always)]
fn times_transposed<R: Real>(tile: &Tile<R>, inverse: &Tile<R>) -> Tile<R> {
    core::array::from_fn(|j| {
        let row = inverse.get(j).map_or([R::ZERO; LANES], |r| r.array());
        let mut sum = R::Eight::zero();
        for (t, f) in tile.iter().zip(row).take(j + 1) {
            sum = sum + *t * R::Eight::all(f);
        }
        sum
    })
}

/// Inverse of the Cholesky factor of one diagonal block, row by row, and how many pivots were replaced.
#[inline(always)]
fn invert_factor<R: Real>(block: &Tile<R>, diagonal: &[R; LANES]) -> (Tile<R>, u32) {
    let mut work = Inversion {
        columns: block.map(|c| c.array()),
        rows: [R::Eight::zero(); LANES],
        replaced: 0,
    };
    work.column::<0>(diagonal);
    work.column::<1>(diagonal);
    work.column::<2>(diagonal);
    work.column::<3>(diagonal);
    work.column::<4>(diagonal);
    work.column::<5>(diagonal);
    work.column::<6>(diagonal);
    work.column::<7>(diagonal);
    (work.rows, work.replaced)
}

#[inline(always)]
fn lane<R: Real>(values: &[R; LANES], j: usize) -> R {
    values.get(j).copied().unwrap_or(R::ZERO)
}

/// A diagonal block while it becomes its factor's inverse, column by column.
struct Inversion<R: Real> {
    /// What is left of the block, then columns of `L`.
    columns: [[R; LANES]; LANES],
    /// Rows of the inverse found so far.
    rows: Tile<R>,
    replaced: u32,
}

impl<R: Real> Inversion<R> {
    /// Column `J` of `L` and row `J` of its inverse. The trip counts are constants: no loop is left.
    #[inline(always)]
    fn column<const J: usize>(&mut self, diagonal: &[R; LANES]) {
        let own = self.columns.get(J).copied().unwrap_or([R::ZERO; LANES]);
        let (used, bad) = pivot(lane(&own, J), lane(diagonal, J));
        let scale = R::of(1.0) / used.root();
        self.replaced += u32::from(bad);
        let column = (R::Eight::from_array(own) * R::Eight::all(scale)).array();
        for (m, c) in self.columns.iter_mut().enumerate() {
            if m > J {
                let factor = R::Eight::all(lane(&column, m));
                *c = (R::Eight::from_array(*c) - R::Eight::from_array(column) * factor).array();
            }
        }
        let mut row =
            R::Eight::from_array(core::array::from_fn(
                |m| if m == J { R::of(1.0) } else { R::ZERO },
            ));
        for (m, known) in self.rows.iter().enumerate() {
            if m < J {
                let factor = self.columns.get(m).map_or(R::ZERO, |c| lane(c, J));
                row = row - *known * R::Eight::all(factor);
            }
        }
        if let (Some(c), Some(r)) = (self.columns.get_mut(J), self.rows.get_mut(J)) {
            *c = column;
            *r = row * R::Eight::all(scale);
        }
    }
}

/// The pivot to use, and whether the one found was too small against the matrix's own entry.
#[inline(always)]
pub(super) fn pivot<R: Real>(found: R, entry: R) -> (R, bool) {
    let bad = !(found > entry * R::of(SMALLEST_PIVOT) && found > R::ZERO);
    (if bad { entry.magnitude().larger(R::of(1.0)) } else { found }, bad)
}
