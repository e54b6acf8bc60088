//! What places see of the lights, at a coarse grid of pixels, and between them.
//!
//! Asking the shadow maps is dear, and most answers are alike. They are asked at every fourth pixel
//! both ways. A pixel between takes the neighbours' answer where all four lie on its own surface
//! and agree; along outlines, where things touch, and in every penumbra it asks for itself.
//!
//! A shadow that begins at the thing that throws it is never missed: the cell the thing ends in has
//! a corner that does not fit, and every further cell the shadow reaches has a corner inside it.

use glam::Vec3;

use crate::hit::Hit;
use crate::lighting::Seen;
use crate::shadow::SkyShare;

/// Pixels between two grid points.
pub(crate) const STRIDE: usize = 4;
/// A grid point whose answer strays this far from the mean of its neighbours' stands at a contact.
const BEND: f32 = 0.05;
/// Grid points that differ by more are not averaged.
const SPREAD: f32 = 0.2;

/// One grid point: its surface, and what it sees.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Probe {
    /// Patch of the surface seen there; `u32::MAX` for none.
    pub(crate) patch: u32,
    pub(crate) near: f32,
    pub(crate) normal: Vec3,
    pub(crate) seen: Seen,
    /// Whether the room's share runs straight through here.
    pub(crate) straight: bool,
}

impl Probe {
    /// Nothing is seen here.
    pub(crate) const NONE: Self = Self {
        patch: u32::MAX,
        near: 0.0,
        normal: Vec3::Y,
        seen: Seen { sky: SkyShare { front: 1.0, back: 1.0 }, lamp: 1.0 },
        straight: false,
    };

    /// Whether this point lies on the surface with these properties.
    fn fits(&self, patch: u32, near: f32, normal: Vec3) -> bool {
        self.patch == patch && (self.near - near).abs() < 0.03 * near && self.normal.dot(normal) > 0.94
    }
}

/// Grid points along a side of `pixels`.
pub(crate) fn points(pixels: usize) -> usize {
    pixels.div_ceil(STRIDE) + 1
}

/// Whether the room's share at grid point `at` lies on the line through its neighbours, both ways.
/// Where the surface ends on one side, the other neighbour must agree outright.
pub(crate) fn straight(probes: &[Probe], columns: usize, at: usize) -> bool {
    let me = &probes[at];
    let (row, column) = (at / columns, at % columns);
    let fitting = |inside: bool, other: usize| {
        let other = if inside { probes.get(other) } else { None };
        other.filter(|o| o.fits(me.patch, me.near, me.normal))
    };
    let along = |before: Option<&Probe>, after: Option<&Probe>, pick: fn(&SkyShare) -> f32| {
        let value = |p: &Probe| pick(&p.seen.sky);
        let expected = match (before, after) {
            (Some(a), Some(b)) => 0.5 * (value(a) + value(b)),
            (Some(a), None) | (None, Some(a)) => value(a),
            (None, None) => value(me),
        };
        (value(me) - expected).abs() < BEND
    };
    let left = fitting(column > 0, at.wrapping_sub(1));
    let right = fitting(column + 1 < columns, at + 1);
    let above = fitting(row > 0, at.wrapping_sub(columns));
    let below = fitting(true, at + columns);
    let picks: [fn(&SkyShare) -> f32; 2] = [|s| s.front, |s| s.back];
    picks.into_iter().all(|pick| along(left, right, pick) && along(above, below, pick))
}

/// What the grid knows of a pixel; `None` where the pixel has to ask for itself.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Known {
    pub(crate) sky: Option<SkyShare>,
    pub(crate) lamp: Option<f32>,
}

/// What the four grid points around pixel (`x`, `y`) tell of it.
pub(crate) fn between(probes: &[Probe], columns: usize, x: usize, y: usize, patch: u32, hit: &Hit) -> Known {
    let (column, row) = (x / STRIDE, y / STRIDE);
    let at = row * columns + column;
    let four = [&probes[at], &probes[at + 1], &probes[at + columns], &probes[at + columns + 1]];
    if !four.iter().all(|p| p.fits(patch, hit.near, hit.normal)) {
        return Known { sky: None, lamp: None };
    }
    let lamp = four[0].seen.lamp;
    let agreed = (lamp == 0.0 || lamp == 1.0) && four.iter().all(|p| p.seen.lamp == lamp);
    Known { sky: blend(&four, x, y), lamp: agreed.then_some(lamp) }
}

/// The room's shares between four points, if they run straight there.
fn blend(four: &[&Probe; 4], x: usize, y: usize) -> Option<SkyShare> {
    let part = |place: usize| (place % STRIDE) as f32 / STRIDE as f32;
    let (fx, fy) = (part(x), part(y));
    let mix = |pick: fn(&SkyShare) -> f32| {
        let [a, b, c, d] = four.map(|p| pick(&p.seen.sky));
        let even = a.max(b).max(c.max(d)) - a.min(b).min(c.min(d)) < SPREAD;
        let upper = a + (b - a) * fx;
        even.then(|| upper + (c + (d - c) * fx - upper) * fy)
    };
    if !four.iter().all(|p| p.straight) {
        return None;
    }
    Some(SkyShare { front: mix(|s| s.front)?, back: mix(|s| s.back)? })
}
