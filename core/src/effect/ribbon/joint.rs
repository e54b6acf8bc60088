//! One crease: how it turns what lies beyond it, with both derivatives.
//!
//! ```text
//! T = rotation by ψ about e = -(c, 1, 0)/s through the crease's middle,  s = √(1+c²);  ψ > 0 lifts the far side
//! dT/dψ T⁻¹ = [e]      dT/dc T⁻¹ = [sin ψ e' + (1-cos ψ)(0,0,-1/s²)]      e' = -(1,-c,0)/s³
//! ```
//!
//! Source: Ribbon App. A, with its angle counted from the perpendicular. Checked by `tests/ribbon_derivatives.rs`.

use super::elementary::sine_and_versine;
use super::frame::{Frame, Six, six};
use crate::real::{Num, Real, V3};

/// The two unknowns of a crease.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Crease<R> {
    /// Bending angle, radians.
    pub psi: R,
    /// Slope of the ruling: zero where it crosses the centreline at a right angle.
    pub c: R,
}

/// A crease with the roots and sines that its turn needs.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Turn<R> {
    /// The slope.
    pub c: R,
    /// `1/√(1+c²)`.
    pub inv_s: R,
    /// `sin ψ`.
    pub sin: R,
    /// `1 - cos ψ`.
    pub versine: R,
}

impl<R: Real> Turn<R> {
    /// No turn about a ruling across.
    pub const NONE: Self = Self { c: R::ZERO, inv_s: R::ZERO, sin: R::ZERO, versine: R::ZERO };

    /// Evaluates sines and roots.
    ///
    /// # Accuracy
    ///
    /// `1 - cos ψ` keeps its digits for small angles.
    #[inline]
    pub fn of(crease: Crease<R>) -> Self {
        let inv_s = R::one() / (R::one() + crease.c * crease.c).root();
        let [sin, versine] = sine_and_versine(crease.psi);
        Self { c: crease.c, inv_s, sin, versine }
    }
    /// The frame beyond the crease, `step` further along.
    #[inline]
    pub fn beyond(&self, f: &Frame<R>, step: R) -> Frame<R> {
        let Self { c, inv_s, sin, versine } = *self;
        let (k, q) = (versine * inv_s * inv_s, sin * inv_s);
        let cos = R::one() - versine;
        let t = f.t * (R::one() - k) + f.b * (c * k) + f.n * q;
        let n = f.t * -q + f.b * (c * q) + f.n * cos;
        Frame { t, b: n.cross(t), n, p: f.p + f.t * step }
    }
}

impl<T: Num> Turn<T> {
    /// World axes of `dψ` and `dc`: `f` is the frame before the crease.
    #[inline(always)]
    pub fn axes(&self, f: &Frame<T>) -> [V3<T>; 2] {
        let Self { c, inv_s, sin, versine } = *self;
        let r = inv_s * inv_s;
        let across = (f.t - f.b * c) * -(inv_s * r);
        [(f.t * c + f.b) * -inv_s, across * sin - f.n * (versine * r)]
    }
    /// Axes of the second derivatives `ψc` (once, not twice) and `cc`; that of `ψψ` is zero.
    #[inline(always)]
    pub fn second_axes(&self, f: &Frame<T>) -> [V3<T>; 2] {
        let Self { c, inv_s, sin, versine } = *self;
        let r = inv_s * inv_s;
        let (half, two) = (T::of(0.5), T::of(2.0));
        let across = (f.t - f.b * c) * -(inv_s * r);
        let mixed = (across * (two - versine) - f.n * (sin * r)) * half;
        let bend = f.t * (T::of(3.0) * c) + f.b * (T::one() - two * c * c);
        (mixed, bend * (inv_s * r * r * sin) + f.n * (two * c * r * r * versine)).into()
    }
}

/// A turn about an axis through a point, as a twist about the world's origin.
#[inline(always)]
pub fn about<T: Num>(axis: V3<T>, p: V3<T>) -> Six<T> {
    six(axis, p.cross(axis))
}
