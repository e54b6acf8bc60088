//! Repeatable noise for surfaces that have no picture.

use glam::Vec3;

use crate::fast::floor;

/// A number in 0..1 that looks random for a lattice place.
pub(super) fn hash(x: i32, y: i32) -> f32 {
    let mut h = (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77);
    h ^= h >> 15;
    h = h.wrapping_mul(0x2c1b_3c6d);
    h ^= h >> 12;
    h = h.wrapping_mul(0x297a_2d39);
    h ^= h >> 15;
    (h >> 8) as f32 / 16_777_216.0
}

fn smooth(t: f32) -> f32 {
    t * t * (3.0 - 2.0 * t)
}

/// Smooth noise in 0..1 with one feature a unit.
pub(super) fn value(x: f32, y: f32) -> f32 {
    let (ix, iy) = (floor(x), floor(y));
    let (tx, ty) = (smooth(x - ix as f32), smooth(y - iy as f32));
    let row = |j: i32| {
        let (a, b) = (hash(ix, iy.wrapping_add(j)), hash(ix.wrapping_add(1), iy.wrapping_add(j)));
        a + (b - a) * tx
    };
    let (top, bottom) = (row(0), row(1));
    top + (bottom - top) * ty
}

/// How much of a pattern with `period` survives a pixel of size `pixel`: 1 fine, 0 averaged away.
pub(super) fn survives(period: f32, pixel: f32) -> f32 {
    (period / (2.0 * pixel.max(1e-9)) - 0.5).clamp(0.0, 1.0)
}

/// Brightness of woven cloth around 1: threads where the pixel is small enough to see them.
pub(super) fn cloth(position: Vec3, pixel_m: f32) -> f32 {
    const THREAD_M: f32 = 0.0012;
    let (x, z) = (position.x + position.y, position.z + position.y);
    let weave = (x * (std::f32::consts::TAU / THREAD_M)).sin()
        * (z * (std::f32::consts::TAU / THREAD_M)).sin();
    let slub = value(x * 900.0, z * 160.0) + value(x * 160.0 + 40.0, z * 900.0) - 1.0;
    let worn = value(x * 35.0, z * 35.0) - 0.5;
    1.0 + 0.10 * survives(THREAD_M, pixel_m) * weave
        + 0.16 * survives(0.0022, pixel_m) * slub
        + 0.08 * worn
}
