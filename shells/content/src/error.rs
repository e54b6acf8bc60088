//! What can be wrong with a book, each in one line that names the file and what to do.

use std::path::Path;

/// Why a book or one of its pages cannot be shown.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ContentError {
    /// There is nothing at this path.
    #[error("{file} does not exist: check the name")]
    Missing {
        /// The path as given.
        file: String,
    },
    /// The system refuses to read it.
    #[error("{file} cannot be read ({reason}): check its permissions and its disk")]
    Unreadable {
        /// The path as given.
        file: String,
        /// The system's own words.
        reason: String,
    },
    /// It is something else.
    #[error("{file} is not a book: {found}; give a pdf, a cbz or a folder of images")]
    NotABook {
        /// The path as given.
        file: String,
        /// What its first bytes look like.
        found: String,
    },
    /// It is locked with a password, or encrypted some other way.
    #[error("{file} is password-protected: save a copy without a password and open that")]
    PasswordProtected {
        /// The path as given.
        file: String,
    },
    /// It is of a known kind but damaged.
    #[error("{file} is broken ({reason}): fetch or export it again")]
    Broken {
        /// The path as given.
        file: String,
        /// What was found.
        reason: String,
    },
    /// It is sound but has no page.
    #[error(
        "{file} has no pages: give a pdf with one, or put png, jpeg, webp or gif images into the cbz or folder"
    )]
    Empty {
        /// The path as given.
        file: String,
    },
    /// It exceeds one of the [`limits`](crate::limits).
    #[error("{file} is too large ({reason}): split it into smaller books")]
    TooLarge {
        /// The path as given.
        file: String,
        /// Which limit, and by how much.
        reason: String,
    },
    /// The caller asked for a page beyond the last.
    #[error("{file} has no page {page}: its last page is {last}")]
    NoSuchPage {
        /// The path as given.
        file: String,
        /// The page asked for, counted from 1.
        page: usize,
        /// The last page, counted from 1.
        last: usize,
    },
    /// This page alone is bad; the rest of the book can be shown.
    #[error("page {page} of {file} cannot be drawn ({reason}): show it blank or replace it")]
    BadPage {
        /// The path as given.
        file: String,
        /// The page, counted from 1.
        page: usize,
        /// What was found.
        reason: String,
    },
}

/// What is wrong with a file, before anybody knows its name.
#[derive(Debug)]
pub(crate) enum Fault {
    Unreadable(String),
    NotABook(String),
    PasswordProtected,
    Broken(String),
    Empty,
    TooLarge(String),
}

impl Fault {
    /// Names the file.
    pub(crate) fn of(self, path: &Path) -> ContentError {
        let file = shown(path);
        match self {
            Self::Unreadable(reason) => ContentError::Unreadable { file, reason },
            Self::NotABook(found) => ContentError::NotABook { file, found },
            Self::PasswordProtected => ContentError::PasswordProtected { file },
            Self::Broken(reason) => ContentError::Broken { file, reason },
            Self::Empty => ContentError::Empty { file },
            Self::TooLarge(reason) => ContentError::TooLarge { file, reason },
        }
    }
}

impl From<std::io::Error> for Fault {
    fn from(error: std::io::Error) -> Self {
        Self::Unreadable(io_words(&error))
    }
}

/// What the system says, in lower case like all of our lines.
pub(crate) fn io_words(error: &std::io::Error) -> String {
    one_line(&error.to_string()).to_lowercase()
}

/// A path as it may stand in a line of text: no line break or other control gets through.
pub(crate) fn shown(path: &Path) -> String {
    one_line(&path.display().to_string())
}

/// Replaces every control character, so that the text stays one line.
pub(crate) fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
}
