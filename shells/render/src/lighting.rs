//! The light at a place: Eq. 15 summed over the room and the lamp, apart from the print.
//!
//! [`Light`] holds what the surface's colour is multiplied with, so that it can be worked out at
//! few places and laid over a finely printed page.

use std::f32::consts::{FRAC_1_PI, PI};

use glam::Vec3;

use crate::fast::unit;
use crate::hit::Hit;
use crate::light::Lights;
use crate::material::{Optics, Paint};
use crate::shade::{self, cook_torrance, environment_share, factors, schlick};
use crate::shadow::{Lamp, SkyShare};

/// A place that sees less than `1 / DEEP` of the room lies in a slit finer than the lamp's maps: the
/// innermost gutter, where a leaf touches a page. Less of the lamp gets there, too.
const DEEP: f32 = 3.0;

/// What stands between a place and the light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Seen {
    /// Shares of the room, for both sides.
    pub(crate) sky: SkyShare,
    /// Share of the lamp, for the side that faces it.
    pub(crate) lamp: f32,
}

/// Light at a place, to be multiplied with the surface's colours.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Light {
    /// `k_d` times the light that falls on the near side.
    pub(crate) diffuse: Vec3,
    /// `k_t` times the light that falls on the far side.
    pub(crate) through: Vec3,
    /// The mirrored light, complete.
    pub(crate) gloss: Vec3,
}

impl Light {
    /// No light at all.
    pub(crate) const NONE: Self =
        Self { diffuse: Vec3::ZERO, through: Vec3::ZERO, gloss: Vec3::ZERO };

    /// The light that reaches the eye from a surface of these colours.
    pub(crate) fn on(&self, optics: &Optics) -> Vec3 {
        optics.albedo * self.diffuse + optics.through * self.through + self.gloss
    }
}

/// Mirrored share of paper, cloth and wood at normal incidence.
fn f0() -> f32 {
    shade::normal_reflectance(shade::PAPER_IOR)
}

/// All light at `hit`.
pub(crate) fn light(hit: &Hit, paint: &Paint, lights: &Lights, seen: Seen) -> Light {
    let mut light = room(hit, paint, lights, seen.sky);
    point(hit, paint, lights, seen, &mut light);
    light
}

/// The room's part: pre-integrated, dimmed by what stands in the way.
fn room(hit: &Hit, paint: &Paint, lights: &Lights, sky: SkyShare) -> Light {
    let n_v = hit.normal.dot(hit.view).max(0.05);
    let fresnel = environment_share(f0(), paint.roughness, n_v);
    let k = factors(fresnel, fresnel, paint.passing);
    let room = &lights.environment;
    let mirror = hit.normal * (2.0 * n_v) - hit.view;
    let mut light = Light {
        diffuse: room.irradiance(hit.normal) * bounced(sky.front, paint.pale) * k.diffuse,
        through: Vec3::ZERO,
        gloss: room.mirrored(mirror, paint.roughness) * (k.specular * sky.front * sky.front),
    };
    if paint.passing > 0.0 {
        light.through =
            room.irradiance(-hit.normal) * bounced(sky.back, paint.pale) * k.transmitted;
    }
    light
}

/// What is hidden from the room is not black: its neighbours are paper too and hand light on. The
/// paler the surface, the less the occlusion darkens it.
fn bounced(open: f32, albedo: Vec3) -> Vec3 {
    let a = 2.0404 * albedo - 0.3324;
    let b = -4.7951 * albedo + 0.6417;
    let c = 2.7552 * albedo + 0.6903;
    (((a * open + b) * open + c) * open).max(Vec3::splat(open))
}

/// Adds the lamp's part. A leaf lit from behind shines by what passes through it.
fn point(hit: &Hit, paint: &Paint, lights: &Lights, seen: Seen, light: &mut Light) {
    let to_lamp = lights.point.position - hit.position;
    let d2 = to_lamp.length_squared().max(1e-6);
    let l = to_lamp / d2.sqrt();
    let n_l = hit.normal.dot(l);
    let enclosed = if n_l >= 0.0 { seen.sky.front } else { seen.sky.back };
    let seen = seen.lamp * (enclosed * DEEP).min(1.0);
    if seen <= 0.0 {
        return;
    }
    let fresnel = schlick(f0(), n_l.abs());
    let k = factors(fresnel, fresnel, paint.passing);
    let falling = lights.point.colour * (FRAC_1_PI / d2 * n_l.abs() * seen);
    if n_l < 0.0 {
        light.through += falling * k.transmitted;
        return;
    }
    let n_v = hit.normal.dot(hit.view).max(0.05);
    let half = unit(l + hit.view, hit.normal);
    let lobe = cook_torrance(n_l, n_v, hit.normal.dot(half).max(0.0), paint.roughness);
    light.diffuse += falling * k.diffuse;
    light.gloss += falling * (schlick(f0(), half.dot(l)) * lobe * PI);
}

/// Share of the lamp seen from the side of the surface that faces it.
///
/// The place is lifted off the surface, the more the flatter the light comes in: one texel of the
/// map then never lies behind its own surface. Light from behind starts on the far side of the leaf.
pub(crate) fn lamp_share(hit: &Hit, paint: &Paint, position: Vec3, lamp: &Lamp) -> f32 {
    let l = unit(position - hit.position, Vec3::Y);
    let behind = hit.normal.dot(l) < 0.0;
    if behind && paint.passing <= 0.0 {
        return 0.0;
    }
    let (side, depth) = if behind { (-hit.face, paint.thickness_m) } else { (hit.face, 0.0) };
    let texel = lamp.texel_m(hit.position);
    let cos = side.dot(l).clamp(0.0, 1.0);
    let sin = (1.0 - cos * cos).sqrt();
    let lifted = hit.position + side * (depth + texel * (0.25 + 1.1 * sin));
    lamp.seen(lifted, texel * 0.5)
}
