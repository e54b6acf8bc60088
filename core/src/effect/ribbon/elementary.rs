//! Logarithm, arc tangent and `atanh(q)/q` from roots and quotients alone: the same bits on every target.
//!
//! An argument is brought near zero by halving (`x → √x`, `x → x/(1+√(1±x²))`), where an odd series is short.

use crate::real::Real;

/// Terms of a series: `1/16` to this power is below the spacing of `f64`.
const TERMS: u32 = 14;
/// Halvings at most; each more than halves an argument below one, and any finite root comes near one.
const HALVINGS: u32 = 12;

/// `Σ zᵏ/(2k+1)`: `atanh(q)/q` at `z = q²`, `atan(x)/x` at `z = -x²`.
fn odd<R: Real>(z: R) -> R {
    (0..=TERMS).rev().fold(R::ZERO, |sum, k| sum * z + R::one() / R::of(f64::from(2 * k + 1)))
}

/// Natural logarithm of a positive number of moderate size.
///
/// # Accuracy
///
/// Sixteen roundings between `1e-300` and `1e300`.
pub fn logarithm<R: Real>(value: R) -> R {
    let (mut x, mut scale) = (value, R::of(2.0));
    for _ in 0..HALVINGS {
        if (x - R::one()).magnitude() < R::of(0.25) {
            break;
        }
        x = x.root();
        scale = scale + scale;
    }
    let t = (x - R::one()) / (x + R::one());
    scale * t * odd(t * t)
}

/// `atan2(y, x)` for `y, x ≥ 0`, not both zero.
pub fn angle<R: Real>(y: R, x: R) -> R {
    let steep = y > x;
    let (mut t, mut scale) = (if steep { x / y } else { y / x }, R::one());
    for _ in 0..HALVINGS {
        if t < R::of(0.25) {
            break;
        }
        t = t / (R::one() + (R::one() + t * t).root());
        scale = scale + scale;
    }
    let small = scale * t * odd(-(t * t));
    if steep { R::of(core::f64::consts::FRAC_PI_2) - small } else { small }
}

/// Angles below this have a short series.
const SHORT: f64 = 0.75;
/// `±1/k!` of the odd and of the even powers, from the third and the second on.
const SINE: [f64; 7] = inverse_factorials(3);
const VERSINE: [f64; 8] = inverse_factorials(2);

const fn inverse_factorials<const K: usize>(first: u32) -> [f64; K] {
    let (mut all, mut power, mut factorial, mut i) = ([0.0; K], 1, 1.0, 0);
    while i < K {
        while power < first + 2 * i as u32 {
            power += 1;
            factorial *= power as f64;
        }
        all[i] = if i % 2 == 0 { 1.0 / factorial } else { -1.0 / factorial };
        i += 1;
    }
    all
}

/// `Σ kᵢ zⁱ` of eight, in pairs: a polynomial that does not wait for itself.
#[inline(always)]
fn eight<R: Real>(k: [f64; 8], z: R) -> R {
    let [a, b, c, d, e, f, g, h] = k.map(R::of);
    let (z2, low, high) = (z * z, (a + b * z, c + d * z), (e + f * z, g + h * z));
    (low.0 + low.1 * z2) + (high.0 + high.1 * z2) * (z2 * z2)
}

/// `sin ψ` and `1 - cos ψ`.
///
/// # Accuracy
///
/// Some three roundings; `1 - cos ψ` keeps its digits for small angles.
#[inline]
pub fn sine_and_versine<R: Real>(psi: R) -> [R; 2] {
    if psi.magnitude() < R::of(SHORT) {
        let (z, [a, b, c, d, e, f, g]) = (psi * psi, SINE);
        let less = eight([a, b, c, d, e, f, g, 0.0], z);
        return [psi - psi * z * less, z * eight(VERSINE, z)];
    }
    let half = psi * R::of(0.5);
    let (sin, cos) = (half.sine(), half.cosine());
    let two = R::of(2.0);
    [two * sin * cos, two * sin * sin]
}

/// `A(q) = atanh(q)/q` with its first and second derivative, for `|q| < 1`.
///
/// # Accuracy
///
/// Some ten roundings; the second derivative loses two digits more near `|q| = 1/4`.
pub fn hyperbolic<R: Real>(q: R) -> [R; 3] {
    let z = q * q;
    if z < R::of(0.0625) {
        return hyperbolic_near_zero(q, z);
    }
    let (mut t, mut scale) = (q, R::one());
    for _ in 0..HALVINGS {
        if t.magnitude() < R::of(0.25) {
            break;
        }
        t = t / (R::one() + (R::one() - t * t).larger(R::ZERO).root());
        scale = scale + scale;
    }
    let a = scale * t * odd(t * t) / q;
    let r = R::one() / (R::one() - z);
    let slope = (r - a) / q;
    [a, slope, R::of(2.0) * (q * r * r - slope) / q]
}

fn hyperbolic_near_zero<R: Real>(q: R, z: R) -> [R; 3] {
    let [mut a, mut first, mut second] = [R::ZERO; 3];
    for k in (0..=TERMS).rev() {
        let (k, share) = (f64::from(k), R::one() / R::of(f64::from(2 * k + 1)));
        a = a * z + share;
        if k > 0.0 {
            first = first * z + share * R::of(2.0 * k);
            second = second * z + share * R::of(2.0 * k * (2.0 * k - 1.0));
        }
    }
    [a, first * q, second]
}
