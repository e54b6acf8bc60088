//! Canaries of the floating-point unit's modes. Nothing here may be computed by the compiler.

use crate::real::Real;
use core::hint::black_box;

/// Sums are rounded to nearest, ties to even, on both sides of zero.
///
/// ```text
/// 1 + ε/2 = 1     1 + 3ε/4 = 1 + ε     (1 + ε) + ε/2 = 1 + 2ε
/// ```
///
/// Upwards breaks the first, downwards and towards zero the second, ties away from zero the first.
pub(super) fn rounds_to_nearest<R: Real>() -> bool {
    let part = |share: f64| black_box(R::of(R::EPSILON * share));
    let one = black_box(R::of(1.0));
    let next = black_box(R::of(1.0 + R::EPSILON));
    let after = black_box(R::of(1.0 + 2.0 * R::EPSILON));
    let positive = one + part(0.5) == one && one + part(0.75) == next && next + part(0.5) == after;
    let negative =
        -one - part(0.5) == -one && -one - part(0.75) == -next && -next - part(0.5) == -after;
    positive && negative
}

/// Half of the smallest normal number is not zero, and the smallest subnormal one is not either.
///
/// The first breaks where results are flushed, the second where operands are.
pub(super) fn keeps_subnormals<R: Real>() -> bool {
    let single = size_of::<R>() == size_of::<f32>();
    let normal: u64 = if single { 0x0080_0000 } else { 0x0010_0000_0000_0000 };
    let smallest = black_box(R::from_bits(normal));
    let half = black_box(smallest * black_box(R::of(0.5)));
    let least = black_box(R::from_bits(1));
    let doubled = black_box(least + least);
    half.bits() == normal / 2 && doubled.bits() == 2
}
