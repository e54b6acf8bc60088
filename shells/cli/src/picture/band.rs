//! A ribbon as triangles: its rims refined by cubics, both sides offset by half its thickness.

use super::sheet::cubic;
use crate::scene::Fabric;
use dogleaf_core::mesh::Vertex;
use dogleaf_render::{Material, PAPER_ALPHA, PAPER_TINT, Vec3};

/// Pieces a segment is cut into.
const CUTS: usize = 4;
/// Rows of vertices across: light is looked up between them.
const ACROSS: usize = 3;
/// Thickness to the eye, metres.
const THICKNESS_M: f32 = 3e-4;

/// A ribbon ready to be drawn: metres, both sides.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct BandShot {
    pub(crate) vertices: Vec<Vertex>,
    pub(crate) indices: Vec<u16>,
    pub(crate) fabric: Fabric,
}

/// A ribbon with these corners, rim A and rim B from its start to its end.
pub(crate) fn band_shot(rims: &[[[f64; 3]; 2]], fabric: Fabric) -> BandShot {
    let rims: Vec<[Vec3; 2]> =
        rims.iter().map(|r| r.map(|p| Vec3::from(p.map(|c| c as f32)))).collect();
    let rows = refined(&rims);
    let mut vertices = Vec::with_capacity(2 * ACROSS * rows.len());
    for facing in [1.0, -1.0] {
        for (j, row) in rows.iter().enumerate() {
            let normal = normal(&rows, j) * facing;
            let along = j as f32 / (rows.len() - 1) as f32;
            vertices.extend((0..ACROSS).map(|k| {
                let share = k as f32 / (ACROSS - 1) as f32;
                let place = row[0].lerp(row[1], share) + normal * (0.5 * THICKNESS_M);
                Vertex { position: place.to_array(), normal: normal.to_array(), uv: [along, share] }
            }));
        }
    }
    let half = ACROSS * rows.len();
    let mut indices = triangles(rows.len(), 0, false);
    indices.extend(triangles(rows.len(), half, true));
    BandShot { vertices, indices, fabric }
}

/// More rulings, on cubics through the given ones.
fn refined(rims: &[[Vec3; 2]]) -> Vec<[Vec3; 2]> {
    // Sixteen bits count the vertices of both sides.
    let most = usize::from(u16::MAX) / (2 * ACROSS);
    let cuts = (1..=CUTS).rev().find(|c| c * rims.len() < most).unwrap_or(1);
    let last = rims.len() - 1;
    let node = |j: isize, rim: usize| {
        let inside = j.clamp(0, last as isize).unsigned_abs();
        let beyond = if j < 0 { 1 } else { last - 1 };
        if inside as isize == j {
            rims[inside][rim]
        } else {
            rims[inside][rim] * 2.0 - rims[beyond][rim]
        }
    };
    let point = |fine: usize| {
        let i = (fine / cuts).min(last - 1) as isize;
        let t = fine as f32 / cuts as f32 - i as f32;
        [0, 1].map(|rim| cubic([-1, 0, 1, 2].map(|d| node(i + d, rim)), t))
    };
    (0..=cuts * last).map(point).collect()
}

/// Along the ribbon, then across it: where its front faces.
fn normal(rows: &[[Vec3; 2]], j: usize) -> Vec3 {
    let middle = |j: usize| (rows[j][0] + rows[j][1]) * 0.5;
    let (before, after) = (j.saturating_sub(1), (j + 1).min(rows.len() - 1));
    let along = middle(after) - middle(before);
    along.cross(rows[j][1] - rows[j][0]).normalize_or(Vec3::Y)
}

fn triangles(rows: usize, base: usize, flip: bool) -> Vec<u16> {
    let mut indices = Vec::with_capacity(6 * rows * (ACROSS - 1));
    for j in 1..rows {
        for k in 1..ACROSS {
            let at = |j: usize, k: usize| (base + j * ACROSS + k) as u16;
            let (a, b, c, d) = (at(j - 1, k - 1), at(j, k - 1), at(j, k), at(j - 1, k));
            indices.extend(if flip { [a, c, b, a, d, c] } else { [a, b, c, a, c, d] });
        }
    }
    indices
}

/// How a ribbon looks: red satin that glows against the light, or paper.
pub(crate) fn fabric(fabric: Fabric) -> Material<'static> {
    let (tint, roughness) = match fabric {
        Fabric::Satin => (Vec3::new(0.42, 0.03, 0.035), 0.42),
        Fabric::Paper => (PAPER_TINT, 0.8),
    };
    Material::Paper {
        front: None,
        back: None,
        thickness_m: 1.2e-4,
        alpha: PAPER_ALPHA,
        tint,
        roughness,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flat_ribbon_has_two_sides_that_face_apart() {
        let rims = (0..5).map(f64::from).map(|x| [[x, 0.0, 0.1], [x, 0.0, -0.1]]);
        let shot = band_shot(&rims.collect::<Vec<_>>(), Fabric::Satin);
        let rows = 4 * CUTS + 1;
        assert_eq!(shot.vertices.len(), 2 * ACROSS * rows, "both sides");
        assert_eq!(shot.indices.len(), 2 * 6 * (rows - 1) * (ACROSS - 1), "all triangles");
        for (n, corners) in shot.indices.chunks_exact(3).enumerate() {
            let [a, b, c] = [0, 1, 2].map(|i| &shot.vertices[usize::from(corners[i])]);
            let [p, q, r] = [a, b, c].map(|v| Vec3::from(v.position));
            let facing = (q - p).cross(r - p).dot(Vec3::from(a.normal));
            assert!(facing > 0.0, "triangle {n} faces as its vertices do: {facing}");
        }
        let up = Vec3::from(shot.vertices[0].normal);
        assert!((up - Vec3::Y).length() < 1e-6, "the front is up: {up}");
    }

    #[test]
    fn the_longest_ribbon_can_be_counted() {
        let rims = vec![[[0.0; 3], [1.0; 3]]; crate::scene::MOST_SEGMENTS + 1];
        let shot = band_shot(&rims, Fabric::Paper);
        assert!(shot.vertices.len() <= usize::from(u16::MAX), "{}", shot.vertices.len());
    }
}
