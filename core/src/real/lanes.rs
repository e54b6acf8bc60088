//! Eight numbers side by side; the lane count is fixed here, in the source, on every target.

use super::{Num, Real};
use wide::{f32x8, f64x8};

/// How many rows travel together.
pub const LANES: usize = 8;

/// Eight scalars. Lane `i` only ever meets lane `i`, except in [`Lanes::sum`], whose order is fixed.
pub trait Lanes<R: Real>: Num {
    /// Eight numbers from `from[at..at + 8]`; zeros where the slice is too short.
    fn load(from: &[R], at: usize) -> Self;
    /// Into `to[at..at + 8]`; nothing where the slice is too short.
    fn store(self, to: &mut [R], at: usize);
    /// The same number in every lane.
    fn all(value: R) -> Self;
    /// The lanes as an array.
    fn array(self) -> [R; LANES];
    /// Lanes from an array.
    fn from_array(values: [R; LANES]) -> Self;

    /// `((0+1)+(2+3))+((4+5)+(6+7))`, in this order on every target.
    #[inline(always)]
    fn sum(self) -> R {
        let [a, b, c, d, e, f, g, h] = self.array();
        ((a + b) + (c + d)) + ((e + f) + (g + h))
    }
    /// Largest lane.
    #[inline(always)]
    fn largest(self) -> R {
        let [a, b, c, d, e, f, g, h] = self.array();
        a.larger(b).larger(c.larger(d)).larger(e.larger(f).larger(g.larger(h)))
    }
    /// Rows become columns.
    fn transpose(rows: [Self; LANES]) -> [Self; LANES];
}

macro_rules! lanes {
    ($t:ty, $r:ty) => {
        impl Num for $t {
            #[inline(always)]
            fn of(value: f64) -> Self {
                Self::splat(value as $r)
            }
            #[inline(always)]
            fn root(self) -> Self {
                // `wide` falls back to a root of its own where there is no vector unit.
                if cfg!(any(
                    target_feature = "sse2",
                    target_feature = "neon",
                    target_feature = "simd128"
                )) {
                    self.sqrt()
                } else {
                    Self::new(self.to_array().map(Num::root))
                }
            }
            #[inline(always)]
            fn larger(self, other: Self) -> Self {
                self.simd_gt(other).select(self, other)
            }
            #[inline(always)]
            fn smaller(self, other: Self) -> Self {
                self.simd_lt(other).select(self, other)
            }
            #[inline(always)]
            fn pick_less(a: Self, b: Self, yes: Self, no: Self) -> Self {
                a.simd_lt(b).select(yes, no)
            }
        }

        impl Lanes<$r> for $t {
            #[inline(always)]
            fn load(from: &[$r], at: usize) -> Self {
                match from.get(at..).and_then(<[$r]>::first_chunk::<LANES>) {
                    Some(eight) => Self::new(*eight),
                    None => Self::ZERO,
                }
            }
            #[inline(always)]
            fn store(self, to: &mut [$r], at: usize) {
                if let Some(eight) = to.get_mut(at..).and_then(<[$r]>::first_chunk_mut::<LANES>) {
                    *eight = self.to_array();
                }
            }
            #[inline(always)]
            fn all(value: $r) -> Self {
                Self::splat(value)
            }
            #[inline(always)]
            fn array(self) -> [$r; LANES] {
                self.to_array()
            }
            #[inline(always)]
            fn from_array(values: [$r; LANES]) -> Self {
                Self::new(values)
            }
            #[inline(always)]
            fn transpose(rows: [Self; LANES]) -> [Self; LANES] {
                <$t>::transpose(rows)
            }
        }
    };
}

lanes!(f32x8, f32);
lanes!(f64x8, f64);
