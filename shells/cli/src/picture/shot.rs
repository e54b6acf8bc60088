//! One pose as triangles, kept until it is drawn: physics first, pictures afterwards.

use super::BandShot;
use crate::error::CliError;
use dogleaf_core::Book;
use dogleaf_core::grid::Grid;
use dogleaf_core::mesh::{self, Counts, Layout, Surface, Vertex};
use dogleaf_core::real::Real;
use std::ops::Range;
use std::sync::Arc;

/// A part of a shot.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Piece {
    pub(crate) surface: Surface,
    pub(crate) indices: Range<usize>,
}

/// The meshes of one pose, metres in the book frame, and what lies where.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Shot {
    pub(crate) vertices: Vec<Vertex>,
    pub(crate) indices: Arc<[u16]>,
    pub(crate) pieces: Vec<Piece>,
    /// Leaves in the left and in the right block.
    pub(crate) leaves: [u32; 2],
    /// Leaves in the air.
    pub(crate) held: u32,
    /// How far the leaf in the air has left the page beneath it: 0 where it lies on it, 1 where light gets
    /// between them.
    pub(crate) free: f32,
    /// The ribbons.
    pub(crate) bands: Vec<BandShot>,
}

impl Shot {
    /// Nothing to be seen.
    pub(crate) fn bare() -> Self {
        Self {
            vertices: Vec::new(),
            indices: [].into(),
            pieces: Vec::new(),
            leaves: [0; 2],
            held: 0,
            free: 1.0,
            bands: Vec::new(),
        }
    }

    /// The triangles of a piece.
    pub(crate) fn triangles(&self, piece: &Piece) -> &[u16] {
        self.indices.get(piece.indices.clone()).unwrap_or_default()
    }
}

/// The indices of a book's mesh: the same in every frame.
pub(crate) fn book_indices<G: Grid>() -> Result<Arc<[u16]>, CliError> {
    let mut indices = vec![0; Layout::<G>::INDICES];
    mesh::indices::<G>(&mut indices)?;
    Ok(indices.into())
}

/// A book as it lies there.
pub(crate) fn book_shot<R: Real, G: Grid>(
    book: &Book<R, G>,
    indices: &Arc<[u16]>,
) -> Result<Shot, CliError> {
    let mut vertices = vec![Vertex::default(); Layout::<G>::VERTICES];
    let counts = mesh::vertices(book, &mut vertices)?;
    let free = book.leaf().map_or(1.0, |_| free::<G>(&vertices, &counts));
    let there = counts.parts.into_iter().filter(|part| part.visible);
    Ok(Shot {
        vertices,
        free,
        indices: indices.clone(),
        pieces: there.map(|p| Piece { surface: p.surface, indices: p.indices }).collect(),
        leaves: book.binding().leaves,
        held: book.binding().held,
        bands: Vec::new(),
    })
}

fn free<G: Grid>(vertices: &[Vertex], counts: &Counts) -> f32 {
    let of = |surface| {
        let part = counts.part(surface).filter(|p| p.visible);
        part.and_then(|p| vertices.get(p.vertices.clone())).unwrap_or_default()
    };
    let leaf = of(Surface::LeafUp);
    mesh::free::<G>(leaf, of(mesh::lies_beneath(leaf)))
}
