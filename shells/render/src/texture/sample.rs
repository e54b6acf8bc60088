//! Reading a texture: trilinear, with several taps along the longer side of the footprint.
//!
//! A page that is bent away from the eye squeezes its print in one direction only. Choosing the mip
//! level by the *short* side of the pixel's footprint and averaging along the long side keeps the
//! text readable there.

use glam::{Vec2, Vec3};

use super::{Level, Texture};
use crate::fast::ceil;

/// Most taps along the footprint.
const MAX_TAPS: f32 = 8.0;
/// Slightly finer levels than the footprint asks for; the samples are not box-shaped and text gains.
const SHARPEN: f32 = -0.35;
/// A blend of two levels closer than this to one of them reads only that one.
const BLEND: f32 = 0.2;

/// What one pixel covers in the texture.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Footprint {
    /// Texture place of the pixel's middle, 0..1.
    pub(crate) uv: Vec2,
    /// Change of `uv` for one pixel to the right.
    pub(crate) dx: Vec2,
    /// Change of `uv` for one pixel down.
    pub(crate) dy: Vec2,
}

impl Footprint {
    /// The same pixel seen from the other side of the leaf, whose picture runs the other way.
    pub(crate) fn mirrored(self) -> Self {
        let flip = Vec2::new(-1.0, 1.0);
        Self { uv: Vec2::new(1.0 - self.uv.x, self.uv.y), dx: self.dx * flip, dy: self.dy * flip }
    }
}

impl Texture {
    /// Linear colour of the footprint; outside 0..1 the border is repeated.
    pub(crate) fn sample(&self, foot: &Footprint) -> Vec3 {
        let size = Vec2::new(self.levels[0].width as f32, self.levels[0].height as f32);
        let (dx, dy) = (foot.dx * size, foot.dy * size);
        let (long, short) =
            if dx.length_squared() > dy.length_squared() { (dx, dy) } else { (dy, dx) };
        let (l, s) = (long.length_squared().sqrt(), short.length_squared().sqrt().max(1e-6));
        if !(l < 1e9 && foot.uv.is_finite()) {
            return Vec3::ONE;
        }
        let taps = ceil((l / s).min(MAX_TAPS).min(l.max(1.0)) - 0.4).max(1);
        let (level, blend) = self.level((l / taps as f32).max(s.min(l)));
        let step = long / size / taps as f32;
        let mut uv = foot.uv - step * (0.5 * (taps - 1) as f32);
        let mut sum = [0.0; 4];
        for _ in 0..taps {
            self.levels[level].bilinear(uv, 1.0 - blend, &mut sum);
            if blend > 0.0 {
                self.levels[level + 1].bilinear(uv, blend, &mut sum);
            }
            uv += step;
        }
        // Texels are square roots of light in 0..255, see the module above.
        Vec3::new(sum[0], sum[1], sum[2]) / (taps as f32 * 255.0 * 255.0)
    }

    /// Linear colour around `uv` from one level only, for pictures without fine print; a pixel covers
    /// `texels` of the finest level.
    pub(crate) fn sample_soft(&self, uv: Vec2, texels: f32) -> Vec3 {
        let level = (texels.clamp(1.0, 1e6) as u32).ilog2() as usize;
        let mut sum = [0.0; 4];
        self.levels[level.min(self.levels.len() - 1)].bilinear(uv, 1.0, &mut sum);
        Vec3::new(sum[0], sum[1], sum[2]) / (255.0 * 255.0)
    }

    /// Texels of the finest level the longer side of the footprint covers.
    pub(crate) fn texels(&self, foot: &Footprint) -> f32 {
        let size = Vec2::new(self.levels[0].width as f32, self.levels[0].height as f32);
        (foot.dx * size).length_squared().max((foot.dy * size).length_squared()).sqrt()
    }

    /// Level for a footprint of `texels` a pixel, and the share of the next coarser one.
    fn level(&self, texels: f32) -> (usize, f32) {
        let last = self.levels.len() - 1;
        let exact = (texels.max(1e-6).log2() + SHARPEN).clamp(0.0, last as f32);
        let fine = exact as usize;
        let blend = exact - fine as f32;
        match blend {
            _ if fine == last => (last, 0.0),
            b if b < BLEND => (fine, 0.0),
            b if b > 1.0 - BLEND => (fine + 1, 0.0),
            b => (fine, (b - BLEND) / (1.0 - 2.0 * BLEND)),
        }
    }
}

impl Level {
    /// Adds the blend of the four texels around `uv`, times `weight`.
    #[inline]
    fn bilinear(&self, uv: Vec2, weight: f32, sum: &mut [f32; 4]) {
        let (x0, x1, fx) = neighbours(uv.x, self.width);
        let (y0, y1, fy) = neighbours(uv.y, self.height);
        let (top, bottom) = (y0 * self.width, y1 * self.width);
        let (upper, lower) = ((1.0 - fy) * weight, fy * weight);
        self.add(top + x0, (1.0 - fx) * upper, sum);
        self.add(top + x1, fx * upper, sum);
        self.add(bottom + x0, (1.0 - fx) * lower, sum);
        self.add(bottom + x1, fx * lower, sum);
    }

    #[inline]
    fn add(&self, at: usize, weight: f32, sum: &mut [f32; 4]) {
        let roots = self.texels[at].map(f32::from);
        for c in 0..4 {
            sum[c] += roots[c] * roots[c] * weight;
        }
    }
}

/// The two texels around place `u` on a line of `n`, and how far it is towards the second.
#[inline]
fn neighbours(u: f32, n: usize) -> (usize, usize, f32) {
    let place = (u * n as f32 - 0.5).clamp(0.0, (n - 1) as f32);
    let first = place as usize;
    (first, (first + 1).min(n - 1), place - first as f32)
}
