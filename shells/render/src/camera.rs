//! Where the picture is taken from.

use glam::{Mat4, Vec3, Vec4};

use crate::error::RenderError;

/// Distance of the near plane, metres; nothing closer to the eye is drawn.
pub(crate) const NEAR: f32 = 0.01;

/// A pinhole camera in the book frame (metres, Y up).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Where the eye is.
    pub eye: Vec3,
    /// The point in the middle of the picture.
    pub target: Vec3,
    /// Any vector that is not along the line of sight; it points up in the picture.
    pub up: Vec3,
    /// Full vertical angle of view, radians, in (0, π).
    pub fov_y_rad: f32,
}

impl Camera {
    /// World to clip space for a picture `aspect` times as wide as high; `w` is the distance along
    /// the line of sight.
    pub(crate) fn clip_from_world(&self, aspect: f32) -> Result<Mat4, RenderError> {
        let sight = self.target - self.eye;
        let aside = sight.cross(self.up);
        let least = 1e-8 * sight.length_squared() * self.up.length_squared();
        let sound = aside.is_finite() && aside.length_squared() > least;
        let angle = self.fov_y_rad > 1e-3 && self.fov_y_rad < 3.1;
        if !(sound && angle) {
            return Err(RenderError::Camera);
        }
        let ahead = sight.normalize();
        let right = aside.normalize();
        let up = right.cross(ahead);
        let zoom = 1.0 / (self.fov_y_rad * 0.5).tan();
        let row = |axis: Vec3| axis.extend(-axis.dot(self.eye));
        // The depth row stays empty: nearness is 1/w, which is linear over the picture.
        Ok(Mat4::from_rows(row(right * (zoom / aspect)), row(up * zoom), Vec4::ZERO, row(ahead)))
    }
}
