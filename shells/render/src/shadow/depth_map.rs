//! A small picture of nearness, and the question whether anything is nearer.

use glam::{Vec2, Vec3};

use crate::fast::{ceil, floor};

/// Nothing is nearer than this.
pub(super) const EMPTY: f32 = -1.0e30;

/// Keeps the nearest of a triangle whose corners are (texel x, texel y, nearness).
pub(super) fn fill(map: &mut [f32], side: usize, p: [Vec3; 3]) {
    let (low, high) = (p[0].min(p[1]).min(p[2]), p[0].max(p[1]).max(p[2]));
    let last = side as i32 - 1;
    if !(low.min_element() > -1e6 && high.max_element() < 1e6) {
        return;
    }
    let (first, end) = (ceil(low.y - 0.5).max(0), floor(high.y - 0.5).min(last));
    if first > end {
        return;
    }
    let (u, v) = (p[1] - p[0], p[2] - p[0]);
    let area = u.x * v.y - v.x * u.y;
    if area.abs() < 1e-9 {
        return;
    }
    let slope_x = (u.z * v.y - v.z * u.y) / area;
    let slope_y = (v.z * u.x - u.z * v.x) / area;
    let origin = p[0].z + (0.5 - p[0].x) * slope_x - p[0].y * slope_y;
    let sides = Sides::new(p);
    for row in first..=end {
        let y = row as f32 + 0.5;
        let (from, to) = sides.span(y);
        let (from, to) = (ceil(from - 0.5).max(0), floor(to - 0.5).min(last));
        if from > to {
            continue;
        }
        let mut near = origin + slope_x * from as f32 + slope_y * y;
        let line = &mut map[row as usize * side..][..side];
        for texel in &mut line[from as usize..=to as usize] {
            *texel = if near > *texel { near } else { *texel };
            near += slope_x;
        }
    }
}

/// The three sides sorted by height: a long one across all rows, two short ones meeting it.
struct Sides {
    low: Vec3,
    middle: Vec3,
    /// Change of x per row along the long side, and along the short ones below and above the middle.
    slopes: [f32; 3],
}

impl Sides {
    fn new(mut p: [Vec3; 3]) -> Self {
        for (i, j) in [(0, 1), (1, 2), (0, 1)] {
            if p[i].y > p[j].y {
                p.swap(i, j);
            }
        }
        let slope = |a: Vec3, b: Vec3| (b.x - a.x) / (b.y - a.y).max(1e-12);
        Self {
            low: p[0],
            middle: p[1],
            slopes: [slope(p[0], p[2]), slope(p[0], p[1]), slope(p[1], p[2])],
        }
    }

    /// Where row `y` enters and leaves the triangle.
    fn span(&self, y: f32) -> (f32, f32) {
        let long = self.low.x + self.slopes[0] * (y - self.low.y);
        let short = if y < self.middle.y {
            self.low.x + self.slopes[1] * (y - self.low.y)
        } else {
            self.middle.x + self.slopes[2] * (y - self.middle.y)
        };
        if long < short { (long, short) } else { (short, long) }
    }
}

/// Share of the light that passes at (`x`, `y`) texels: the four texels around are asked and their
/// answers, not their depths, are blended. Outside the map nothing is in the way.
///
/// `open(texel)` answers for one texel by its nearness, 0..1. `WINDOW` is `SIDE + 2`: what holds
/// two texels of one row and the two below them.
#[inline]
pub(super) fn passes<const SIDE: usize, const WINDOW: usize>(
    map: &[f32],
    at: Vec2,
    mut open: impl FnMut(f32) -> f32,
) -> f32 {
    let (x, y) = (at.x - 0.5, at.y - 0.5);
    let edge = (SIDE - 1) as f32;
    if !(x >= 0.0 && y >= 0.0 && x < edge && y < edge) {
        return 1.0;
    }
    let (column, row) = (x as i32, y as i32);
    let (fx, fy) = (x - column as f32, y - row as f32);
    let first = row as usize * SIDE + column as usize;
    let window = map.get(first..first + WINDOW).and_then(|w| <&[f32; WINDOW]>::try_from(w).ok());
    let Some(w) = window else { return 1.0 };
    let four = [open(w[0]), open(w[1]), open(w[SIDE]), open(w[SIDE + 1])];
    let a = four[0] + (four[1] - four[0]) * fx;
    let b = four[2] + (four[3] - four[2]) * fx;
    a + (b - a) * fy
}
