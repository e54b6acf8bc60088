//! Filling: the nearest triangle at every sample of a band of the picture.

use super::geometry::Geometry;
use super::setup::{Edge, Triangle};
use super::{SUBPIXELS, TILE_HEIGHT, TILE_WIDTH};

/// Marks a sample that no triangle covers.
pub(crate) const NONE: u32 = u32::MAX;

/// Where the samples of a pixel lie, in sixteenths of a pixel from its top left corner.
///
/// # Accuracy
///
/// No two samples share a row or a column, so that nearly upright and nearly level edges get the
/// most steps.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Grid<const N: usize> {
    places: [[i64; 2]; N],
}

impl Grid<1> {
    /// One sample in the middle.
    pub(crate) const ONE: Self = Self { places: [[8, 8]] };
}

impl Grid<4> {
    /// The rotated grid.
    pub(crate) const FOUR: Self = Self { places: [[6, 2], [14, 6], [2, 10], [10, 14]] };
}

impl Grid<8> {
    /// Eight queens.
    pub(crate) const EIGHT: Self =
        Self { places: [[9, 5], [7, 11], [13, 9], [5, 3], [3, 13], [1, 7], [11, 15], [15, 1]] };
}

impl<const N: usize> Grid<N> {
    /// Place of sample `i` in its pixel, 0..1.
    pub(crate) fn place(&self, i: usize) -> glam::Vec2 {
        let [x, y] = self.places[i];
        glam::Vec2::new(x as f32, y as f32) / 16.0
    }
}

/// One tile while it is filled.
struct Tile<'a> {
    x0: usize,
    y0: usize,
    width: usize,
    height: usize,
    /// Numbers of the band, `stride` pixels a row.
    numbers: &'a mut [u32],
    stride: usize,
    nearness: &'a mut [f32],
}

/// Fills band `band` of the picture: `numbers` gets, for every pixel row by row and every sample,
/// the triangle seen there or [`NONE`].
pub(crate) fn draw_band<const N: usize>(
    geometry: &Geometry,
    grid: &Grid<N>,
    band: usize,
    width: usize,
    numbers: &mut [u32],
) {
    numbers.fill(NONE);
    let height = numbers.len() / (width * N);
    let mut nearness = vec![0.0_f32; TILE_WIDTH * TILE_HEIGHT * N];
    for column in 0..geometry.columns() {
        nearness.fill(0.0);
        let x0 = column * TILE_WIDTH;
        let mut tile = Tile {
            x0,
            y0: band * TILE_HEIGHT,
            width: TILE_WIDTH.min(width - x0),
            height,
            numbers,
            stride: width,
            nearness: &mut nearness,
        };
        for &i in &geometry.tiles[band * geometry.columns() + column] {
            fill(&mut tile, &geometry.triangles[i as usize], i, grid);
        }
    }
}

/// An edge at a pixel's corner and what each sample adds to it.
struct Walk<const N: usize> {
    at: i64,
    right: i64,
    down: i64,
    samples: [i64; N],
    least: i64,
    most: i64,
}

impl<const N: usize> Walk<N> {
    fn new(edge: &Edge, grid: &Grid<N>, x: usize, y: usize) -> Self {
        let (x, y) = (x as i64 * SUBPIXELS, y as i64 * SUBPIXELS);
        let samples = grid.places.map(|[sx, sy]| (edge.a * sx + edge.b * sy) * (SUBPIXELS / 16));
        Self {
            at: edge.a * x + edge.b * y + edge.c,
            right: edge.a * SUBPIXELS,
            down: edge.b * SUBPIXELS,
            least: samples.iter().copied().min().unwrap_or(0),
            most: samples.iter().copied().max().unwrap_or(0),
            samples,
        }
    }

    /// Whether the edge leaves every pixel of a `w` by `h` block outside.
    fn rejects(&self, w: usize, h: usize) -> bool {
        let x = self.right.max(0) * (w as i64 - 1);
        let y = self.down.max(0) * (h as i64 - 1);
        self.at + x + y + self.most < 0
    }
}

fn fill<const N: usize>(tile: &mut Tile<'_>, triangle: &Triangle, number: u32, grid: &Grid<N>) {
    let [bx0, bx1, by0, by1] = triangle.bounds.map(|b| b as usize);
    let (x0, x1) = (bx0.max(tile.x0), bx1.min(tile.x0 + tile.width - 1));
    let (y0, y1) = (by0.max(tile.y0), by1.min(tile.y0 + tile.height - 1));
    let mut walks: [Walk<N>; 3] = triangle.edges.each_ref().map(|e| Walk::new(e, grid, x0, y0));
    if walks.iter().any(|w| w.rejects(x1 - x0 + 1, y1 - y0 + 1)) {
        return;
    }
    let near = &triangle.near;
    let offsets: [f32; N] = std::array::from_fn(|i| {
        let p = grid.place(i);
        near.dx * p.x + near.dy * p.y
    });
    for y in y0..=y1 {
        let start = near.at(glam::Vec2::new(x0 as f32, y as f32));
        let row = (y - tile.y0) * TILE_WIDTH;
        let band_row = (y - tile.y0) * tile.stride;
        let mut at = walks.each_ref().map(|w| w.at);
        for x in x0..=x1 {
            let (cell, pixel) = ((row + x - tile.x0) * N, (band_row + x) * N);
            let depth = &mut tile.nearness[cell..cell + N];
            let out = &mut tile.numbers[pixel..pixel + N];
            let base = start + near.dx * (x - x0) as f32;
            if (0..3).all(|e| at[e] + walks[e].least >= 0) {
                nearest(depth, out, |s| base + offsets[s], number);
            } else if (0..3).all(|e| at[e] + walks[e].most >= 0) {
                let outside = f32::NEG_INFINITY;
                let covered = |s: usize| (0..3).all(|e| at[e] + walks[e].samples[s] >= 0);
                nearest(
                    depth,
                    out,
                    |s| if covered(s) { base + offsets[s] } else { outside },
                    number,
                );
            }
            for e in 0..3 {
                at[e] += walks[e].right;
            }
        }
        walks.iter_mut().for_each(|w| w.at += w.down);
    }
}

/// Lets `number` have every sample where its nearness is the greatest so far.
#[inline]
fn nearest(depth: &mut [f32], out: &mut [u32], value: impl Fn(usize) -> f32, number: u32) {
    for (s, (depth, out)) in depth.iter_mut().zip(out).enumerate() {
        let value = value(s);
        let wins = value > *depth;
        *depth = if wins { value } else { *depth };
        *out = if wins { number } else { *out };
    }
}
