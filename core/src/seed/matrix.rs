//! `K` on fixed slots: the upper triangle, by columns, in the order of elimination.

use super::grid::{SeedGrid, Table, get, set};
use crate::real::Real;

/// Where the parts of the system are emitted to: the matrix, or the list of its slots.
pub(super) trait Sink<R> {
    /// Adds to the entry between unknowns `a` and `b`; each pair is emitted once.
    fn add(&mut self, a: usize, b: usize, value: R);
    /// Adds to the gradient (or residual) at `a`.
    fn pull(&mut self, a: usize, value: R);
}

/// The symmetric matrix.
#[derive(Debug, Clone)]
pub struct Matrix<R: Real, G: SeedGrid> {
    /// When each unknown is eliminated.
    place: G::Numbers<u16>,
    starts: G::Starts<u32>,
    rows: G::Entries<u16>,
    values: G::Entries<R>,
}

impl<R: Real, G: SeedGrid> Matrix<R, G> {
    /// Zeros without slots.
    pub const ZERO: Self = Self {
        place: <G::Numbers<u16> as Table<u16>>::BLANK,
        starts: <G::Starts<u32> as Table<u32>>::BLANK,
        rows: <G::Entries<u16> as Table<u16>>::BLANK,
        values: <G::Entries<R> as Table<R>>::BLANK,
    };

    /// Slots of the upper triangle, diagonal included.
    pub fn entries(&self) -> usize {
        get(self.starts.as_ref(), G::N) as usize
    }
    /// When unknown `a` is eliminated.
    #[inline(always)]
    pub(super) fn place(&self, a: usize) -> usize {
        usize::from(get(self.place.as_ref(), a))
    }
    /// Rows and values of column `c`, both in elimination order; rows rise, the diagonal is last.
    #[inline(always)]
    pub(super) fn column(&self, c: usize) -> (&[u16], &[R]) {
        let range = self.range(c);
        let rows = self.rows.as_ref().get(range.clone()).unwrap_or(&[]);
        (rows, self.values.as_ref().get(range).unwrap_or(&[]))
    }
    /// Zeros in every slot.
    pub(super) fn clear(&mut self) {
        self.values.as_mut().fill(R::ZERO);
    }
    /// Sets a diagonal entry.
    pub(super) fn set_diagonal(&mut self, a: usize, value: R) {
        let at = self.range(self.place(a)).end.wrapping_sub(1);
        set(self.values.as_mut(), at, value);
    }
    /// Adds to the entry between unknowns `a` and `b`. An entry without a slot is dropped.
    #[inline(always)]
    pub(super) fn add(&mut self, a: usize, b: usize, value: R) {
        let (row, column) = ordered(self.place(a), self.place(b));
        let range = self.range(column);
        let from = range.start;
        let rows = self.rows.as_ref().get(range).unwrap_or(&[]);
        if let Ok(at) = rows.binary_search(&(row as u16))
            && let Some(slot) = self.values.as_mut().get_mut(from + at)
        {
            *slot += value;
        }
    }
    /// `y -= K x`, both in elimination order.
    pub(super) fn subtract_product(&self, x: &[R], y: &mut [R]) {
        for c in 0..G::N {
            let (rows, values) = self.column(c);
            let (xc, mut sum) = (get(x, c), R::ZERO);
            for (&r, &v) in rows.iter().zip(values) {
                let r = usize::from(r);
                sum += v * get(x, r);
                if r != c
                    && let Some(slot) = y.get_mut(r)
                {
                    *slot -= v * xc;
                }
            }
            if let Some(slot) = y.get_mut(c) {
                *slot -= sum;
            }
        }
    }

    #[inline(always)]
    fn range(&self, c: usize) -> core::ops::Range<usize> {
        let starts = self.starts.as_ref();
        get(starts, c) as usize..get(starts, c + 1) as usize
    }

    /// Writes both triangles by columns in the order of the numbers, rows rising, for other solvers.
    ///
    /// Answers how many entries there are, or `None` where a buffer is too short.
    pub fn export(
        &self,
        starts: &mut [i32],
        rows: &mut [i32],
        values: &mut [f64],
    ) -> Option<usize> {
        let entries = 2 * self.entries() - G::N;
        let starts = starts.get_mut(..=G::N)?;
        if rows.len() < entries || values.len() < entries {
            return None;
        }
        starts.fill(0);
        self.pairs(|_, column, _| {
            if let Some(count) = starts.get_mut(column + 1) {
                *count += 1;
            }
        });
        let mut sum = 0;
        for start in starts.iter_mut() {
            sum += *start;
            *start = sum;
        }
        // `starts[c]` walks to the end of its column while that is filled, and is moved back after.
        self.pairs(|row, column, value| {
            if let Some(at) = starts.get_mut(column) {
                set(rows, *at as usize, row as i32);
                set(values, *at as usize, value.wide());
                *at += 1;
            }
        });
        let mut from = 0;
        for start in starts.iter_mut() {
            from = core::mem::replace(start, from);
        }
        for c in 0..G::N {
            let range = get_i32(starts, c)..get_i32(starts, c + 1);
            let columns = (rows.get_mut(range.clone()), values.get_mut(range));
            if let (Some(rows), Some(values)) = columns {
                sort_together(rows, values);
            }
        }
        Some(entries)
    }

    /// Calls `visit(row, column, value)` for every entry of both triangles, in the order of the numbers.
    fn pairs(&self, mut visit: impl FnMut(usize, usize, R)) {
        let natural = |at: usize| usize::from(get(G::ORDER, at));
        for c in 0..G::N {
            let (rows, values) = self.column(c);
            for (&r, &v) in rows.iter().zip(values) {
                let (a, b) = (natural(usize::from(r)), natural(c));
                visit(a, b, v);
                if a != b {
                    visit(b, a, v);
                }
            }
        }
    }
}

fn get_i32(table: &[i32], at: usize) -> usize {
    table.get(at).copied().unwrap_or(0).max(0) as usize
}

/// Insertion sort by row: columns are short.
fn sort_together(rows: &mut [i32], values: &mut [f64]) {
    for end in 1..rows.len() {
        for at in (1..=end).rev() {
            let (Some([a, b]), Some([va, vb])) =
                (rows.get_mut(at - 1..=at), values.get_mut(at - 1..=at))
            else {
                return;
            };
            if *a <= *b {
                break;
            }
            core::mem::swap(a, b);
            core::mem::swap(va, vb);
        }
    }
}

#[inline(always)]
fn ordered(a: usize, b: usize) -> (usize, usize) {
    if a < b { (a, b) } else { (b, a) }
}

/// Collects slots: pairs in any order, any number of times.
#[derive(Debug)]
pub(super) struct Slots<'a, R: Real, G: SeedGrid> {
    matrix: &'a mut Matrix<R, G>,
    count: usize,
}

impl<'a, R: Real, G: SeedGrid> Slots<'a, R, G> {
    /// Forgets the slots of `matrix` and begins anew, with the diagonal.
    pub(super) fn new(matrix: &'a mut Matrix<R, G>) -> Self {
        for (at, &unknown) in G::ORDER.iter().enumerate() {
            set(matrix.place.as_mut(), usize::from(unknown), at as u16);
        }
        for (at, row) in matrix.rows.as_mut().iter_mut().take(G::N).enumerate() {
            *row = at as u16;
        }
        matrix.starts.as_mut().iter_mut().enumerate().for_each(|(at, s)| *s = at as u32);
        Self { matrix, count: G::N }
    }
}

impl<R: Real, G: SeedGrid> Sink<R> for Slots<'_, R, G> {
    fn add(&mut self, a: usize, b: usize, _: R) {
        let (row, column) = ordered(self.matrix.place(a), self.matrix.place(b));
        let range = self.matrix.range(column);
        let found = self.matrix.rows.as_ref().get(range.clone()).unwrap_or(&[]);
        let Err(at) = found.binary_search(&(row as u16)) else { return };
        let Some(tail) = self.matrix.rows.as_mut().get_mut(range.start + at..=self.count) else {
            return;
        };
        let mut carried = row as u16;
        tail.iter_mut().for_each(|slot| core::mem::swap(slot, &mut carried));
        self.matrix.starts.as_mut().iter_mut().skip(column + 1).for_each(|s| *s += 1);
        self.count += 1;
    }
    fn pull(&mut self, _: usize, _: R) {}
}
