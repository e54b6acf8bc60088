//! The light of the room, pre-integrated into nine spherical harmonics.
//!
//! Paper is so rough that everything it shows of the room is smooth: nine coefficients hold the
//! irradiance within a few percent, and the mirrored part needs no sharper picture either.

use std::f32::consts::PI;

use glam::Vec3;

/// Directions used to integrate a room; a fixed spiral, so that the same room gives the same bits.
const DIRECTIONS: usize = 2048;
/// Band of each harmonic.
const BAND: [usize; 9] = [0, 1, 1, 1, 2, 2, 2, 2, 2];
/// What the clamped cosine does to each band, divided by π: 1, 2/3, 1/4.
const COSINE: [f32; 3] = [1.0, 2.0 / 3.0, 0.25];

/// A room's light from every direction, up to second order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Environment {
    /// Radiance in the nine real harmonics, order (0,0) (1,-1) (1,0) (1,1) (2,-2) .. (2,2).
    /// The fourth number only fills a vector register.
    radiance: [[f32; 4]; 9],
}

impl Environment {
    /// Integrates a room given as the light that comes from each unit direction.
    ///
    /// # Accuracy
    ///
    /// The harmonics keep what is smooth; lamps belong into [`crate::PointLight`].
    #[must_use]
    pub fn from_fn(room: impl Fn(Vec3) -> Vec3) -> Self {
        let mut radiance = [[0.0; 4]; 9];
        for i in 0..DIRECTIONS {
            let direction = spiral(i, DIRECTIONS, -1.0, 1.0);
            let light = room(direction) * (4.0 * PI / DIRECTIONS as f32);
            for (sum, y) in radiance.iter_mut().zip(harmonics(direction)) {
                for (s, l) in sum.iter_mut().zip(light.to_array()) {
                    *s += l * y;
                }
            }
        }
        Self { radiance }
    }

    /// A quiet room: pale ceiling, a broad window on the far left, a dim warm floor.
    #[must_use]
    pub fn reading_room() -> Self {
        let window = Vec3::new(-0.62, 0.66, -0.42).normalize();
        Self::from_fn(|d| {
            let up = (0.5 + 0.5 * d.y).clamp(0.0, 1.0);
            let walls = Vec3::new(0.23, 0.205, 0.175).lerp(Vec3::new(0.50, 0.475, 0.44), up);
            let floor = Vec3::new(0.36, 0.315, 0.26);
            let room = floor.lerp(walls, (d.y * 3.0 + 0.5).clamp(0.0, 1.0));
            let lobe = (3.0 * (d.dot(window) - 1.0)).exp();
            room + Vec3::new(1.0, 0.97, 0.92) * (1.0 * lobe)
        })
    }

    /// Light a white, matte surface facing `normal` sends out when nothing stands in the way.
    #[must_use]
    pub fn irradiance(&self, normal: Vec3) -> Vec3 {
        self.filtered(normal, COSINE)
    }

    /// Light mirrored towards `direction` by a surface of this roughness, before its Fresnel share.
    pub(crate) fn mirrored(&self, direction: Vec3, roughness: f32) -> Vec3 {
        let a = roughness * roughness;
        self.filtered(direction, [1.0, 1.0 / (1.0 + 0.5 * a), 1.0 / (1.0 + 1.5 * a)])
    }

    /// How bright the room is in one direction, never quite dark; for weighing what is hidden.
    pub(crate) fn brightness(&self, direction: Vec3) -> f32 {
        let light = self.filtered(direction, [1.0; 3]);
        light.dot(Vec3::new(0.2126, 0.7152, 0.0722)).max(0.02)
    }

    fn filtered(&self, d: Vec3, bands: [f32; 3]) -> Vec3 {
        let y = harmonics(d);
        let mut sum = [0.0; 4];
        for (i, (colour, y)) in self.radiance.iter().zip(y).enumerate() {
            let weight = y * bands[BAND[i]];
            for (s, c) in sum.iter_mut().zip(colour) {
                *s += c * weight;
            }
        }
        Vec3::new(sum[0], sum[1], sum[2]).max(Vec3::ZERO)
    }
}

/// The nine real spherical harmonics up to order two.
fn harmonics(d: Vec3) -> [f32; 9] {
    let Vec3 { x, y, z } = d;
    [
        0.282_095,
        0.488_603 * y,
        0.488_603 * z,
        0.488_603 * x,
        1.092_548 * x * y,
        1.092_548 * y * z,
        0.315_392 * (3.0 * z * z - 1.0),
        1.092_548 * x * z,
        0.546_274 * (x * x - y * y),
    ]
}

/// Direction `i` of `n` spread evenly over the band of the unit sphere with height in (`low`, `high`).
pub(crate) fn spiral(i: usize, n: usize, low: f32, high: f32) -> Vec3 {
    const GOLDEN_ANGLE: f32 = 2.399_963_2;
    let y = low + (high - low) * (i as f32 + 0.5) / n as f32;
    let r = (1.0 - y * y).max(0.0).sqrt();
    let (sin, cos) = (i as f32 * GOLDEN_ANGLE).sin_cos();
    Vec3::new(r * cos, y, r * sin)
}
