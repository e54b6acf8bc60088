//! `f32` and `f64` as the core sees them.

use super::{Eight, Lanes, Num, small};
use core::ops::{AddAssign, MulAssign, SubAssign};
use nalgebra::{SMatrix, SVector};

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// A scalar the core runs on: `f32` in shells and firmware, `f64` as the oracle. Sealed.
pub trait Real:
    Num
    + PartialOrd
    + Default
    + AddAssign
    + SubAssign
    + MulAssign
    + nalgebra::Scalar
    + sealed::Sealed
    + Send
    + Sync
{
    /// As many as travel together through a kernel on this target.
    type Lanes: Lanes<Self>;
    /// As many as one vector register of this target holds.
    type Few: Lanes<Self>;
    /// Eight of them.
    type Eight: Eight<Self>;
    /// `"f32"` or `"f64"`.
    const NAME: &'static str;
    /// Zero, usable in constants.
    const ZERO: Self;
    /// One, usable in constants.
    const ONE: Self;
    /// Relative spacing of numbers near one.
    const EPSILON: f64;

    /// Exact widening.
    fn wide(self) -> f64;
    /// Nearest `f32`.
    fn narrow(self) -> f32;
    /// Bits for hashing: NaN is canonical, the sign of zero is kept.
    fn bits(self) -> u64;
    /// From the bits of [`Real::bits`].
    fn from_bits(bits: u64) -> Self;
    /// Neither infinite nor NaN.
    fn finite(self) -> bool;
    /// Sine by `libm`; never in an inner loop.
    fn sine(self) -> Self;
    /// Cosine by `libm`; never in an inner loop.
    fn cosine(self) -> Self;
    /// `e^self` by `libm`; never in an inner loop.
    fn exponential(self) -> Self;
    /// Solves a small symmetric positive definite system in place: `b` becomes the solution. False where it is not
    /// positive definite.
    fn solve_small<const D: usize>(a: &mut SMatrix<Self, D, D>, b: &mut SVector<Self, D>) -> bool;
}

#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
use dogleaf_root::root as root_f32;
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
use libm::sqrtf as root_f32;

macro_rules! real {
    ($t:ty, $lanes:ty, $wide:ty, $few:ty, $name:literal, $eps:expr, $bits:ty, $nan:literal, $sqrt:path, $sin:path, $cos:path, $exp:path) => {
        impl Num for $t {
            #[inline(always)]
            fn of(value: f64) -> Self {
                value as $t
            }
            #[inline(always)]
            fn root(self) -> Self {
                $sqrt(self)
            }
            #[inline(always)]
            fn larger(self, other: Self) -> Self {
                if self > other { self } else { other }
            }
            #[inline(always)]
            fn smaller(self, other: Self) -> Self {
                if self < other { self } else { other }
            }
            #[inline(always)]
            fn pick_less(a: Self, b: Self, yes: Self, no: Self) -> Self {
                if a < b { yes } else { no }
            }
        }

        impl Real for $t {
            #[cfg(all(
                not(feature = "one-lane"),
                any(target_feature = "sse2", target_feature = "neon", target_feature = "simd128")
            ))]
            type Lanes = $lanes;
            #[cfg(not(all(
                not(feature = "one-lane"),
                any(target_feature = "sse2", target_feature = "neon", target_feature = "simd128")
            )))]
            type Lanes = Self;
            #[cfg(all(not(feature = "one-lane"), target_feature = "avx"))]
            type Few = $wide;
            #[cfg(all(
                not(feature = "one-lane"),
                not(target_feature = "avx"),
                any(target_feature = "sse2", target_feature = "neon", target_feature = "simd128")
            ))]
            type Few = $few;
            #[cfg(not(all(
                not(feature = "one-lane"),
                any(target_feature = "sse2", target_feature = "neon", target_feature = "simd128")
            )))]
            type Few = Self;
            type Eight = $lanes;
            const NAME: &'static str = $name;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const EPSILON: f64 = $eps;
            #[inline(always)]
            fn wide(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn narrow(self) -> f32 {
                self as f32
            }
            #[inline(always)]
            fn bits(self) -> u64 {
                u64::from(if self == self { self.to_bits() } else { $nan })
            }
            #[inline(always)]
            fn from_bits(bits: u64) -> Self {
                <$t>::from_bits(bits as $bits)
            }
            #[inline(always)]
            fn finite(self) -> bool {
                self.is_finite()
            }
            fn sine(self) -> Self {
                $sin(self)
            }
            fn cosine(self) -> Self {
                $cos(self)
            }
            fn exponential(self) -> Self {
                $exp(self)
            }
            fn solve_small<const D: usize>(
                a: &mut SMatrix<Self, D, D>,
                b: &mut SVector<Self, D>,
            ) -> bool {
                small::solve(a.as_mut_slice(), b.as_mut_slice())
            }
        }
    };
}

real!(
    f32,
    wide::f32x8,
    wide::f32x8,
    wide::f32x4,
    "f32",
    1.1920929e-7,
    u32,
    0x7fc0_0000,
    root_f32,
    libm::sinf,
    libm::cosf,
    libm::expf
);
real!(
    f64,
    wide::f64x8,
    wide::f64x4,
    wide::f64x2,
    "f64",
    2.220446049250313e-16,
    u64,
    0x7ff8_0000_0000_0000,
    libm::sqrt,
    libm::sin,
    libm::cos,
    libm::exp
);
