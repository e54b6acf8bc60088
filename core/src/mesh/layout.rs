//! Which vertices and indices belong to which part; follows from the grid alone.

use super::{Vertex, columns};
use crate::book::Book;
use crate::grid::Grid;
use crate::real::Real;
use core::fmt;
use core::marker::PhantomData;
use core::ops::Range;

/// Parts of a mesh.
pub const PARTS: usize = 12;
/// Rows a cell of the net is cut into, along the binding.
pub(super) const ALONG: usize = 2;
/// Curves from the underside of a block to its top.
pub(super) const LEVELS: usize = 7;
/// Patches a part has at most.
const PATCHES: usize = 6;

/// A part of the mesh, named by what it is of the book. Left and right as the reader sees them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Surface {
    /// The side of the leaf that faces up when it lies on the right.
    LeafUp,
    /// The side that faces up when it lies on the left.
    LeafDown,
    /// The leaf's four edges.
    LeafRim,
    /// The open page of the left block.
    LeftTop,
    /// Tail, head, fore-edge and gutter of the left block, in this order.
    LeftSides,
    /// Its underside.
    LeftBottom,
    /// The open page of the right block.
    RightTop,
    /// Tail, head, fore-edge and gutter of the right block, in this order.
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

/// A grid of vertices: column by column, `rows` in each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Patch {
    pub(super) columns: usize,
    pub(super) rows: usize,
    /// Columns cross rows points inwards.
    pub(super) flip: bool,
}

impl Patch {
    const NONE: Self = Self { columns: 0, rows: 0, flip: false };

    pub(super) const fn new(columns: usize, rows: usize, flip: bool) -> Self {
        Self { columns, rows, flip }
    }
    const fn vertices(self) -> usize {
        self.columns * self.rows
    }
    const fn indices(self) -> usize {
        6 * self.columns.saturating_sub(1) * self.rows.saturating_sub(1)
    }
}

impl Surface {
    /// Every surface, in the order of the buffers.
    pub const ALL: [Self; PARTS] = [
        Self::LeafUp,
        Self::LeafDown,
        Self::LeafRim,
        Self::LeftTop,
        Self::LeftSides,
        Self::LeftBottom,
        Self::RightTop,
        Self::RightSides,
        Self::RightBottom,
        Self::LeftBoard,
        Self::RightBoard,
        Self::Spine,
    ];

    /// The patches a part is made of.
    pub(super) const fn patches<G: Grid>(self) -> [Patch; PATCHES] {
        let (c, r) = (Layout::<G>::COLUMNS, Layout::<G>::ROWS);
        let none = Patch::NONE;
        match self {
            Self::LeafUp => [Patch::new(c, r, false), none, none, none, none, none],
            Self::LeafDown => [Patch::new(c, r, true), none, none, none, none, none],
            Self::LeafRim => [
                Patch::new(c, 2, false),
                Patch::new(c, 2, true),
                Patch::new(r, 2, false),
                Patch::new(r, 2, true),
                none,
                none,
            ],
            Self::LeftTop => pick([true, false, false], c, LEVELS, true),
            Self::LeftSides => pick([false, true, false], c, LEVELS, true),
            Self::LeftBottom => pick([false, false, true], c, LEVELS, true),
            Self::RightTop => pick([true, false, false], c, LEVELS, false),
            Self::RightSides => pick([false, true, false], c, LEVELS, false),
            Self::RightBottom => pick([false, false, true], c, LEVELS, false),
            Self::LeftBoard => prism(2, 2, true),
            Self::RightBoard | Self::Spine => prism(2, 2, false),
        }
    }

    pub(super) fn present<R: Real, G: Grid>(self, book: &Book<R, G>) -> bool {
        let [left, right] = book.binding().leaves;
        match self {
            Self::LeafUp | Self::LeafDown | Self::LeafRim => book.leaf().is_some(),
            Self::LeftTop | Self::LeftSides | Self::LeftBottom => left > 0,
            Self::RightTop | Self::RightSides | Self::RightBottom => right > 0,
            Self::LeftBoard | Self::RightBoard | Self::Spine => {
                book.boards().is_some() && book.binding().all() > 0
            }
        }
    }
}

/// Top, tail, head, outer end, inner end, bottom of an extruded body.
pub(super) const fn prism(columns: usize, levels: usize, mirrored: bool) -> [Patch; PATCHES] {
    let m = mirrored;
    [
        Patch::new(columns, 2, m),
        Patch::new(columns, levels, m),
        Patch::new(columns, levels, !m),
        Patch::new(levels, 2, !m),
        Patch::new(levels, 2, m),
        Patch::new(columns, 2, !m),
    ]
}

/// Of an extruded body its top, its four sides, or its bottom.
const fn pick(which: [bool; 3], columns: usize, levels: usize, mirrored: bool) -> [Patch; PATCHES] {
    let [a, b, c, d, e, f] = prism(columns, levels, mirrored);
    let none = Patch::NONE;
    match which {
        [true, ..] => [a, none, none, none, none, none],
        [_, true, _] => [b, c, d, e, none, none],
        _ => [f, none, none, none, none, none],
    }
}

/// One part and where it stands in the buffers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Part {
    /// What it is.
    pub surface: Surface,
    /// Its vertices.
    pub vertices: Range<usize>,
    /// Its indices, three a triangle.
    pub indices: Range<usize>,
    /// Whether it is there in this frame. If not, its vertices mean nothing.
    pub visible: bool,
}

/// Every part, in the order of the buffers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Counts {
    /// The parts; `parts[surface as usize]` is that surface's.
    pub parts: [Part; PARTS],
}

impl Counts {
    /// The part of one surface.
    pub fn part(&self, surface: Surface) -> Option<&Part> {
        self.parts.iter().find(|p| p.surface == surface)
    }
    /// Triangles of the parts that are there.
    pub fn triangles(&self) -> usize {
        self.parts.iter().filter(|p| p.visible).map(|p| p.indices.len() / 3).sum()
    }
    /// The vertices from one part to another; empty if the first is not there.
    pub(super) fn body<'a>(
        &self,
        out: &'a mut [Vertex],
        [first, last]: [Surface; 2],
    ) -> &'a mut [Vertex] {
        let range = match (self.part(first), self.part(last)) {
            (Some(a), Some(b)) if a.visible => a.vertices.start..b.vertices.end,
            _ => 0..0,
        };
        out.get_mut(range).unwrap_or_default()
    }
}

/// Sizes of the buffers of one grid.
#[derive(Debug, Clone, Copy, Default)]
pub struct Layout<G: Grid>(PhantomData<G>);

impl<G: Grid> Layout<G> {
    /// Vertices from spine to fore-edge, of the leaf and of the blocks.
    pub const COLUMNS: usize = columns::count(G::NX) + 1;
    /// Vertices from tail to head of the leaf.
    pub const ROWS: usize = ALONG * (G::NZ - 1) + 1;
    /// Vertices in all.
    pub const VERTICES: usize = Self::totals(PARTS).0;
    /// Vertices of the leaf's three parts, which come first.
    pub const LEAF_VERTICES: usize = Self::totals(3).0;
    /// Their indices.
    pub const LEAF_INDICES: usize = Self::totals(3).1;
    /// Indices in all.
    pub const INDICES: usize = Self::totals(PARTS).1;

    /// Vertices and indices of the first `parts` parts.
    const fn totals(parts: usize) -> (usize, usize) {
        let (mut vertices, mut indices) = (0, 0);
        let mut all: &[Surface] = &Surface::ALL;
        let mut left = parts;
        while let [first, rest @ ..] = all {
            if left == 0 {
                break;
            }
            let mut patches: &[Patch] = &first.patches::<G>();
            while let [patch, others @ ..] = patches {
                vertices += patch.vertices();
                indices += patch.indices();
                patches = others;
            }
            all = rest;
            left -= 1;
        }
        (vertices, indices)
    }

    /// Every part's place; all visible.
    pub fn counts() -> Counts {
        const { assert!(Self::VERTICES <= 65_536, "an index has sixteen bits") };
        const { assert!(Self::COLUMNS <= columns::MOST, "a row has a place of fixed size") };
        let parts = Surface::ALL.map(|surface| {
            let (v0, i0) = Self::totals(surface as usize);
            let (v1, i1) = Self::totals(surface as usize + 1);
            Part { surface, vertices: v0..v1, indices: i0..i1, visible: true }
        });
        Counts { parts }
    }
}

/// Why a buffer was not filled; nothing was written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum MeshError {
    /// The buffer is too short.
    TooSmall {
        /// Elements it has.
        has: usize,
        /// Elements it needs.
        needs: usize,
    },
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self::TooSmall { has, needs } = self;
        write!(f, "the mesh buffer has {has} places and needs {needs}")
    }
}

impl core::error::Error for MeshError {}

pub(crate) fn enough(has: usize, needs: usize) -> Result<(), MeshError> {
    if has < needs { Err(MeshError::TooSmall { has, needs }) } else { Ok(()) }
}
