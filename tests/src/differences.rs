//! Central differences, and the question whether a derivative agrees with them.

use core::ops::Range;

/// How far to either side a difference looks, and twice as far to cancel the next error: exact for
/// polynomials of fourth degree, and far from where rounding spoils it.
const STEP: f64 = 3e-4;

/// Why a derivative is not believed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Doubt {
    /// It is zero, so it says nothing.
    Zero,
    /// It has the wrong number of entries.
    Length,
    /// An entry differs by this share of the largest.
    Differs(usize, f64),
}

/// The gradient of `f` at `x` by central differences.
pub fn gradient(f: impl Fn(&[f64]) -> f64, x: &[f64]) -> Vec<f64> {
    jacobian(|x| vec![f(x)], x)
}

/// The Jacobian of `f` at `x` by central differences, row by row.
pub fn jacobian(f: impl Fn(&[f64]) -> Vec<f64>, x: &[f64]) -> Vec<f64> {
    let columns: Vec<_> = (0..x.len()).map(|n| column(&f, x, n)).collect();
    let rows: Range<usize> = 0..columns.first().map_or(0, Vec::len);
    rows.flat_map(|r| columns.iter().map(move |c| c[r])).collect()
}

fn column(f: &impl Fn(&[f64]) -> Vec<f64>, x: &[f64], n: usize) -> Vec<f64> {
    let at = |shift: f64| {
        let mut moved = x.to_vec();
        moved[n] += shift;
        f(&moved)
    };
    let [up, down, far_up, far_down] = [STEP, -STEP, 2.0 * STEP, -2.0 * STEP].map(at);
    let slope = |n: usize| (8.0 * (up[n] - down[n]) - (far_up[n] - far_down[n])) / (12.0 * STEP);
    (0..up.len()).map(slope).collect()
}

/// Whether `found` has a norm at all, and then agrees with `expected` within a share of its largest entry.
///
/// # Errors
///
/// The first reason not to believe it.
pub fn agree(found: &[f64], expected: &[f64], tolerance: f64) -> Result<(), Doubt> {
    if found.len() != expected.len() {
        return Err(Doubt::Length);
    }
    let largest = |v: &[f64]| v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let scale = largest(expected);
    if largest(found) == 0.0 || scale == 0.0 {
        return Err(Doubt::Zero);
    }
    let gaps = found.iter().zip(expected).map(|(a, b)| (a - b).abs() / scale).enumerate();
    let wrong = gaps.filter(|(_, gap)| gap.is_nan() || *gap > tolerance);
    match wrong.max_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((entry, gap)) => Err(Doubt::Differs(entry, gap)),
        None => Ok(()),
    }
}
