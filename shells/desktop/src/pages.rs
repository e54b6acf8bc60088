//! Page pictures: those a frame shows at once, their neighbours from a thread of its own.

use crate::error::one_line;
use dogleaf_content::{Book, Picture};
use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};

/// Pages before and after the open ones that are made ready.
pub(crate) const AHEAD: u32 = 6;

/// A page's number and its picture.
type Made = (u32, Picture);

/// Makes page pictures.
#[derive(Debug)]
pub(crate) struct Pages {
    book: Arc<Book>,
    size: [u32; 2],
    orders: Sender<u32>,
    made: Receiver<Made>,
    ordered: BTreeSet<u32>,
}

impl Pages {
    /// Pictures as large as `size` at most. `ready` is called from another thread when one is made.
    pub(crate) fn new(book: Arc<Book>, size: [u32; 2], ready: impl Fn() + Send + 'static) -> Self {
        let (orders, taken) = channel();
        let (gives, made) = channel();
        let theirs = Arc::clone(&book);
        // It ends when nobody orders any more.
        std::thread::spawn(move || {
            for page in taken {
                if gives.send((page, picture(&theirs, page, size))).is_err() {
                    break;
                }
                ready();
            }
        });
        Self { book, size, orders, made, ordered: BTreeSet::new() }
    }

    /// Largest picture, pixels.
    pub(crate) fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Whether the book has this page; what lies beyond is blank paper.
    pub(crate) fn has(&self, page: u32) -> bool {
        (page as usize) < self.book.page_count()
    }

    /// A page that is wanted now.
    pub(crate) fn now(&self, page: u32) -> Picture {
        picture(&self.book, page, self.size)
    }

    /// A page that may be wanted soon.
    pub(crate) fn soon(&mut self, page: u32) {
        if self.has(page) && self.ordered.insert(page) {
            let _ = self.orders.send(page);
        }
    }

    /// A page that was made meanwhile.
    pub(crate) fn take(&mut self) -> Option<Made> {
        let made = self.made.try_recv().ok()?;
        self.ordered.remove(&made.0);
        Some(made)
    }
}

/// A damaged page is drawn blank, and said so.
fn picture(book: &Book, page: u32, [width, height]: [u32; 2]) -> Picture {
    book.page(page as usize, width, height).unwrap_or_else(|error| {
        eprintln!("dogleaf-desktop: {}", one_line(&error.to_string()));
        Picture::blank(width, height)
    })
}
