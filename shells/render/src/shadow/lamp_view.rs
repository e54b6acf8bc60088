//! The projection all of the lamp's maps share.
//!
//! They have one plane of projection through the book, parallel to the disc: a place at distance `z`
//! that the disc's centre sees at `c` is seen by the point `o` of the disc at `c + o (1 - D/z)`, so
//! a look-up costs two multiplications more than with one map.

use glam::{Vec2, Vec3};

use super::casters::{Casters, steady};
use crate::light::PointLight;

/// Points of the disc.
pub(super) const POINTS: usize = 16;
/// Side of one map, texels.
pub(super) const SIDE: usize = 544;
/// Places asked in each point's patch.
pub(super) const TAPS: usize = 3;

/// Where the lamp looks.
#[derive(Debug, Default, Clone, Copy)]
pub(super) struct View {
    pub(super) position: Vec3,
    right: Vec3,
    up: Vec3,
    ahead: Vec3,
    /// Distance of the plane of projection, metres.
    distance: f32,
    /// Texels per metre on that plane.
    scale: Vec2,
    /// Texel of the point opposite the lamp.
    centre: Vec2,
    /// Points of the disc, metres.
    points: [Vec2; POINTS],
    /// Radius of the disc, metres.
    radius: f32,
    /// Places within the patch of each point, patch radii.
    pub(super) taps: [[Vec2; TAPS]; POINTS],
}

impl View {
    /// Looks from the lamp at the middle of the casters.
    pub(super) fn new(light: &PointLight, casters: &Casters) -> Option<Self> {
        let (low, high) = casters.extent(|p| p)?;
        // The foot of what stands there, to the centimetre: it stays put while a leaf moves above it.
        let foot = Vec3::new(0.5 * (low.x + high.x), low.y, 0.5 * (low.z + high.z));
        let middle = (foot * 100.0).round() / 100.0;
        let ahead = (middle - light.position).try_normalize()?;
        let right = ahead.any_orthonormal_vector();
        let radius = light.radius_m.max(0.0);
        let mut view = Self {
            position: light.position,
            right,
            up: right.cross(ahead),
            ahead,
            distance: light.position.distance(middle),
            scale: Vec2::ONE,
            centre: Vec2::ZERO,
            points: disc(radius),
            radius,
            taps: std::array::from_fn(taps),
        };
        view.fit(casters)?;
        Some(view)
    }

    /// Chooses scale and centre so that every map holds all casters.
    fn fit(&mut self, casters: &Casters) -> Option<()> {
        let probe = *self;
        let (low, high) = casters.extent(|p| probe.project(p).unwrap_or_default())?;
        let margin = self.reach(low.z).max(self.reach(high.z)) + 0.002;
        let (low, high) = steady(low.truncate() - margin, high.truncate() + margin);
        self.scale = Vec2::splat(SIDE as f32 - 4.0) / (high - low).max(Vec2::splat(1e-6));
        self.centre = Vec2::splat(2.0) - low * self.scale;
        Some(())
    }

    /// Texel under the disc's centre, and nearness; `None` beside or behind the lamp.
    pub(super) fn project(&self, p: Vec3) -> Option<Vec3> {
        let d = p - self.position;
        let z = d.dot(self.ahead);
        if z < 1e-3 {
            return None;
        }
        let on_plane = Vec2::new(d.dot(self.right), d.dot(self.up)) * (self.distance / z);
        Some((on_plane * self.scale + self.centre).extend(1.0 / z))
    }

    /// How far point `i` of the disc sees a place of this nearness beside the centre, texels.
    pub(super) fn shift(&self, i: usize, nearness: f32) -> Vec2 {
        self.points[i] * (1.0 - self.distance * nearness) * self.scale
    }

    /// How far any point of the disc sees a place of this nearness beside the centre, texels.
    pub(super) fn reach(&self, nearness: f32) -> Vec2 {
        self.scale * ((1.0 - self.distance * nearness).abs() * self.radius)
    }

    /// How far the shadow of a blocker moves on a place when a point moves within its patch, texels; no
    /// less than what hides the steps of the maps themselves.
    pub(super) fn spread(&self, near: f32, blocker: f32) -> Vec2 {
        let patch = self.radius / (POINTS as f32).sqrt();
        (self.scale * (patch * self.distance * (blocker - near).abs())).max(Vec2::splat(1.2))
    }

    /// Side of a texel near `p`, metres.
    pub(super) fn texel_m(&self, p: Vec3) -> f32 {
        let z = (p - self.position).dot(self.ahead);
        (z / self.distance.max(1e-6)) / self.scale.min_element().max(1e-6)
    }
}

/// Points spread evenly over the disc; with their patches they stay inside it.
fn disc(radius: f32) -> [Vec2; POINTS] {
    std::array::from_fn(|i| {
        let r = ((i as f32 + 0.5) / POINTS as f32).sqrt() * 0.85;
        let angle = i as f32 * 2.399_963_2;
        Vec2::new(angle.cos(), angle.sin()) * (r * radius)
    })
}

/// Places within the patch of point `i`, turned from point to point.
fn taps(i: usize) -> [Vec2; TAPS] {
    std::array::from_fn(|k| {
        let angle = (k as f32 / TAPS as f32 + i as f32 * 0.618_034) * std::f32::consts::TAU;
        Vec2::new(angle.cos(), angle.sin()) * 0.75
    })
}
