//! A few rows of the picture at a time: the page, the leaf's shadow on it, the leaf, its outline.

use crate::pose::Faces;
use crate::raster::{Span, Triangle, Vertex};
use crate::rect::Rect;
use crate::sheet::{COLUMNS, Corner, ROWS, Sheet};
use crate::stage::{SUB, Stage};

/// Page pictures, as large as [`Stage::page`] says.
pub trait Print {
    /// Brightness of a pixel: 0 black to 255 white. A panel of sixteen greys shows `17 n` exactly.
    fn luma(&self, page: u32, x: u16, y: u16) -> u8;

    /// The same for a part of a row, from pixel `x` on: most of a page is copied so.
    fn row(&self, page: u32, x: u16, y: u16, out: &mut [u8]) {
        for (x, luma) in (x..).zip(out) {
            *luma = self.luma(page, x, y);
        }
    }
}

/// What is on the panel.
#[derive(Debug, Clone, Copy)]
pub enum Scene<'a> {
    /// The open pages.
    Rest,
    /// The open pages and the leaf above them.
    Leaf(&'a Sheet),
    /// The pages after the turn on the side of column `edge` the leaf has left, those before it on the other.
    Swept {
        /// The first column that the leaf, if it came from the right, has left.
        edge: u16,
        /// It came from the right.
        from_right: bool,
    },
}

/// Everything that is drawn.
#[derive(Debug, Clone, Copy)]
pub struct Canvas<'a, P> {
    /// Where the pages stand.
    pub stage: &'a Stage,
    /// Which they are.
    pub faces: Faces,
    /// What happens above them.
    pub scene: Scene<'a>,
    /// Their pictures.
    pub print: &'a P,
    /// Two tones are to be had: print gets harder, so that letters keep their edges.
    pub hard: bool,
}

/// What a pixel belongs to, in the two lowest bits of its depth.
const KIND: u16 = 3;
const PAGE: u16 = 0;
const SHADED: u16 = 1;
const UP: u16 = 2;
const DOWN: u16 = 3;
/// Deeper than any leaf.
const DEEPEST: u16 = !KIND;
/// Brightness of an outline, of 256.
const OUTLINE: u16 = 40;
/// Beyond the pages.
const MARGIN: u8 = 255;
/// Most samples taken of a page for one pixel.
const TAPS: i32 = 4;

/// Rows of pixels: `CELLS` of them at a time, three bytes each. For the caller to place.
#[derive(Debug, Clone)]
pub struct Band<const CELLS: usize> {
    luma: [u8; CELLS],
    depth: [u16; CELLS],
    rect: Rect,
}

impl<const CELLS: usize> Band<CELLS> {
    /// Nothing: for the caller to place.
    pub const EMPTY: Self = Self { luma: [0; CELLS], depth: [0; CELLS], rect: Rect::NONE };

    /// Rows a band has if its rows are so long: one is lost to the outline.
    #[must_use]
    pub const fn rows(width: u16) -> u16 {
        let rows = CELLS / if width == 0 { 1 } else { width as usize };
        if rows > 1 { (rows - 1) as u16 } else { 0 }
    }

    /// Draws the pixels of `rect`, which has at most [`Band::rows`] rows, and hands them out: row by row.
    pub fn draw<P: Print>(
        &mut self,
        rect: Rect,
        canvas: &Canvas<'_, P>,
    ) -> impl Iterator<Item = u8> + '_ {
        // The row above, for the outline that runs between both.
        self.rect = Rect { y0: rect.y0.saturating_sub(1), ..rect };
        self.pages(canvas);
        if let Scene::Leaf(sheet) = canvas.scene
            && !sheet.reach().intersection(self.rect).is_empty()
        {
            self.depth.fill(DEEPEST | PAGE);
            self.shadow(sheet);
            self.leaf(sheet, canvas);
            self.outline();
        }
        let skip = usize::from(rect.y0 - self.rect.y0) * usize::from(rect.width());
        self.luma.iter().copied().skip(skip).take(rect.area() as usize)
    }

    fn pages<P: Print>(&mut self, canvas: &Canvas<'_, P>) {
        let rect = self.rect;
        let width = usize::from(rect.width()).max(1);
        for (y, row) in (rect.y0..rect.y1).zip(self.luma.chunks_exact_mut(width)) {
            row.fill(MARGIN);
            for (left, area) in [true, false].into_iter().zip(canvas.stage.pages()) {
                lay(row, [rect.x0, y], area, left, canvas);
            }
        }
    }

    fn shadow(&mut self, sheet: &Sheet) {
        let vertex = |c: &Corner, _: [i32; 2]| {
            let [x, y] = c.shadow;
            Vertex { x, y, runs: [i32::from(c.dim)] }
        };
        self.triangles(sheet, [0; 2], vertex, |_, span, luma, depth| {
            let cells = luma.iter_mut().zip(depth.iter_mut());
            span.pixels(cells, |(luma, depth), [dim]| {
                if *depth & KIND == PAGE {
                    *depth |= SHADED;
                    *luma = dimmed(*luma, dim);
                }
            });
        });
    }

    fn leaf<P: Print>(&mut self, sheet: &Sheet, canvas: &Canvas<'_, P>) {
        let page = canvas.stage.page().map(i32::from);
        let vertex = |c: &Corner, [u, v]: [i32; 2]| {
            let runs = [i32::from(c.at.depth), i32::from(c.light), u, v];
            Vertex { x: c.at.x, y: c.at.y, runs }
        };
        self.triangles(sheet, page.map(|n| n * 16), vertex, |up, span, luma, depth| {
            let (kind, face) = if up { (UP, canvas.faces.up) } else { (DOWN, canvas.faces.down) };
            let taps = Taps::of(span, page, !up);
            let cells = luma.iter_mut().zip(depth.iter_mut());
            span.pixels(cells, |(luma, depth), [z, light, u, v]| {
                let z = (z.clamp(0, 16_000) as u16) << 2;
                if z < *depth & !KIND || *depth & KIND < UP {
                    *depth = z | kind;
                    *luma = dimmed(taps.read(face, u, v, canvas), light);
                }
            });
        });
    }

    /// Every triangle of the net that may cover pixels of the band, with the rows of it that do.
    fn triangles<const K: usize>(
        &mut self,
        sheet: &Sheet,
        page: [i32; 2],
        vertex: impl Fn(&Corner, [i32; 2]) -> Vertex<K>,
        mut draw: impl FnMut(bool, &Span<K>, &mut [u8], &mut [u16]),
    ) {
        let rect = self.rect;
        let rows = [i32::from(rect.y0), i32::from(rect.y1)];
        let columns = [i32::from(rect.x0), i32::from(rect.x1)];
        let width = usize::from(rect.width());
        cells(sheet, page, rows, vertex, |triangle| {
            triangle.spans(rows, columns, |span| {
                let start = (span.y - rows[0]) as usize * width;
                let inside = |x: i32| start + (x - columns[0]) as usize;
                let range = inside(span.x)..inside(span.end);
                if let (Some(luma), Some(depth)) =
                    (self.luma.get_mut(range.clone()), self.depth.get_mut(range))
                {
                    draw(triangle.up, span, luma, depth);
                }
            });
        });
    }

    /// A dark line wherever a leaf begins or ends: on a panel of two tones white paper on white paper has no other edge.
    fn outline(&mut self) {
        let width = usize::from(self.rect.width()).max(1);
        let mut above: Option<&[u16]> = None;
        let rows = self.depth.chunks_exact(width).zip(self.luma.chunks_exact_mut(width));
        for (depth, luma) in rows.take(usize::from(self.rect.height())) {
            let mut left = depth.first().map_or(PAGE, |d| d & KIND);
            let mut up = above.unwrap_or(depth).iter();
            for (cell, luma) in depth.iter().zip(luma) {
                let kind = cell & KIND;
                let over = up.next().map_or(kind, |d| d & KIND);
                if border(kind, left) || border(kind, over) {
                    *luma = dimmed(*luma, i32::from(OUTLINE));
                }
                left = kind;
            }
            above = Some(depth);
        }
    }
}

fn border(a: u16, b: u16) -> bool {
    a != b && (a >= UP || b >= UP)
}

fn dimmed(luma: u8, share: i32) -> u8 {
    (i32::from(luma) * share / 256).clamp(0, 255) as u8
}

/// Every triangle of the net with pixels in some rows.
fn cells<const K: usize>(
    sheet: &Sheet,
    [w, h]: [i32; 2],
    rows: [i32; 2],
    vertex: impl Fn(&Corner, [i32; 2]) -> Vertex<K>,
    mut draw: impl FnMut(&Triangle<K>),
) {
    let last = [COLUMNS - 1, ROWS - 1].map(|n| n.max(1) as i32);
    let [top, bottom] = rows.map(|y| y * SUB);
    for (j, (inner, outer)) in sheet.corners.iter().zip(sheet.corners.iter().skip(1)).enumerate() {
        let us = [j as i32, j as i32 + 1].map(|j| j * w / last[0]);
        let pairs =
            inner.iter().zip(inner.iter().skip(1)).zip(outer.iter().zip(outer.iter().skip(1)));
        for (r, ((a, d), (b, c))) in pairs.enumerate() {
            // From tail to head the picture is read upwards.
            let vs = [r as i32, r as i32 + 1].map(|r| h - r * h / last[1]);
            let [a, b] = [vertex(a, [us[0], vs[0]]), vertex(b, [us[1], vs[0]])];
            let [d, c] = [vertex(d, [us[0], vs[1]]), vertex(c, [us[1], vs[1]])];
            let above = [a.y, b.y, c.y, d.y].iter().all(|&y| y < top);
            if above || [a.y, b.y, c.y, d.y].iter().all(|&y| y >= bottom) {
                continue;
            }
            for triangle in [Triangle::new([a, b, c]), Triangle::new([a, c, d])] {
                triangle.iter().for_each(&mut draw);
            }
        }
    }
}

/// Lays a page's row over a row of the band: in two parts where a turn is swept over it.
fn lay<P: Print>(
    row: &mut [u8],
    [x0, y]: [u16; 2],
    area: Rect,
    left: bool,
    canvas: &Canvas<'_, P>,
) {
    if y < area.y0 || y >= area.y1 {
        return;
    }
    let edge = match canvas.scene {
        Scene::Swept { edge, .. } => edge.max(area.x0).min(area.x1),
        Scene::Rest | Scene::Leaf(_) => area.x0,
    };
    for (from, to) in [(area.x0, edge), (edge, area.x1)] {
        let from = from.max(x0);
        let part = usize::from(from - x0)..usize::from(to.saturating_sub(x0)).min(row.len());
        let (Some(part), Some(page)) = (row.get_mut(part), face(left, from, canvas)) else {
            continue;
        };
        canvas.print.row(page, from - area.x0, y - area.y0, part);
        if canvas.hard {
            part.iter_mut().for_each(|luma| *luma = hard(*luma));
        }
    }
}

/// The page seen on the left or the right at column `x`.
fn face<P>(left: bool, x: u16, canvas: &Canvas<'_, P>) -> Option<u32> {
    let Faces { left: on_left, right: on_right, up, down } = canvas.faces;
    let beneath = if left { on_left } else { on_right };
    let Scene::Swept { edge, from_right } = canvas.scene else { return beneath };
    // On the side the leaf goes to, its reverse comes; on the side it leaves, what lies beneath.
    let old = match (from_right, left) {
        (true, true) => on_left,
        (true, false) => up,
        (false, true) => down,
        (false, false) => on_right,
    };
    let new = match (from_right, left) {
        (true, true) => down,
        (true, false) => on_right,
        (false, true) => on_left,
        (false, false) => up,
    };
    if (x >= edge) == from_right { new } else { old }
}

fn read<P: Print>(canvas: &Canvas<'_, P>, page: u32, x: u16, y: u16) -> u8 {
    let luma = canvas.print.luma(page, x, y);
    if canvas.hard { hard(luma) } else { luma }
}

/// Twice the contrast about the middle.
fn hard(luma: u8) -> u8 {
    (i32::from(luma) * 2 - 128).clamp(0, 255) as u8
}

/// How many samples of the page make a pixel, and where they lie about it.
#[derive(Debug, Clone, Copy)]
struct Taps {
    count: i32,
    /// Way from one to the next, 1/16 pixel of the page.
    step: [i32; 2],
    last: [i32; 2],
    mirrored: bool,
}

impl Taps {
    fn of(span: &Span<4>, page: [i32; 2], mirrored: bool) -> Self {
        let [_, _, u, v] = span.slopes;
        let way = [u >> 16, v >> 16];
        // One to a pixel of the page, to the nearest.
        let longest = way.iter().map(|w| w.abs()).max().unwrap_or(0);
        let count = ((longest + 8) / 16).clamp(1, TAPS);
        Self { count, step: way.map(|w| w / count), last: page.map(|n| n - 1), mirrored }
    }

    fn read<P: Print>(&self, face: Option<u32>, u: i32, v: i32, canvas: &Canvas<'_, P>) -> u8 {
        let Some(page) = face else { return MARGIN };
        let [last_x, last_y] = self.last;
        let mut sum = 0;
        for n in 0..self.count {
            let off = 2 * n + 1 - self.count;
            let at = |c: i32, step: i32| (c + off * step / 2) >> 4;
            let x = at(u, self.step[0]).min(last_x).max(0);
            let x = if self.mirrored { last_x - x } else { x };
            let y = at(v, self.step[1]).min(last_y).max(0);
            sum += i32::from(read(canvas, page, x as u16, y as u16));
        }
        (sum / self.count.max(1)) as u8
    }
}
