//! One triangle into rows of pixels: which of them it covers, and what runs over it linearly.

use crate::stage::SUB;

/// Longest side of a triangle that is drawn, 1/16 pixel: products of two such stay within 32 bits.
const LONGEST: i32 = 1 << 14;

/// A corner on the panel, and the `K` values that run from corner to corner.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Vertex<const K: usize> {
    /// 1/16 pixel.
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) runs: [i32; K],
}

/// Pixels of a row that a triangle covers, and what runs over them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Span<const K: usize> {
    pub(crate) y: i32,
    pub(crate) x: i32,
    pub(crate) end: i32,
    edges: [i32; 3],
    steps: [i32; 3],
    /// Values at `x`, 16 fractional bits, and what each pixel adds.
    runs: [i32; K],
    pub(crate) slopes: [i32; K],
}

/// A triangle, ready.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Triangle<const K: usize> {
    corners: [Vertex<K>; 3],
    /// Twice its area, 1/256 square pixel; above nothing.
    area: i32,
    /// Its up side is seen: the corners ran clockwise.
    pub(crate) up: bool,
}

impl<const K: usize> Triangle<K> {
    /// None if it is seen edge on, or is larger than any cell of a leaf.
    pub(crate) fn new([a, b, c]: [Vertex<K>; 3]) -> Option<Self> {
        let far =
            |p: &Vertex<K>, q: &Vertex<K>| (p.x - q.x).abs().max((p.y - q.y).abs()) >= LONGEST;
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

    fn bounds(&self, of: impl Fn(&Vertex<K>) -> i32) -> [i32; 2] {
        let [a, b, c] = self.corners.each_ref().map(of);
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        [low.div_euclid(SUB), high.div_euclid(SUB) + 1]
    }

    /// Hands over every row from `first` to, but without, `end`, clipped to columns `left..right`.
    pub(crate) fn spans(
        &self,
        [first, end]: [i32; 2],
        [left, right]: [i32; 2],
        mut draw: impl FnMut(&Span<K>),
    ) {
        let [top, bottom] = self.bounds(|v| v.y);
        let [x0, x1] = self.bounds(|v| v.x);
        let (x, stop) = (x0.max(left), x1.min(right));
        let (top, bottom) = (top.max(first), bottom.min(end));
        if x >= stop || top >= bottom {
            return;
        }
        let (steps, downs) = self.gradients();
        let (slopes, falls) = (self.runs(steps), self.runs(downs));
        let (mut edges, mut runs) = (self.edges(x, top), self.start(x, top, &slopes, &falls));
        for y in top..bottom {
            draw(&Span { y, x, end: stop, edges, steps, runs, slopes });
            add(&mut edges, &downs);
            add(&mut runs, &falls);
        }
    }

    /// Everything that runs at the middle of a pixel, 16 fractional bits.
    fn start(&self, x: i32, y: i32, slopes: &[i32; K], falls: &[i32; K]) -> [i32; K] {
        let [a, _, _] = self.corners;
        let [dx, dy] = [x * SUB + SUB / 2 - a.x, y * SUB + SUB / 2 - a.y];
        let mut runs = [0; K];
        for (slot, ((&value, &slope), &fall)) in
            runs.iter_mut().zip(a.runs.iter().zip(slopes).zip(falls))
        {
            let off = i64::from(slope) * i64::from(dx) + i64::from(fall) * i64::from(dy);
            *slot = ((i64::from(value) << 16) + off / i64::from(SUB)) as i32;
        }
        runs
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
    fn runs(&self, [_, to_b, to_c]: [i32; 3]) -> [i32; K] {
        let [a, b, c] = self.corners;
        // 2^32 / area: one division for all.
        let share = i64::from(u32::MAX / self.area.unsigned_abs().max(1));
        let mut out = [0; K];
        for (n, slot) in out.iter_mut().enumerate() {
            let at = |v: &Vertex<K>| i64::from(v.runs.get(n).copied().unwrap_or(0));
            let sum = (at(&b) - at(&a)) * i64::from(to_b) + (at(&c) - at(&a)) * i64::from(to_c);
            *slot = (sum.saturating_mul(share) >> 16).clamp(-(1 << 30), 1 << 30) as i32;
        }
        out
    }
}

impl<const K: usize> Span<K> {
    /// Hands over each covered pixel of the row with its values.
    pub(crate) fn pixels<T>(
        &self,
        cells: impl Iterator<Item = T>,
        mut draw: impl FnMut(T, [i32; K]),
    ) {
        let (mut edges, mut runs) = (self.edges, self.runs);
        for cell in cells {
            let [a, b, c] = edges;
            if a | b | c >= 0 {
                draw(cell, runs.map(|v| v >> 16));
            }
            add(&mut edges, &self.steps);
            add(&mut runs, &self.slopes);
        }
    }
}

fn add<const K: usize>(to: &mut [i32; K], more: &[i32; K]) {
    for (slot, step) in to.iter_mut().zip(more) {
        *slot = slot.wrapping_add(*step);
    }
}
