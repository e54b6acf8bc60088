//! The leaf as it is seen: a finer net of places on the panel, with light and shadow.

use crate::pose::{ACROSS, ALONG, Pose, UNIT};
use crate::rect::Rect;
use crate::root::root;
use crate::stage::{Place, SUB, Stage};

/// Columns and rows of the finer net.
pub(crate) const COLUMNS: usize = THIRDS * (ACROSS - 1) + 1;
pub(crate) const ROWS: usize = HALVES * (ALONG - 1) + 1;
const THIRDS: usize = 3;
const HALVES: usize = 2;

/// Where the light comes from: over the reader's left shoulder. 256 is one.
const LIGHT: [i32; 3] = [-115, 205, -102];
/// What a side turned away still gets, and what light that falls straight on it adds; a page that lies gets 256.
const AMBIENT: i32 = 140;
const DIFFUSE: i32 = 145;
/// What a shadow takes where the leaf touches the page, and how much less of that a page's width up.
const DARKEST: i32 = 120;
const FADES: i32 = 84;
/// Blank columns kept around what is drawn, pixels.
const MARGIN: i32 = 3;

/// One corner of the finer net.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Corner {
    pub(crate) at: Place,
    /// Light on the side that is seen, 256 for a page that lies.
    pub(crate) light: i16,
    /// Where its shadow falls, 1/16 pixel.
    pub(crate) shadow: [i32; 2],
    /// What of the light the shadow leaves, of 256.
    pub(crate) dim: i16,
}

/// A leaf ready to be drawn: 10 kB, for the caller to place.
#[derive(Debug, Clone)]
pub struct Sheet {
    pub(crate) corners: [[Corner; ROWS]; COLUMNS],
    places: [[[i16; 3]; ROWS]; COLUMNS],
    reach: Rect,
    edge_x: u16,
}

impl Sheet {
    /// Nothing: for the caller to place.
    pub const EMPTY: Self = Self {
        corners: [[Corner { at: Place { x: 0, y: 0, depth: 0 }, light: 0, shadow: [0; 2], dim: 256 };
            ROWS]; COLUMNS],
        places: [[[0; 3]; ROWS]; COLUMNS],
        reach: Rect::NONE,
        edge_x: 0,
    };

    /// Looks at a pose from a stage.
    ///
    /// # Accuracy
    ///
    /// Catmull and Rom's spline through the nodes, rounded to 1/8192 of a page's width; places to 1/16 pixel.
    ///
    /// # Cost
    ///
    /// 465 corners: a square root, three divisions and some hundred additions each. No floating point.
    pub fn look(&mut self, pose: &Pose, stage: &Stage) {
        self.refine(pose);
        let eye = stage.eye();
        for j in 0..COLUMNS {
            for r in 0..ROWS {
                let here = self.place(j, r);
                let light = self.light(j, r, here, eye);
                let corner = Corner {
                    at: stage.project(here),
                    light,
                    shadow: shadow(here, stage),
                    dim: dim(here),
                };
                if let Some(slot) = self.corners.get_mut(j).and_then(|c| c.get_mut(r)) {
                    *slot = corner;
                }
            }
        }
        self.measure(stage);
    }

    /// Every pixel the leaf or its shadow may cover.
    #[must_use]
    pub fn reach(&self) -> Rect {
        self.reach
    }

    /// Where the middle of the fore-edge is seen, pixels from the left.
    #[must_use]
    pub fn edge_x(&self) -> u16 {
        self.edge_x
    }

    fn refine(&mut self, pose: &Pose) {
        for (j, column) in self.places.iter_mut().enumerate() {
            let mut line = [[0; 3]; ALONG];
            for (k, slot) in line.iter_mut().enumerate() {
                *slot = across(pose, j, k);
            }
            for (r, slot) in column.iter_mut().enumerate() {
                *slot = along(&line, r);
            }
        }
    }

    fn place(&self, j: usize, r: usize) -> [i32; 3] {
        let place = self.places.get(j).and_then(|c| c.get(r)).copied().unwrap_or_default();
        place.map(i32::from)
    }

    /// Light on the side that the eye sees.
    fn light(&self, j: usize, r: usize, here: [i32; 3], eye: [i32; 3]) -> i16 {
        let last = [COLUMNS - 1, ROWS - 1];
        let way = |a: [i32; 3], b: [i32; 3]| less(b, a);
        let du = way(self.place(j.saturating_sub(1), r), self.place((j + 1).min(last[0]), r));
        let dv = way(self.place(j, r.saturating_sub(1)), self.place(j, (r + 1).min(last[1])));
        let n = short(cross(du, dv));
        let length = root(dot(n, n).max(1) as u32).max(1) as i32;
        let towards = dot64(n, less(eye, here));
        let falls = dot(n, LIGHT) / length;
        let falls = if towards < 0 { -falls } else { falls };
        (AMBIENT + DIFFUSE * falls.max(0) / 256).clamp(0, 256) as i16
    }

    fn measure(&mut self, stage: &Stage) {
        let whole = stage.whole();
        let [mut x0, mut y0, mut x1, mut y1] = [i32::MAX, i32::MAX, i32::MIN, i32::MIN];
        for corner in self.corners.as_flattened() {
            for [x, y] in [[corner.at.x, corner.at.y], corner.shadow] {
                (x0, x1) = (x0.min(x), x1.max(x));
                (y0, y1) = (y0.min(y), y1.max(y));
            }
        }
        let low = |v: i32, most: u16| (v / SUB - MARGIN).clamp(0, i32::from(most)) as u16;
        let high = |v: i32, most: u16| (v / SUB + 1 + MARGIN).clamp(0, i32::from(most)) as u16;
        let (w, h) = (whole.x1, whole.y1);
        self.reach = Rect::new(low(x0, w), low(y0, h), high(x1, w), high(y1, h));
        let edge = self.corners.last().map_or(0, |c| {
            c.iter().map(|corner| i64::from(corner.at.x)).sum::<i64>() / ROWS as i64
        });
        self.edge_x = (edge / i64::from(SUB)).clamp(0, i64::from(w)) as u16;
    }
}

/// The point a third or two between nodes `(i, k)` and `(i + 1, k)`, or the node itself.
fn across(pose: &Pose, j: usize, k: usize) -> [i32; 3] {
    let node = |i: usize| {
        let column = pose.nodes.get(i.min(ACROSS - 1));
        column.and_then(|c| c.get(k)).copied().unwrap_or_default().map(i32::from)
    };
    /// Of the four nodes about the point; 54ths.
    const WEIGHTS: [[i32; 4]; THIRDS] = [[0, 54, 0, 0], [-4, 42, 18, -2], [-2, 18, 42, -4]];
    let (i, part) = (j / THIRDS, j % THIRDS);
    let four = four(node, i, ACROSS);
    let weights = WEIGHTS.get(part).copied().unwrap_or_default();
    mixed(four, weights, 54)
}

/// The point half way between two rows of a column, or on a row.
fn along(line: &[[i32; 3]; ALONG], r: usize) -> [i16; 3] {
    const WEIGHTS: [[i32; 4]; HALVES] = [[0, 16, 0, 0], [-1, 9, 9, -1]];
    let node = |k: usize| line.get(k.min(ALONG - 1)).copied().unwrap_or_default();
    let four = four(node, r / HALVES, ALONG);
    let weights = WEIGHTS.get(r % HALVES).copied().unwrap_or_default();
    let narrow = |n: i32| n.clamp(i32::from(i16::MIN), i32::from(i16::MAX)) as i16;
    mixed(four, weights, 16).map(narrow)
}

/// Nodes `i - 1` to `i + 2`; beyond an end the line goes on straight.
fn four(node: impl Fn(usize) -> [i32; 3], i: usize, count: usize) -> [[i32; 3]; 4] {
    let [b, c] = [node(i), node(i + 1)];
    let beyond = |end: [i32; 3], inner: [i32; 3]| {
        let [[x, y, z], [a, b, c]] = [end, inner];
        [2 * x - a, 2 * y - b, 2 * z - c]
    };
    let a = if i == 0 { beyond(b, c) } else { node(i - 1) };
    let d = if i + 2 < count { node(i + 2) } else { beyond(c, b) };
    [a, b, c, d]
}

fn mixed(points: [[i32; 3]; 4], weights: [i32; 4], sum: i32) -> [i32; 3] {
    let mut out = [0; 3];
    for (point, w) in points.iter().zip(weights) {
        for (slot, c) in out.iter_mut().zip(point) {
            *slot += c * w;
        }
    }
    out.map(|c| (c + sum / 2).div_euclid(sum))
}

/// Where the light that passes the leaf here would have met the page.
fn shadow([x, y, z]: [i32; 3], stage: &Stage) -> [i32; 2] {
    let y = y.max(0);
    let [lx, ly, lz] = LIGHT;
    let foot = stage.project([x - y * lx / ly, 0, z - y * lz / ly]);
    [foot.x, foot.y]
}

fn dim([_, y, _]: [i32; 3]) -> i16 {
    let up = y.clamp(0, UNIT);
    (256 - DARKEST + FADES * up / UNIT) as i16
}

fn less([a, b, c]: [i32; 3], [x, y, z]: [i32; 3]) -> [i32; 3] {
    [a - x, b - y, c - z]
}

fn dot([a, b, c]: [i32; 3], [x, y, z]: [i32; 3]) -> i32 {
    a * x + b * y + c * z
}

fn dot64(a: [i32; 3], b: [i32; 3]) -> i64 {
    a.iter().zip(b).map(|(&p, q)| i64::from(p) * i64::from(q)).sum()
}

fn cross([a, b, c]: [i32; 3], [x, y, z]: [i32; 3]) -> [i64; 3] {
    let m = |p: i32, q: i32| i64::from(p) * i64::from(q);
    [m(b, z) - m(c, y), m(c, x) - m(a, z), m(a, y) - m(b, x)]
}

/// The same direction, shorter than 2^14.
fn short(n: [i64; 3]) -> [i32; 3] {
    let most = n.iter().map(|c| c.unsigned_abs()).max().unwrap_or(0);
    let shift = (64 - most.leading_zeros()).saturating_sub(14);
    n.map(|c| (c >> shift) as i32)
}
