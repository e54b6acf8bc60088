//! Triangles for a shell to draw: the leaf in the air, the two blocks, the cover. Never fed back.
//!
//! The caller owns both buffers. [`indices`] fills one once; [`vertices`] fills the other every frame
//! and says which parts are there ([`Part::visible`]). Sizes follow from the grid alone: [`Layout`].
//!
//! | body | parts | shape |
//! |---|---|---|
//! | leaf | `LeafUp`, `LeafDown`, `LeafRim` | the net refined by a cubic spline, offset by half its thickness |
//! | block | `…Top`, `…Sides`, `…Bottom` | curves of one page's length, one above another, extruded along Z |
//! | cover | `LeftBoard`, `RightBoard`, `Spine` | boxes below the blocks |
//!
//! Every body is closed by itself, turned outwards (counter-clockwise seen from outside), in metres in
//! the book frame. Every curve from spine to fore-edge has the length of a page, whatever the soft
//! isometry or an offset did to it. That gives a stack its sheared fore-edge.
//!
//! Leaf and blocks have the same columns, so a leaf that lies on a block has its corners where the
//! block has them, and merging the two is not seen.
//!
//! Source: Book Sec. 3.5. Instead of moving only the last vertex, each curve is walked in steps of
//! known length; the last segment goes on straight where the curve is too short. Checked by
//! `tests/mesh_books.rs`, `tests/mesh_gestures.rs`, `tests/mesh_layout.rs`.

mod block;
mod board;
mod clear;
mod columns;
mod curve;
mod fold;
mod free;
mod indices;
mod layout;
mod leaf;
mod normals;
mod prism;
mod rim;
mod spline;
pub mod vertex;

pub use board::{BOARD_M, OVERHANG_M, table_drop_m};
pub use free::{free, lies_beneath};
pub use indices::indices;
pub(crate) use layout::enough;
pub use layout::{Counts, Layout, MeshError, PARTS, Part, Surface};
pub use vertex::Vertex;

use crate::book::{Book, LoneLeaf};
use crate::grid::Grid;
use crate::real::Real;

/// Fills the vertices of every part that is there, and says which are.
///
/// # Shapes and units
///
/// `out`: at least [`Layout::VERTICES`]; metres, book frame. Vertices of parts that are not there are left
/// as they are, so an index buffer filled once stays true.
///
/// # Cost
///
/// 3,058 vertices at 11x8, some 5,000 square roots, no trigonometry; about 10 kB of stack. A leaf folded
/// through itself is smoothed in up to 40 more rounds.
///
/// # Errors
///
/// [`MeshError::TooSmall`]: nothing was written.
pub fn vertices<R: Real, G: Grid>(
    book: &Book<R, G>,
    out: &mut [Vertex],
) -> Result<Counts, MeshError> {
    layout::enough(out.len(), Layout::<G>::VERTICES)?;
    let mut counts = Layout::<G>::counts();
    for part in &mut counts.parts {
        part.visible = part.surface.present(book);
    }
    if let Some(leaf) = book.leaf() {
        let leaf = leaf::Sheaf::of_book(book, leaf);
        leaf.write(counts.body(out, [Surface::LeafUp, Surface::LeafRim]));
    }
    block::write(book, false, counts.body(out, [Surface::LeftTop, Surface::LeftBottom]));
    block::write(book, true, counts.body(out, [Surface::RightTop, Surface::RightBottom]));
    board::write(book, counts.body(out, [Surface::LeftBoard, Surface::Spine]));
    Ok(counts)
}

/// Fills the three parts of one more leaf over a book, one leaf thick, in another pose than the held one's.
///
/// # Errors
///
/// [`MeshError::TooSmall`] below [`Layout::LEAF_VERTICES`]: nothing was written.
pub(crate) fn one_leaf<R: Real, G: Grid>(
    book: &Book<R, G>,
    leaf: &crate::state::Leaf<R, G>,
    out: &mut [Vertex],
) -> Result<(), MeshError> {
    layout::enough(out.len(), Layout::<G>::LEAF_VERTICES)?;
    let half = book.binding().leaf * R::of(0.5);
    leaf::Sheaf { half, ..leaf::Sheaf::of_book(book, leaf) }.write(out);
    Ok(())
}

/// The same for a lone leaf `thickness_m` thick, from [`PaperSpec`](crate::scene::PaperSpec): its three parts, no other.
///
/// # Errors
///
/// [`MeshError::TooSmall`]: nothing was written.
pub fn lone_vertices<R: Real, G: Grid>(
    lone: &LoneLeaf<R, G>,
    thickness_m: f64,
    out: &mut [Vertex],
) -> Result<Counts, MeshError> {
    layout::enough(out.len(), Layout::<G>::VERTICES)?;
    let mut counts = Layout::<G>::counts();
    for part in &mut counts.parts {
        let of_leaf = [Surface::LeafUp, Surface::LeafDown, Surface::LeafRim];
        part.visible = of_leaf.contains(&part.surface);
    }
    let units = lone.units();
    let leaf = leaf::Sheaf {
        sheet: lone.sheet(),
        leaf: lone.leaf(),
        half: R::of(0.5 * units.length(thickness_m)),
        clear: None,
        metres: units.metres,
    };
    leaf.write(counts.body(out, [Surface::LeafUp, Surface::LeafRim]));
    Ok(counts)
}
