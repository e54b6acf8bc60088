//! Numbers side by side: eight of them, and as many as travel together through a kernel.
//!
//! Eight is fixed here, in the source, on every target: sums run in eight partial sums. Where there is a
//! vector unit a kernel takes eight rows at a time, elsewhere one: eight would only spill. A kernel with many
//! intermediate results takes as many as one register holds.
//!
//! # Determinism
//!
//! A row never meets another but where a kernel adds to the rows beside its own. It adds to row `k + 1`
//! first, then to `k`, then to `k - 1`: so each row gets its terms in the order of the rows they come from,
//! however many travel together. The feature `one-lane` makes it one everywhere, and the bits stay.

use super::{Num, Real};
use wide::{f32x4, f32x8, f64x2, f64x4, f64x8};

/// Partial sums, rows of a panel of the factor, and what the rows of a column are padded to.
pub const LANES: usize = 8;

/// What a kernel computes with: one row of a column, or several. Row `i` only ever meets row `i`.
pub trait Lanes<R: Real>: Num {
    /// Rows that travel together: at most [`LANES`].
    const WIDTH: usize;

    /// Lane by lane.
    fn each(lane: impl FnMut(usize) -> R) -> Self;

    /// Numbers from `from[at..]`; zeros where the slice is too short.
    fn load(from: &[R], at: usize) -> Self;
    /// Into `to[at..]`; nothing where the slice is too short.
    fn store(self, to: &mut [R], at: usize);
    /// The number in a lane; lanes are counted round.
    fn lane(self, i: usize) -> R;
    /// The same number in every lane.
    fn all(value: R) -> Self;
    /// One in the lanes of rows `k..` that are in `from..to`, else zero.
    fn mask(k: usize, from: usize, to: usize) -> Self;
    /// Largest lane.
    fn largest(self) -> R;
}

/// Exactly eight scalars.
pub trait Eight<R: Real>: Lanes<R> {
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
    /// Rows become columns.
    fn transpose(rows: [Self; LANES]) -> [Self; LANES];
}

/// One where `k` is in `from..to`, else zero.
#[inline(always)]
fn inside<R: Real>(k: usize, from: usize, to: usize) -> R {
    if (from..to).contains(&k) { R::of(1.0) } else { R::ZERO }
}

macro_rules! lanes {
    ($t:ty, $r:ty, $width:expr) => {
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
            const WIDTH: usize = $width;
            #[inline(always)]
            fn each(lane: impl FnMut(usize) -> $r) -> Self {
                Self::new(core::array::from_fn(lane))
            }
            #[inline(always)]
            fn load(from: &[$r], at: usize) -> Self {
                match from.get(at..).and_then(<[$r]>::first_chunk::<$width>) {
                    Some(lanes) => Self::new(*lanes),
                    None => Self::ZERO,
                }
            }
            #[inline(always)]
            fn store(self, to: &mut [$r], at: usize) {
                if let Some(lanes) = to.get_mut(at..).and_then(<[$r]>::first_chunk_mut::<$width>) {
                    *lanes = self.to_array();
                }
            }
            #[inline(always)]
            fn lane(self, i: usize) -> $r {
                self.to_array()[i % $width]
            }
            #[inline(always)]
            fn all(value: $r) -> Self {
                Self::splat(value)
            }
            #[inline(always)]
            fn mask(k: usize, from: usize, to: usize) -> Self {
                Self::new(core::array::from_fn(|lane| inside(k + lane, from, to)))
            }
            #[inline(always)]
            fn largest(self) -> $r {
                // Neighbours first, then pairs, then fours: in this order on every target.
                let mut lanes = self.to_array();
                for step in [1, 2, 4] {
                    for i in (0..$width - step.min($width)).step_by(2 * step) {
                        lanes[i] = lanes[i].larger(lanes[i + step]);
                    }
                }
                lanes[0]
            }
        }
    };
}

macro_rules! eight {
    ($t:ty, $r:ty) => {
        impl Eight<$r> for $t {
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

macro_rules! one {
    ($r:ty) => {
        impl Lanes<$r> for $r {
            const WIDTH: usize = 1;
            #[inline(always)]
            fn each(mut lane: impl FnMut(usize) -> $r) -> Self {
                lane(0)
            }
            #[inline(always)]
            fn load(from: &[$r], at: usize) -> Self {
                from.get(at).copied().unwrap_or(0.0)
            }
            #[inline(always)]
            fn store(self, to: &mut [$r], at: usize) {
                if let Some(slot) = to.get_mut(at) {
                    *slot = self;
                }
            }
            #[inline(always)]
            fn lane(self, _: usize) -> $r {
                self
            }
            #[inline(always)]
            fn all(value: $r) -> Self {
                value
            }
            #[inline(always)]
            fn mask(k: usize, from: usize, to: usize) -> Self {
                inside(k, from, to)
            }
            #[inline(always)]
            fn largest(self) -> $r {
                self
            }
        }
    };
}

lanes!(f32x4, f32, 4);
lanes!(f32x8, f32, LANES);
lanes!(f64x2, f64, 2);
lanes!(f64x4, f64, 4);
lanes!(f64x8, f64, LANES);
eight!(f32x8, f32);
eight!(f64x8, f64);
one!(f32);
one!(f64);
