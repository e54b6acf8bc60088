//! Where a segment is: a right-handed frame, moved by twists about the world's origin.

use super::elementary::angle;
use crate::real::{Num, Real, V3};

/// A twist or a wrench: the part that turns, then the part that shifts.
pub type Six<R> = [R; 6];

/// A point of the centreline with the ribbon's directions there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame<R> {
    /// Along the centreline.
    pub t: V3<R>,
    /// Across it, from rim A to rim B.
    pub b: V3<R>,
    /// The normal `t × b`.
    pub n: V3<R>,
    /// The point.
    pub p: V3<R>,
}

/// Two vectors as six numbers.
#[inline(always)]
pub fn six<T: Num>(turn: V3<T>, shift: V3<T>) -> Six<T> {
    let ([a, b, c], [d, e, f]) = (turn.0, shift.0);
    [a, b, c, d, e, f]
}

/// Six numbers as two vectors.
pub fn halves<R: Real>(s: &Six<R>) -> [V3<R>; 2] {
    let [a, b, c, d, e, f] = *s;
    [V3([a, b, c]), V3([d, e, f])]
}

/// Inner product of six.
#[inline(always)]
pub fn dot6<R: Real>(x: &Six<R>, y: &Six<R>) -> R {
    x.iter().zip(y).fold(R::ZERO, |sum, (&x, &y)| sum + x * y)
}

impl<R: Real> Frame<R> {
    /// The world's own axes at its origin.
    pub const WORLD: Self =
        Self { t: V3([R::ZERO; 3]), b: V3([R::ZERO; 3]), n: V3([R::ZERO; 3]), p: V3([R::ZERO; 3]) };

    /// The world's axes at `p`.
    pub fn at(p: V3<R>) -> Self {
        let (o, l) = (R::ZERO, R::one());
        Self { t: V3([l, o, o]), b: V3([o, l, o]), n: V3([o, o, l]), p }
    }
    /// From a tangent and a vector that the normal leans to, made orthonormal.
    pub fn leaning(p: V3<R>, t: V3<R>, n: V3<R>) -> Self {
        let t = t * (R::one() / t.norm());
        let b = n.cross(t);
        let b = b * (R::one() / b.norm());
        Self { t, b, n: t.cross(b), p }
    }
    /// Turned about the world's origin by a rotation vector, then shifted so that a twist's exponential results.
    pub fn moved(&self, twist: &Six<R>) -> Self {
        let [w, v] = halves(twist);
        let sq = w.norm_sq();
        let (a, b, c) = exponential(sq);
        let turn = |x: V3<R>| x + w.cross(x) * a + w.cross(w.cross(x)) * b;
        let shift = v + w.cross(v) * b + w.cross(w.cross(v)) * c;
        Self::leaning(turn(self.p) + shift, turn(self.t), turn(self.n))
    }
    /// The rotation vector that turns `from`'s axes onto its own, and the way between their points.
    pub fn apart(&self, from: &Self) -> [V3<R>; 2] {
        [rotation_vector(&[from.t, from.b, from.n], &[self.t, self.b, self.n]), self.p - from.p]
    }
}

/// `sin θ/θ`, `(1 - cos θ)/θ²`, `(θ - sin θ)/θ³` from `θ²`.
fn exponential<R: Real>(sq: R) -> (R, R, R) {
    if sq < R::of(1e-4) {
        let of = |a: f64, b: f64, c: f64| R::of(a) + sq * (R::of(b) + sq * R::of(c));
        let (a, b) = (of(1.0, -1.0 / 6.0, 1.0 / 120.0), of(0.5, -1.0 / 24.0, 1.0 / 720.0));
        return (a, b, of(1.0 / 6.0, -1.0 / 120.0, 1.0 / 5040.0));
    }
    let angle = sq.root();
    let (sin, half) = (angle.sine(), (angle * R::of(0.5)).sine());
    (sin / angle, R::of(2.0) * half * half / sq, (angle - sin) / (sq * angle))
}

/// The logarithm of `Σ to_i from_iᵀ`, at most half a turn; about `x` where it is exactly half a turn.
///
/// # Hard case
///
/// At half a turn the axis is read from the quaternion's largest part, so no digits are lost; at none it is zero.
fn rotation_vector<R: Real>(from: &[V3<R>; 3], to: &[V3<R>; 3]) -> V3<R> {
    let m = |r: usize, c: usize| {
        let entry = |v: &V3<R>, i: usize| v.0.get(i).copied().unwrap_or(R::ZERO);
        from.iter().zip(to).fold(R::ZERO, |sum, (f, t)| sum + entry(t, r) * entry(f, c))
    };
    let one = R::one();
    let (x, y, z) = (m(0, 0), m(1, 1), m(2, 2));
    let sum = V3([m(0, 1) + m(1, 0), m(0, 2) + m(2, 0), m(1, 2) + m(2, 1)]).0;
    let skew = [m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)];
    // Four times the quaternion's products with its largest part.
    let rows = [
        [one + x + y + z, skew[0], skew[1], skew[2]],
        [skew[0], one + x - y - z, sum[0], sum[1]],
        [skew[1], sum[0], one - x + y - z, sum[2]],
        [skew[2], sum[1], sum[2], one - x - y + z],
    ];
    let [a, b, c, d] = [rows[0][0], rows[1][1], rows[2][2], rows[3][3]];
    let largest = a.larger(b).larger(c.larger(d));
    let row = if a == largest {
        rows[0]
    } else if b == largest {
        rows[1]
    } else if c == largest {
        rows[2]
    } else {
        rows[3]
    };
    let (real, v) = (row[0], V3([row[1], row[2], row[3]]));
    let (size, v) = (v.norm(), if real < R::ZERO { -v } else { v });
    let turned = size > R::ZERO;
    if turned { v * (R::of(2.0) * angle(size, real.magnitude()) / size) } else { V3([R::ZERO; 3]) }
}

/// What a rotation vector's logarithm adds to a small turn before it: `x → J_l⁻¹(w) x`, or its transpose.
pub fn log_slope<R: Real>(w: V3<R>, x: V3<R>, transposed: bool) -> V3<R> {
    let sq = w.norm_sq();
    let b = if sq < R::of(1e-4) {
        R::of(1.0 / 12.0) + sq * R::of(1.0 / 720.0)
    } else {
        let half = sq.root() * R::of(0.5);
        (R::one() - half * half.cosine() / half.sine()) / sq
    };
    let a = R::of(if transposed { 0.5 } else { -0.5 });
    x + w.cross(x) * a + w.cross(w.cross(x)) * b
}
