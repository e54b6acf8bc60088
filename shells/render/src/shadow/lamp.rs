//! Soft shadows of the lamp: percentage closer over the lamp's disc.
//!
//! The disc is replaced by a few points, each with its own depth map; the share of them that sees a
//! place is its light. That gives true penumbrae, sharp at the contact and wide further away, where
//! one map with a guessed filter width would let light leak in the gutter.
//!
//! All maps share one plane of projection through the book, parallel to the disc: a place at
//! distance `z` that the disc's centre sees at `c` is seen by the point `o` of the disc at
//! `c + o (1 - D/z)`, so a look-up costs two multiplications more than with one map.

use glam::{Vec2, Vec3};

use super::casters::Casters;
use super::depth_map::{EMPTY, fill, passes};
use crate::light::PointLight;
use crate::parallel::for_each_part;

/// Points of the disc.
const POINTS: usize = 18;
/// The first points lie on the rim; if they agree, the whole disc does.
const RIM: usize = 6;
/// Side of a roof cell, texels.
const CELL: usize = 12;
/// Roof cells a side.
const CELLS: usize = SIDE / CELL;
/// What stands out by less than this throws no shadow wider than a pixel, metres.
const LOW_M: f32 = 0.0004;
/// Side of one map, texels.
const SIDE: usize = 576;

/// The lamp's maps for one frame.
#[derive(Debug, Default)]
pub(crate) struct Lamp {
    maps: Vec<f32>,
    view: View,
    /// For every cell of the maps, how high anything reaches that any of them holds there.
    roof: Vec<f32>,
    empty: bool,
}

/// The shared projection.
#[derive(Debug, Default, Clone, Copy)]
struct View {
    position: Vec3,
    right: Vec3,
    up: Vec3,
    ahead: Vec3,
    /// Distance of the plane of projection, metres.
    distance: f32,
    /// Texels per metre on that plane.
    scale: Vec2,
    /// Texel of the point opposite the lamp.
    centre: Vec2,
    /// Points of the disc, metres.
    points: [Vec2; POINTS],
    /// Radius of the disc, metres.
    radius: f32,
}

impl View {
    /// Looks from the lamp at the middle of the casters.
    fn new(light: &PointLight, casters: &Casters) -> Option<Self> {
        let (low, high) = casters.extent(|p| p)?;
        let middle = (low + high) * 0.5;
        let ahead = (middle - light.position).try_normalize()?;
        let right = ahead.any_orthonormal_vector();
        let mut view = Self {
            position: light.position,
            right,
            up: right.cross(ahead),
            ahead,
            distance: light.position.distance(middle),
            scale: Vec2::ONE,
            centre: Vec2::ZERO,
            points: disc(light.radius_m.max(0.0)),
            radius: light.radius_m.max(0.0),
        };
        view.fit(casters)?;
        Some(view)
    }

    /// Chooses scale and centre so that every map holds all casters.
    fn fit(&mut self, casters: &Casters) -> Option<()> {
        let probe = *self;
        let (low, high) = casters.extent(|p| probe.project(p).unwrap_or_default())?;
        let farthest = 1.0 / low.z.max(1e-6);
        let nearest = 1.0 / high.z.max(1e-6);
        let shift = |z: f32| (1.0 - self.distance / z).abs() * self.radius;
        let margin = shift(farthest).max(shift(nearest)) + 0.002;
        let (low, high) = (low.truncate() - margin, high.truncate() + margin);
        self.scale = Vec2::splat(SIDE as f32 - 4.0) / (high - low).max(Vec2::splat(1e-6));
        self.centre = Vec2::splat(2.0) - low * self.scale;
        Some(())
    }

    /// Texel under the disc's centre, and nearness; `None` beside or behind the lamp.
    fn project(&self, p: Vec3) -> Option<Vec3> {
        let d = p - self.position;
        let z = d.dot(self.ahead);
        if z < 1e-3 {
            return None;
        }
        let on_plane = Vec2::new(d.dot(self.right), d.dot(self.up)) * (self.distance / z);
        Some((on_plane * self.scale + self.centre).extend(1.0 / z))
    }

    /// How far any point of the disc sees a place of this nearness beside the centre, texels.
    fn reach(&self, nearness: f32) -> Vec2 {
        self.scale * ((1.0 - self.distance * nearness).abs() * self.radius)
    }

    /// How far point `i` of the disc sees a place of this nearness beside the centre, texels.
    fn shift(&self, i: usize, nearness: f32) -> Vec2 {
        self.points[i] * (1.0 - self.distance * nearness) * self.scale
    }
}

/// Roof cell of a texel place, kept inside.
fn cell(texel: f32) -> usize {
    ((texel.max(0.0) * (1.0 / CELL as f32)) as usize).min(CELLS - 1)
}

/// The rim first, then the inside, evenly by area.
fn disc(radius: f32) -> [Vec2; POINTS] {
    std::array::from_fn(|i| {
        let (r, angle) = if i < RIM {
            (0.93, (i as f32 + 0.35) * std::f32::consts::TAU / RIM as f32)
        } else {
            let inner = (i - RIM) as f32;
            (((inner + 0.5) / (POINTS - RIM) as f32).sqrt() * 0.86, inner * 2.399_963_2)
        };
        Vec2::new(angle.cos(), angle.sin()) * (r * radius)
    })
}

impl Lamp {
    /// Draws the maps.
    pub(crate) fn draw(&mut self, light: &PointLight, casters: &Casters, threads: usize) {
        let Some(view) = View::new(light, casters) else {
            self.empty = true;
            return;
        };
        self.empty = false;
        self.view = view;
        let places: Vec<Option<Vec3>> = casters.points.iter().map(|p| view.project(*p)).collect();
        self.raise_roof(casters, &places);
        self.maps.resize(POINTS * SIDE * SIDE, EMPTY);
        for_each_part(threads, &mut self.maps, SIDE * SIDE, |i, map| {
            map.fill(EMPTY);
            let seen = |k: u32| places[k as usize].map(|p| p + view.shift(i, p.z).extend(0.0));
            for &[a, b, c] in &casters.triangles {
                if let (Some(a), Some(b), Some(c)) = (seen(a), seen(b), seen(c)) {
                    fill(map, SIDE, [a, b, c]);
                }
            }
        });
    }

    /// Notes the heights of all casters, cell by cell, wherever one of the disc's points sees them
    /// from a place they could shade.
    fn raise_roof(&mut self, casters: &Casters, places: &[Option<Vec3>]) {
        self.roof.clear();
        self.roof.resize(CELLS * CELLS, f32::NEG_INFINITY);
        let farthest = places.iter().flatten().map(|p| p.z).fold(f32::INFINITY, f32::min);
        let beyond = self.view.reach(farthest * 0.95);
        for t in &casters.triangles {
            let height = t.iter().map(|&k| casters.points[k as usize].y).fold(f32::NEG_INFINITY, f32::max);
            // What a triangle shades lies behind it: between its own reach and that of the table.
            let around = |k: u32| places[k as usize].map(|p| (p.truncate(), self.view.reach(p.z) * 2.0 + beyond + 2.0));
            let (Some(a), Some(b), Some(c)) = (around(t[0]), around(t[1]), around(t[2])) else { continue };
            let low = (a.0 - a.1).min(b.0 - b.1).min(c.0 - c.1);
            let high = (a.0 + a.1).max(b.0 + b.1).max(c.0 + c.1);
            for row in cell(low.y)..=cell(high.y) {
                for roof in &mut self.roof[row * CELLS + cell(low.x)..=row * CELLS + cell(high.x)] {
                    *roof = roof.max(height);
                }
            }
        }
    }

    /// Whether nothing that is noticeably higher than `p` is on the way to any point of the disc.
    fn open(&self, p: Vec3, place: Vec3) -> bool {
        let roof = self.roof[cell(place.y) * CELLS + cell(place.x)];
        roof <= p.y + LOW_M && p.y < self.view.position.y
    }

    /// Side of a texel near `p`, metres.
    pub(crate) fn texel_m(&self, p: Vec3) -> f32 {
        let z = (p - self.view.position).dot(self.view.ahead);
        (z / self.view.distance.max(1e-6)) / self.view.scale.min_element().max(1e-6)
    }

    /// Share of the lamp that is seen from `p`, where anything within `slack_m` of it on the way
    /// to the lamp is not in the way.
    pub(crate) fn seen(&self, p: Vec3, slack_m: f32) -> f32 {
        if self.empty {
            return 1.0;
        }
        let Some(place) = self.view.project(p) else { return 1.0 };
        if self.open(p, place) {
            return 1.0;
        }
        let z = 1.0 / place.z;
        let near = 1.0 / (z - slack_m).max(1e-4);
        let ask = |i: usize| {
            let at = place.truncate() + self.view.shift(i, place.z);
            passes(&self.maps[i * SIDE * SIDE..(i + 1) * SIDE * SIDE], SIDE, at.x, at.y, |t| if t > near { 0.0 } else { 1.0 })
        };
        let rim: f32 = (0..RIM).map(ask).sum();
        if rim <= 0.0 || rim >= RIM as f32 {
            return rim / RIM as f32;
        }
        let inside: f32 = (RIM..POINTS).map(ask).sum();
        (rim + inside) / POINTS as f32
    }
}
