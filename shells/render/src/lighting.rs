//! The light a place sends to the eye: Eq. 15 summed over the room and the lamp.

use std::f32::consts::{FRAC_1_PI, PI};

use glam::Vec3;

use crate::fast::unit;
use crate::hit::Hit;
use crate::light::Lights;
use crate::material::{Optics, Sheet};
use crate::shade::{self, cook_torrance, environment_share, factors, schlick};
use crate::shadow::{Lamp, SkyShare};

/// Mirrored share of paper, cloth and wood at normal incidence.
fn f0() -> f32 {
    shade::normal_reflectance(shade::PAPER_IOR)
}

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

/// All light from `hit` to the eye.
pub(crate) fn shine(hit: &Hit, optics: &Optics, lights: &Lights, seen: Seen) -> Vec3 {
    room(hit, optics, lights, seen.sky) + point(hit, optics, lights, seen)
}

/// The room's part: pre-integrated, dimmed by what stands in the way.
fn room(hit: &Hit, optics: &Optics, lights: &Lights, sky: SkyShare) -> Vec3 {
    let n_v = hit.normal.dot(hit.view).max(0.05);
    let fresnel = environment_share(f0(), optics.roughness, n_v);
    let k = factors(fresnel, fresnel, optics.sheet.passing);
    let front = lights.environment.irradiance(hit.normal) * bounced(sky.front, optics.albedo);
    let mut light = optics.albedo * front * k.diffuse;
    if optics.sheet.passing > 0.0 {
        let back = lights.environment.irradiance(-hit.normal) * bounced(sky.back, optics.albedo);
        light += optics.through * back * k.transmitted;
    }
    let mirror = hit.normal * (2.0 * n_v) - hit.view;
    light + lights.environment.mirrored(mirror, optics.roughness) * (k.specular * sky.front * sky.front)
}

/// What is hidden from the room is not black: its neighbours are paper too and hand light on. The
/// paler the surface, the less the occlusion darkens it.
fn bounced(open: f32, albedo: Vec3) -> Vec3 {
    let a = 2.0404 * albedo - 0.3324;
    let b = -4.7951 * albedo + 0.6417;
    let c = 2.7552 * albedo + 0.6903;
    (((a * open + b) * open + c) * open).max(Vec3::splat(open))
}

/// The lamp's part, with its shadow. A leaf lit from behind shines by what passes through it.
fn point(hit: &Hit, optics: &Optics, lights: &Lights, seen: Seen) -> Vec3 {
    let to_lamp = lights.point.position - hit.position;
    let d2 = to_lamp.length_squared().max(1e-6);
    let l = to_lamp / d2.sqrt();
    let n_l = hit.normal.dot(l);
    if n_l <= 0.0 && optics.sheet.passing <= 0.0 {
        return Vec3::ZERO;
    }
    let fresnel = schlick(f0(), n_l.abs());
    let k = factors(fresnel, fresnel, optics.sheet.passing);
    let light = lights.point.colour * (FRAC_1_PI / d2);
    let enclosed = if n_l >= 0.0 { seen.sky.front } else { seen.sky.back };
    let seen = seen.lamp * (enclosed * DEEP).min(1.0);
    if n_l < 0.0 {
        return optics.through * light * (k.transmitted * -n_l * seen);
    }
    let n_v = hit.normal.dot(hit.view).max(0.05);
    let half = unit(l + hit.view, hit.normal);
    let gloss = cook_torrance(n_l, n_v, hit.normal.dot(half).max(0.0), optics.roughness);
    let gloss = schlick(f0(), half.dot(l)) * gloss * PI;
    light * ((optics.albedo * k.diffuse + Vec3::splat(gloss)) * (n_l * seen))
}

/// Share of the lamp seen from the side of the surface that faces it.
///
/// The place is lifted off the surface, the more the flatter the light comes in: one texel of the
/// map then never lies behind its own surface. Light from behind starts on the far side of the leaf.
pub(crate) fn lamp_share(hit: &Hit, sheet: Sheet, position: Vec3, lamp: &Lamp) -> f32 {
    let l = unit(position - hit.position, Vec3::Y);
    let behind = hit.normal.dot(l) < 0.0;
    if behind && sheet.passing <= 0.0 {
        return 0.0;
    }
    let (side, depth) = if behind { (-hit.face, sheet.thickness_m) } else { (hit.face, 0.0) };
    let texel = lamp.texel_m(hit.position);
    let cos = side.dot(l).clamp(0.0, 1.0);
    let sin = (1.0 - cos * cos).sqrt();
    let lifted = hit.position + side * (depth + texel * (0.25 + 1.1 * sin));
    lamp.seen(lifted, texel * 0.5)
}
