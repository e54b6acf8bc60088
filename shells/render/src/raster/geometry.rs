//! All triangles of a frame, placed in the picture and sorted into tiles.

use dogleaf_core::mesh::Vertex;
use glam::{Mat4, Vec2, Vec3, Vec4};

use super::clip::{self, Placed};
use super::setup::{self, Input, Triangle};
use super::{TILE_HEIGHT, TILE_WIDTH};
use crate::patch::Patch;

/// A corner in the world, as it is interpolated.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Corner {
    pub(crate) position: Vec3,
    pub(crate) normal: Vec3,
    pub(crate) uv: Vec2,
}

impl Corner {
    fn from_vertex(v: &Vertex) -> Self {
        Self { position: v.position.into(), normal: v.normal.into(), uv: v.uv.into() }
    }
}

/// The frame's triangles; its lists are kept from frame to frame.
#[derive(Debug, Default)]
pub(crate) struct Geometry {
    pub(crate) corners: Vec<Corner>,
    pub(crate) triangles: Vec<Triangle>,
    /// For every tile, row by row, the triangles whose box touches it, in drawing order.
    pub(crate) tiles: Vec<Vec<u32>>,
    /// Triangles left out because their input was unsound.
    pub(crate) refused: usize,
    columns: usize,
    size: (usize, usize),
}

impl Geometry {
    /// Takes all patches in for a picture of this size.
    pub(crate) fn gather(
        &mut self,
        patches: &[Patch<'_>],
        clip_from_world: &Mat4,
        size: (usize, usize),
    ) {
        self.reset(size);
        for (i, patch) in patches.iter().enumerate() {
            self.take(i as u32, patch, clip_from_world);
        }
        self.sort_into_tiles();
    }

    /// Tiles side by side.
    pub(crate) fn columns(&self) -> usize {
        self.columns
    }

    fn reset(&mut self, size: (usize, usize)) {
        self.corners.clear();
        self.triangles.clear();
        self.refused = 0;
        self.size = size;
        self.columns = size.0.div_ceil(TILE_WIDTH);
        self.tiles.resize_with(self.columns * size.1.div_ceil(TILE_HEIGHT), Vec::new);
        self.tiles.iter_mut().for_each(Vec::clear);
    }

    fn take(&mut self, number: u32, patch: &Patch<'_>, clip_from_world: &Mat4) {
        let base = self.corners.len() as u32;
        self.corners.extend(patch.used().0.iter().map(Corner::from_vertex));
        let place = |c: &Corner| *clip_from_world * c.position.extend(1.0);
        let clips: Vec<Vec4> = self.corners[base as usize..].iter().map(place).collect();
        for triangle in patch.triangles() {
            match triangle {
                Some(at) => self.add(number, at.map(|i| base + i as u32), at.map(|i| clips[i])),
                None => self.refused += 1,
            }
        }
    }

    /// Adds one triangle, cutting it if it reaches behind the near plane.
    fn add(&mut self, patch: u32, corners: [u32; 3], clip: [Vec4; 3]) {
        let whole = clip.iter().all(|c| c.w >= crate::camera::NEAR);
        let face = self.face(corners);
        if whole {
            self.set_up(&Input { clip, corners, patch, face });
            return;
        }
        let placed: [Placed; 3] = std::array::from_fn(|i| Placed {
            clip: clip[i],
            corner: self.corners[corners[i] as usize],
        });
        let (polygon, n) = clip::near(&placed);
        let base = self.corners.len() as u32;
        self.corners.extend(polygon[..n].iter().map(|p| p.corner));
        for i in 2..n {
            let clip = [polygon[0].clip, polygon[i - 1].clip, polygon[i].clip];
            let corners = [base, base + i as u32 - 1, base + i as u32];
            self.set_up(&Input { clip, corners, patch, face });
        }
    }

    fn set_up(&mut self, input: &Input) {
        self.triangles.extend(setup::triangle(input, self.size.0, self.size.1));
    }

    /// Unit normal of the flat triangle on the side its corners' normals point to.
    fn face(&self, corners: [u32; 3]) -> Vec3 {
        let [a, b, c] = corners.map(|i| &self.corners[i as usize]);
        let smooth = a.normal + b.normal + c.normal;
        let flat = (b.position - a.position).cross(c.position - a.position).normalize_or_zero();
        if flat.dot(smooth) < 0.0 { -flat } else { flat }
    }

    fn sort_into_tiles(&mut self) {
        for (i, t) in self.triangles.iter().enumerate() {
            let [x0, x1, y0, y1] = t.bounds.map(|b| b as usize);
            for row in y0 / TILE_HEIGHT..=y1 / TILE_HEIGHT {
                for column in x0 / TILE_WIDTH..=x1 / TILE_WIDTH {
                    self.tiles[row * self.columns + column].push(i as u32);
                }
            }
        }
    }
}
