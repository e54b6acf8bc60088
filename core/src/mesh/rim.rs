//! The four edges of the leaf: strips between the borders of its two sides.

use super::Vertex;
use super::curve::unit;
use super::normals::direction;
use crate::real::V3;

/// Fills tail, head, fore-edge and spine, in this order, once both sides are drawn.
///
/// # Hard case
///
/// On a stack folded over by more than a right angle the sides lag behind each other by more than the
/// stack is thick, and a strip may turn over. It still has an area and stays joined to the sides.
pub(super) fn write(
    columns: usize,
    rows: usize,
    up: &[Vertex],
    down: &[Vertex],
    out: &mut [Vertex],
) {
    let mut rest = out;
    for (first, stride, count, sign) in [
        (0, rows, columns, 1.0),
        (rows - 1, rows, columns, -1.0),
        ((columns - 1) * rows, 1, rows, 1.0),
        (0, 1, rows, -1.0),
    ] {
        let Some((strip, others)) = rest.split_at_mut_checked(2 * count) else { return };
        Border { first, stride, count, sign }.write(up, down, strip);
        rest = others;
    }
}

/// A border of the leaf: every `stride`-th vertex from `first`.
#[derive(Debug, Clone, Copy)]
struct Border {
    first: usize,
    stride: usize,
    count: usize,
    /// Which way out is from the direction of travel.
    sign: f32,
}

impl Border {
    /// A vertex on either side for each of the border's, with the normal of the strip between them.
    fn write(&self, up: &[Vertex], down: &[Vertex], strip: &mut [Vertex]) {
        let at = |net: &[Vertex], i: usize| {
            net.get(self.first + self.stride * i).map_or(V3([0.0; 3]), |v| V3(v.position))
        };
        for (i, pair) in strip.chunks_exact_mut(2).enumerate() {
            let ends = [at(down, i), at(up, i)];
            let along = direction(i, self.count, |i| at(up, i) + at(down, i));
            let thick = unit((ends[1] - ends[0]) * 1e3, V3([0.0, 1.0, 0.0]));
            let normal = unit(along.cross(thick) * (self.sign * 1e3), thick);
            let u = i as f32 / (self.count - 1) as f32;
            for ((slot, end), v) in pair.iter_mut().zip(ends).zip([0.0, 1.0]) {
                *slot = Vertex { position: end.0, normal: normal.0, uv: [u, v] };
            }
        }
    }
}
