//! The room's share at a coarse grid of pixels, and between them.
//!
//! What a place sees of the room changes slowly, but asking for it is dear. It is asked at every
//! fourth pixel both ways; a pixel between takes the mean of its four neighbours where they lie on its
//! own surface and agree, and asks itself elsewhere: along outlines and where things touch.

use glam::Vec3;

use crate::hit::Hit;
use crate::shadow::SkyShare;

/// Pixels between two grid points.
pub(crate) const STRIDE: usize = 4;

/// Grid points that differ by more are not averaged.
const SMOOTH: f32 = 0.06;

/// One grid point: its surface, and what it sees.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Probe {
    /// Patch of the surface seen there; `u32::MAX` for none.
    pub(crate) patch: u32,
    pub(crate) near: f32,
    pub(crate) normal: Vec3,
    pub(crate) share: SkyShare,
}

impl Probe {
    /// Nothing is seen here.
    pub(crate) const NONE: Self = Self { patch: u32::MAX, near: 0.0, normal: Vec3::Y, share: SkyShare::OPEN };

    /// Whether this point lies on the surface of `hit`.
    fn fits(&self, patch: u32, hit: &Hit) -> bool {
        self.patch == patch && (self.near - hit.near).abs() < 0.03 * hit.near && self.normal.dot(hit.normal) > 0.94
    }
}

/// Grid points along a side of `pixels`.
pub(crate) fn points(pixels: usize) -> usize {
    pixels.div_ceil(STRIDE) + 1
}

/// The mean of the four grid points around pixel (`x`, `y`); `None` if one of them lies on another
/// surface or if they differ so much that a mean would smear a contact.
pub(crate) fn between(probes: &[Probe], columns: usize, x: usize, y: usize, patch: u32, hit: &Hit) -> Option<SkyShare> {
    let (column, row) = (x / STRIDE, y / STRIDE);
    let at = row * columns + column;
    let four = [&probes[at], &probes[at + 1], &probes[at + columns], &probes[at + columns + 1]];
    if !four.iter().all(|p| p.fits(patch, hit)) {
        return None;
    }
    let part = |place: usize| (place % STRIDE) as f32 / STRIDE as f32;
    let (fx, fy) = (part(x), part(y));
    let blend = |pick: fn(&SkyShare) -> f32| {
        let [a, b, c, d] = four.map(|p| pick(&p.share));
        let even = a.max(b).max(c.max(d)) - a.min(b).min(c.min(d)) < SMOOTH;
        let upper = a + (b - a) * fx;
        even.then(|| upper + (c + (d - c) * fx - upper) * fy)
    };
    Some(SkyShare { front: blend(|s| s.front)?, back: blend(|s| s.back)? })
}
