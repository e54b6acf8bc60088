//! A book: opened once, asked for single pages.

use crate::archive::Archive;
use crate::decode::{self, ImageFiles};
use crate::error::{ContentError, Fault, one_line, shown};
use crate::folder::Folder;
use crate::kind::{self, BookKind};
use crate::pdf::PdfBook;
use crate::picture::Picture;
use crate::title;
use std::fs::File;
use std::io::{ErrorKind, Read, Seek};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// Pages looked at for [`Book::aspect`], evenly spread: more would not move the median.
const ASPECT_SAMPLES: usize = 256;

/// Pages tried before a book is given up as broken from end to end.
const FIRST_PAGE_TRIES: usize = 64;

/// An open book. It can be shared between threads; a folder's and an archive's files must stay
/// where they are while it is open.
pub struct Book {
    path: PathBuf,
    kind: BookKind,
    source: Source,
    title: String,
    first_size: (f32, f32),
    aspect: OnceLock<f32>,
}

enum Source {
    Pdf(PdfBook),
    Images(Box<dyn ImageFiles>),
}

impl Book {
    /// Opens a PDF, a CBZ or a folder of images and makes sure that it has a page to show.
    ///
    /// # Cost
    ///
    /// A PDF is read and its page tree parsed; of an archive the directory is read; a folder is
    /// listed. Of the pages only the first one's header is looked at.
    ///
    /// # Errors
    ///
    /// Every [`ContentError`] but `NoSuchPage` and `BadPage`: the book cannot be shown at all.
    pub fn open(path: &Path) -> Result<Self, ContentError> {
        let (kind, source) = open_source(path)?;
        let title = match &source {
            Source::Pdf(pdf) => pdf.title().map(str::to_owned),
            Source::Images(_) => None,
        };
        let title = title.unwrap_or_else(|| title::from_path(path));
        let first_size = first_size(&source).map_err(|fault| fault.of(path))?;
        let path = path.to_owned();
        Ok(Self { path, kind, source, title, first_size, aspect: OnceLock::new() })
    }

    /// The number of pages, at least 1.
    #[must_use]
    pub fn page_count(&self) -> usize {
        self.source.count()
    }

    /// What the book was read from.
    #[must_use]
    pub fn kind(&self) -> BookKind {
        self.kind
    }

    /// What the book calls itself, else its file's name without the ending; one line.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Width and height of page `i`, counted from 0: points in a PDF, pixels else.
    ///
    /// # Cost
    ///
    /// Nothing for a PDF; else the head of the image is read, and no pixel decoded.
    ///
    /// # Errors
    ///
    /// `NoSuchPage`, or `BadPage` if this page alone is damaged.
    pub fn page_size(&self, i: usize) -> Result<(f32, f32), ContentError> {
        self.check_index(i)?;
        self.source.page_size(i).map_err(|reason| self.bad_page(i, &reason))
    }

    /// Width over height of the typical page: the median over (at most 256 of) the sound pages.
    ///
    /// # Cost
    ///
    /// As many [`page_size`](Self::page_size)s, once.
    #[must_use]
    pub fn aspect(&self) -> f32 {
        *self.aspect.get_or_init(|| median_aspect(&self.source).unwrap_or(ratio(self.first_size)))
    }

    /// Draws page `i`, counted from 0, as large as the box allows without changing its shape.
    ///
    /// White paper lies beneath whatever is transparent. Images are enlarged twofold at most,
    /// the pages of a PDF without limit; the box is clamped to [`limits`](crate::limits).
    ///
    /// # Errors
    ///
    /// `NoSuchPage`, or `BadPage` if this page alone is damaged: draw a
    /// [`Picture::blank`] leaf and go on.
    pub fn page(
        &self,
        i: usize,
        max_width_px: u32,
        max_height_px: u32,
    ) -> Result<Picture, ContentError> {
        self.check_index(i)?;
        let max = (max_width_px, max_height_px);
        self.source.page(i, max).map_err(|reason| self.bad_page(i, &reason))
    }

    fn check_index(&self, i: usize) -> Result<(), ContentError> {
        let last = self.page_count();
        if i < last {
            return Ok(());
        }
        let (file, page) = (shown(&self.path), i.saturating_add(1));
        Err(ContentError::NoSuchPage { file, page, last })
    }

    fn bad_page(&self, i: usize, reason: &str) -> ContentError {
        let reason = self.source.named(i, reason);
        ContentError::BadPage { file: shown(&self.path), page: i + 1, reason }
    }
}

impl std::fmt::Debug for Book {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (kind, pages) = (self.kind, self.page_count());
        write!(f, "Book({:?}, {kind}, {pages} pages)", self.title)
    }
}

impl Source {
    fn count(&self) -> usize {
        match self {
            Self::Pdf(pdf) => pdf.count(),
            Self::Images(files) => files.count(),
        }
    }

    fn page_size(&self, i: usize) -> Result<(f32, f32), String> {
        match self {
            Self::Pdf(pdf) => pdf.page_size(i),
            Self::Images(files) => decode::page_size(files.as_ref(), i),
        }
    }

    fn page(&self, i: usize, max: (u32, u32)) -> Result<Picture, String> {
        match self {
            Self::Pdf(pdf) => pdf.page(i, max),
            Self::Images(files) => decode::page(files.as_ref(), i, max),
        }
    }

    /// A reason with the name of the image it is about.
    fn named(&self, i: usize, reason: &str) -> String {
        match self {
            Self::Pdf(_) => reason.to_owned(),
            Self::Images(files) => format!("{}: {reason}", one_line(files.name(i))),
        }
    }
}

fn open_source(path: &Path) -> Result<(BookKind, Source), ContentError> {
    let about = match std::fs::metadata(path) {
        Err(e) if e.kind() == ErrorKind::NotFound => {
            return Err(ContentError::Missing { file: shown(path) });
        }
        other => other.map_err(|e| Fault::from(e).of(path))?,
    };
    let opened = if about.is_dir() {
        Folder::open(path).map(|folder| (BookKind::Folder, Source::Images(Box::new(folder))))
    } else if about.is_file() {
        open_file(path)
    } else {
        Err(Fault::NotABook("it is a device or a pipe".into()))
    };
    opened.map_err(|fault| fault.of(path))
}

fn open_file(path: &Path) -> Result<(BookKind, Source), Fault> {
    let mut file = File::open(path)?;
    let mut head = Vec::new();
    (&mut file).take(kind::HEAD_BYTES).read_to_end(&mut head)?;
    file.rewind()?;
    let kind = kind::recognise(&head)?;
    let source = match kind {
        BookKind::Pdf => Source::Pdf(PdfBook::open(&file)?),
        _ => Source::Images(Box::new(Archive::open(file)?)),
    };
    Ok((kind, source))
}

/// The size of the first sound page; an error if there is none, with the first page's reason.
fn first_size(source: &Source) -> Result<(f32, f32), Fault> {
    let mut first_reason = None;
    for i in 0..source.count().min(FIRST_PAGE_TRIES) {
        match source.page_size(i) {
            Ok(size) => return Ok(size),
            Err(reason) => _ = first_reason.get_or_insert_with(|| source.named(i, &reason)),
        }
    }
    Err(first_reason.map_or(Fault::Empty, |reason| {
        Fault::Broken(format!("no page can be read, and of the first, {reason}"))
    }))
}

fn median_aspect(source: &Source) -> Option<f32> {
    let step = source.count().div_ceil(ASPECT_SAMPLES).max(1);
    let sampled = (0..source.count()).step_by(step);
    let mut aspects: Vec<f32> =
        sampled.filter_map(|i| source.page_size(i).ok().map(ratio)).collect();
    aspects.sort_by(f32::total_cmp);
    // Of an even number the lower middle: always the aspect of a page that exists.
    aspects.get(aspects.len().saturating_sub(1) / 2).copied()
}

fn ratio((width, height): (f32, f32)) -> f32 {
    width / height
}
