//! One triangle into rows of pixels: which of them it covers, and what runs over it linearly.

use crate::stage::SUB;

/// Longest side of a triangle that is drawn, 1/16 pixel: products of two such stay within 32 bits.
const LONGEST: i32 = 1 << 14;

/// What runs over a triangle: depth, light, and where in the page picture (1/16 pixel).
pub(crate) const RUNS: usize = 4;

/// A corner on the panel.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Vertex {
    /// 1/16 pixel.
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) runs: [i32; RUNS],
}

/// Pixels of a row that a triangle covers, and what runs over them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Span {
    pub(crate) y: i32,
    pub(crate) x: i32,
    pub(crate) end: i32,
    edges: [i32; 3],
    steps: [i32; 3],
    /// Values at `x`, 16 fractional bits, and what each pixel adds.
    pub(crate) runs: [i32; RUNS],
    pub(crate) slopes: [i32; RUNS],
}

/// A triangle, ready.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Triangle {
    corners: [Vertex; 3],
    /// Twice its area, 1/256 square pixel; above nothing.
    area: i32,
    /// Its up side is seen: the corners ran clockwise.
    pub(crate) up: bool,
}

impl Triangle {
    /// None if it is seen edge on, or is larger than any cell of a leaf.
    pub(crate) fn new([a, b, c]: [Vertex; 3]) -> Option<Self> {
        let far = |p: &Vertex, q: &Vertex| (p.x - q.x).abs().max((p.y - q.y).abs()) >= LONGEST;
        if far(&a, &b) || far(&b, &c) || far(&c, &a) {
            return None;
        }
        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        match area {
            0 => None,
            1.. => Some(Self { corners: [a, b, c], area, up: false }),
            _ => Some(Self { corners: [a, c, b], area: -area, up: true }),
        }
    }

    /// Rows of pixels whose middle it may cover.
    pub(crate) fn rows(&self) -> [i32; 2] {
        self.bounds(|v| v.y)
    }

    fn bounds(&self, of: impl Fn(&Vertex) -> i32) -> [i32; 2] {
        let [a, b, c] = self.corners.each_ref().map(of);
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        [low.div_euclid(SUB), high.div_euclid(SUB) + 1]
    }

    /// Hands over every row from `first` to, but without, `end`, clipped to columns `left..right`.
    pub(crate) fn spans(
        &self,
        [first, end]: [i32; 2],
        [left, right]: [i32; 2],
        mut draw: impl FnMut(&Span),
    ) {
        let [top, bottom] = self.rows();
        let [x0, x1] = self.bounds(|v| v.x);
        let (x, stop) = (x0.max(left), x1.min(right));
        if x >= stop {
            return;
        }
        let [a, _, _] = self.corners;
        let (steps, downs) = self.gradients();
        let slopes = self.runs(steps);
        let falls = self.runs(downs);
        for y in top.max(first)..bottom.min(end) {
            let edges = self.edges(x, y);
            let [dx, dy] = [x * SUB + SUB / 2 - a.x, y * SUB + SUB / 2 - a.y];
            let mut runs = [0; RUNS];
            for (slot, ((&value, &slope), &fall)) in
                runs.iter_mut().zip(a.runs.iter().zip(&slopes).zip(&falls))
            {
                let off = i64::from(slope) * i64::from(dx) + i64::from(fall) * i64::from(dy);
                *slot = ((i64::from(value) << 16) + off / i64::from(SUB)) as i32;
            }
            draw(&Span { y, x, end: stop, edges, steps, runs, slopes });
        }
    }

    /// Edge functions at the middle of a pixel; an edge that is neither left nor top loses its own points.
    fn edges(&self, x: i32, y: i32) -> [i32; 3] {
        let [a, b, c] = self.corners;
        let (px, py) = (x * SUB + SUB / 2, y * SUB + SUB / 2);
        [(b, c), (c, a), (a, b)].map(|(p, q)| {
            let (ex, ey) = (q.x - p.x, q.y - p.y);
            let owns = ey < 0 || (ey == 0 && ex > 0);
            ex * (py - p.y) - ey * (px - p.x) - i32::from(!owns)
        })
    }

    /// What a pixel to the right and a pixel down add to the three edge functions.
    fn gradients(&self) -> ([i32; 3], [i32; 3]) {
        let [a, b, c] = self.corners;
        let sides = [(b, c), (c, a), (a, b)];
        (sides.map(|(p, q)| -(q.y - p.y) * SUB), sides.map(|(p, q)| (q.x - p.x) * SUB))
    }

    /// What such a pixel adds to everything that runs, 16 fractional bits.
    fn runs(&self, [_, to_b, to_c]: [i32; 3]) -> [i32; RUNS] {
        let [a, b, c] = self.corners;
        // 2^32 / area: one division for all.
        let share = i64::from(u32::MAX / self.area.unsigned_abs().max(1));
        let mut out = [0; RUNS];
        for (n, slot) in out.iter_mut().enumerate() {
            let at = |v: &Vertex| i64::from(v.runs.get(n).copied().unwrap_or(0));
            let sum = (at(&b) - at(&a)) * i64::from(to_b) + (at(&c) - at(&a)) * i64::from(to_c);
            *slot = (sum.saturating_mul(share) >> 16).clamp(-(1 << 30), 1 << 30) as i32;
        }
        out
    }
}

impl Span {
    /// Hands over each covered pixel of the row with its values.
    pub(crate) fn pixels<'a, T: 'a>(
        &self,
        cells: impl Iterator<Item = T>,
        mut draw: impl FnMut(T, [i32; RUNS]),
    ) {
        let (mut edges, mut runs) = (self.edges, self.runs);
        for cell in cells {
            let [a, b, c] = edges;
            if a | b | c >= 0 {
                draw(cell, runs.map(|v| v >> 16));
            }
            for (edge, step) in edges.iter_mut().zip(self.steps) {
                *edge += step;
            }
            for (run, slope) in runs.iter_mut().zip(self.slopes) {
                *run = run.wrapping_add(slope);
            }
        }
    }
}
