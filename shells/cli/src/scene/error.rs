//! Why a scene is refused: file, line, reason.

use dogleaf_core::scene::SpecError;

/// A scene is refused; nothing was run.
#[derive(Debug, thiserror::Error)]
#[error("{file}:{line}: {fault}")]
pub(crate) struct SceneError {
    /// The file as given.
    pub(crate) file: String,
    /// Line of the fault, counted from 1.
    pub(crate) line: usize,
    /// What is wrong there.
    pub(crate) fault: Fault,
}

/// What is wrong at a line of a scene.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Fault {
    /// Not TOML.
    #[error("{0}")]
    Syntax(String),
    /// A word no scene has.
    #[error("unknown {what} '{given}'{place}; {hint}")]
    Unknown {
        /// Key, table or value.
        what: &'static str,
        /// The word.
        given: String,
        /// ` in [table]`, or nothing.
        place: String,
        /// What may have been meant.
        hint: String,
    },
    /// A value of the wrong kind.
    #[error("{key} must be {wanted}")]
    Kind {
        /// Table and key.
        key: String,
        /// What it must be.
        wanted: String,
    },
    /// An effect that other versions have.
    #[error("the effect '{0}' is not built into this dogleaf")]
    NotBuilt(&'static str),
    /// Two things that exclude each other.
    #[error("{0}")]
    Conflict(&'static str),
    /// A number out of its range.
    #[error(transparent)]
    Spec(#[from] SpecError),
}
