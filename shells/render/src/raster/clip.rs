//! Cutting triangles at the near plane.

use glam::Vec4;

use super::geometry::Corner;
use crate::camera::NEAR;

/// A corner with its place in clip space.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placed {
    pub(super) clip: Vec4,
    pub(super) corner: Corner,
}

impl Placed {
    /// The point at `t` of the way to `other`.
    fn towards(&self, other: &Self, t: f32) -> Self {
        let (a, b) = (&self.corner, &other.corner);
        Self {
            clip: self.clip.lerp(other.clip, t),
            corner: Corner {
                position: a.position.lerp(b.position, t),
                normal: a.normal.lerp(b.normal, t),
                uv: a.uv.lerp(b.uv, t),
            },
        }
    }
}

/// What is in front of the near plane: a polygon of 0, 3 or 4 corners in the order of the input.
pub(super) fn near(triangle: &[Placed; 3]) -> ([Placed; 4], usize) {
    let mut out = [triangle[0]; 4];
    let mut n = 0;
    let mut push = |p: Placed| {
        out[n.min(3)] = p;
        n += 1;
    };
    for i in 0..3 {
        let (a, b) = (&triangle[i], &triangle[(i + 1) % 3]);
        let (da, db) = (a.clip.w - NEAR, b.clip.w - NEAR);
        if da >= 0.0 {
            push(*a);
        }
        if (da >= 0.0) != (db >= 0.0) {
            // Always cut from the visible end, so that neighbours cut their shared edge alike.
            push(if da >= 0.0 {
                a.towards(b, da / (da - db))
            } else {
                b.towards(a, db / (db - da))
            });
        }
    }
    (out, n.min(4))
}
