//! Cholesky factor `S = L Lᵀ` in panels of eight rows, in place, without a pivot search.
//!
//! A panel holds eight rows of `L` as vectors over its rows, one a column, from the first column any
//! of them touches (the envelope, [`Panel`]) to its diagonal block. The envelope is closed under
//! elimination, so the pattern never changes. Every entry is summed over its columns in ascending
//! order, whatever the width of the target's vectors: the bits do not depend on the blocking.
//!
//! Source: ours. Checked against a dense factorisation by `tests/kkt_dense.rs`.

use super::stencil::Stencil;
use crate::grid::{Grid, Panel, Store};
use crate::real::{LANES, Lanes, Num, Real};

/// A pivot below this share of its diagonal entry is replaced and counted.
const SMALLEST_PIVOT: f64 = 1e-7;

/// The factor, its diagonal blocks' inverses, and how many pivots were replaced.
#[derive(Debug, Clone)]
pub struct Factor<R: Real, G: Grid> {
    panels: G::Factor<R>,
    inverses: G::Inverses<R>,
    /// Pivots of the last factorisation that were not positive enough and were replaced.
    pub regularised: u32,
}

/// Eight columns of one panel, as vectors over its rows.
type Tile<R> = [<R as Real>::Lanes; LANES];

impl<R: Real, G: Grid> Factor<R, G> {
    /// Zeros.
    pub const ZERO: Self = Self {
        panels: <G::Factor<R> as Store<R>>::ZERO,
        inverses: <G::Inverses<R> as Store<R>>::ZERO,
        regularised: 0,
    };

    /// Panel `p`: its first stored column, the first column any of its rows touches, its numbers.
    #[inline(always)]
    pub(super) fn panel(&self, p: usize) -> Rows<'_, R> {
        let place = Place::of::<G>(p);
        Rows { place, numbers: self.panels.as_ref().get(place.start..place.end).unwrap_or(&[]) }
    }
    /// Inverse of the diagonal block of panel `p`, row by row.
    #[inline(always)]
    pub(super) fn inverse(&self, p: usize) -> Tile<R> {
        load_tile(self.inverses.as_ref(), p * LANES * LANES)
    }

    /// Copies `S` into the panels and factors it.
    ///
    /// # Cost
    ///
    /// About 320,000 multiply-adds at 11x8 (exact profile: 238,566); no branch on a value.
    ///
    /// # Hard case
    ///
    /// A pivot that rounding made too small is replaced by its diagonal entry and counted in
    /// [`Factor::regularised`]; the caller reports it.
    pub fn factor(&mut self, s: &Stencil<R, G>) {
        self.fill(s);
        self.regularised = 0;
        for p in 0..G::PANELS.len() {
            self.factor_panel(p);
        }
    }

    fn fill(&mut self, s: &Stencil<R, G>) {
        self.panels.as_mut().fill(R::ZERO);
        for row in G::UNKNOWNS..G::ROWS {
            self.put(row, row, R::one());
        }
        s.entries(|row, column, value| self.put(row, column, value));
    }

    #[inline(always)]
    fn put(&mut self, row: usize, column: usize, value: R) {
        let place = Place::of::<G>(row / LANES);
        let at = place.start + (column - place.stored) * LANES + row % LANES;
        if let Some(slot) = self.panels.as_mut().get_mut(at) {
            *slot = value;
        }
    }

    /// Row panel `p` of `L` from the panels above it, then its diagonal block.
    #[inline(always)]
    fn factor_panel(&mut self, p: usize) {
        let place = Place::of::<G>(p);
        let (done, rest) = self.panels.as_mut().split_at_mut(place.start);
        let Some(own) = rest.get_mut(..place.end - place.start) else { return };
        for q in place.stored / LANES..p {
            let above = Place::of::<G>(q);
            let upper = done.get(above.start..above.end).unwrap_or(&[]);
            let inverse = load_tile::<R>(self.inverses.as_ref(), q * LANES * LANES);
            let first = place.first.max(above.first);
            let column = q * LANES;
            let (own_at, upper_at) =
                ((column - place.stored) * LANES, (first - above.stored) * LANES);
            let terms = column.saturating_sub(first) * LANES;
            let start = own_at - terms;
            let (left, right) = own.split_at_mut(own_at);
            let mut tile = load_tile::<R>(right, 0);
            let factors = upper.get(upper_at..upper_at + terms).unwrap_or(&[]);
            subtract::<R>(&mut tile, left.get(start..).unwrap_or(&[]), factors);
            store_tile::<R>(&times_transposed::<R>(&tile, &inverse), right, 0);
        }
        let last = own.len() - LANES * LANES;
        let (left, right) = own.split_at_mut(last);
        let mut tile = load_tile::<R>(right, 0);
        let used = left.get((place.first - place.stored) * LANES..).unwrap_or(&[]);
        subtract::<R>(&mut tile, used, used);
        let (inverse, replaced) = invert_factor::<R>(&tile);
        self.regularised += replaced;
        store_tile::<R>(&inverse, self.inverses.as_mut(), p * LANES * LANES);
    }
}

/// Where a panel lies in the factor.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// First stored column, a multiple of eight.
    pub(super) stored: usize,
    /// First column any of its rows touches.
    pub(super) first: usize,
    start: usize,
    end: usize,
}

impl Place {
    #[inline(always)]
    fn of<G: Grid>(p: usize) -> Self {
        let panel = G::PANELS.get(p).copied().unwrap_or(Panel { first: 0, offset: 0 });
        let first = usize::from(panel.first);
        let stored = first / LANES * LANES;
        let start = panel.offset as usize * LANES;
        Self { stored, first, start, end: start + ((p + 1) * LANES - stored) * LANES }
    }
}

/// The numbers of one panel.
pub(super) struct Rows<'a, R> {
    pub(super) place: Place,
    pub(super) numbers: &'a [R],
}

#[inline(always)]
fn load_tile<R: Real>(from: &[R], at: usize) -> Tile<R> {
    match from.get(at..).and_then(<[R]>::first_chunk::<{ LANES * LANES }>) {
        Some(block) => core::array::from_fn(|j| R::Lanes::load(block, j * LANES)),
        None => [R::Lanes::zero(); LANES],
    }
}

#[inline(always)]
fn store_tile<R: Real>(tile: &Tile<R>, to: &mut [R], at: usize) {
    if let Some(block) = to.get_mut(at..).and_then(<[R]>::first_chunk_mut::<{ LANES * LANES }>) {
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
        let rows = R::Lanes::from_array(*rows);
        for (a, &f) in acc.iter_mut().zip(factors) {
            *a = *a - rows * R::Lanes::all(f);
        }
    }
    *tile = acc;
}

/// `tile · inverseᵀ`: column `j` is `Σ_{m ≤ j} tile[:, m] · inverse[j, m]`.
#[inline(always)]
fn times_transposed<R: Real>(tile: &Tile<R>, inverse: &Tile<R>) -> Tile<R> {
    core::array::from_fn(|j| {
        let row = inverse.get(j).map_or([R::ZERO; LANES], |r| r.array());
        let mut sum = R::Lanes::zero();
        for (t, f) in tile.iter().zip(row).take(j + 1) {
            sum = sum + *t * R::Lanes::all(f);
        }
        sum
    })
}

/// Inverse of the Cholesky factor of one diagonal block, row by row, and how many pivots were replaced.
#[inline(always)]
fn invert_factor<R: Real>(block: &Tile<R>) -> (Tile<R>, u32) {
    let mut columns = *block;
    let mut rows = [R::Lanes::zero(); LANES];
    let mut replaced = 0;
    for j in 0..LANES {
        let (scale, bad) = pivot::<R>(&columns, block, j);
        replaced += u32::from(bad);
        let column = columns.get(j).map_or(R::Lanes::zero(), |c| *c * R::Lanes::all(scale));
        let factors = column.array();
        for (c, &f) in columns.iter_mut().zip(&factors).skip(j + 1) {
            *c = *c - column * R::Lanes::all(f);
        }
        if let Some(slot) = columns.get_mut(j) {
            *slot = column;
        }
        let row = inverse_row::<R>(&columns, &rows, j) * R::Lanes::all(scale);
        if let Some(slot) = rows.get_mut(j) {
            *slot = row;
        }
    }
    (rows, replaced)
}

/// `1 / L_jj`, and whether the pivot had to be replaced.
#[inline(always)]
fn pivot<R: Real>(columns: &Tile<R>, block: &Tile<R>, j: usize) -> (R, bool) {
    let entry = |t: &Tile<R>| t.get(j).and_then(|c| c.array().get(j).copied()).unwrap_or(R::one());
    let (found, diagonal) = (entry(columns), entry(block));
    let bad = !(found > diagonal * R::of(SMALLEST_PIVOT) && found > R::ZERO);
    let used = if bad { diagonal.magnitude().larger(R::one()) } else { found };
    (R::one() / used.root(), bad)
}

/// Row `j` of the inverse before its scaling: `e_j - Σ_{m < j} L_jm · row_m`.
#[inline(always)]
fn inverse_row<R: Real>(columns: &Tile<R>, rows: &Tile<R>, j: usize) -> R::Lanes {
    let mut unit = [R::ZERO; LANES];
    if let Some(one) = unit.get_mut(j) {
        *one = R::one();
    }
    let mut sum = R::Lanes::from_array(unit);
    for (column, row) in columns.iter().zip(rows).take(j) {
        let factor = column.array().get(j).copied().unwrap_or(R::ZERO);
        sum = sum - *row * R::Lanes::all(factor);
    }
    sum
}
