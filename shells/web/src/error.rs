//! Why a call was refused: a kind for programs, one line for people. Nothing was changed by what was refused.

use dogleaf_core::book::InputError;
use dogleaf_core::reading::Refusal;
use dogleaf_core::record::RecordError;
use dogleaf_core::scene::SpecError;
use std::fmt;

/// Why a call was refused.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refused {
    /// `busy`, `noSuchPage`, `paused`, `refused`, `pointer` or `recording`.
    pub kind: &'static str,
    /// The line.
    pub text: String,
}

impl Refused {
    /// One of a kind.
    pub fn new(kind: &'static str, text: impl fmt::Display) -> Self {
        Self { kind, text: text.to_string() }
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl std::error::Error for Refused {}

impl From<SpecError> for Refused {
    fn from(error: SpecError) -> Self {
        Self::new("refused", error)
    }
}

impl From<InputError> for Refused {
    fn from(error: InputError) -> Self {
        Self::new("pointer", error)
    }
}

impl From<RecordError> for Refused {
    fn from(error: RecordError) -> Self {
        match error {
            RecordError::Spec(error) => error.into(),
            other => Self::new("recording", other),
        }
    }
}

impl From<Refusal> for Refused {
    fn from(refusal: Refusal) -> Self {
        let kind = match refusal {
            Refusal::Busy => "busy",
            Refusal::NoSuchPage => "noSuchPage",
            Refusal::Paused => "paused",
        };
        Self::new(kind, refusal)
    }
}
