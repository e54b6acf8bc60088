//! Which page is seen where, and its picture: made when it is first seen, at the size needed.

use super::Shot;
use crate::error::CliError;
use dogleaf_content::{Book, Picture};
use dogleaf_core::scene::Direction;
use dogleaf_render::Texture;
use std::collections::BTreeMap;

/// The pages on the four faces one can see, counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Faces {
    pub(crate) left: Option<u32>,
    pub(crate) right: Option<u32>,
    /// On the side of the leaf that faces up when it lies on the right.
    pub(crate) leaf_up: u32,
    pub(crate) leaf_down: u32,
}

impl Faces {
    /// Two pages a leaf, in reading order: read leaves on the left, or on the right if one reads so.
    pub(crate) fn of(shot: &Shot, direction: Direction) -> Self {
        let [left, right] = shot.leaves;
        let ltr = direction == Direction::Ltr;
        let read = if ltr { left } else { right };
        let [first, after] = [2 * read, 2 * (read + shot.held)];
        let [over, next] = [first.checked_sub(1), Some(after)];
        let last = after.saturating_sub(1);
        if ltr {
            Self { left: over, right: next, leaf_up: first, leaf_down: last }
        } else {
            Self { left: next, right: over, leaf_up: last, leaf_down: first }
        }
    }
}

/// Where page pictures come from.
#[derive(Debug)]
pub(crate) struct PageSource {
    pub(crate) book: Book,
    /// Largest picture wanted, pixels.
    pub(crate) size: [u32; 2],
}

/// Page pictures made so far; nothing for a page beyond the book: blank paper.
#[derive(Debug, Default)]
pub(crate) struct Pages {
    source: Option<PageSource>,
    made: BTreeMap<u32, Texture>,
}

impl Pages {
    pub(crate) fn new(source: Option<PageSource>) -> Self {
        Self { source, made: BTreeMap::new() }
    }

    /// Makes a page's picture if that has not been done.
    ///
    /// A damaged page is drawn blank, and said so once.
    pub(crate) fn make(&mut self, page: Option<u32>) -> Result<(), CliError> {
        let (Some(source), Some(page)) = (&self.source, page) else { return Ok(()) };
        if self.made.contains_key(&page) || page as usize >= source.book.page_count() {
            return Ok(());
        }
        let [width, height] = source.size;
        let picture = source.book.page(page as usize, width, height).unwrap_or_else(|error| {
            eprintln!("dogleaf: {}", crate::error::one_line(&error.to_string()));
            Picture::blank(width, height)
        });
        let texture = Texture::from_rgba8(picture.width, picture.height, &picture.rgba)?;
        self.made.insert(page, texture);
        Ok(())
    }

    /// The picture of a page, if it has one.
    pub(crate) fn get(&self, page: Option<u32>) -> Option<&Texture> {
        self.made.get(&page?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shot(leaves: [u32; 2], held: u32) -> Shot {
        Shot { leaves, held, ..Shot::bare() }
    }

    #[test]
    fn a_leaf_has_its_own_reverse() {
        let f = Faces::of(&shot([4, 7], 1), Direction::Ltr);
        let wanted = Faces { left: Some(7), right: Some(10), leaf_up: 8, leaf_down: 9 };
        assert_eq!(f, wanted, "left to right");
        let f = Faces::of(&shot([7, 4], 1), Direction::Rtl);
        let wanted = Faces { left: Some(10), right: Some(7), leaf_up: 9, leaf_down: 8 };
        assert_eq!(f, wanted, "right to left");
    }

    #[test]
    fn a_stack_shows_its_outer_pages() {
        let f = Faces::of(&shot([0, 3], 5), Direction::Ltr);
        assert_eq!(f, Faces { left: None, right: Some(10), leaf_up: 0, leaf_down: 9 }, "five");
    }
}
