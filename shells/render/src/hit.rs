//! A place of the picture on a triangle, with everything interpolated.

use glam::{Vec2, Vec3};

use crate::fast::unit;
use crate::raster::{Geometry, Triangle};
use crate::texture::Footprint;

/// What is seen at one place of the picture.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hit {
    /// World place, metres.
    pub(crate) position: Vec3,
    /// Interpolated unit normal, on the eye's side of the surface.
    pub(crate) normal: Vec3,
    /// Normal of the flat triangle, on the eye's side.
    pub(crate) face: Vec3,
    /// From the place to the eye, unit.
    pub(crate) view: Vec3,
    /// Texture place and its change over the pixel.
    pub(crate) foot: Footprint,
    /// Side of the pixel on a surface that faces the eye, metres.
    pub(crate) pixel_m: f32,
    /// Nearness, `1/w`.
    pub(crate) near: f32,
    /// Whether the eye is on the side the corners' normals point to.
    pub(crate) outside: bool,
}

/// The eye and the size of a pixel one metre away.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Eye {
    pub(crate) position: Vec3,
    pub(crate) pixel_at_1m: f32,
}

impl Hit {
    /// Interpolates `triangle` at `place` (pixels), with perspective.
    pub(crate) fn new(geometry: &Geometry, triangle: &Triangle, place: Vec2, eye: &Eye) -> Self {
        let near = triangle.near.at(place).max(1e-9);
        let w = 1.0 / near;
        let weights = triangle.weights.map(|p| p.at(place) * w);
        let [a, b, c] = triangle.corners.map(|i| &geometry.corners[i as usize]);
        let first = 1.0 - weights[0] - weights[1];
        let position = a.position * first + b.position * weights[0] + c.position * weights[1];
        let smooth =
            unit(a.normal * first + b.normal * weights[0] + c.normal * weights[1], triangle.face);
        let view = unit(eye.position - position, Vec3::Y);
        let outside = triangle.face.dot(view) >= 0.0;
        let side = if outside { 1.0 } else { -1.0 };
        // Derivatives of the weights: d(W/N)/dx = (dW - W/N dN) / N.
        let slope = |pick: fn(&crate::raster::Plane) -> f32| {
            let n = pick(&triangle.near);
            let d = [0, 1].map(|i| (pick(&triangle.weights[i]) - weights[i] * n) * w);
            (b.uv - a.uv) * d[0] + (c.uv - a.uv) * d[1]
        };
        let uv = a.uv * first + b.uv * weights[0] + c.uv * weights[1];
        Self {
            position,
            normal: smooth * side,
            face: triangle.face * side,
            view,
            foot: Footprint { uv, dx: slope(|p| p.dx), dy: slope(|p| p.dy) },
            pixel_m: w * eye.pixel_at_1m,
            near,
            outside,
        }
    }
}
