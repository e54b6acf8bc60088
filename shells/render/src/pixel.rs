//! One pixel: its samples grouped by surface, each group shaded once.

use glam::{Vec2, Vec3};

use crate::ambient::{self, Probe, STRIDE};
use crate::hit::{Eye, Hit};
use crate::light::Lights;
use crate::lighting::{self, Seen};
use crate::material::{Optics, Sheet, Spot};
use crate::patch::Patch;
use crate::raster::{Geometry, Grid, NONE, Triangle};
use crate::shadow::{Lamp, Place, Sky, SkyShare};

/// Everything a pixel needs to know of the frame.
#[derive(Debug)]
pub(crate) struct Frame<'a, const N: usize> {
    pub(crate) patches: &'a [Patch<'a>],
    pub(crate) sheets: &'a [Sheet],
    pub(crate) lights: &'a Lights,
    pub(crate) geometry: &'a Geometry,
    pub(crate) lamp: &'a Lamp,
    pub(crate) sky: &'a Sky,
    pub(crate) eye: Eye,
    pub(crate) grid: Grid<N>,
    pub(crate) background: Vec3,
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
    pub(crate) fn pixel(&self, numbers: &[u32], x: usize, y: usize, probes: &[Probe], columns: usize) -> Vec3 {
        let corner = Vec2::new(x as f32, y as f32);
        let first = numbers[0];
        if numbers.iter().all(|&n| n == first) {
            return self.surface(first, corner + 0.5, x, y, probes, columns);
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
        let light = |g: &Group| self.surface(g.triangle, g.places / g.count, x, y, probes, columns) * g.count;
        groups[..used].iter().map(light).sum::<Vec3>() / N as f32
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

    fn surface(&self, number: u32, place: Vec2, x: usize, y: usize, probes: &[Probe], columns: usize) -> Vec3 {
        if number == NONE {
            return self.background;
        }
        let triangle = self.triangle(number);
        let hit = Hit::new(self.geometry, triangle, place, &self.eye);
        let sheet = self.sheets[triangle.patch as usize];
        let optics = self.optics(triangle, &hit, sheet);
        let known = ambient::between(probes, columns, x, y, triangle.patch, &hit);
        let seen = Seen {
            sky: known.sky.unwrap_or_else(|| self.sky_share(&hit, sheet)),
            lamp: known.lamp.unwrap_or_else(|| self.lamp_share(&hit, sheet)),
        };
        lighting::shine(&hit, &optics, self.lights, seen)
    }

    fn optics(&self, triangle: &Triangle, hit: &Hit, sheet: Sheet) -> Optics {
        let material = &self.patches[triangle.patch as usize].material;
        let spot = Spot { position: hit.position, foot: hit.foot, pixel_m: hit.pixel_m, outside: hit.outside };
        material.at(&spot, sheet)
    }

    fn sky_share(&self, hit: &Hit, sheet: Sheet) -> SkyShare {
        let thickness_m = (sheet.passing > 0.0).then_some(sheet.thickness_m);
        self.sky.share(&Place { position: hit.position, normal: hit.normal, face: hit.face, thickness_m })
    }

    fn lamp_share(&self, hit: &Hit, sheet: Sheet) -> f32 {
        lighting::lamp_share(hit, sheet, self.lights.point.position, self.lamp)
    }

    /// What grid point (`column`, `row`) sees; `numbers` are those of the whole picture.
    pub(crate) fn probe(&self, numbers: &[u32], size: (usize, usize), column: usize, row: usize) -> Probe {
        let (x, y) = ((column * STRIDE).min(size.0 - 1), (row * STRIDE).min(size.1 - 1));
        let number = numbers[(y * size.0 + x) * N];
        if number == NONE {
            return Probe::NONE;
        }
        let place = Vec2::new(x as f32, y as f32) + self.grid.place(0);
        let triangle = self.triangle(number);
        let hit = Hit::new(self.geometry, triangle, place, &self.eye);
        let sheet = self.sheets[triangle.patch as usize];
        let seen = Seen { sky: self.sky_share(&hit, sheet), lamp: self.lamp_share(&hit, sheet) };
        Probe { patch: triangle.patch, near: hit.near, normal: hit.normal, seen, straight: false }
    }
}
