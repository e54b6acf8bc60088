//! The scalar type: the only door to `libm`, and the lanes that eight rows of a leaf share.
//!
//! Every kernel is written once over [`Num`] and runs on one number or on
//! eight rows at a time ([`Lanes`]). Additions and multiplications are never fused and lanes are
//! never summed in an order the target could choose, so all targets produce the same bits.
//!
//! Source: ours; the rules are in `ARCHITECTURE.md`, "The same bits". Checked by `tests/lanes.rs`.

mod lanes;
mod scalar;
mod small;
mod vec3;

pub use lanes::{Eight, LANES, Lanes};
pub use scalar::Real;
pub use vec3::{V2, V3};

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// What a kernel may do with a number, or with eight at once.
pub trait Num:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The constant nearest to `value`, in every lane.
    fn of(value: f64) -> Self;
    /// Square root, correctly rounded on every target.
    fn root(self) -> Self;
    /// `self` where `self > other`, else `other`: the same for `-0`, `+0` and NaN on every target.
    fn larger(self, other: Self) -> Self;
    /// `self` where `self < other`, else `other`.
    fn smaller(self, other: Self) -> Self;
    /// Lane by lane: `yes` where `a < b`, else `no`.
    fn pick_less(a: Self, b: Self, yes: Self, no: Self) -> Self;

    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::of(0.0)
    }
    /// One.
    #[inline(always)]
    fn one() -> Self {
        Self::of(1.0)
    }
    /// Magnitude.
    #[inline(always)]
    fn magnitude(self) -> Self {
        self.larger(-self)
    }
}
