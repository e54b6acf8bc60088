//! Cholesky factor `S = L Lᵀ` in panels of eight rows, in place, without a pivot search.
//!
//! A panel holds eight rows of `L` as vectors over its rows, one a column, from the first column any
//! of them touches (the envelope, [`Panel`](crate::grid::Panel)) to its diagonal block. The envelope is
//! closed under elimination, so the pattern never changes. Every entry is summed over its columns in
//! ascending order, whatever the width of the target's vectors: the bits do not depend on the blocking.
//! Of a diagonal block its factor's inverse is kept, in its place.
//!
//! Source: ours. Checked against a dense factorisation by `tests/kkt_dense.rs`.

use super::place::{Place, unknown};
use super::stencil::{NEIGHBOURS, Stencil, pair};
use super::{one, tile};
use crate::grid::{Grid, Store};
use crate::real::{LANES, Lanes, Real};

/// A pivot below this share of its diagonal entry is replaced and counted.
pub(super) const SMALLEST_PIVOT: f64 = 1e-7;

/// The matrix until [`Factor::decompose`], then its factor.
#[derive(Debug, Clone)]
pub struct Factor<R: Real, G: Grid> {
    panels: G::Factor<R>,
    /// Pivots of the last factorisation that were not positive enough and were replaced.
    pub regularised: u32,
}

impl<R: Real, G: Grid> Factor<R, G> {
    /// Zeros.
    pub const ZERO: Self = Self { panels: <G::Factor<R> as Store<R>>::ZERO, regularised: 0 };

    /// Panel `p`: where it lies, and its numbers.
    #[inline(always)]
    pub(super) fn panel(&self, p: usize) -> (Place, &[R]) {
        let place = Place::of::<G>(p);
        (place, self.panels.as_ref().get(place.start..place.end).unwrap_or(&[]))
    }

    /// Empties the matrix: ones on the diagonal of the padding, zeros elsewhere.
    pub fn clear(&mut self) {
        // The zero is hidden: the loop would else become a call that takes thrice as long on a small processor.
        let zero = core::hint::black_box(R::ZERO);
        let (lines, rest) = self.panels.as_mut().as_chunks_mut::<{ 4 * LANES }>();
        lines.iter_mut().for_each(|line| *line = [zero; 4 * LANES]);
        rest.fill(zero);
        for row in G::UNKNOWNS..G::ROWS {
            self.set(row, row, R::of(1.0));
        }
    }
    /// Takes the rows of column `i` of nodes.
    pub fn take(&mut self, s: &Stencil<R, G>, i: usize) {
        for k in 0..G::NZ {
            self.take_node(s, i, k);
        }
    }
    /// One entry of the matrix, `row >= column`.
    pub fn set(&mut self, row: usize, column: usize, value: R) {
        let at = Place::of::<G>(row / LANES).entry(row, column);
        if let Some(slot) = self.panels.as_mut().get_mut(at) {
            *slot = value;
        }
    }
    /// Calls `visit(row, column, value)` for every entry the matrix can have in its lower triangle.
    pub fn entries(&self, mut visit: impl FnMut(usize, usize, R)) {
        for (i, k, n) in pairs::<G>() {
            let (j, l) = earlier(i, k, n);
            for c in 0..3 {
                for d in 0..=(if n == pair::SELF { c } else { 2 }) {
                    let (row, column) = (unknown::<G>(i, k, c), unknown::<G>(j, l, d));
                    let at = Place::of::<G>(row / LANES).entry(row, column);
                    visit(row, column, self.panels.as_ref().get(at).copied().unwrap_or(R::ZERO));
                }
            }
        }
    }

    /// The entries of node `(i, k)`: seven neighbours of three by three.
    #[inline(always)]
    fn take_node(&mut self, s: &Stencil<R, G>, i: usize, k: usize) {
        let first = unknown::<G>(i, k, 0);
        let diagonal: [usize; 3] =
            core::array::from_fn(|c| Place::of::<G>((first + c) / LANES).entry(first + c, first));
        let [a, b, c] = diagonal;
        // Of the node itself only the lower triangle.
        let [own, second, third] = s.lines(pair::SELF, i, k);
        self.take_entry(a, own[0]);
        self.take_entry(b, second[0]);
        self.take_entry(b + LANES, second[1]);
        self.take_line(c, third);
        for n in (pair::ROW..NEIGHBOURS.len()).filter(|&n| exists::<G>(i, k, n)) {
            let (j, l) = earlier(i, k, n);
            let back = (first - unknown::<G>(j, l, 0)) * LANES;
            let [x, y, z] = s.lines(n, i, k);
            self.take_line(a - back, x);
            self.take_line(b - back, y);
            self.take_line(c - back, z);
        }
    }

    /// One entry, at place `at`.
    #[inline(always)]
    fn take_entry(&mut self, at: usize, value: R) {
        if let Some(slot) = self.panels.as_mut().get_mut(at) {
            *slot = value;
        }
    }
    /// Three entries of a row, from place `at` on.
    #[inline(always)]
    fn take_line(&mut self, at: usize, line: [R; 3]) {
        let slots = self.panels.as_mut().get_mut(at..);
        if let Some(slots) = slots.and_then(<[R]>::first_chunk_mut::<{ 2 * LANES + 1 }>) {
            for (slot, value) in slots.iter_mut().step_by(LANES).zip(line) {
                *slot = value;
            }
        }
    }

    /// Factors the matrix in place.
    ///
    /// # Cost
    ///
    /// About 320,000 multiply-adds at 11x8 (exact profile: 238,566); no branch on a value.
    ///
    /// # Hard case
    ///
    /// A pivot that rounding made too small is replaced by its diagonal entry and counted in
    /// [`Factor::regularised`]; the caller reports it.
    pub fn decompose(&mut self) {
        self.regularised = 0;
        for p in 0..G::PANELS.len() {
            self.factor_panel(p);
        }
    }

    /// Row panel `p` of `L` from the panels above it, then its diagonal block.
    #[inline(always)]
    fn factor_panel(&mut self, p: usize) {
        let place = Place::of::<G>(p);
        let Some((done, rest)) = self.panels.as_mut().split_at_mut_checked(place.start) else {
            return;
        };
        let Some(own) = rest.get_mut(..place.end - place.start) else { return };
        for q in place.stored / LANES..p {
            let above = Place::of::<G>(q);
            let upper = done.get(above.start..above.end).unwrap_or(&[]);
            eliminate::<R>(own, &place, upper, &above, q * LANES);
        }
        let Some((left, right)) = own.split_at_mut_checked(place.diagonal() - place.start) else {
            return;
        };
        let first = begun::<R>(place.first);
        let used = left.get((first - place.stored) * LANES..).unwrap_or(&[]);
        self.regularised += if R::Lanes::WIDTH == 1 {
            one::factor_diagonal::<R>(right, used, place.second - first)
        } else {
            tile::factor_diagonal::<R>(right, used)
        };
    }
}

/// The column to begin with for sums that are zeros before `first`: where rows travel alone, its stride's.
#[inline(always)]
fn begun<R: Real>(first: usize) -> usize {
    if R::Lanes::WIDTH == 1 { first / one::STRIDE * one::STRIDE } else { first }
}

/// The block of a panel in the columns of the panel above that begins with `column`.
#[inline(always)]
fn eliminate<R: Real>(own: &mut [R], place: &Place, upper: &[R], above: &Place, column: usize) {
    let first = begun::<R>(place.first.max(above.first));
    let own_at = (column - place.stored) * LANES;
    let upper_at = (first - above.stored) * LANES;
    let terms = column.saturating_sub(first) * LANES;
    let Some((left, right)) = own.split_at_mut_checked(own_at) else { return };
    let rows = left.get(own_at - terms..).unwrap_or(&[]);
    let factors = upper.get(upper_at..upper_at + terms).unwrap_or(&[]);
    let inverse = upper.get(above.diagonal() - above.start..).unwrap_or(&[]);
    if R::Lanes::WIDTH == 1 {
        let later = [place.second.saturating_sub(first), above.second.saturating_sub(first)];
        one::eliminate::<R>(right, rows, factors, inverse, later);
    } else {
        tile::eliminate::<R>(right, rows, factors, inverse);
    }
}

/// The earlier node of pair `n` of node `(i, k)`; only where it [`exists`].
#[inline(always)]
fn earlier(i: usize, k: usize, n: usize) -> (usize, usize) {
    let (di, dk) = NEIGHBOURS.get(n).copied().unwrap_or_default();
    (i.wrapping_sub(di), k.wrapping_add_signed(-dk))
}

/// Whether node `(i, k)` has pair `n`, with both nodes free.
#[inline(always)]
fn exists<G: Grid>(i: usize, k: usize, n: usize) -> bool {
    let (j, l) = earlier(i, k, n);
    j >= 1 && j <= i && l < G::NZ
}

/// Every pair of free nodes that the matrix couples: `(i, k, n)`.
fn pairs<G: Grid>() -> impl Iterator<Item = (usize, usize, usize)> {
    (1..G::NX)
        .flat_map(|i| (0..G::NZ).map(move |k| (i, k)))
        .flat_map(|(i, k)| (0..NEIGHBOURS.len()).map(move |n| (i, k, n)))
        .filter(|&(i, k, n)| exists::<G>(i, k, n))
}
