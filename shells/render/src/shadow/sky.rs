//! How much of the room a place sees: ambient occlusion by many small shadow maps.
//!
//! Each of some dozens of directions gets a coarse parallel depth map. A place asks all of them and
//! weighs the answers by how bright the room is there and how much that direction gives its side.
//! The gutter, the space beneath a lifted leaf and the table along the cover darken by themselves.

use glam::Vec3;

use super::casters::{Casters, steady};
use super::depth_map::{EMPTY, fill, passes};
use crate::environment::{Environment, spiral};
use crate::parallel::for_each_part;

/// Directions asked.
const DIRECTIONS: usize = 48;
/// Lowest direction, as height on the unit sphere: the table hides what is lower.
const LOWEST: f32 = 0.10;
/// Side of one map, texels.
const SIDE: usize = 144;

/// How far a place is lifted off its own surface, texels.
const LIFT: f32 = 0.35;

/// One direction's projection.
#[derive(Debug, Clone, Copy, Default)]
struct View {
    towards: Vec3,
    /// Texels per metre to the right and upwards, with their axes.
    right: Vec3,
    up: Vec3,
    centre: [f32; 2],
    brightness: f32,
}

/// The sky's maps for one frame.
#[derive(Debug, Default)]
pub(crate) struct Sky {
    maps: Vec<f32>,
    views: Vec<View>,
    /// Side of the largest texel, metres.
    texel_m: f32,
    floor: f32,
}

/// What a place sees of the room.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SkyShare {
    /// Share of the light that can reach the near side and does.
    pub(crate) front: f32,
    /// The same for the far side.
    pub(crate) back: f32,
}

impl SkyShare {
    /// Nothing in the way.
    pub(crate) const OPEN: Self = Self { front: 1.0, back: 1.0 };
}

/// Where a place asks from.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    pub(crate) position: Vec3,
    /// Unit normal of the near side.
    pub(crate) normal: Vec3,
    /// Unit normal of the flat triangle, near side.
    pub(crate) face: Vec3,
    /// Distance to the far side, metres; `None` if no light comes through.
    pub(crate) thickness_m: Option<f32>,
}

impl Sky {
    /// Draws the maps.
    pub(crate) fn draw(&mut self, room: &Environment, casters: &Casters, threads: usize) {
        self.views.clear();
        self.texel_m = 0.0;
        self.floor = room.brightness(Vec3::NEG_Y);
        for i in 0..DIRECTIONS {
            self.aim(spiral(i, DIRECTIONS, LOWEST, 1.0), room, casters);
        }
        if self.views.is_empty() {
            return;
        }
        let views = &self.views;
        self.maps.resize(DIRECTIONS * SIDE * SIDE, EMPTY);
        for_each_part(threads, &mut self.maps, SIDE * SIDE, |i, map| {
            map.fill(EMPTY);
            let places: Vec<Vec3> = casters.points.iter().map(|p| views[i].project(*p)).collect();
            for t in &casters.triangles {
                fill(map, SIDE, t.map(|k| places[k as usize]));
            }
        });
    }

    fn aim(&mut self, towards: Vec3, room: &Environment, casters: &Casters) {
        let right = towards.any_orthonormal_vector();
        let up = towards.cross(right);
        let along = |p: Vec3| Vec3::new(p.dot(right), p.dot(up), p.dot(towards));
        let Some((low, high)) = casters.extent(along) else { return };
        let (low, high) = steady(low.truncate(), high.truncate());
        let size = (high - low).max(glam::Vec2::splat(1e-5));
        let scale = glam::Vec2::splat(SIDE as f32 - 4.0) / size;
        self.texel_m = self.texel_m.max(1.0 / scale.min_element());
        self.views.push(View {
            towards,
            right: right * scale.x,
            up: up * scale.y,
            centre: [2.0 - low.x * scale.x, 2.0 - low.y * scale.y],
            brightness: room.brightness(towards),
        });
    }

    /// What `place` sees. From below the floor's light comes in, the less the more the place is
    /// closed in.
    pub(crate) fn share(&self, place: &Place) -> SkyShare {
        if self.views.is_empty() {
            return SkyShare::OPEN;
        }
        let lift = self.texel_m * LIFT;
        let soft = 1.0 / self.texel_m.max(1e-6);
        let near = place.position + place.face * lift;
        let far = place.thickness_m.map(|t| place.position - place.face * (t + lift));
        let mut front = Sum::default();
        let mut back = Sum::default();
        for (view, map) in self.views.iter().zip(self.maps.chunks_exact(SIDE * SIDE)) {
            let cos = place.normal.dot(view.towards);
            if cos > 0.0 {
                front.add(cos * view.brightness, view.passes(map, near, soft));
            } else if let Some(far) = far {
                back.add(-cos * view.brightness, view.passes(map, far, soft));
            }
        }
        let floor = |up: f32| self.floor * DIRECTIONS as f32 * 0.25 * (1.0 - up);
        SkyShare {
            front: front.share(floor(place.normal.y)),
            back: back.share(floor(-place.normal.y)),
        }
    }
}

/// A weighted mean in the making.
#[derive(Default)]
struct Sum {
    light: f32,
    seen: f32,
    asked: f32,
    open: f32,
}

impl Sum {
    fn add(&mut self, weight: f32, passes: f32) {
        self.light += weight;
        self.seen += weight * passes;
        self.asked += 1.0;
        self.open += passes;
    }

    fn share(&self, floor: f32) -> f32 {
        let openness = if self.asked > 0.0 { 0.35 + 0.65 * self.open / self.asked } else { 0.6 };
        (self.seen + floor * openness) / (self.light + floor).max(1e-6)
    }
}

impl View {
    fn project(&self, p: Vec3) -> Vec3 {
        Vec3::new(
            p.dot(self.right) + self.centre[0],
            p.dot(self.up) + self.centre[1],
            p.dot(self.towards),
        )
    }

    /// What stands out by less than a texel hides only a part: a hard answer would show the steps
    /// of a steep surface in the coarse map.
    #[inline]
    fn passes(&self, map: &[f32], p: Vec3, soft: f32) -> f32 {
        let at = self.project(p);
        passes::<SIDE, { SIDE + 2 }>(map, at.truncate(), |t| {
            let open = 1.0 + (at.z - t) * soft;
            let open = if open < 1.0 { open } else { 1.0 };
            if open > 0.0 { open } else { 0.0 }
        })
    }
}
