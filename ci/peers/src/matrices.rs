//! Many symmetric matrices with one pattern, each with a right-hand side.

/// `count` systems `K x = b` of size `n`, by columns, both triangles stored.
#[derive(Debug, Clone)]
pub(crate) struct Matrices {
    /// What the systems are.
    pub(crate) name: &'static str,
    /// Rows of each.
    pub(crate) n: usize,
    /// Where each column starts in `rows`: `n + 1` places.
    pub(crate) starts: Vec<i32>,
    /// The row of each entry, rising within a column.
    pub(crate) rows: Vec<i32>,
    /// The entries of one matrix after the other.
    pub(crate) values: Vec<f64>,
    /// The right-hand sides, one after the other.
    pub(crate) rhs: Vec<f64>,
}

impl Matrices {
    /// Stored entries of one matrix.
    pub(crate) fn entries(&self) -> usize {
        self.rows.len()
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.rhs.len() / self.n
    }

    /// The backward error, the worst of all systems: `max |K x - b| / max (|K| |x| + |b|)`, over rows.
    ///
    /// Not over `|b|` alone: near the flat state the matrix is nearly singular, and the best of solvers
    /// leaves much of a right-hand side that does not fit.
    pub(crate) fn residual(&self, x: &[f64]) -> f64 {
        let one = |(m, x): (usize, &[f64])| {
            let values = &self.values[m * self.entries()..][..self.entries()];
            let b = &self.rhs[m * self.n..][..self.n];
            let mut r: Vec<f64> = b.iter().map(|b| -b).collect();
            let mut size: Vec<f64> = b.iter().map(|b| b.abs()).collect();
            for (col, x) in x.iter().enumerate() {
                for at in self.column(col) {
                    let row = self.rows[at] as usize;
                    r[row] += values[at] * x;
                    size[row] += (values[at] * x).abs();
                }
            }
            largest(&r) / largest(&size)
        };
        // A NaN must win, so `f64::max` will not do.
        x.chunks(self.n)
            .enumerate()
            .map(one)
            .fold(0.0, |a, b| if b > a || b.is_nan() { b } else { a })
    }

    fn column(&self, col: usize) -> std::ops::Range<usize> {
        self.starts[col] as usize..self.starts[col + 1] as usize
    }
}

fn largest(v: &[f64]) -> f64 {
    v.iter().fold(0.0, |a, b| if b.abs() > a || b.is_nan() { b.abs() } else { a })
}

#[cfg(test)]
mod tests {
    use super::Matrices;
    use crate::triplets::Triplets;

    #[test]
    fn residual_of_the_solution_is_zero_of_a_nan_is_nan() {
        let mut t = Triplets::default();
        t.add(0, 0, 2.0);
        t.add(1, 1, 4.0);
        t.add_both(0, 1, 1.0);
        let (starts, rows) = t.pattern(2);
        assert_eq!((starts.as_slice(), rows.as_slice()), (&[0, 2, 4][..], &[0, 1, 0, 1][..]));
        let set = Matrices {
            name: "two",
            n: 2,
            starts,
            rows,
            values: t.values().collect(),
            rhs: vec![3.0, 5.0],
        };
        assert_eq!(set.residual(&[1.0, 1.0]), 0.0);
        assert_eq!(set.residual(&[1.0, 2.0]), 4.0 / 14.0);
        assert!(set.residual(&[f64::NAN, 1.0]).is_nan(), "a NaN is never a small residual");
    }
}
