//! What each piece of the book is made of, and how light passes a leaf.

use dogleaf_core::book::Book;
use dogleaf_core::grid::Grid;
use dogleaf_core::mesh::{self, Surface, Vertex};
use dogleaf_core::reading::{Face, Piece};
use dogleaf_core::real::Real;

/// Colour of bare paper, linear.
const PAPER: [f32; 3] = [0.905, 0.885, 0.835];
/// Colour of the boards' cloth.
const CLOTH: [f32; 3] = [0.16, 0.035, 0.03];
/// Mean colour of the table's wood.
const WOOD: [f32; 3] = [0.105, 0.066, 0.042];
/// Extinction of paper, 1/m: a sheet of 0.1 mm passes a quarter of the light.
const ALPHA: f32 = 14_000.0;
/// What passes less than this counts as opaque.
const OPAQUE: f32 = 1e-3;
/// How the shader shall take a piece: its uniforms of the same names.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Look {
    pub(super) material: i32,
    pub(super) tint: [f32; 3],
    pub(super) passing: f32,
    pub(super) thickness: f32,
    pub(super) leaves: f32,
    /// The pages on this side and on the other.
    pub(super) front: Option<u32>,
    pub(super) back: Option<u32>,
}

impl Look {
    const SOLID: Self = Self {
        material: 0,
        tint: PAPER,
        passing: 0.0,
        thickness: 0.0,
        leaves: 0.0,
        front: None,
        back: None,
    };
    /// The table's.
    pub(super) const TABLE: Self = Self { material: 3, tint: WOOD, ..Self::SOLID };
}

/// What a frame's looks follow from, beside its pieces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leaves {
    /// In the left and the right block.
    pub blocks: [u32; 2],
    /// In the air.
    pub held: u32,
    /// How far the leaf in the air, and the one that flies into the hand, have left the page beneath: 0 where
    /// they lie on it, 1 where light gets between. What passes a leaf that lies comes back from the page.
    pub free: [f32; 2],
}

impl Leaves {
    /// Counts them, and measures the gaps.
    #[must_use]
    pub fn of<R: Real, G: Grid>(book: &Book<R, G>, pieces: &[Piece], vertices: &[Vertex]) -> Self {
        let binding = book.binding();
        let free = [false, true].map(|flying| free::<G>(pieces, vertices, flying));
        Self { blocks: binding.leaves, held: binding.held, free }
    }
}

fn free<G: Grid>(pieces: &[Piece], vertices: &[Vertex], flying: bool) -> f32 {
    let of = |surface, flying| {
        let piece = pieces.iter().find(|p| p.surface == surface && p.flying == flying && p.visible);
        piece.and_then(|p| vertices.get(p.vertices.clone())).unwrap_or_default()
    };
    let leaf = of(Surface::LeafUp, flying);
    mesh::free::<G>(leaf, of(mesh::lies_beneath(leaf), false))
}

/// The look of one piece among all.
pub(super) fn look(piece: &Piece, pieces: &[Piece], leaves: &Leaves, leaf_m: f32) -> Look {
    let edges = |count: u32| Look { material: 1, leaves: count as f32, ..Look::SOLID };
    let stack = leaves.held > 1 && !piece.flying;
    match piece.surface {
        Surface::LeafRim if stack => edges(leaves.held),
        Surface::LeafUp | Surface::LeafDown | Surface::LeafRim => {
            let passing = if stack { 0.0 } else { passing(leaf_m, leaves, piece.flying) };
            Look {
                passing,
                thickness: if passing > 0.0 { leaf_m.min(1e-3) } else { 0.0 },
                front: page(piece.face),
                back: reverse(piece, pieces),
                ..Look::SOLID
            }
        }
        Surface::LeftTop | Surface::RightTop => Look { front: page(piece.face), ..Look::SOLID },
        Surface::LeftSides => edges(leaves.blocks[0]),
        Surface::RightSides => edges(leaves.blocks[1]),
        Surface::LeftBottom | Surface::RightBottom => Look::SOLID,
        Surface::LeftBoard | Surface::RightBoard | Surface::Spine => {
            Look { material: 2, tint: CLOTH, ..Look::SOLID }
        }
    }
}

/// Share of the light that passes one leaf.
fn passing(leaf_m: f32, leaves: &Leaves, flying: bool) -> f32 {
    let share = (-ALPHA * leaf_m).exp() * leaves.free[usize::from(flying)];
    if share < OPAQUE { 0.0 } else { share }
}

fn page(face: Face) -> Option<u32> {
    match face {
        Face::Page(page) => Some(page),
        Face::Edge | Face::Cover => None,
    }
}

/// The page on the other side of the same leaf.
fn reverse(piece: &Piece, pieces: &[Piece]) -> Option<u32> {
    let other = match piece.surface {
        Surface::LeafUp => Surface::LeafDown,
        Surface::LeafDown => Surface::LeafUp,
        _ => return None,
    };
    let there = pieces.iter().find(|p| p.surface == other && p.flying == piece.flying);
    there.and_then(|p| page(p.face))
}
