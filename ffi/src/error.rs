//! Why a call was refused.

use dogleaf_core::book::InputError;
use dogleaf_core::reading::Refusal;
use dogleaf_core::record::RecordError;
use dogleaf_core::scene::SpecError;

/// Why a call was refused. But for `Panicked`, nothing was changed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error, uniffi::Error)]
#[uniffi(flat_error)]
pub enum DogleafError {
    /// The book was shut.
    #[error("the book is closed")]
    Closed,
    /// A leaf is in the air.
    #[error("a leaf is in the air")]
    Busy,
    /// There is no page that way.
    #[error("there is no page that way")]
    NoSuchPage,
    /// The app paused the book.
    #[error("the book is paused")]
    Paused,
    /// A value no book can have; the text names it.
    #[error("{0}")]
    Refused(String),
    /// A pointer sample came too early, too late or too often. Samples before it in the same call were taken.
    #[error("{0}")]
    Pointer(String),
    /// Bytes that are no snapshot, or a recording that could not be made.
    #[error("{0}")]
    Recording(String),
    /// Something below broke. The book was put back to rest at its page, and goes on.
    #[error("dogleaf broke and put the book back to rest: {0}")]
    Panicked(String),
}

impl From<SpecError> for DogleafError {
    fn from(error: SpecError) -> Self {
        Self::Refused(error.to_string())
    }
}

impl From<InputError> for DogleafError {
    fn from(error: InputError) -> Self {
        Self::Pointer(error.to_string())
    }
}

impl From<Refusal> for DogleafError {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Busy => Self::Busy,
            Refusal::NoSuchPage => Self::NoSuchPage,
            Refusal::Paused => Self::Paused,
        }
    }
}

impl From<RecordError> for DogleafError {
    fn from(error: RecordError) -> Self {
        match error {
            RecordError::Spec(error) => error.into(),
            other => Self::Recording(other.to_string()),
        }
    }
}
