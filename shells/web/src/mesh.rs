//! The buffers a page uploads: made once, never moved, filled in place; and the list of what they hold, as numbers.

use dogleaf_core::grid::G11x8;
use dogleaf_core::mesh::{Surface, Vertex, free, lies_beneath};
use dogleaf_core::reading::{Face, Piece, Reading, Shape};

/// The book of every shell: 11 nodes by 8, single precision.
pub type Paper = Reading<f32, G11x8>;

/// Numbers of one piece.
///
/// ```text
/// surface (its place in Surface::ALL)   flying 0, 1   face 0 page, 1 edge, 2 cover   page or -1   page of the reverse or -1
/// leaves whose cut edges it shows       first index   indices                        visible 0, 1
/// ```
pub const PIECE: usize = 9;

/// Extinction of paper, 1/m, and what counts as opaque: `shells/glsl/README.md`.
const EXTINCTION: f32 = 14_000.0;
const OPAQUE: f32 = 1e-3;

/// Both buffers and the list of pieces.
#[derive(Debug)]
pub struct Mesh {
    /// Vertices, as `Reading::vertices` fills them.
    pub vertices: Box<[Vertex]>,
    /// Indices: true for every frame.
    pub indices: Box<[u16]>,
    /// [`PIECE`] numbers for each piece.
    pub pieces: Vec<i32>,
    /// Moves when the vertices do.
    pub generation: u32,
    /// Moves when the pieces do.
    pub pieces_generation: u32,
    /// Share of the light that passes the leaf in the air, and the one on its way into the hand.
    pub through: [f32; 2],
}

impl Default for Mesh {
    fn default() -> Self {
        let mut indices = vec![0; Shape::<G11x8>::INDICES].into_boxed_slice();
        let filled = Paper::indices(&mut indices);
        debug_assert!(filled.is_ok(), "the buffer has the grid's own size");
        Self {
            vertices: vec![Vertex::default(); Shape::<G11x8>::VERTICES].into_boxed_slice(),
            indices,
            pieces: Vec::new(),
            generation: 0,
            pieces_generation: 0,
            through: [0.0; 2],
        }
    }
}

impl Mesh {
    /// Fills everything from the book as it is.
    pub fn make(&mut self, paper: &Paper) {
        let Ok(pieces) = paper.vertices(&mut self.vertices) else { return };
        self.generation = self.generation.wrapping_add(1);
        let list = pieces.iter().flat_map(|p| numbers(p, &pieces, paper)).collect();
        if self.pieces != list {
            self.pieces = list;
            self.pieces_generation = self.pieces_generation.wrapping_add(1);
        }
        let leaf_m = paper.setup().paper.thickness_mm as f32 * 1e-3;
        let one = paper.book().binding().held <= 1;
        let share = |flying: bool| {
            let seen = (-EXTINCTION * leaf_m).exp() * self.free(&pieces, flying);
            if seen >= OPAQUE && (flying || one) { seen } else { 0.0 }
        };
        self.through = [share(false), share(true)];
    }

    /// How far a leaf has left the page beneath, 0 to 1.
    fn free(&self, pieces: &[Piece], flying: bool) -> f32 {
        let part = |surface: Surface, flying: bool| {
            let there = |p: &&Piece| p.visible && p.surface == surface && p.flying == flying;
            let range = pieces.iter().find(there).map(|p| p.vertices.clone());
            range.and_then(|r| self.vertices.get(r)).unwrap_or_default()
        };
        let leaf = part(Surface::LeafUp, flying);
        free::<G11x8>(leaf, part(lies_beneath(leaf), false))
    }
}

fn numbers(piece: &Piece, all: &[Piece], paper: &Paper) -> [i32; PIECE] {
    let surface = Surface::ALL.iter().position(|s| *s == piece.surface).unwrap_or_default();
    let (kind, page) = match piece.face {
        Face::Page(page) => (0, page as i32),
        Face::Edge => (1, -1),
        Face::Cover => (2, -1),
    };
    [
        surface as i32,
        i32::from(piece.flying),
        kind,
        page,
        reverse(piece, all),
        edges(piece, paper) as i32,
        piece.indices.start as i32,
        piece.indices.len() as i32,
        i32::from(piece.visible),
    ]
}

/// Leaves whose cut edges a piece shows.
fn edges(piece: &Piece, paper: &Paper) -> u32 {
    let binding = paper.book().binding();
    let [left, right] = binding.leaves;
    match piece.surface {
        Surface::LeftSides => left,
        Surface::RightSides => right,
        Surface::LeafRim if !piece.flying && binding.held > 1 => binding.held,
        _ => 0,
    }
}

/// The page on the other side of the same leaf.
fn reverse(piece: &Piece, all: &[Piece]) -> i32 {
    let other = match piece.surface {
        Surface::LeafUp => Surface::LeafDown,
        Surface::LeafDown => Surface::LeafUp,
        _ => return -1,
    };
    let pair = all.iter().find(|p| p.surface == other && p.flying == piece.flying);
    match pair.map(|p| p.face) {
        Some(Face::Page(page)) => page as i32,
        _ => -1,
    }
}
