//! One frame from patches to bytes.
//!
//! ```text
//! patches ─► geometry (placed, cut, tiled) ─► which triangle at every sample
//!        └─► casters ─► lamp maps, sky maps                │
//!                              └──────► what the room gives at every 4th pixel
//!                                                └──────► pixels ─► tone ─► RGB
//! ```

use glam::Vec3;

use crate::camera::Camera;
use crate::error::RenderError;
use crate::hit::Eye;
use crate::lattice::{Lattice, Probe};
use crate::light::Lights;
use crate::material::Paint;
use crate::parallel::{default_threads, for_each_part};
use crate::patch::Patch;
use crate::pixel::{Frame, Near};
use crate::raster::{Geometry, Grid, TILE_HEIGHT, draw_band};
use crate::shadow::{Casters, Lamp, Sky};
use crate::tone::Tone;

/// Largest side of a picture, pixels.
pub const MAX_SIDE: u32 = 8192;

/// Lattice rows handed to a thread at once.
const BAND: usize = 8;

/// What the last frame was made of.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Stats {
    /// Triangles inside the picture.
    pub triangles: usize,
    /// Triangles left out: an index out of range or a corner that is not finite.
    pub refused: usize,
}

/// Samples a pixel.
#[derive(Debug, Clone, Copy)]
enum Samples {
    One,
    Four,
    Eight,
}

/// Draws frames of one size; keeps its buffers from frame to frame.
#[derive(Debug)]
pub struct Renderer {
    size: (usize, usize),
    samples: Samples,
    threads: usize,
    background: Vec3,
    geometry: Geometry,
    casters: Casters,
    lamp: Lamp,
    sky: Sky,
    numbers: Vec<u32>,
    lattices: [Lattice; 2],
    tone: Tone,
    picture: Vec<u8>,
}

impl Renderer {
    /// A renderer for pictures of this size with 1, 4 or 8 samples a pixel.
    ///
    /// # Cost
    ///
    /// Memory: `4 · samples + 6` bytes a pixel and 23 MB of shadow maps.
    ///
    /// # Errors
    ///
    /// [`RenderError::PictureSize`], [`RenderError::Samples`].
    pub fn new(width: u32, height: u32, samples: u32) -> Result<Self, RenderError> {
        let sides = 1..=MAX_SIDE;
        if !(sides.contains(&width) && sides.contains(&height)) {
            return Err(RenderError::PictureSize { width, height });
        }
        let samples = match samples {
            1 => Samples::One,
            4 => Samples::Four,
            8 => Samples::Eight,
            other => return Err(RenderError::Samples(other)),
        };
        let size = (width as usize, height as usize);
        Ok(Self {
            size,
            samples,
            threads: default_threads(),
            background: Vec3::splat(0.02),
            geometry: Geometry::default(),
            casters: Casters::default(),
            lamp: Lamp::default(),
            sky: Sky::default(),
            numbers: Vec::new(),
            lattices: [Lattice::new(8), Lattice::new(4)],
            tone: Tone::new(size.0, size.1),
            picture: vec![0; size.0 * size.1 * 3],
        })
    }

    /// Uses up to `threads` threads (at least one). The picture does not depend on it.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.threads = threads.max(1);
        self
    }

    /// Linear colour where nothing is drawn.
    #[must_use]
    pub fn with_background(mut self, colour: Vec3) -> Self {
        self.background = colour;
        self
    }

    /// Width and height of the picture, pixels.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.size.0 as u32, self.size.1 as u32)
    }

    /// What the last frame was made of.
    #[must_use]
    pub fn stats(&self) -> Stats {
        Stats { triangles: self.geometry.triangles.len(), refused: self.geometry.refused }
    }

    /// Draws a frame: RGB bytes, sRGB, rows from the top.
    ///
    /// # Errors
    ///
    /// [`RenderError::Camera`]. Unsound triangles are left out and counted, see [`Self::stats`].
    ///
    /// # Determinism
    ///
    /// The same input gives the same bytes on any number of threads.
    pub fn render(
        &mut self,
        camera: &Camera,
        lights: &Lights,
        patches: &[Patch<'_>],
    ) -> Result<&[u8], RenderError> {
        let aspect = self.size.0 as f32 / self.size.1 as f32;
        let clip_from_world = camera.clip_from_world(aspect)?;
        self.geometry.gather(patches, &clip_from_world, self.size);
        self.casters.gather(patches);
        self.lamp.draw(&lights.point, &self.casters, self.threads);
        self.sky.draw(&lights.environment, &self.casters, self.threads);
        match self.samples {
            Samples::One => self.draw(camera, lights, patches, Grid::ONE),
            Samples::Four => self.draw(camera, lights, patches, Grid::FOUR),
            Samples::Eight => self.draw(camera, lights, patches, Grid::EIGHT),
        }
        Ok(&self.picture)
    }

    fn draw<const N: usize>(
        &mut self,
        camera: &Camera,
        lights: &Lights,
        patches: &[Patch<'_>],
        grid: Grid<N>,
    ) {
        let paints: Vec<Paint> = patches.iter().map(|p| p.material.paint()).collect();
        let pixel_at_1m = 2.0 * (camera.fov_y_rad * 0.5).tan() / self.size.1 as f32;
        let frame = Frame {
            patches,
            paints: &paints,
            lights,
            geometry: &self.geometry,
            lamp: &self.lamp,
            sky: &self.sky,
            eye: Eye { position: camera.eye, pixel_at_1m },
            grid,
            background: self.background,
        };
        let canvas = Canvas { frame: &frame, size: self.size, threads: self.threads };
        canvas.cover(&mut self.numbers);
        let [coarse, fine] = &mut self.lattices;
        canvas.probe(coarse, &self.numbers, |_, number, x, y| frame.probe(number, x, y, None));
        coarse.judge();
        canvas
            .probe(fine, &self.numbers, |_, number, x, y| frame.probe(number, x, y, Some(coarse)));
        fine.smooth();
        canvas.probe(fine, &self.numbers, |probe, number, x, y| Probe {
            light: frame.probe_light(number, x, y, probe.seen),
            ..*probe
        });
        fine.judge();
        canvas.colour(fine, &self.numbers, &self.tone, &mut self.picture);
    }
}

/// The three passes over the picture.
struct Canvas<'a, const N: usize> {
    frame: &'a Frame<'a, N>,
    size: (usize, usize),
    threads: usize,
}

impl<const N: usize> Canvas<'_, N> {
    /// Finds the triangle at every sample.
    fn cover(&self, numbers: &mut Vec<u32>) {
        let (width, height) = self.size;
        numbers.resize(width * height * N, 0);
        for_each_part(self.threads, numbers, width * TILE_HEIGHT * N, |band, numbers| {
            draw_band(self.frame.geometry, &self.frame.grid, band, width, numbers);
        });
    }

    /// Sets every point of a lattice to what `ask` makes of the point, and of the triangle and the
    /// pixel it lies on.
    fn probe(
        &self,
        lattice: &mut Lattice,
        numbers: &[u32],
        ask: impl Fn(&Probe, u32, usize, usize) -> Probe + Sync,
    ) {
        lattice.resize(self.size.0, self.size.1);
        let columns = lattice.columns;
        let mut probes = std::mem::take(&mut lattice.probes);
        for_each_part(self.threads, &mut probes, columns * BAND, |band, probes| {
            let rows = probes.len() / columns;
            // Down first, then across: neighbours read the same corner of every shadow map.
            for (column, row) in (0..columns).flat_map(|c| (0..rows).map(move |r| (c, r))) {
                let (x, y) = lattice.pixel(column, band * BAND + row, self.size);
                let number = numbers[(y * self.size.0 + x) * N];
                let probe = &mut probes[row * columns + column];
                *probe = ask(probe, number, x, y);
            }
        });
        lattice.probes = probes;
    }

    /// Colours all pixels, two by two.
    fn colour(&self, lattice: &Lattice, numbers: &[u32], tone: &Tone, picture: &mut [u8]) {
        let width = self.size.0;
        for_each_part(self.threads, picture, width * 3 * 2, |pair, rows| {
            for x in (0..width).step_by(2) {
                let mut near = Near { lattice, asked: [Probe::NONE; 3] };
                for (row, out) in rows.chunks_exact_mut(width * 3).enumerate() {
                    let y = pair * 2 + row;
                    for x in x..(x + 2).min(width) {
                        let at = (y * width + x) * N;
                        let light = self.frame.pixel(&numbers[at..at + N], x, y, &mut near);
                        out[x * 3..x * 3 + 3].copy_from_slice(&tone.pixel(light, x, y));
                    }
                }
            }
        });
    }
}
