//! Books to page pictures: a PDF, a CBZ or a folder of images in, white-backed RGBA pages out.
//!
//! A [`Book`] is opened once and asked for single pages; nothing is decoded before it is asked for,
//! and a page is made at the size the caller can show. What a file *is* is read from its first
//! bytes, never from its name. Pages of archives and folders come in natural order (2 before 10).
//!
//! A wide scan that shows two pages side by side stays **one** picture, as wide as it was scanned:
//! where the gutter lies is the scanner's secret. [`Book::aspect`] is the median over the pages, so
//! a few such spreads among single pages do not change the book's shape.
//!
//! # Trust
//!
//! A book is a stranger's file. Every cap in [`limits`] is checked before memory is set aside;
//! archives are read by index and nothing is ever written to disk; a parser that panics becomes a
//! [`ContentError`]. One bad page is the error of that page alone: draw a [`Picture::blank`] leaf.
//! What is not bounded: a PDF is parsed in this process, and a hostile one can still cost time
//! and, by its compressed streams, memory. A shell that opens strangers' PDFs unattended
//! should do so in a process it can end. A build with `panic = "abort"` loses the guard too.
//!
//! # Example
//!
//! ```no_run
//! use dogleaf_content::{Book, Picture};
//!
//! let book = Book::open("novel.pdf".as_ref())?;
//! for i in 0..book.page_count() {
//!     let page = book.page(i, 1000, 1500).unwrap_or_else(|_| Picture::blank(1000, 1500));
//!     println!("{} x {}", page.width, page.height);
//! }
//! # Ok::<(), dogleaf_content::ContentError>(())
//! ```
//!
//! Checked by the files in `tests/`, one per promise.

mod archive;
mod book;
mod budget;
mod decode;
mod error;
mod fit;
mod folder;
mod guard;
mod inspect;
mod kind;
pub mod limits;
mod names;
mod natural;
mod pdf;
mod picture;
mod scale;
mod size;
mod title;

pub use book::Book;
pub use error::ContentError;
pub use kind::BookKind;
pub use picture::Picture;
