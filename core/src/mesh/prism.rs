//! A body extruded along Z: curves of points, one above another, between the tail and the head.
//!
//! Given in outward coordinates, as the midline is; mirrored for the left.

use super::Vertex;
use super::curve::unit;
use crate::real::{V2, V3};

/// What all vertices of a body share.
#[derive(Debug, Clone, Copy)]
pub(super) struct Form {
    pub(super) columns: usize,
    pub(super) levels: usize,
    /// One for the right, minus one for the left.
    pub(super) sign: f32,
    /// Half its extent along Z, model units.
    pub(super) half_height: f32,
    /// Metres in a model unit.
    pub(super) metres: f32,
}

/// The six patches of a body, and how to fill them.
#[derive(Debug)]
pub(super) struct Prism<'a> {
    form: Form,
    top: &'a mut [Vertex],
    tail: &'a mut [Vertex],
    head: &'a mut [Vertex],
    outer: &'a mut [Vertex],
    inner: &'a mut [Vertex],
    bottom: &'a mut [Vertex],
}

impl<'a> Prism<'a> {
    /// Cuts the vertices of a body into its patches; `None` where they are too few.
    pub(super) fn new(form: Form, out: &'a mut [Vertex]) -> Option<Self> {
        let Form { columns, levels, .. } = form;
        let (top, out) = out.split_at_mut_checked(2 * columns)?;
        let (tail, out) = out.split_at_mut_checked(levels * columns)?;
        let (head, out) = out.split_at_mut_checked(levels * columns)?;
        let (outer, out) = out.split_at_mut_checked(2 * levels)?;
        let (inner, out) = out.split_at_mut_checked(2 * levels)?;
        let (bottom, _) = out.split_at_mut_checked(2 * columns)?;
        Some(Self { form, top, tail, head, outer, inner, bottom })
    }

    /// Sets the point of one column and level, at share `u` of the width, with its upward normal, which may
    /// have any length.
    pub(super) fn set(&mut self, column: usize, level: usize, u: f32, p: V2<f32>, n: V3<f32>) {
        let Form { columns, levels, sign, .. } = self.form;
        let at = column * levels + level;
        let side = [u, level as f32 / (levels - 1) as f32];
        let p = V2([p.0[0] * sign, p.0[1]]);
        let [x, y, z] = n.0;
        let n = V3([x * sign, y, z]);
        let up = V3([0.0, 1.0, 0.0]);
        for (slots, e, z) in [(&mut *self.tail, 0, 1.0), (&mut *self.head, 1, -1.0)] {
            if let Some(slot) = slots.get_mut(at) {
                *slot = self.form.corner(p, e, V3([0.0, 0.0, z]), side);
            }
        }
        let page = if sign > 0.0 { u } else { 1.0 - u };
        if level + 1 == levels {
            self.form.pair(self.top, column, p, unit(n, up), |v| [page, v]);
        }
        if level == 0 {
            self.form.pair(self.bottom, column, p, unit(-n, -up), |v| [page, v]);
        }
        if column + 1 == columns {
            self.form.pair(self.outer, level, p, up, |v| [v, side[1]]);
        }
        if column == 0 {
            self.form.pair(self.inner, level, p, up, |v| [v, side[1]]);
        }
    }

    /// Turns the normals of both ends outwards, once all points are set.
    pub(super) fn finish(self) {
        ends(self.outer, self.form.sign);
        ends(self.inner, -self.form.sign);
    }
}

impl Form {
    /// A vertex at the tail (`end` 0) or the head (1).
    fn corner(&self, p: V2<f32>, end: usize, n: V3<f32>, uv: [f32; 2]) -> Vertex {
        let z = if end == 0 { self.half_height } else { -self.half_height };
        Vertex { position: (V3([p.0[0], p.0[1], z]) * self.metres).0, normal: n.0, uv }
    }

    /// The two vertices of a column, tail and head; `uv` is given 1 at the tail.
    fn pair(
        &self,
        slots: &mut [Vertex],
        at: usize,
        p: V2<f32>,
        n: V3<f32>,
        uv: impl Fn(f32) -> [f32; 2],
    ) {
        for (end, slot) in slots.iter_mut().skip(2 * at).take(2).enumerate() {
            *slot = self.corner(p, end, n, uv(1.0 - end as f32));
        }
    }
}

/// Normals of a strip that climbs from level to level, from the climb itself.
fn ends(strip: &mut [Vertex], sign: f32) {
    let count = strip.len() / 2;
    for level in 0..count {
        let at = |l: usize| strip.get(2 * l).map_or([0.0; 3], |v| v.position);
        let ([x0, y0, _], [x1, y1, _]) =
            (at(level.saturating_sub(1)), at((level + 1).min(count - 1)));
        let n = unit(V3([y1 - y0, x0 - x1, 0.0]) * (1e3 * sign), V3([sign, 0.0, 0.0]));
        for slot in strip.iter_mut().skip(2 * level).take(2) {
            slot.normal = n.0;
        }
    }
}
