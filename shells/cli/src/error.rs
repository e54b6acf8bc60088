//! What can go wrong, each in one line, and the exit code it asks for.

use crate::gesture::GestureError;
use crate::scene::SceneError;
use dogleaf_content::ContentError;
use dogleaf_core::mesh::MeshError;
use dogleaf_core::record::RecordError;
use dogleaf_core::scene::SpecError;
use dogleaf_render::{AnimError, RenderError};
use std::path::Path;

/// Why the program ends without what was asked for.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CliError {
    /// A file the caller named cannot be read.
    #[error("{file}: cannot be read ({reason})")]
    Read {
        /// The path as given.
        file: String,
        /// The system's words.
        reason: String,
    },
    /// A file cannot be written.
    #[error("{file}: cannot be written ({reason})")]
    Write {
        /// The path as given.
        file: String,
        /// The system's words.
        reason: String,
    },
    /// The scene is refused.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The gesture is refused.
    #[error(transparent)]
    Gesture(#[from] GestureError),
    /// The core refuses a spec.
    #[error(transparent)]
    Spec(#[from] SpecError),
    /// The mesh does not fit where it shall go.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// No recording can be made.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// The recording is refused.
    #[error("{file}: {error}")]
    Recording {
        /// The path as given.
        file: String,
        /// Why.
        error: RecordError,
    },
    /// The book is refused.
    #[error(transparent)]
    Content(#[from] ContentError),
    /// The picture cannot be drawn.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The animation cannot be written.
    #[error(transparent)]
    Anim(#[from] AnimError),
    /// No report of costs can be made.
    #[error(transparent)]
    Cost(#[from] dogleaf_cost::CostError),
    /// The call asks for what does not go together, or is not there.
    #[error("{0}")]
    Call(String),
    /// A check ran and failed.
    #[error("{0}")]
    Check(String),
    /// The reader of our output went away: no fault of anybody.
    #[error("the reader of the output went away")]
    Gone,
}

impl CliError {
    /// 2 for bad input, 1 for a failed check.
    pub(crate) fn exit_code(&self) -> u8 {
        match self {
            Self::Gone => 0,
            Self::Check(_) => 1,
            _ => 2,
        }
    }

    pub(crate) fn read(path: &Path, error: &std::io::Error) -> Self {
        Self::Read { file: shown(path), reason: words(error) }
    }

    pub(crate) fn write(path: &Path, error: &std::io::Error) -> Self {
        if error.kind() == std::io::ErrorKind::BrokenPipe {
            return Self::Gone;
        }
        Self::Write { file: shown(path), reason: words(error) }
    }
}

/// A path as it may stand in a line of text.
pub(crate) fn shown(path: &Path) -> String {
    one_line(&path.display().to_string())
}

/// Text without line breaks and other controls.
pub(crate) fn one_line(text: &str) -> String {
    let parts: Vec<&str> = text.split_whitespace().collect();
    parts.join(" ").chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
}

fn words(error: &std::io::Error) -> String {
    one_line(&error.to_string()).to_lowercase()
}
