//! Cholesky of a small dense system, one code for every size.
//!
//! `nalgebra` unrolls its own for each size and call: nine kilobytes of a firmware for one matrix of twelve rows.
//! These are its sums in its order, so the bits are the same.
//!
//! Source: textbook; the order is that of nalgebra 0.35. Checked by the test below.

use super::{LANES, Real};

/// Solves `a x = b`, `a` column by column, in place: `a` becomes its factor, `b` the solution. False where `a` is
/// not positive definite.
///
/// # Cost
///
/// `n³ / 6` multiply-adds.
#[inline(never)]
pub(super) fn solve<R: Real>(a: &mut [R], b: &mut [R]) -> bool {
    let n = b.len();
    for j in 0..n {
        if !column(a, n, j) {
            return false;
        }
    }
    for i in 0..n {
        let (_, rest) = b.split_at_mut_checked(i).unwrap_or_default();
        let (Some((own, below)), Some((d, l))) = (rest.split_first_mut(), from_diagonal(a, n, i))
        else {
            return false;
        };
        *own = *own / *d;
        take(below, l, *own);
    }
    for i in (0..n).rev() {
        let (_, rest) = b.split_at_mut_checked(i).unwrap_or_default();
        let (Some((own, below)), Some((d, l))) = (rest.split_first_mut(), from_diagonal(a, n, i))
        else {
            return false;
        };
        *own = (*own - dot(l, below)) / *d;
    }
    true
}

/// Column `j` of the factor from those before it.
fn column<R: Real>(a: &mut [R], n: usize, j: usize) -> bool {
    let (done, rest) = a.split_at_mut_checked(j * n).unwrap_or_default();
    let Some(own) = rest.get_mut(j..n) else { return false };
    for earlier in done.chunks_exact(n) {
        let Some((&factor, _)) = earlier.get(j..).and_then(<[R]>::split_first) else { continue };
        take(own, earlier.get(j..).unwrap_or(&[]), factor);
    }
    let Some((pivot, below)) = own.split_first_mut() else { return false };
    let positive = *pivot > R::ZERO;
    if !positive {
        return false;
    }
    *pivot = pivot.root();
    below.iter_mut().for_each(|v| *v = *v / *pivot);
    true
}

/// The diagonal of column `i` and what lies below it.
fn from_diagonal<R: Real>(a: &[R], n: usize, i: usize) -> Option<(&R, &[R])> {
    a.get(i * n + i..(i + 1) * n)?.split_first()
}

/// `y -= x f`.
#[inline(never)]
fn take<R: Real>(y: &mut [R], x: &[R], f: R) {
    y.iter_mut().zip(x).for_each(|(y, &x)| *y -= x * f);
}

/// `⟨x, y⟩`: whole eights in eight partial sums, then the rest.
#[inline(never)]
fn dot<R: Real>(x: &[R], y: &[R]) -> R {
    let ((eights, x), (other, y)) = (x.as_chunks::<LANES>(), y.as_chunks::<LANES>());
    let mut partial = [R::ZERO; LANES];
    for (x, y) in eights.iter().zip(other) {
        partial.iter_mut().zip(x.iter().zip(y)).for_each(|(p, (&x, &y))| *p += x * y);
    }
    let [a, b, c, d, e, f, g, h] = partial;
    let sum = (a + e) + (b + f) + (c + g) + (d + h);
    x.iter().zip(y).fold(sum, |sum, (&x, &y)| sum + x * y)
}

#[cfg(test)]
mod tests {
    use super::solve;
    use nalgebra::{SMatrix, SVector};

    /// A positive definite matrix without structure.
    fn matrix<const D: usize>(seed: f32) -> (SMatrix<f32, D, D>, SVector<f32, D>) {
        let m = SMatrix::<f32, D, D>::from_fn(|r, c| libm::sinf(seed + (r * 7 + c * 13) as f32));
        let b = SVector::from_fn(|r, _| libm::cosf(seed + r as f32));
        (m * m.transpose() + SMatrix::identity() * 0.1, b)
    }

    fn same_as_nalgebra<const D: usize>() {
        for n in 0..100 {
            let (mut a, mut b) = matrix::<D>(n as f32 * 0.37);
            let want = a.cholesky().map(|factor| factor.solve(&b));
            let solved = solve(a.as_mut_slice(), b.as_mut_slice()).then_some(b);
            assert_eq!(solved, want, "size {D}, matrix {n}");
        }
    }

    #[test]
    fn same_bits_as_nalgebra() {
        same_as_nalgebra::<2>();
        same_as_nalgebra::<12>();
    }

    #[test]
    fn refuses_what_is_not_positive_definite() {
        assert!(!solve(&mut [1.0_f32, 2.0, 2.0, 1.0], &mut [1.0, 1.0]), "a saddle");
        assert!(!solve(&mut [f32::NAN], &mut [1.0]), "no number");
    }
}
