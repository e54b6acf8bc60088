//! Cholesky factor `S = L Lᵀ` in panels of eight rows, in place, without a pivot search.
//!
//! A panel holds eight rows of `L` as vectors over its rows, one a column, from the first column any
//! of them touches (the envelope, [`Panel`]) to its diagonal block. The envelope is closed under
//! elimination, so the pattern never changes. Every entry is summed over its columns in ascending
//! order, whatever the width of the target's vectors: the bits do not depend on the blocking.
//!
//! Source: ours. Checked against a dense factorisation by `tests/kkt_dense.rs`.

use super::stencil::{NEIGHBOURS, Stencil};
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
            if let Some(slot) =
                self.panels.as_mut().get_mut(Place::of::<G>(row / LANES).entry(row, row))
            {
                *slot = R::of(1.0);
            }
        }
        for i in 1..G::NX {
            for k in 0..G::NZ {
                for c in 0..3 {
                    self.fill_row(s, i, k, c);
                }
            }
        }
    }

    /// The entries of coordinate `c` of node `(i, k)`: seven neighbours, three coordinates each.
    #[inline(always)]
    fn fill_row(&mut self, s: &Stencil<R, G>, i: usize, k: usize, c: usize) {
        let row = 3 * ((i - 1) * G::NZ + k) + c;
        let place = Place::of::<G>(row / LANES);
        for (n, &(di, dk)) in NEIGHBOURS.iter().enumerate() {
            let l = k.wrapping_add_signed(-dk);
            if i <= di || l >= G::NZ {
                continue;
            }
            let first = 3 * ((i - di - 1) * G::NZ + l);
            let at = place.entry(row, first);
            for d in 0..3 {
                if let Some(slot) = self.panels.as_mut().get_mut(at + d * LANES)
                    && (n > 0 || d <= c)
                {
                    *slot = s.at(n, c, d, i, k);
                }
            }
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
        let diagonal = diagonal::<R>(&tile);
        let used = left.get((place.first - place.stored) * LANES..).unwrap_or(&[]);
        subtract::<R>(&mut tile, used, used);
        let (inverse, replaced) = invert_factor::<R>(&tile, &diagonal);
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
    /// Where the entry of a row of this panel in `column` is stored.
    #[inline(always)]
    fn entry(&self, row: usize, column: usize) -> usize {
        self.start + (column - self.stored) * LANES + row % LANES
    }
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
/// `diagonal` holds the matrix's own entries: a pivot is small against what it was before elimination.
#[inline(always)]
fn invert_factor<R: Real>(block: &Tile<R>, diagonal: &[R; LANES]) -> (Tile<R>, u32) {
    let mut work = Inversion {
        columns: block.map(|c| c.array()),
        rows: [R::Lanes::zero(); LANES],
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

/// The diagonal entries of a block.
#[inline(always)]
fn diagonal<R: Real>(block: &Tile<R>) -> [R; LANES] {
    core::array::from_fn(|j| block.get(j).map_or(R::ZERO, |c| lane::<R>(&c.array(), j)))
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
        let (found, entry) = (lane(&own, J), lane(diagonal, J));
        let bad = !(found > entry * R::of(SMALLEST_PIVOT) && found > R::ZERO);
        let used = if bad { entry.magnitude().larger(R::of(1.0)) } else { found };
        let scale = R::of(1.0) / used.root();
        self.replaced += u32::from(bad);
        let column = (R::Lanes::from_array(own) * R::Lanes::all(scale)).array();
        for (m, c) in self.columns.iter_mut().enumerate() {
            if m > J {
                let factor = R::Lanes::all(lane(&column, m));
                *c = (R::Lanes::from_array(*c) - R::Lanes::from_array(column) * factor).array();
            }
        }
        let mut row =
            R::Lanes::from_array(core::array::from_fn(
                |m| if m == J { R::of(1.0) } else { R::ZERO },
            ));
        for (m, known) in self.rows.iter().enumerate() {
            if m < J {
                let factor = self.columns.get(m).map_or(R::ZERO, |c| lane(c, J));
                row = row - *known * R::Lanes::all(factor);
            }
        }
        if let (Some(c), Some(r)) = (self.columns.get_mut(J), self.rows.get_mut(J)) {
            *c = column;
            *r = row * R::Lanes::all(scale);
        }
    }
}
