//! Adds.

use crate::{FRACTION, HIDDEN, INFINITY, QUIET, SIGN};

/// Bits below the fraction's last while it is summed: guard, round, and those that are one where anything was lost.
const BELOW: u32 = 7;
/// The hidden bit above them.
const TOP: u32 = HIDDEN << BELOW;

/// `a + b`, bits to bits.
///
/// ```text
/// |a| ≥ |b|    m = m_a ± m_b 2^-(e_a - e_b)    e = e_a    s = s_a
/// ```
///
/// # Cost
///
/// Normal numbers with a normal sum: no call; a loop only where digits cancel, at most eleven rounds.
#[inline(always)]
#[must_use]
pub fn add(a: u32, b: u32) -> u32 {
    let (a, b) = if a << 1 < b << 1 { (b, a) } else { (a, b) };
    let (e_a, e_b) = (a << 1 >> 24, b << 1 >> 24);
    if e_b == 0 || e_a == 255 {
        return rare(a, b);
    }
    let apart = e_a - e_b;
    if apart > 25 {
        return a;
    }
    let (m_a, m_b) = ((a << 8 | SIGN) >> 1, (b << 8 | SIGN) >> 1);
    sum(a, b, e_a, m_a, shifted(m_b, apart))
}

/// The sum of two fractions with guard bits at one exponent, with the sign of `a`.
#[inline(always)]
fn sum(a: u32, b: u32, exponent: u32, m_a: u32, m_b: u32) -> u32 {
    let sign = a & SIGN;
    if ((a ^ b) as i32) < 0 {
        less(sign, exponent, m_a - m_b)
    } else {
        more(sign, exponent, m_a + m_b)
    }
}

/// `m 2^-by`, its last bit set if anything was lost. `by` is below 32.
#[inline(always)]
fn shifted(m: u32, by: u32) -> u32 {
    let kept = m >> by;
    kept | u32::from(kept << by != m)
}

/// A sum of equal signs: the fraction may have grown by a bit.
#[inline(always)]
fn more(sign: u32, exponent: u32, m: u32) -> u32 {
    if (m as i32) >= 0 {
        return round(sign, exponent, m);
    }
    if exponent == 254 {
        return sign | INFINITY;
    }
    round(sign, exponent + 1, m >> 1 | m & 1)
}

/// A difference: the fraction may have lost bits in front.
#[inline(always)]
fn less(sign: u32, mut exponent: u32, mut m: u32) -> u32 {
    if m == 0 {
        return 0;
    }
    while m < TOP >> 3 && exponent > 4 {
        (m, exponent) = (m << 4, exponent - 4);
    }
    while m < TOP && exponent > 1 {
        (m, exponent) = (m << 1, exponent - 1);
    }
    round(sign, exponent, m)
}

/// To the nearest, ties to even. The hidden bit adds one to the exponent; a subnormal sum, of exponent one, lacks it.
#[inline(always)]
fn round(sign: u32, exponent: u32, m: u32) -> u32 {
    let m = (m + (HALF - 1) + (m >> BELOW & 1)) >> BELOW;
    sign + ((exponent - 1) << 23) + m
}

/// Half of the fraction's last bit.
const HALF: u32 = 1 << (BELOW - 1);

/// Zeros, subnormals, infinities, NaN. `|a| ≥ |b|`.
#[inline(never)]
fn rare(a: u32, b: u32) -> u32 {
    let (size, less) = (a & !SIGN, b & !SIGN);
    if size > INFINITY {
        return a | QUIET;
    }
    if size == INFINITY {
        // What is left of b is a number, an infinity, or its opposite.
        return if less == INFINITY && a != b { INFINITY | QUIET } else { a };
    }
    if less == 0 {
        return if size == 0 { a & b } else { a };
    }
    // b is subnormal: its exponent is that of the smallest normal number, without the hidden bit.
    let one =
        |number: u32| if number << 1 >> 24 == 0 { (1, 0) } else { (number << 1 >> 24, HIDDEN) };
    let ((e_a, hidden), (e_b, _)) = (one(a), one(b));
    let apart = e_a - e_b;
    if apart > 25 {
        return a;
    }
    let m_a = ((a & FRACTION) | hidden) << BELOW;
    sum(a, b, e_a, m_a, shifted((b & FRACTION) << BELOW, apart))
}
