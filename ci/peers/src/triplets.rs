//! A sparse symmetric matrix put together entry by entry, for tests.

/// One matrix under construction; entries may be added in any order and more than once.
#[derive(Debug, Default)]
pub(crate) struct Triplets(std::collections::BTreeMap<(usize, usize), f64>);

impl Triplets {
    /// Adds `v` at `(row, col)`. A zero makes a place too: the pattern must not depend on the values.
    pub(crate) fn add(&mut self, row: usize, col: usize, v: f64) {
        *self.0.entry((col, row)).or_insert(0.0) += v;
    }

    /// Adds `v` at `(row, col)` and at `(col, row)`.
    pub(crate) fn add_both(&mut self, row: usize, col: usize, v: f64) {
        self.add(row, col, v);
        self.add(col, row, v);
    }

    /// Column starts and rows.
    pub(crate) fn pattern(&self, n: usize) -> (Vec<i32>, Vec<i32>) {
        let mut starts = vec![0; n + 1];
        for (col, _) in self.0.keys() {
            starts[col + 1] += 1;
        }
        for col in 0..n {
            starts[col + 1] += starts[col];
        }
        (starts, self.0.keys().map(|(_, row)| *row as i32).collect())
    }

    /// The entries in the order of [`Self::pattern`].
    pub(crate) fn values(&self) -> impl Iterator<Item = f64> {
        self.0.values().copied()
    }
}
