//! Why a recording is refused, or cannot be made.

use super::header::Tier;
use crate::scene::SpecError;
use core::fmt;

/// Why a recording is refused, or cannot be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RecordError {
    /// It does not begin as a recording does.
    NotARecording,
    /// It was written in another version of the format.
    Version(u16),
    /// It ends in the middle of something.
    Truncated,
    /// It is longer than [`MAX_BYTES`](super::MAX_BYTES).
    TooLarge,
    /// It holds more than [`MAX_RECORDS`](super::MAX_RECORDS) records.
    TooMany,
    /// Its checksum does not fit: bytes were changed or lost.
    Checksum,
    /// The named field or tag has a value that means nothing.
    Unknown(&'static str),
    /// It repeats a hash before there was one, or no times.
    Repeat,
    /// Its end does not agree with what came before.
    Counts,
    /// Bytes follow its end.
    Trailing,
    /// What it asks for is refused.
    Spec(SpecError),
    /// It was made with other numbers than the book it shall be replayed in.
    Tier {
        /// Numbers of the recording.
        recorded: Tier,
        /// Numbers of the book.
        here: Tier,
    },
    /// It was made on another grid than the book's.
    Grid {
        /// Nodes of the recording, across and along.
        recorded: [u8; 2],
        /// Nodes of the book, across and along.
        here: [u8; 2],
    },
    /// It was made with equations that a book here does not solve.
    Formulation,
    /// No more fits in. What was recorded so far can still be finished.
    Full,
    /// The place it is written to failed; what was written is not a recording.
    Sink,
}

impl fmt::Display for RecordError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Version(v) => {
                write!(f, "the recording has version {v}, which this build does not read")
            }
            Self::Unknown(what) => write!(f, "the recording has an unknown {what}"),
            Self::Spec(error) => write!(f, "the recording asks for what cannot be: {error}"),
            Self::Tier { recorded, here } => {
                write!(f, "the recording was made with {recorded}, not {here}")
            }
            Self::Grid { recorded: [a, b], here: [c, d] } => {
                write!(f, "the recording was made on a {a}x{b} grid, not {c}x{d}")
            }
            plain => f.write_str(plain.words()),
        }
    }
}

impl RecordError {
    /// The message of an error that carries no value.
    fn words(self) -> &'static str {
        match self {
            Self::NotARecording => "not a dogleaf recording",
            Self::Truncated => "the recording ends too early",
            Self::TooLarge => "the recording is longer than 16 MiB",
            Self::TooMany => "the recording holds more than 1048576 records",
            Self::Checksum => "the checksum of the recording is wrong",
            Self::Repeat => "the recording repeats a step that is not there",
            Self::Counts => "the recording's counts are wrong",
            Self::Trailing => "bytes follow the end of the recording",
            Self::Formulation => "the recording was made with another formulation",
            Self::Full => "the recording is full",
            Self::Sink => "the recording could not be written",
            _ => "the recording is refused",
        }
    }
}

impl core::error::Error for RecordError {}

impl From<SpecError> for RecordError {
    fn from(error: SpecError) -> Self {
        Self::Spec(error)
    }
}
