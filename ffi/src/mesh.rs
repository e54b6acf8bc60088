//! The buffers an app uploads: made once, never moved, filled in place.

use crate::options::mirrored;
use dogleaf_core::grid::G11x8;
use dogleaf_core::mesh::{self, Vertex};
use dogleaf_core::reading::{self, Reading, Shape};

type Sizes = Shape<G11x8>;

mirrored! {
    /// A part of the mesh, named by what it is of the book. Left and right as the reader sees them.
    Surface = mesh::Surface {
        /// The side of the leaf that faces up when it lies on the right.
        LeafUp,
        /// The side that faces up when it lies on the left.
        LeafDown,
        /// The leaf's four edges.
        LeafRim,
        /// The open page of the left block.
        LeftTop,
        /// Tail, head, fore-edge and gutter of the left block.
        LeftSides,
        /// Its underside.
        LeftBottom,
        /// The open page of the right block.
        RightTop,
        /// Tail, head, fore-edge and gutter of the right block.
        RightSides,
        /// Its underside.
        RightBottom,
        /// The board below the left block.
        LeftBoard,
        /// The board below the right block.
        RightBoard,
        /// The strip that joins the boards below the binding.
        Spine,
    }
}

/// What a piece shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, uniffi::Enum)]
pub enum PieceFace {
    /// A printed page, counted from 0; beyond the last one blank paper.
    Page {
        /// Which.
        page: u32,
    },
    /// The edges of leaves.
    Edge,
    /// A board or the spine of the cover.
    Cover,
}

/// One piece of the mesh: what it is, what it shows, which triangles it has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, uniffi::Record)]
pub struct Piece {
    /// What it is of the book.
    pub surface: Surface,
    /// It belongs to the leaf that slips into the hand or out of it.
    pub flying: bool,
    /// What it shows.
    pub face: PieceFace,
    /// The page on the other side of the same leaf, for the light that passes it; none but for a leaf in the air.
    pub reverse: Option<u32>,
    /// Leaves whose cut edges it shows; nought where it shows none.
    pub leaves: u32,
    /// Its first index.
    pub first_index: u32,
    /// How many; three a triangle.
    pub index_count: u32,
    /// Whether it is to be drawn.
    pub visible: bool,
}

/// Where the vertices lie: position (3 floats, metres), normal (3), place in the page picture (2).
///
/// The memory stays at this address until the object is freed, also after it was shut. It is written by `open`, `step`
/// and `restore` only: read it on the thread that calls those, or between two such calls.
#[derive(Debug, Clone, Copy, PartialEq, Eq, uniffi::Record)]
pub struct MeshView {
    /// First byte.
    pub address: u64,
    /// Bytes.
    pub byte_len: u64,
    /// Vertices.
    pub vertices: u32,
    /// Bytes of one.
    pub stride: u32,
    /// Number of this mesh.
    pub generation: u64,
}

/// Where the indices lie, 16 bits each: true for every frame. The same memory rules as [`MeshView`]'s.
#[derive(Debug, Clone, Copy, PartialEq, Eq, uniffi::Record)]
pub struct IndexView {
    /// First byte.
    pub address: u64,
    /// Bytes.
    pub byte_len: u64,
    /// Indices.
    pub indices: u32,
}

/// Both buffers, and what stands in them.
#[derive(Debug)]
pub(crate) struct Mesh {
    vertices: Box<[Vertex]>,
    indices: Box<[u16]>,
    pub(crate) pieces: Vec<Piece>,
    pub(crate) generation: u64,
    pub(crate) pieces_generation: u64,
    /// Share of the light that passes the leaf in the air, and the one on its way into the hand.
    pub(crate) through: [f32; 2],
    /// The pieces of the last frame, kept to compare.
    fresh: Vec<Piece>,
}

/// Extinction of paper, 1/m: a sheet of 0.1 mm passes a quarter of the light.
const ALPHA: f32 = 14_000.0;
/// What passes less than this counts as opaque.
const OPAQUE: f32 = 1e-3;
impl Mesh {
    pub(crate) fn new() -> Self {
        let mut indices = vec![0; Sizes::INDICES].into_boxed_slice();
        let fits = Reading::<f32, G11x8>::indices(&mut indices);
        debug_assert!(fits.is_ok(), "the buffer has the grid's own size");
        let vertices = vec![Vertex::default(); Sizes::VERTICES].into_boxed_slice();
        Self {
            vertices,
            indices,
            pieces: Vec::new(),
            generation: 0,
            pieces_generation: 0,
            through: [0.0; 2],
            fresh: Vec::new(),
        }
    }

    /// Fills the vertices from the book as it is.
    pub(crate) fn make(&mut self, reading: &Reading<f32, G11x8>) {
        let Ok(pieces) = reading.vertices(&mut self.vertices) else { return };
        self.generation += 1;
        let binding = reading.book().binding();
        let edges = Edges { blocks: binding.leaves, held: binding.held };
        self.fresh.clear();
        self.fresh.extend(pieces.iter().map(|p| piece(p, &pieces, &edges)));
        if self.fresh != self.pieces {
            std::mem::swap(&mut self.fresh, &mut self.pieces);
            self.pieces_generation += 1;
        }
        let leaf_m = reading.setup().paper.thickness_mm as f32 * 1e-3;
        self.through = [false, true].map(|flying| {
            let stack = !flying && binding.held > 1;
            let gap = if stack { 0.0 } else { free(&pieces, &self.vertices, flying) };
            let share = (-ALPHA * leaf_m).exp() * gap;
            if share < OPAQUE { 0.0 } else { share }
        });
    }

    pub(crate) fn view(&self) -> MeshView {
        MeshView {
            address: self.vertices.as_ptr() as u64,
            byte_len: size_of_val(&*self.vertices) as u64,
            vertices: self.vertices.len() as u32,
            stride: size_of::<Vertex>() as u32,
            generation: self.generation,
        }
    }

    pub(crate) fn index_view(&self) -> IndexView {
        IndexView {
            address: self.indices.as_ptr() as u64,
            byte_len: size_of_val(&*self.indices) as u64,
            indices: self.indices.len() as u32,
        }
    }

    #[cfg(test)]
    pub(crate) fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }
}

/// Leaves that lie left and right, and those in the air.
struct Edges {
    blocks: [u32; 2],
    held: u32,
}

fn piece(of: &reading::Piece, all: &[reading::Piece], edges: &Edges) -> Piece {
    let leaves = match of.surface {
        mesh::Surface::LeftSides => edges.blocks[0],
        mesh::Surface::RightSides => edges.blocks[1],
        mesh::Surface::LeafRim if edges.held > 1 && !of.flying => edges.held,
        _ => 0,
    };
    Piece {
        reverse: reverse(of, all),
        leaves,
        surface: of.surface.into(),
        flying: of.flying,
        face: match of.face {
            reading::Face::Page(page) => PieceFace::Page { page },
            reading::Face::Edge => PieceFace::Edge,
            reading::Face::Cover => PieceFace::Cover,
        },
        first_index: of.indices.start as u32,
        index_count: of.indices.len() as u32,
        visible: of.visible,
    }
}

/// The page on the other side of the same leaf.
fn reverse(of: &reading::Piece, all: &[reading::Piece]) -> Option<u32> {
    let other = match of.surface {
        mesh::Surface::LeafUp => mesh::Surface::LeafDown,
        mesh::Surface::LeafDown => mesh::Surface::LeafUp,
        _ => return None,
    };
    let there = all.iter().find(|p| p.surface == other && p.flying == of.flying)?;
    match there.face {
        reading::Face::Page(page) => Some(page),
        reading::Face::Edge | reading::Face::Cover => None,
    }
}

/// How far a leaf has left the page beneath, 0 to 1.
fn free(pieces: &[reading::Piece], vertices: &[Vertex], flying: bool) -> f32 {
    let of = |surface, flying| {
        let piece = pieces.iter().find(|p| p.surface == surface && p.flying == flying && p.visible);
        piece.and_then(|p| vertices.get(p.vertices.clone())).unwrap_or_default()
    };
    let leaf = of(mesh::Surface::LeafUp, flying);
    mesh::free::<G11x8>(leaf, of(mesh::lies_beneath(leaf), false))
}
