//! A dense symmetric matrix and its Cholesky factor, in `f64`: the plainest oracle there is.

use dogleaf_core::grid::Grid;
use dogleaf_core::kkt::Factor;
use dogleaf_core::real::Real;

/// A square matrix, row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct Dense {
    size: usize,
    numbers: Vec<f64>,
}

impl Dense {
    /// Zeros.
    pub fn zeros(size: usize) -> Self {
        Self { size, numbers: vec![0.0; size * size] }
    }
    /// From its numbers, row by row.
    pub fn of(numbers: Vec<f64>) -> Self {
        let size = numbers.len().isqrt();
        assert_eq!(size * size, numbers.len(), "a square matrix");
        Self { size, numbers }
    }
    /// The lower triangle of a matrix not yet factored, mirrored.
    pub fn of_matrix<R: Real, G: Grid>(s: &Factor<R, G>) -> Self {
        let mut dense = Self::zeros(G::UNKNOWNS);
        s.entries(|row, column, value| {
            *dense.entry(row, column) = value.wide();
            *dense.entry(column, row) = value.wide();
        });
        dense
    }
    /// Rows and columns.
    pub fn size(&self) -> usize {
        self.size
    }
    /// Its numbers, row by row.
    pub fn numbers(&self) -> &[f64] {
        &self.numbers
    }
    /// One entry.
    pub fn entry(&mut self, row: usize, column: usize) -> &mut f64 {
        &mut self.numbers[row * self.size + column]
    }
    /// One row.
    pub fn row(&self, row: usize) -> &[f64] {
        &self.numbers[row * self.size..][..self.size]
    }
    /// Matrix times vector.
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        (0..self.size).map(|r| dot(self.row(r), x)).collect()
    }
    /// Largest sum of magnitudes of a row.
    pub fn norm(&self) -> f64 {
        (0..self.size).map(|r| self.row(r).iter().map(|v| v.abs()).sum()).fold(0.0, f64::max)
    }
    /// With `share` of its norm added to the diagonal.
    #[must_use]
    pub fn shifted(mut self, share: f64) -> Self {
        let shift = share * self.norm();
        (0..self.size).for_each(|n| *self.entry(n, n) += shift);
        self
    }
    /// Its factor, or `None` where it is not positive definite.
    pub fn cholesky(&self) -> Option<Lower> {
        let mut l = Self::zeros(self.size);
        for row in 0..self.size {
            for column in 0..=row {
                let known = dot(&l.row(row)[..column], &l.row(column)[..column]);
                let rest = self.row(row)[column] - known;
                if row == column && (rest.is_nan() || rest <= 0.0) {
                    return None;
                }
                let value = if row == column { rest.sqrt() } else { rest / l.row(column)[column] };
                *l.entry(row, column) = value;
            }
        }
        Some(Lower(l))
    }
}

/// A Cholesky factor.
#[derive(Debug, Clone, PartialEq)]
pub struct Lower(Dense);

impl Lower {
    /// Solves `L Lᵀ x = b`.
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        let l = &self.0;
        let mut x = b.to_vec();
        for row in 0..l.size {
            let known = dot(&l.row(row)[..row], &x[..row]);
            x[row] = (x[row] - known) / l.row(row)[row];
        }
        for row in (0..l.size).rev() {
            let own = x[row] / l.row(row)[row];
            x[row] = own;
            x[..row].iter_mut().zip(l.row(row)).for_each(|(v, f)| *v -= own * f);
        }
        x
    }
}

/// Inner product in four partial sums.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (fours, rest) = a.as_chunks::<4>();
    let (others, last) = b.as_chunks::<4>();
    let mut sums = [0.0; 4];
    for (a, b) in fours.iter().zip(others) {
        sums.iter_mut().zip(a.iter().zip(b)).for_each(|(s, (x, y))| *s += x * y);
    }
    let tail: f64 = rest.iter().zip(last).map(|(x, y)| x * y).sum();
    sums.iter().sum::<f64>() + tail
}
