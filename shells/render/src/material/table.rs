//! The table top: calm dark wood, or plain cloth when the grain is zero.
//!
//! The grain is drawn once into a picture, stretched along X, and read like a
//! page: computing its layers at every pixel would cost more than the light on it.

use std::sync::LazyLock;

use glam::{Vec2, Vec3};

use super::Spot;
use super::noise::value;
use crate::fast::floor;
use crate::texture::Texture;

/// Size of the picture, texels.
const SIZE: (u32, u32) = (192, 1536);
/// Size of the picture on the table, metres; it is mirrored beyond.
const PATCH_M: Vec2 = Vec2::new(1.6, 0.8);

/// Texels per metre across the grain.
const FINEST_PER_M: f32 = SIZE.1 as f32 / PATCH_M.y;

static GRAIN: LazyLock<Option<Texture>> = LazyLock::new(draw);

/// Colour of the table at `spot` around 1.
pub(super) fn shade(grain: f32, spot: &Spot) -> Vec3 {
    match &*GRAIN {
        Some(picture) if grain > 0.0 => {
            let wood = picture.sample_soft(uv(spot.position), spot.pixel_m * FINEST_PER_M) * 4.0;
            Vec3::ONE + (wood - 1.0) * grain.min(1.0)
        }
        _ => Vec3::ONE,
    }
}

/// Where a place lies in the picture.
fn uv(position: Vec3) -> Vec2 {
    let mirrored = |place: f32| {
        let half = 0.5 * place + 0.18;
        1.0 - (2.0 * (half - floor(half) as f32) - 1.0).abs()
    };
    Vec2::new(mirrored(position.x / PATCH_M.x), mirrored(position.z / PATCH_M.y))
}

/// Light of the wood, a quarter of it, so that bright streaks fit into a byte.
fn draw() -> Option<Texture> {
    let mut rgba = Vec::with_capacity((SIZE.0 * SIZE.1 * 4) as usize);
    for y in 0..SIZE.1 {
        for x in 0..SIZE.0 {
            let place =
                Vec2::new((x as f32 + 0.5) / SIZE.0 as f32, (y as f32 + 0.5) / SIZE.1 as f32)
                    * PATCH_M;
            let light = wood(place);
            rgba.extend(light.to_array().map(|c| crate::tone::encode_byte(c * 0.25)));
            rgba.push(255);
        }
    }
    Texture::from_rgba8(SIZE.0, SIZE.1, &rgba).ok()
}

/// Colour of the wood around 1. It runs along X, so that it leads the eye past the book.
fn wood(place: Vec2) -> Vec3 {
    let (x, z) = (place.x, place.y);
    let sway = 0.016 * (value(x * 2.3, z * 7.0) - 0.5) + 0.005 * (value(x * 7.0, z * 24.0) - 0.5);
    let z = z + sway;
    let layer = |per_m: f32, stretch: f32, seed: f32| {
        value(x * per_m / stretch + seed, z * per_m + seed) - 0.5
    };
    let broad = layer(14.0, 9.0, 3.0);
    let rings = layer(70.0, 34.0, 7.0);
    let fibres = layer(260.0, 60.0, 11.0) + 0.7 * layer(700.0, 90.0, 29.0);
    let pores = (layer(900.0, 26.0, 41.0) - 0.22).max(0.0);
    let light = 1.0 + 0.34 * broad + 0.30 * rings + 0.22 * fibres - 0.9 * pores;
    // Darker wood is redder.
    let warmth = 0.10 * (broad + rings);
    Vec3::new(1.0 - 0.5 * warmth, 1.0, 1.0 + warmth) * light
}
