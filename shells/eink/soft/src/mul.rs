//! Multiplies.

use crate::{HIDDEN, INFINITY, QUIET, SIGN};

/// `a b`, bits to bits.
///
/// ```text
/// m = m_a m_b    e = e_a + e_b - 127    s = s_a xor s_b
/// m_a m_b = h_a h_b 2¹⁶ + (h_a l_b + l_a h_b) 2⁸ + l_a l_b        m = h 2⁸ + l
/// ```
///
/// # Cost
///
/// Normal numbers with a normal product: no loop, no call, four short multiplications.
#[inline(always)]
#[must_use]
pub fn mul(a: u32, b: u32) -> u32 {
    let (e_a, e_b) = (a << 1 >> 24, b << 1 >> 24);
    let exponent = (e_a + e_b).wrapping_sub(128);
    // Also the product's exponent, less one as here or as it is, must be a normal number's.
    if e_a.wrapping_sub(1) >= 254 || e_b.wrapping_sub(1) >= 254 || exponent >= 252 {
        return rare(a, b);
    }
    normal(exponent, a << 8 | TOP, b << 8 | TOP) + ((a ^ b) & SIGN)
}

/// The hidden bit of a fraction that fills a word from above.
const TOP: u32 = 1 << 31;

/// The product of two fractions that fill a word from above, rounded. `exponent` is the product's less one, where its
/// first digit is not carried.
#[inline(always)]
fn normal(exponent: u32, m_a: u32, m_b: u32) -> u32 {
    let (high, low) = product(m_a, m_b);
    let m = high | u32::from(low != 0);
    // In both cases the hidden bit adds one to the exponent.
    if m & TOP == 0 { round(exponent, m << 1) } else { round(exponent + 1, m) }
}

/// `m_a m_b` of two fractions of 24 bits that fill a word from above: its first 32 bits and its other 16.
#[inline(always)]
fn product(m_a: u32, m_b: u32) -> (u32, u32) {
    let (h_a, l_a, h_b, l_b) = (m_a >> 16, m_a << 16 >> 24, m_b >> 16, m_b << 16 >> 24);
    let middle = h_a * l_b + l_a * h_b;
    let low = (middle << 24 >> 16) + l_a * l_b;
    (h_a * h_b + (middle >> 8) + (low >> 16), low << 16)
}

/// To the nearest, ties to even, from eight bits more than there is place for; what is carried out of the fraction
/// belongs to the exponent.
#[inline(always)]
fn round(exponent: u32, m: u32) -> u32 {
    let kept = m >> 8;
    (exponent << 23) + kept + (((m & 0xff) + 0x7f + (kept & 1)) >> 8)
}

/// Zeros, subnormals, infinities, NaN; products too large or too small.
#[inline(never)]
fn rare(a: u32, b: u32) -> u32 {
    let sign = (a ^ b) & SIGN;
    let (a, b) = (a & !SIGN, b & !SIGN);
    if a > INFINITY || b > INFINITY {
        return if a > INFINITY { a } else { b } | QUIET;
    }
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    if high == INFINITY {
        return if low == 0 { INFINITY | QUIET } else { sign | INFINITY };
    }
    if low == 0 {
        return sign;
    }
    sign | extreme(normalised(low), normalised(high))
}

/// Exponent and fraction, which fills a word from above, of a number that is not zero; subnormal numbers get exponents
/// below one.
fn normalised(number: u32) -> (i32, u32) {
    if number >= HIDDEN {
        return ((number >> 23) as i32, number << 8 | TOP);
    }
    let shift = number.leading_zeros() - 8;
    (1 - shift as i32, number << shift << 8)
}

/// The product of two numbers other than zero, of any exponents.
fn extreme((e_a, m_a): (i32, u32), (e_b, m_b): (i32, u32)) -> u32 {
    let exponent = e_a + e_b - 127;
    if exponent >= 255 {
        return INFINITY;
    }
    if exponent >= 1 {
        let product = normal(exponent as u32 - 1, m_a, m_b);
        return if product > INFINITY { INFINITY } else { product };
    }
    // A subnormal product is told in units of the smallest number: 2⁻¹⁴⁹.
    let shift = (1 - exponent) as u32;
    if shift > 25 {
        return 0;
    }
    let (high, low) = product(m_a, m_b);
    let whole = u64::from(high) << 16 | u64::from(low >> 16);
    let places = 23 + shift;
    let (m, rest, half) =
        ((whole >> places) as u32, whole & ((1 << places) - 1), 1 << (places - 1));
    m + u32::from(rest > half || (rest == half && m & 1 == 1))
}
