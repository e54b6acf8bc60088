//! The last steps and changes of gradient, and the small matrices made of them.

use super::{Point, dot};
use std::collections::VecDeque;

/// A small square matrix.
pub(super) type Small = Vec<Vec<f64>>;

/// Pairs `s = x' - x`, `y = g' - g`, oldest first.
#[derive(Debug, Clone)]
pub(super) struct Memory {
    most: usize,
    s: VecDeque<Vec<f64>>,
    y: VecDeque<Vec<f64>>,
    /// `WᵀW`'s parts without `θ`: `SᵀS`, `SᵀY`, `YᵀY`.
    ss: Small,
    sy: Small,
    yy: Small,
    /// `θ`.
    pub(super) theta: f64,
    /// `M`.
    middle: Small,
}

impl Memory {
    pub(super) fn new(most: usize) -> Self {
        let none = Vec::new;
        let (s, y) = (VecDeque::new(), VecDeque::new());
        Self { most, s, y, ss: none(), sy: none(), yy: none(), theta: 1.0, middle: none() }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.s.is_empty()
    }

    pub(super) fn clear(&mut self) {
        *self = Self::new(self.most);
    }

    /// Columns of `W`.
    pub(super) fn width(&self) -> usize {
        2 * self.s.len()
    }

    /// `Wᵀ v`.
    pub(super) fn project(&self, v: &[f64]) -> Vec<f64> {
        let y = self.y.iter().map(|y| dot(y, v));
        y.chain(self.s.iter().map(|s| self.theta * dot(s, v))).collect()
    }

    /// Row `i` of `W`.
    pub(super) fn row(&self, i: usize) -> Vec<f64> {
        self.y.iter().map(|y| y[i]).chain(self.s.iter().map(|s| self.theta * s[i])).collect()
    }

    /// Adds `factor W v` to `to`.
    pub(super) fn lift(&self, v: &[f64], factor: f64, to: &mut [f64]) {
        let k = self.s.len();
        let columns = self.y.iter().map(|y| (y, factor));
        let columns = columns.chain(self.s.iter().map(|s| (s, factor * self.theta)));
        for ((column, by), &part) in columns.zip(&v[..2 * k]) {
            let by = by * part;
            to.iter_mut().zip(column).for_each(|(to, c)| *to += by * c);
        }
    }

    /// `M v`.
    pub(super) fn times_middle(&self, v: &[f64]) -> Vec<f64> {
        self.middle.iter().map(|row| dot(row, v)).collect()
    }

    /// `M A`.
    pub(super) fn middle_times(&self, a: &Small) -> Small {
        let column = |j: usize| a.iter().map(|row| row[j]).collect::<Vec<_>>();
        let columns: Vec<_> = (0..a.len()).map(column).collect();
        self.middle.iter().map(|row| columns.iter().map(|c| dot(row, c)).collect()).collect()
    }

    /// `WᵀW` of all rows.
    pub(super) fn square(&self) -> Small {
        let (k, t) = (self.s.len(), self.theta);
        let entry = |i: usize, j: usize| match (i < k, j < k) {
            (true, true) => self.yy[i][j],
            (true, false) => t * self.sy[j - k][i],
            (false, true) => t * self.sy[i - k][j],
            (false, false) => t * t * self.ss[i - k][j - k],
        };
        (0..2 * k).map(|i| (0..2 * k).map(|j| entry(i, j)).collect()).collect()
    }

    /// Takes in a step, unless the function curves down along it.
    pub(super) fn learn(&mut self, from: &Point, to: &Point) {
        let less = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a - b).collect::<Vec<_>>();
        let (s, y) = (less(&to.x, &from.x), less(&to.gradient, &from.gradient));
        let (curve, square) = (dot(&s, &y), dot(&y, &y));
        if curve <= 2.2e-16 * square {
            return;
        }
        if self.s.len() == self.most {
            self.forget();
        }
        self.s.push_back(s);
        self.y.push_back(y);
        self.theta = square / curve;
        self.border();
        self.remake();
    }

    fn forget(&mut self) {
        self.s.pop_front();
        self.y.pop_front();
        for small in [&mut self.ss, &mut self.sy, &mut self.yy] {
            small.remove(0);
            for row in small {
                row.remove(0);
            }
        }
    }

    /// One more row and column of each product.
    fn border(&mut self) {
        let last = self.s.len() - 1;
        let (s, y) = (&self.s[last], &self.y[last]);
        for (small, left, right, new, other) in [
            (&mut self.ss, &self.s, &self.s, s, s),
            (&mut self.sy, &self.s, &self.y, s, y),
            (&mut self.yy, &self.y, &self.y, y, y),
        ] {
            for (row, left) in small.iter_mut().zip(left) {
                row.push(dot(left, other));
            }
            small.push(right.iter().map(|right| dot(new, right)).collect());
        }
    }

    fn remake(&mut self) {
        let (k, t) = (self.s.len(), self.theta);
        let entry = |i: usize, j: usize| match (i < k, j < k) {
            (true, true) => {
                if i == j {
                    -self.sy[i][i]
                } else {
                    0.0
                }
            }
            (true, false) => {
                if j - k > i {
                    self.sy[j - k][i]
                } else {
                    0.0
                }
            }
            (false, true) => {
                if i - k > j {
                    self.sy[i - k][j]
                } else {
                    0.0
                }
            }
            (false, false) => t * self.ss[i - k][j - k],
        };
        let matrix: Small = (0..2 * k).map(|i| (0..2 * k).map(|j| entry(i, j)).collect()).collect();
        let unit = |i: usize| (0..2 * k).map(|j| f64::from(u8::from(i == j))).collect();
        match solve(matrix, (0..2 * k).map(unit).collect()) {
            // Columns of the inverse; it is symmetric.
            Some(inverse) => self.middle = inverse,
            None => self.clear(),
        }
    }
}

/// Solves `A X = B` for every right-hand side of `B`; `None` where `A` is singular.
pub(super) fn solve(mut a: Small, mut b: Small) -> Option<Small> {
    let n = a.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
        if a[pivot][k] == 0.0 || !a[pivot][k].is_finite() {
            return None;
        }
        a.swap(k, pivot);
        b.iter_mut().for_each(|b| b.swap(k, pivot));
        let (above, below) = a.split_at_mut(k + 1);
        for (i, row) in below.iter_mut().enumerate() {
            let by = row[k] / above[k][k];
            if by != 0.0 {
                row[k..].iter_mut().zip(&above[k][k..]).for_each(|(to, from)| *to -= by * from);
                b.iter_mut().for_each(|b| b[k + 1 + i] -= by * b[k]);
            }
        }
    }
    for b in &mut b {
        for k in (0..n).rev() {
            b[k] = (b[k] - dot(&a[k][k + 1..], &b[k + 1..])) / a[k][k];
        }
    }
    Some(b)
}
