//! Wavefront OBJ: the leaf's net, the meshes around it and the ribbons, one file a frame. Metres, book frame.

use crate::error::CliError;
use crate::picture::Shot;
use crate::sim::LeafNodes;
use dogleaf_core::mesh::Vertex;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Where the files go.
pub(super) struct Folder(PathBuf);

impl Folder {
    pub(super) fn create(path: &Path) -> Result<Self, CliError> {
        std::fs::create_dir_all(path).map_err(|e| CliError::write(path, &e))?;
        Ok(Self(path.to_owned()))
    }

    /// Writes one frame: `net`, the simulated nodes, if there is a leaf; then every part that is drawn.
    pub(super) fn frame(
        &self,
        number: u32,
        leaf: Option<&LeafNodes>,
        shot: &Shot,
    ) -> Result<(), CliError> {
        let path = self.0.join(format!("frame_{number:05}.obj"));
        let mut text = format!("# dogleaf, frame {number}\n");
        let nodes = leaf.map_or(0, |leaf| net(&mut text, leaf));
        meshes(&mut text, shot, nodes);
        std::fs::write(&path, text).map_err(|e| CliError::write(&path, &e))
    }
}

/// Nodes with their places on the page (from the spine, from the tail), and quads facing up. Answers how
/// many nodes.
fn net(text: &mut String, leaf: &LeafNodes) -> usize {
    let share = |n: usize, of: usize| n as f64 / (of.max(2) - 1) as f64;
    text.push_str("o net\n");
    for [x, y, z] in &leaf.nodes {
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for i in 0..leaf.nx {
        for k in 0..leaf.nz {
            let _ = writeln!(text, "vt {} {}", share(i, leaf.nx), share(k, leaf.nz));
        }
    }
    for i in 1..leaf.nx {
        for k in 1..leaf.nz {
            let at = |i: usize, k: usize| 1 + i * leaf.nz + k;
            let [a, b, c, d] = [at(i - 1, k - 1), at(i, k - 1), at(i, k), at(i - 1, k)];
            let _ = writeln!(text, "f {a}/{a} {b}/{b} {c}/{c} {d}/{d}");
        }
    }
    leaf.nodes.len()
}

/// The parts that are drawn, each an object. OBJ counts `v` from the tail up, the core from the head down.
fn meshes(text: &mut String, shot: &Shot, before: usize) {
    corners(text, &shot.vertices);
    for piece in &shot.pieces {
        let _ = writeln!(text, "o {:?}", piece.surface);
        faces(text, shot.triangles(piece), [before, 0]);
    }
    let mut normals = shot.vertices.len();
    for (k, band) in shot.bands.iter().enumerate() {
        corners(text, &band.vertices);
        let _ = writeln!(text, "o Ribbon{k}");
        faces(text, &band.indices, [before + normals, normals]);
        normals += band.vertices.len();
    }
}

fn corners(text: &mut String, vertices: &[Vertex]) {
    for v in vertices {
        let [x, y, z] = v.position;
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for v in vertices {
        let _ = writeln!(text, "vt {} {}", v.uv[0], 1.0 - v.uv[1]);
    }
    for v in vertices {
        let [x, y, z] = v.normal;
        let _ = writeln!(text, "vn {x} {y} {z}");
    }
}

/// Triangles whose corners are counted behind so many places and so many normals.
fn faces(text: &mut String, indices: &[u16], [places, normals]: [usize; 2]) {
    for triangle in indices.chunks_exact(3) {
        text.push('f');
        for &corner in triangle {
            let own = usize::from(corner) + 1;
            let (place, normal) = (places + own, normals + own);
            let _ = write!(text, " {place}/{place}/{normal}");
        }
        text.push('\n');
    }
}
