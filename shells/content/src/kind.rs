//! What a file is, by its first bytes.

use crate::error::Fault;

/// The three kinds of book.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BookKind {
    /// A PDF: vector pages, drawn at any size.
    Pdf,
    /// A comic-book archive: a zip of images.
    Cbz,
    /// A directory of images.
    Folder,
}

impl std::fmt::Display for BookKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Pdf => "pdf",
            Self::Cbz => "cbz",
            Self::Folder => "folder",
        })
    }
}

/// Bytes that [`recognise`] wants: readers accept a PDF header anywhere in the first 1024.
pub(crate) const HEAD_BYTES: u64 = 1024;

/// What starts a file that is not a book, and what to call it.
const STRANGERS: [(&[u8], &str); 9] = [
    (b"Rar!", "it is a rar archive (cbr), pack its images as a zip"),
    (b"7z\xbc\xaf\x27\x1c", "it is a 7z archive, pack its images as a zip"),
    (b"\x1f\x8b", "it is a gzip file"),
    (b"\x89PNG", "it is a single image"),
    (b"\xff\xd8\xff", "it is a single image"),
    (b"GIF8", "it is a single image"),
    (b"RIFF", "it is a single image or a sound"),
    (b"\xd0\xcf\x11\xe0", "it is an old office document"),
    (b"%!PS", "it is postscript, convert it to pdf"),
];

/// Tells a file's kind from its first [`HEAD_BYTES`].
pub(crate) fn recognise(head: &[u8]) -> Result<BookKind, Fault> {
    if head.is_empty() {
        return Err(Fault::NotABook("it is an empty file".into()));
    }
    if head.starts_with(b"PK\x03\x04") || head.starts_with(b"PK\x05\x06") {
        return Ok(BookKind::Cbz);
    }
    if head.windows(5).any(|w| w == b"%PDF-") {
        return Ok(BookKind::Pdf);
    }
    let known = STRANGERS.iter().find(|(magic, _)| head.starts_with(magic));
    Err(Fault::NotABook(known.map_or("its first bytes are of no known kind", |s| s.1).into()))
}
