//! Wavefront OBJ: the leaf's net, one file a frame. Metres, book frame.

use super::Frame;
use crate::error::CliError;
use crate::sim::LeafNodes;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Where the files go.
pub(super) struct Folder(PathBuf);

impl Folder {
    pub(super) fn create(path: &Path) -> Result<Self, CliError> {
        std::fs::create_dir_all(path).map_err(|e| CliError::write(path, &e))?;
        Ok(Self(path.to_owned()))
    }

    /// Writes the frame; one without a leaf in the air gives a file without a face.
    pub(super) fn frame(&mut self, frame: &Frame<'_>) -> Result<(), CliError> {
        let path = self.0.join(format!("frame_{:05}.obj", frame.number));
        let mut text = format!("# dogleaf, frame {}, {} s\n", frame.number, frame.time_s);
        if let Some(leaf) = &frame.pose.leaf {
            net(&mut text, leaf);
        }
        std::fs::write(&path, text).map_err(|e| CliError::write(&path, &e))
    }
}

/// Nodes with their places on the page (from the spine, from the tail), and quads facing up.
fn net(text: &mut String, leaf: &LeafNodes) {
    let share = |n: usize, of: usize| n as f64 / (of.max(2) - 1) as f64;
    text.push_str("o leaf\n");
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
            let corners = [at(i - 1, k - 1), at(i, k - 1), at(i, k), at(i - 1, k)];
            let [a, b, c, d] = corners;
            let _ = writeln!(text, "f {a}/{a} {b}/{b} {c}/{c} {d}/{d}");
        }
    }
}
