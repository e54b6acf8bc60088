//! Vectors of two and three numbers (or lanes of numbers).

use super::Num;
use core::ops::{Add, Mul, Neg, Sub};

/// Three numbers: across the book (X), up the stack (Y), along the binding (Z).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct V3<T>(pub [T; 3]);

/// Two numbers in the plane of the midline: X and Y.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct V2<T>(pub [T; 2]);

macro_rules! vector {
    ($v:ident, $n:literal, $($i:literal),+) => {
        impl<T: Num> $v<T> {
            /// Nothing in every coordinate.
            #[inline(always)]
            pub fn zero() -> Self {
                Self([T::zero(); $n])
            }
            /// Inner product, summed from the first coordinate on.
            #[inline(always)]
            pub fn dot(self, o: Self) -> T {
                let p = [$(self.0[$i] * o.0[$i]),+];
                let mut sum = p[0];
                let mut rest = p.iter().skip(1);
                while let Some(&x) = rest.next() {
                    sum = sum + x;
                }
                sum
            }
            /// Squared length.
            #[inline(always)]
            pub fn norm_sq(self) -> T {
                self.dot(self)
            }
            /// Length.
            #[inline(always)]
            pub fn norm(self) -> T {
                self.norm_sq().root()
            }
        }
        impl<T: Num> Add for $v<T> {
            type Output = Self;
            #[inline(always)]
            fn add(self, o: Self) -> Self {
                Self([$(self.0[$i] + o.0[$i]),+])
            }
        }
        impl<T: Num> Sub for $v<T> {
            type Output = Self;
            #[inline(always)]
            fn sub(self, o: Self) -> Self {
                Self([$(self.0[$i] - o.0[$i]),+])
            }
        }
        impl<T: Num> Neg for $v<T> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self([$(-self.0[$i]),+])
            }
        }
        impl<T: Num> Mul<T> for $v<T> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, s: T) -> Self {
                Self([$(self.0[$i] * s),+])
            }
        }
    };
}

vector!(V3, 3, 0, 1, 2);
vector!(V2, 2, 0, 1);

impl<T: Num> V3<T> {
    /// A vector from its coordinates.
    #[inline(always)]
    pub fn new(x: T, y: T, z: T) -> Self {
        Self([x, y, z])
    }
    /// Right-handed cross product.
    #[inline(always)]
    pub fn cross(self, o: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.0, o.0);
        Self([b * f - c * e, c * d - a * f, a * e - b * d])
    }
    /// The part in the plane of the midline.
    #[inline(always)]
    pub fn xy(self) -> V2<T> {
        V2([self.0[0], self.0[1]])
    }
}

impl<T: Num> V2<T> {
    /// A vector from its coordinates.
    #[inline(always)]
    pub fn new(x: T, y: T) -> Self {
        Self([x, y])
    }
    /// Turned a quarter to the left: X becomes Y.
    #[inline(always)]
    pub fn left(self) -> Self {
        Self([-self.0[1], self.0[0]])
    }
    /// Signed area of the parallelogram.
    #[inline(always)]
    pub fn cross(self, o: Self) -> T {
        self.0[0] * o.0[1] - self.0[1] * o.0[0]
    }
}
