//! The camera: from a place on the screen to a ray into the book.

use crate::real::{Num, Real, V3};
use crate::scene::{SpecError, Units};

/// Where the reader looks from. Metres, book frame; a pinhole camera.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Eye.
    pub eye_m: [f64; 3],
    /// Point in the middle of the picture.
    pub target_m: [f64; 3],
    /// Vertical opening of the picture, degrees.
    pub fov_y_deg: f64,
    /// Width of the picture, pixels.
    pub width_px: u32,
    /// Height of the picture, pixels.
    pub height_px: u32,
}

/// Tilt of the reader's gaze from straight down, as (cosine, sine).
const TILT: (f64, f64) = (0.848_048_096_156_426, 0.529_919_264_233_205);
/// Furthest an eye or a target may be from the book, metres.
const FURTHEST_M: f64 = 1e4;
/// Share of the picture the open book fills.
const FILL: f64 = 0.93;

impl View {
    /// A view that sees nothing.
    pub const NONE: Self =
        Self { eye_m: [0.0; 3], target_m: [0.0; 3], fov_y_deg: 0.0, width_px: 0, height_px: 0 };

    /// A reader at a table: the whole spread in the picture with room for a leaf in the air.
    pub fn reading(width_m: f64, height_m: f64, width_px: u32, height_px: u32) -> Self {
        let fov_y_deg = 30.0;
        let aspect = f64::from(width_px.max(1)) / f64::from(height_px.max(1));
        let half = half_tangent(fov_y_deg);
        let (cos, sin) = TILT;
        let near = 0.5 * height_m * sin;
        let across = width_m / (half * aspect * FILL) + near;
        let along = 0.5 * (height_m * cos + 0.9 * width_m * sin) / (half * FILL) + near;
        let distance = if across > along { across } else { along };
        let target = [0.0, 0.27 * width_m, 0.0];
        let eye_m = [0.0, target[1] + distance * cos, target[2] + distance * sin];
        Self { eye_m, target_m: target, fov_y_deg, width_px, height_px }
    }

    /// One page from straight above, filling the picture: the right one, or the left.
    pub fn page(width_m: f64, height_m: f64, width_px: u32, height_px: u32, right: bool) -> Self {
        let fov_y_deg = 20.0;
        let aspect = f64::from(width_px.max(1)) / f64::from(height_px.max(1));
        let across = 0.5 * width_m / aspect;
        let along = 0.5 * height_m;
        let distance = if across > along { across } else { along } / half_tangent(fov_y_deg);
        let x = if right { 0.5 * width_m } else { -0.5 * width_m };
        let (eye_m, target_m) = ([x, distance, 0.0], [x, 0.0, 0.0]);
        Self { eye_m, target_m, fov_y_deg, width_px, height_px }
    }

    /// Refuses a camera that sees nothing.
    ///
    /// # Errors
    ///
    /// `view`: a number that is not finite, a place beyond 10 km, an opening outside 1° to 150°, a picture without
    /// pixels or above 16,384, an eye at its target, or a gaze straight down where "up" has no direction.
    pub fn check(&self) -> Result<(), SpecError> {
        let all = self.eye_m.iter().chain(&self.target_m).chain([&self.fov_y_deg]);
        if all.into_iter().any(|v| !v.is_finite()) {
            return Err(SpecError::NotFinite("view"));
        }
        let sizes = [self.width_px, self.height_px].iter().all(|s| (1..=16_384).contains(s));
        let Camera { forward, right, .. } =
            self.camera::<f64>(&Units { metres: 1.0, kilograms: 1.0 });
        let turned = forward.norm_sq() > 0.5 && right.norm_sq() > 0.5;
        let near = self.eye_m.iter().chain(&self.target_m).all(|v| v.magnitude() <= FURTHEST_M);
        let open = (1.0..=150.0).contains(&self.fov_y_deg);
        if sizes && near && turned && open { Ok(()) } else { Err(SpecError::OutOfRange("view")) }
    }

    /// The camera in model units.
    pub fn camera<R: Real>(&self, units: &Units) -> Camera<R> {
        let v3 = |p: [f64; 3]| V3(p.map(|c| units.length(c)));
        let (eye, target) = (v3(self.eye_m), v3(self.target_m));
        let forward = unit(target - eye);
        // The picture's up leans towards the head of the page, which lies at -Z.
        let right = unit(forward.cross(V3([0.0, 1.0, -1e-3])));
        let up = right.cross(forward);
        let focal = 0.5 * f64::from(self.height_px) / half_tangent(self.fov_y_deg);
        let narrow = |v: V3<f64>| V3(v.0.map(R::of));
        Camera {
            eye: narrow(eye),
            right: narrow(right),
            up: narrow(up),
            forward: narrow(forward),
            focal: R::of(focal),
            centre: [R::of(0.5 * f64::from(self.width_px)), R::of(0.5 * f64::from(self.height_px))],
        }
    }
}

/// Terms of the tangent's continued fraction: the error is below rounding up to 80°.
const TERMS: u32 = 12;

/// `tan x = x / (1 - x² / (3 - x² / (5 - …)))`: a sine and a cosine would be seven kilobytes of a firmware.
fn half_tangent(fov_deg: f64) -> f64 {
    let half = fov_deg * (core::f64::consts::PI / 360.0);
    let odd = |n: u32| f64::from(2 * n + 1);
    half / (0..TERMS).rev().fold(odd(TERMS), |below, n| odd(n) - half * half / below)
}

fn unit(v: V3<f64>) -> V3<f64> {
    let length = v.norm();
    if length > 1e-9 { v * (1.0 / length) } else { V3::zero() }
}

/// A pinhole camera in model units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera<R> {
    /// Eye.
    pub eye: V3<R>,
    /// Unit vector to the right of the picture.
    pub right: V3<R>,
    /// Unit vector to its top.
    pub up: V3<R>,
    /// Unit vector into it.
    pub forward: V3<R>,
    /// Focal length, pixels.
    pub focal: R,
    /// Middle of the picture, pixels.
    pub centre: [R; 2],
}

/// A half line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray<R> {
    /// Where it starts.
    pub from: V3<R>,
    /// Where it goes; not normalised.
    pub along: V3<R>,
}

impl<R: Real> Camera<R> {
    /// The ray through a place in 1/256 pixel.
    pub fn ray(&self, x: i32, y: i32) -> Ray<R> {
        let pixel = |v: i32| R::of(f64::from(v) / 256.0);
        let across = (pixel(x) - self.centre[0]) / self.focal;
        let down = (pixel(y) - self.centre[1]) / self.focal;
        Ray { from: self.eye, along: self.forward + self.right * across - self.up * down }
    }
    /// Where a point is seen, pixels from the left and the top; `None` behind the eye.
    pub fn project(&self, p: V3<R>) -> Option<[R; 2]> {
        let v = p - self.eye;
        let depth = v.dot(self.forward);
        if depth <= R::of(1e-6) {
            return None;
        }
        let scale = self.focal / depth;
        Some([self.centre[0] + v.dot(self.right) * scale, self.centre[1] - v.dot(self.up) * scale])
    }
}

impl<R: Real> Ray<R> {
    /// Where it meets the plane through `point` with normal `normal`; `None` where it runs along it or away.
    pub fn meet(&self, point: V3<R>, normal: V3<R>) -> Option<V3<R>> {
        let down = self.along.dot(normal);
        if down.magnitude() < R::of(1e-4) {
            return None;
        }
        let t = (point - self.from).dot(normal) / down;
        (t > R::ZERO).then(|| self.from + self.along * t)
    }
    /// Squared distance of a point to the line.
    pub fn distance_sq(&self, p: V3<R>) -> R {
        let v = p - self.from;
        let length_sq = self.along.norm_sq().larger(R::of(1e-9));
        v.cross(self.along).norm_sq() / length_sq
    }
}
