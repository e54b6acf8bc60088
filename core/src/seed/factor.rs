//! `K = L D Lᵀ` without pivoting, up-looking, on fixed slots.
//!
//! Row by row of `L`: the row's slots are found once, by walking the elimination tree; afterwards each
//! factorisation is one sparse triangular solve a row. `K` is quasi-definite where `H` is positive
//! definite, so every order of elimination has non-zero pivots: positive for unknowns, negative for
//! multipliers.
//!
//! Source: ours; the up-looking method and the elimination tree are textbook (Davis 2006, ch. 4).
//! Checked against a dense factorisation by `tests/seed_agrees.rs`.

use super::grid::{Cell, SeedGrid, Table, get, set};
use super::matrix::Matrix;
use crate::real::Real;

/// No parent, no mark.
const NONE: u16 = u16::MAX;

/// The factor and the slots it stands on.
#[derive(Debug, Clone)]
pub struct Factor<R: Real, G: SeedGrid> {
    parent: G::Numbers<u16>,
    mark: G::Numbers<u16>,
    /// Columns of `L` below the diagonal: starts, rows, values.
    starts: G::Starts<u32>,
    below: G::Fill<u16>,
    values: G::Fill<R>,
    /// Rows of `L` left of the diagonal: starts, columns, rising.
    row_starts: G::Starts<u32>,
    left: G::Fill<u16>,
    inverse: G::Numbers<R>,
    filled: G::Numbers<u32>,
    work: G::Numbers<R>,
    /// Pivots of the last factorisation that were too small and were replaced.
    pub regularised: u32,
}

impl<R: Real, G: SeedGrid> Factor<R, G> {
    /// An empty factor.
    pub const ZERO: Self = Self {
        parent: <G::Numbers<u16> as Table<u16>>::BLANK,
        mark: <G::Numbers<u16> as Table<u16>>::BLANK,
        starts: <G::Starts<u32> as Table<u32>>::BLANK,
        below: <G::Fill<u16> as Table<u16>>::BLANK,
        values: <G::Fill<R> as Table<R>>::BLANK,
        row_starts: <G::Starts<u32> as Table<u32>>::BLANK,
        left: <G::Fill<u16> as Table<u16>>::BLANK,
        inverse: <G::Numbers<R> as Table<R>>::BLANK,
        filled: <G::Numbers<u32> as Table<u32>>::BLANK,
        work: <G::Numbers<R> as Table<R>>::BLANK,
        regularised: 0,
    };

    /// Entries of `L` below the diagonal.
    pub fn entries(&self) -> usize {
        get(self.starts.as_ref(), G::N) as usize
    }

    /// Finds the slots of `L` for those of `K`. Answers how many there are below the diagonal.
    ///
    /// # Cost
    ///
    /// Once for a grid and an option; a few operations a slot of `L`.
    pub(super) fn analyse(&mut self, k: &Matrix<R, G>) -> usize {
        self.parent.as_mut().fill(NONE);
        self.mark.as_mut().fill(NONE);
        self.filled.as_mut().fill(0);
        let mut count = 0;
        for row in 0..G::N {
            set(self.row_starts.as_mut(), row, count as u32);
            count = self.reach(k, row, count);
        }
        set(self.row_starts.as_mut(), G::N, count as u32);
        let mut sum = 0;
        for (start, &in_column) in self.starts.as_mut().iter_mut().zip(self.filled.as_ref()) {
            *start = sum;
            sum += in_column;
        }
        set(self.starts.as_mut(), G::N, sum);
        self.place_rows();
        count
    }

    /// Columns that row `row` touches: all ancestors, below it in order, of what `K` has in it.
    fn reach(&mut self, k: &Matrix<R, G>, row: usize, from: usize) -> usize {
        let mut count = from;
        set(self.mark.as_mut(), row, row as u16);
        for &column in k.column(row).0 {
            let mut at = usize::from(column);
            while at < row && usize::from(get(self.mark.as_ref(), at)) != row {
                set(self.mark.as_mut(), at, row as u16);
                set(self.left.as_mut(), count, at as u16);
                count += 1;
                if let Some(n) = self.filled.as_mut().get_mut(at) {
                    *n += 1;
                }
                if get(self.parent.as_ref(), at) == NONE {
                    set(self.parent.as_mut(), at, row as u16);
                }
                at = usize::from(get(self.parent.as_ref(), at));
            }
        }
        if let Some(columns) = self.left.as_mut().get_mut(from..count) {
            columns.sort_unstable();
        }
        count
    }

    /// The rows of each column, from the columns of each row.
    fn place_rows(&mut self) {
        self.filled.as_mut().fill(0);
        for row in 0..G::N {
            for column in row_of(self.row_starts.as_ref(), self.left.as_ref(), row) {
                let column = usize::from(*column);
                if let Some(n) = self.filled.as_mut().get_mut(column) {
                    let at = (get(self.starts.as_ref(), column) + *n) as usize;
                    *n += 1;
                    set(self.below.as_mut(), at, row as u16);
                }
            }
        }
    }

    /// Factors `K`.
    ///
    /// # Cost
    ///
    /// At 11x8 about 200,000 multiply-adds.
    ///
    /// # Hard case
    ///
    /// A pivot that vanishes in rounding, which only an indefinite `H` brings about, is replaced and counted.
    pub fn factor(&mut self, k: &Matrix<R, G>) {
        self.regularised = 0;
        self.filled.as_mut().fill(0);
        for row in 0..G::N {
            let (columns, values) = k.column(row);
            let mut diagonal = R::ZERO;
            for (&c, &v) in columns.iter().zip(values) {
                if usize::from(c) == row {
                    diagonal = v;
                } else {
                    set(self.work.as_mut(), usize::from(c), v);
                }
            }
            let pivot = diagonal - self.eliminate(row);
            let used = self.checked(pivot, diagonal);
            set(self.inverse.as_mut(), row, R::of(1.0) / used);
        }
    }

    /// Row `row` of `L` from the columns before it. Answers what it takes off the diagonal.
    #[inline(always)]
    fn eliminate(&mut self, row: usize) -> R {
        let mut taken = R::ZERO;
        let work = self.work.as_mut();
        for &column in row_of(self.row_starts.as_ref(), self.left.as_ref(), row) {
            let column = usize::from(column);
            let y = get(work, column);
            set(work, column, R::ZERO);
            let from = get(self.starts.as_ref(), column) as usize;
            let end = from + get(self.filled.as_ref(), column) as usize;
            let rows = self.below.as_ref().get(from..end).unwrap_or(&[]);
            let done = self.values.as_ref().get(from..end).unwrap_or(&[]);
            for (&r, &l) in rows.iter().zip(done) {
                if let Some(slot) = work.get_mut(usize::from(r)) {
                    *slot -= l * y;
                }
            }
            let l = y * get(self.inverse.as_ref(), column);
            taken += y * l;
            set(self.values.as_mut(), end, l);
            set(self.filled.as_mut(), column, (end - from + 1) as u32);
        }
        taken
    }

    fn checked(&mut self, pivot: R, diagonal: R) -> R {
        let least = diagonal.magnitude() * R::of(R::EPSILON);
        if pivot.magnitude() > least {
            return pivot;
        }
        self.regularised += 1;
        if diagonal < R::ZERO { diagonal } else { diagonal.larger(R::of(1.0)) }
    }

    /// Solves `K x = b` in elimination order; `x` holds `b` on entry.
    pub fn solve(&self, x: &mut [R]) {
        for c in 0..G::N {
            let xc = get(x, c);
            let (rows, values) = self.column(c);
            for (&r, &l) in rows.iter().zip(values) {
                if let Some(slot) = x.get_mut(usize::from(r)) {
                    *slot -= l * xc;
                }
            }
        }
        for (x, &d) in x.iter_mut().zip(self.inverse.as_ref()) {
            *x *= d;
        }
        for c in (0..G::N).rev() {
            let (rows, values) = self.column(c);
            let sum = rows
                .iter()
                .zip(values)
                .fold(get(x, c), |s, (&r, &l)| s - l * get(x, usize::from(r)));
            set(x, c, sum);
        }
    }

    #[inline(always)]
    fn column(&self, c: usize) -> (&[u16], &[R]) {
        let starts = self.starts.as_ref();
        let range = get(starts, c) as usize..get(starts, c + 1) as usize;
        let rows = self.below.as_ref().get(range.clone()).unwrap_or(&[]);
        (rows, self.values.as_ref().get(range).unwrap_or(&[]))
    }
}

#[inline(always)]
fn row_of<'a, T: Cell>(starts: &[u32], all: &'a [T], row: usize) -> &'a [T] {
    all.get(get(starts, row) as usize..get(starts, row + 1) as usize).unwrap_or(&[])
}
