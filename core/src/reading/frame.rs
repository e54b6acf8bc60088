//! The one mesh an app uploads: the book, and the leaf that slips into the hand or out of it.

use super::Reading;
use super::faces::{Face, faces};
use crate::grid::Grid;
use crate::mesh::{self, Layout, MeshError, PARTS, Surface, Vertex};
use crate::real::Real;
use core::marker::PhantomData;
use core::ops::Range;

/// Pieces of a mesh: the parts of the book, and those of the leaf on its way.
pub const FACES: usize = PARTS + LEAF.len();
/// Surfaces of a leaf.
const LEAF: [Surface; 3] = [Surface::LeafUp, Surface::LeafDown, Surface::LeafRim];

/// Sizes of the buffers of one grid.
#[derive(Debug, Clone, Copy, Default)]
pub struct Shape<G: Grid>(PhantomData<G>);

impl<G: Grid> Shape<G> {
    /// Vertices in all.
    pub const VERTICES: usize = Layout::<G>::VERTICES + Layout::<G>::LEAF_VERTICES;
    /// Indices in all.
    pub const INDICES: usize = Layout::<G>::INDICES + Layout::<G>::LEAF_INDICES;
}

/// One piece of the mesh: where it stands, what it shows, whether it is there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Piece {
    /// What it is of the book.
    pub surface: Surface,
    /// It belongs to the leaf that slips into the hand or out of it.
    pub flying: bool,
    /// What it shows.
    pub face: Face,
    /// Its vertices.
    pub vertices: Range<usize>,
    /// Its indices, three a triangle.
    pub indices: Range<usize>,
    /// Whether it is there in this frame. If not, its vertices mean nothing.
    pub visible: bool,
}

impl<R: Real, G: Grid> Reading<R, G> {
    /// Fills the vertices of every piece that is there, and says of each what it shows.
    ///
    /// # Shapes and units
    ///
    /// `out`: at least [`Shape::VERTICES`]; metres, book frame. [`Reading::indices`] belong to it.
    ///
    /// # Errors
    ///
    /// [`MeshError::TooSmall`]: nothing was written.
    pub fn vertices(&self, out: &mut [Vertex]) -> Result<[Piece; FACES], MeshError> {
        mesh::enough(out.len(), Shape::<G>::VERTICES)?;
        let counts = mesh::vertices(&self.book, out)?;
        let rest = out.get_mut(Layout::<G>::VERTICES..).unwrap_or_default();
        let flying = self.flier(rest)?;
        let first = Layout::<G>::counts();
        let way = self.trail.way().filter(|_| flying);
        Ok(core::array::from_fn(|n| {
            let own = counts.parts.get(n);
            let part = own.or_else(|| first.parts.get(n.wrapping_sub(PARTS)));
            let shift = if own.is_some() { [0, 0] } else { Self::SHIFT };
            let surface = part.map_or(Surface::Spine, |p| p.surface);
            let moved = |r: Range<usize>, by: usize| r.start + by..r.end + by;
            Piece {
                surface,
                flying: own.is_none(),
                face: faces(&self.book, surface, way, own.is_none()),
                vertices: part.map_or(0..0, |p| moved(p.vertices.clone(), shift[0])),
                indices: part.map_or(0..0, |p| moved(p.indices.clone(), shift[1])),
                visible: own.map_or(flying, |p| p.visible),
            }
        }))
    }

    /// Where the leaf on its way begins in both buffers.
    const SHIFT: [usize; 2] = [Layout::<G>::VERTICES, Layout::<G>::INDICES];

    fn flier(&self, out: &mut [Vertex]) -> Result<bool, MeshError> {
        let Some(leaf) = self.book.leaf() else { return Ok(false) };
        let mut there = crate::state::Leaf::ZERO;
        if !self.trail.pose(&leaf.x, &mut there.x) {
            return Ok(false);
        }
        mesh::one_leaf(&self.book, &there, out)?;
        Ok(true)
    }

    /// Fills the indices of all pieces: once, they are true for every frame.
    ///
    /// # Errors
    ///
    /// [`MeshError::TooSmall`] below [`Shape::INDICES`]: nothing was written.
    pub fn indices(out: &mut [u16]) -> Result<(), MeshError> {
        mesh::enough(out.len(), Shape::<G>::INDICES)?;
        mesh::indices::<G>(out)?;
        let halves = out.split_at_mut_checked(Layout::<G>::INDICES);
        let Some((book, flier)) = halves else { return Ok(()) };
        for (slot, &index) in flier.iter_mut().zip(book.iter()).take(Layout::<G>::LEAF_INDICES) {
            *slot = index.saturating_add(Layout::<G>::VERTICES as u16);
        }
        Ok(())
    }
}
