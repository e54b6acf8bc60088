//! One pixel: its samples grouped by surface, each group shaded once.

use glam::{Vec2, Vec3};

use crate::hit::{Eye, Hit};
use crate::lattice::{Lattice, Probe};
use crate::light::Lights;
use crate::lighting::{self, Light, Seen};
use crate::material::{Paint, Spot};
use crate::patch::Patch;
use crate::raster::{Geometry, Grid, NONE, Triangle};
use crate::shadow::{Lamp, Place, Sky};

/// Everything a pixel needs to know of the frame.
#[derive(Debug)]
pub(crate) struct Frame<'a, const N: usize> {
    pub(crate) patches: &'a [Patch<'a>],
    pub(crate) paints: &'a [Paint],
    pub(crate) lights: &'a Lights,
    pub(crate) geometry: &'a Geometry,
    pub(crate) lamp: &'a Lamp,
    pub(crate) sky: &'a Sky,
    pub(crate) eye: Eye,
    pub(crate) grid: Grid<N>,
    pub(crate) background: Vec3,
}

/// What is known around a pixel.
#[derive(Debug)]
pub(crate) struct Near<'a> {
    /// The lattice of the frame.
    pub(crate) lattice: &'a Lattice,
    /// The last places among this pixel and its nearest neighbours that had to ask for themselves.
    pub(crate) asked: [Probe; 3],
}

/// Samples of one pixel that see the same smooth surface.
#[derive(Debug, Clone, Copy)]
struct Group {
    /// A triangle of the surface.
    triangle: u32,
    /// Samples.
    count: f32,
    /// Sum of their places.
    places: Vec2,
}

impl<const N: usize> Frame<'_, N> {
    /// The light of pixel (`x`, `y`), whose samples see the triangles `numbers`.
    pub(crate) fn pixel(&self, numbers: &[u32], x: usize, y: usize, near: &mut Near<'_>) -> Vec3 {
        let corner = Vec2::new(x as f32, y as f32);
        let first = numbers[0];
        if numbers.iter().all(|&n| n == first) {
            return self.surface(first, corner + 0.5, x, y, near);
        }
        let mut groups = [Group { triangle: NONE, count: 0.0, places: Vec2::ZERO }; N];
        let mut used = 0;
        for (i, &number) in numbers.iter().enumerate() {
            let place = corner + self.grid.place(i);
            let found = groups[..used].iter_mut().find(|g| self.joins(g.triangle, number, place));
            let group = match found {
                Some(group) => group,
                None => {
                    used += 1;
                    groups[used - 1].triangle = number;
                    &mut groups[used - 1]
                }
            };
            group.count += 1.0;
            group.places += place;
        }
        let mut light = Vec3::ZERO;
        for group in &groups[..used] {
            light +=
                self.surface(group.triangle, group.places / group.count, x, y, near) * group.count;
        }
        light / N as f32
    }

    /// Whether a sample of triangle `b` at `place` continues the surface of triangle `a`.
    fn joins(&self, a: u32, b: u32, place: Vec2) -> bool {
        if a == b || a == NONE || b == NONE {
            return a == b;
        }
        let (a, b) = (self.triangle(a), self.triangle(b));
        let (here, there) = (a.near.at(place), b.near.at(place));
        a.patch == b.patch && a.face.dot(b.face) > 0.85 && (here - there).abs() < 0.004 * there
    }

    fn triangle(&self, number: u32) -> &Triangle {
        &self.geometry.triangles[number as usize]
    }

    fn surface(&self, number: u32, place: Vec2, x: usize, y: usize, near: &mut Near<'_>) -> Vec3 {
        if number == NONE {
            return self.background;
        }
        let triangle = self.triangle(number);
        let hit = Hit::new(self.geometry, triangle, place, &self.eye);
        let paint = &self.paints[triangle.patch as usize];
        let light = match near.lattice.at(x, y, triangle.patch, &hit) {
            Some(mean) if mean.is_whole() => mean.light(),
            Some(mean) => self.light(
                &hit,
                paint,
                Seen { sky: mean.sky(), lamp: self.lamp_share(&hit, paint) },
            ),
            None => self.light(&hit, paint, self.seen_near(&hit, paint, triangle.patch, near)),
        };
        let spot = Spot {
            position: hit.position,
            foot: hit.foot,
            pixel_m: hit.pixel_m,
            outside: hit.outside,
        };
        light.on(&self.patches[triangle.patch as usize].material.at(&spot, paint.passing > 0.0))
    }

    fn light(&self, hit: &Hit, paint: &Paint, seen: Seen) -> Light {
        lighting::light(hit, paint, self.lights, seen)
    }

    /// As [`Self::seen`], with the room's share of a neighbour on the same surface if there is one.
    fn seen_near(&self, hit: &Hit, paint: &Paint, patch: u32, near: &mut Near<'_>) -> Seen {
        if let Some(asked) = near.asked.iter().find(|a| a.fits(patch, hit)) {
            return Seen { sky: asked.seen.sky, lamp: self.lamp_share(hit, paint) };
        }
        let seen = self.seen(hit, paint);
        near.asked.rotate_right(1);
        near.asked[0] =
            Probe { patch, near: hit.near, normal: hit.normal, seen, light: Light::NONE };
        seen
    }

    fn seen(&self, hit: &Hit, paint: &Paint) -> Seen {
        let thickness_m = (paint.passing > 0.0).then_some(paint.thickness_m);
        let place =
            Place { position: hit.position, normal: hit.normal, face: hit.face, thickness_m };
        Seen { sky: self.sky.share(&place), lamp: self.lamp_share(hit, paint) }
    }

    fn lamp_share(&self, hit: &Hit, paint: &Paint) -> f32 {
        lighting::lamp_share(hit, paint, self.lights.point.position, self.lamp)
    }

    /// What is seen at pixel (`x`, `y`), whose first sample sees triangle `number`; a coarser
    /// lattice is asked first.
    pub(crate) fn probe(&self, number: u32, x: usize, y: usize, coarse: Option<&Lattice>) -> Probe {
        let Some((triangle, hit, paint)) = self.first(number, x, y) else { return Probe::NONE };
        let seen = match coarse.and_then(|c| c.at(x, y, triangle.patch, &hit)) {
            Some(mean) if mean.is_whole() => Seen { sky: mean.sky(), lamp: mean.lamp() },
            Some(mean) => Seen { sky: mean.sky(), lamp: self.lamp_share(&hit, paint) },
            None => self.seen(&hit, paint),
        };
        Probe {
            patch: triangle.patch,
            near: hit.near,
            normal: hit.normal,
            seen,
            light: Light::NONE,
        }
    }

    /// The light at such a pixel.
    pub(crate) fn probe_light(&self, number: u32, x: usize, y: usize, seen: Seen) -> Light {
        self.first(number, x, y)
            .map_or(Light::NONE, |(_, hit, paint)| self.light(&hit, paint, seen))
    }

    /// Place of the first sample of a pixel.
    fn first(&self, number: u32, x: usize, y: usize) -> Option<(&Triangle, Hit, &Paint)> {
        if number == NONE {
            return None;
        }
        let triangle = self.triangle(number);
        let place = Vec2::new(x as f32, y as f32) + self.grid.place(0);
        let hit = Hit::new(self.geometry, triangle, place, &self.eye);
        Some((triangle, hit, &self.paints[triangle.patch as usize]))
    }
}
