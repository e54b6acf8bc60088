//! One triangle ready to be filled: edges on the fixed-point grid, planes over the picture.

use glam::{Vec2, Vec3, Vec4};

use super::SUBPIXELS;

/// Farthest place on the grid we fill; beyond it products would leave 64 bits.
const LIMIT: f64 = (1_i64 << 29) as f64;

/// `value = origin + dx·x + dy·y` over the picture, pixels.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Plane {
    /// Value at the picture's top left corner.
    pub(crate) origin: f64,
    /// Change per pixel to the right.
    pub(crate) dx: f32,
    /// Change per pixel down.
    pub(crate) dy: f32,
}

impl Plane {
    /// Value at a place of the picture.
    pub(crate) fn at(&self, place: Vec2) -> f32 {
        let x = f64::from(self.dx) * f64::from(place.x);
        (self.origin + x + f64::from(self.dy) * f64::from(place.y)) as f32
    }
}

/// `e(x, y) = a·x + b·y + c` on the grid; not negative inside the triangle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Edge {
    pub(crate) a: i64,
    pub(crate) b: i64,
    pub(crate) c: i64,
}

/// A triangle in the picture.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Triangle {
    /// Which corners it is interpolated from.
    pub(crate) corners: [u32; 3],
    /// Which patch it belongs to.
    pub(crate) patch: u32,
    /// Unit normal of the flat triangle, on the side of its corners' normals.
    pub(crate) face: Vec3,
    pub(crate) edges: [Edge; 3],
    /// First and last pixel in x and y that can be touched.
    pub(crate) bounds: [i32; 4],
    /// Nearness `1/w`.
    pub(crate) near: Plane,
    /// Weight of the second and third corner times nearness.
    pub(crate) weights: [Plane; 2],
}

/// What a triangle needs from its corners to be set up.
#[derive(Debug, Clone, Copy)]
pub(super) struct Input {
    pub(super) clip: [Vec4; 3],
    pub(super) corners: [u32; 3],
    pub(super) patch: u32,
    pub(super) face: Vec3,
}

/// Sets a triangle up for a picture of this size; `None` if it is empty or outside.
pub(super) fn triangle(input: &Input, width: usize, height: usize) -> Option<Triangle> {
    let mut corners = input.corners;
    let mut near = input.clip.map(|c| 1.0 / f64::from(c.w));
    let mut p = [[0_i64; 2]; 3];
    for (at, c) in p.iter_mut().zip(&input.clip) {
        *at = snap(*c, width, height)?;
    }
    let mut area = cross(p[0], p[1], p[2]);
    if area == 0 {
        return None;
    }
    if area < 0 {
        p.swap(1, 2);
        corners.swap(1, 2);
        near.swap(1, 2);
        area = -area;
    }
    let bounds = bounds(&p, width, height)?;
    let edges = [edge(p[1], p[2]), edge(p[2], p[0]), edge(p[0], p[1])];
    let fit = |values: [f64; 3]| plane(&p, area, values);
    Some(Triangle {
        corners,
        patch: input.patch,
        face: input.face,
        edges,
        bounds,
        near: fit(near),
        weights: [fit([0.0, near[1], 0.0]), fit([0.0, 0.0, near[2]])],
    })
}

/// Clip space to the grid; `None` far outside.
fn snap(clip: Vec4, width: usize, height: usize) -> Option<[i64; 2]> {
    let w = f64::from(clip.w);
    let x = (0.5 + 0.5 * f64::from(clip.x) / w) * width as f64 * SUBPIXELS as f64;
    let y = (0.5 - 0.5 * f64::from(clip.y) / w) * height as f64 * SUBPIXELS as f64;
    (x.abs() < LIMIT && y.abs() < LIMIT).then(|| [x.round() as i64, y.round() as i64])
}

fn cross(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Edge from `p` to `q`; a sample exactly on it belongs to the triangle only if the edge is a top or
/// a left one, so that neighbours never share a sample or leave one out.
fn edge(p: [i64; 2], q: [i64; 2]) -> Edge {
    let (a, b) = (p[1] - q[1], q[0] - p[0]);
    let owns = a > 0 || (a == 0 && b > 0);
    Edge { a, b, c: -(a * p[0] + b * p[1]) - i64::from(!owns) }
}

/// Pixels the triangle can touch, clipped to the picture.
fn bounds(p: &[[i64; 2]; 3], width: usize, height: usize) -> Option<[i32; 4]> {
    let span = |axis: usize, size: usize| {
        let [a, b, c] = p.map(|v| v[axis]);
        let low = a.min(b).min(c).div_euclid(SUBPIXELS).max(0);
        let high = a.max(b).max(c).div_euclid(SUBPIXELS).min(size as i64 - 1);
        (low <= high).then_some((low as i32, high as i32))
    };
    let ((x0, x1), (y0, y1)) = (span(0, width)?, span(1, height)?);
    Some([x0, x1, y0, y1])
}

/// The plane through three values at the corners.
fn plane(p: &[[i64; 2]; 3], area: i64, v: [f64; 3]) -> Plane {
    let d = |i: usize, axis: usize| (p[i][axis] - p[0][axis]) as f64;
    let (v1, v2) = (v[1] - v[0], v[2] - v[0]);
    let scale = SUBPIXELS as f64 / area as f64;
    let dx = (v1 * d(2, 1) - v2 * d(1, 1)) * scale;
    let dy = (v2 * d(1, 0) - v1 * d(2, 0)) * scale;
    let (dx, dy) = (dx as f32, dy as f32);
    let at = p[0].map(|c| c as f64 / SUBPIXELS as f64);
    Plane { origin: v[0] - f64::from(dx) * at[0] - f64::from(dy) * at[1], dx, dy }
}
