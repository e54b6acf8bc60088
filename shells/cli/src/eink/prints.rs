//! Page pictures in sixteen greys, made when a panel first shows them.

use dogleaf_content::{Book, Picture};
use dogleaf_eink::{Print, Stage};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// The pages of a book as a panel prints them.
pub(crate) struct Prints {
    content: Book,
    size: [u16; 2],
    made: RefCell<BTreeMap<u32, Vec<u8>>>,
}

impl std::fmt::Debug for Prints {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Prints").field("size", &self.size).finish_non_exhaustive()
    }
}

impl Prints {
    pub(crate) fn new(content: Book, stage: &Stage) -> Self {
        Self { content, size: stage.page(), made: RefCell::default() }
    }

    fn make(&self, page: u32) -> Vec<u8> {
        let [w, h] = self.size.map(u32::from);
        let picture = self.content.page(page as usize, w, h).unwrap_or_else(|error| {
            eprintln!("dogleaf: {}", crate::error::one_line(&error.to_string()));
            Picture::blank(w, h)
        });
        let [left, top] =
            [w.saturating_sub(picture.width) / 2, h.saturating_sub(picture.height) / 2];
        let cells = (0..h).flat_map(|y| (0..w).map(move |x| (x, y)));
        let grey = |(x, y): (u32, u32)| {
            let inside = x.checked_sub(left).zip(y.checked_sub(top));
            inside.and_then(|(x, y)| picture.pixel(x, y)).map_or(255, sixteen)
        };
        cells.map(grey).collect()
    }
}

/// The nearest of sixteen greys, as brightness.
fn sixteen([r, g, b, _]: [u8; 4]) -> u8 {
    let luma = (u32::from(r) * 54 + u32::from(g) * 183 + u32::from(b) * 19) / 256;
    ((luma + 8) / 17 * 17) as u8
}

impl Print for Prints {
    fn luma(&self, page: u32, x: u16, y: u16) -> u8 {
        let mut made = self.made.borrow_mut();
        let picture = made.entry(page).or_insert_with(|| self.make(page));
        let at = usize::from(y) * usize::from(self.size[0]) + usize::from(x);
        picture.get(at).copied().unwrap_or(255)
    }
}
