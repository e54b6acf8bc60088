//! Small arithmetic for the innermost loops.
//!
//! The baseline x86-64 has no rounding instruction, and glam (kept on software maths for the core's
//! sake) has no inlined square root; both would be calls here, a few million a frame.

use glam::Vec3;

/// Largest whole number not above `x`, for |x| below 2³¹.
#[inline]
pub(crate) fn floor(x: f32) -> i32 {
    let cut = x as i32;
    cut - i32::from((cut as f32) > x)
}

/// Smallest whole number not below `x`, for |x| below 2³¹.
#[inline]
pub(crate) fn ceil(x: f32) -> i32 {
    let cut = x as i32;
    cut + i32::from((cut as f32) < x)
}

/// `v` at length one, or `otherwise` if it has none.
#[inline]
pub(crate) fn unit(v: Vec3, otherwise: Vec3) -> Vec3 {
    let d = v.length_squared();
    if d > 1e-30 && d < f32::INFINITY { v * (1.0 / d.sqrt()) } else { otherwise }
}
