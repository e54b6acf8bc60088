//! A lone leaf as triangles: its net refined by cubics, both sides offset by half its thickness.

use super::{Piece, Shot};
use crate::sim::LeafNodes;
use dogleaf_core::mesh::{Surface, Vertex};
use dogleaf_render::Vec3;

/// Pieces an edge of the net is cut into.
const CUTS: usize = 4;

/// The two sides of a leaf whose nodes are given in metres.
pub(crate) fn sheet_shot(leaf: &LeafNodes, thickness_m: f32) -> Shot {
    let fine = Net::of(leaf).refined().turned().refined().turned();
    let count = fine.nodes.len();
    let mut vertices = fine.side(0.5 * thickness_m);
    vertices.extend(fine.side(-0.5 * thickness_m));
    let mut indices = fine.triangles(0, false);
    let half = indices.len();
    indices.extend(fine.triangles(count, true));
    let piece = |surface, indices| Piece { surface, indices };
    let pieces =
        vec![piece(Surface::LeafUp, 0..half), piece(Surface::LeafDown, half..indices.len())];
    Shot { vertices, indices: indices.into(), pieces, held: 1, ..Shot::bare() }
}

/// Points in columns.
struct Net {
    columns: usize,
    rows: usize,
    nodes: Vec<Vec3>,
}

impl Net {
    fn of(leaf: &LeafNodes) -> Self {
        let nodes = leaf.nodes.iter().map(|p| Vec3::from(p.map(|c| c as f32))).collect();
        Self { columns: leaf.nx, rows: leaf.nz, nodes }
    }

    /// The point at a column and a row, counted on beyond the border in a straight line.
    fn at(&self, column: isize, row: usize) -> Vec3 {
        let last = self.columns as isize - 1;
        let inside = column.clamp(0, last);
        let node = |c: isize| self.nodes[c.unsigned_abs() * self.rows + row];
        let beyond = column - inside;
        if beyond == 0 {
            return node(inside);
        }
        node(inside) * 2.0 - node((inside - beyond).clamp(0, last))
    }

    /// More columns, on cubics through the given ones.
    fn refined(&self) -> Self {
        let columns = CUTS * (self.columns - 1) + 1;
        let mut nodes = Vec::with_capacity(columns * self.rows);
        for fine in 0..columns {
            let i = (fine / CUTS).min(self.columns - 2) as isize;
            let t = fine as f32 / CUTS as f32 - i as f32;
            for row in 0..self.rows {
                nodes.push(cubic([-1, 0, 1, 2].map(|d| self.at(i + d, row)), t));
            }
        }
        Self { columns, rows: self.rows, nodes }
    }

    /// Rows become columns.
    fn turned(&self) -> Self {
        let place = |row: usize| (0..self.columns).map(move |c| c * self.rows + row);
        let nodes = (0..self.rows).flat_map(place).map(|at| self.nodes[at]).collect();
        Self { columns: self.rows, rows: self.columns, nodes }
    }

    /// The vertices of one side.
    fn side(&self, offset: f32) -> Vec<Vertex> {
        let facing = offset.signum();
        let vertex = |(c, r): (usize, usize)| {
            let normal = self.normal(c, r);
            let share = |n: usize, of: usize| n as f32 / (of - 1) as f32;
            let u = share(c, self.columns);
            Vertex {
                position: (self.nodes[c * self.rows + r] + normal * offset).to_array(),
                normal: (normal * facing).to_array(),
                uv: [if facing > 0.0 { u } else { 1.0 - u }, 1.0 - share(r, self.rows)],
            }
        };
        (0..self.columns).flat_map(|c| (0..self.rows).map(move |r| (c, r))).map(vertex).collect()
    }

    /// Up, where the leaf lies flat: columns run along X, rows along -Z.
    fn normal(&self, c: usize, r: usize) -> Vec3 {
        let near = |n: usize, of: usize| (n.saturating_sub(1), (n + 1).min(of - 1));
        let ((c0, c1), (r0, r1)) = (near(c, self.columns), near(r, self.rows));
        let node = |c: usize, r: usize| self.nodes[c * self.rows + r];
        (node(c1, r) - node(c0, r)).cross(node(c, r1) - node(c, r0)).normalize_or(Vec3::Y)
    }

    fn triangles(&self, base: usize, flip: bool) -> Vec<u16> {
        let mut indices = Vec::new();
        for c in 1..self.columns {
            for r in 1..self.rows {
                let at = |c: usize, r: usize| (base + c * self.rows + r) as u16;
                let (a, b, d, e) = (at(c - 1, r - 1), at(c, r - 1), at(c, r), at(c - 1, r));
                let two = if flip { [a, d, b, a, e, d] } else { [a, b, d, a, d, e] };
                indices.extend(two);
            }
        }
        indices
    }
}

/// Catmull and Rom's curve between the second and third of four points.
pub(super) fn cubic([a, b, c, d]: [Vec3; 4], t: f32) -> Vec3 {
    let (m, n) = ((c - a) * 0.5, (d - b) * 0.5);
    let (t2, t3) = (t * t, t * t * t);
    b * (2.0 * t3 - 3.0 * t2 + 1.0)
        + m * (t3 - 2.0 * t2 + t)
        + c * (3.0 * t2 - 2.0 * t3)
        + n * (t3 - t2)
}
