//! Which printed page is seen on which surface.

use crate::book::Book;
use crate::grid::Grid;
use crate::mesh::Surface;
use crate::real::Real;
use crate::scene::Direction;

/// What a surface shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Face {
    /// A printed page, counted from 0; beyond the last one blank paper.
    Page(u32),
    /// The edges of leaves.
    Edge,
    /// A board or the spine of the cover.
    Cover,
}

/// What a surface of a book shows; `flying` asks for the leaf on its way, which goes into the hand or out of it as
/// `inwards` says.
///
/// Two pages a leaf, in reading order: leaves that are read lie on the left, or on the right where one reads so.
pub fn faces<R: Real, G: Grid>(
    book: &Book<R, G>,
    surface: Surface,
    inwards: Option<bool>,
    flying: bool,
) -> Face {
    let binding = book.binding();
    let ltr = book.spec().direction == Direction::Ltr;
    let on_right = usize::from(!ltr);
    let read = binding.leaves.get(on_right).copied().unwrap_or_default();
    // Leaves come to the hand on the side they were taken from: last ones if that is where one reads on.
    let onward = binding.from_right == ltr;
    let mut first = read;
    let mut after = read.saturating_add(binding.held);
    let (mut over, mut next) = (first, after);
    match (inwards, onward) {
        (None, _) => {}
        (Some(true), true) => after = after.saturating_sub(1),
        (Some(true), false) => first = first.saturating_add(1),
        (Some(false), true) => next = next.saturating_add(1),
        (Some(false), false) => over = over.saturating_sub(1),
    }
    if flying {
        first = if onward { after } else { first.saturating_sub(1) };
        after = first.saturating_add(1);
    }
    let front = |leaf: u32| Face::Page(leaf.saturating_mul(2));
    let back = |leaf: u32| leaf.saturating_mul(2).checked_sub(1).map_or(Face::Edge, Face::Page);
    let side = |left: bool, low: Face, high: Face| if left == ltr { low } else { high };
    match surface {
        Surface::LeafUp => side(true, front(first), back(after)),
        Surface::LeafDown => side(false, front(first), back(after)),
        Surface::LeftTop => side(true, back(over), front(next)),
        Surface::RightTop => side(false, back(over), front(next)),
        Surface::LeftBoard | Surface::RightBoard | Surface::Spine => Face::Cover,
        Surface::LeafRim
        | Surface::LeftSides
        | Surface::LeftBottom
        | Surface::RightSides
        | Surface::RightBottom => Face::Edge,
    }
}
