//! What can go wrong, each in one line.

use crate::headless::HeadlessError;
use crate::renderer::DrawError;
use dogleaf_content::ContentError;
use dogleaf_core::mesh::MeshError;
use dogleaf_core::record::RecordError;
use dogleaf_core::scene::SpecError;
use std::path::Path;

/// Why the program ends without what was asked for.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DesktopError {
    /// The book is refused.
    #[error(transparent)]
    Content(#[from] ContentError),
    /// The core refuses a spec.
    #[error(transparent)]
    Spec(#[from] SpecError),
    /// The core refuses a setup, or no recording can be made.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// The mesh does not fit where it shall go.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Nothing can be drawn.
    #[error(transparent)]
    Draw(#[from] DrawError),
    /// Nothing can be drawn without a window.
    #[error(transparent)]
    Headless(#[from] HeadlessError),
    /// There is no window.
    #[error("no window can be opened ({0})")]
    Window(String),
    /// A file the caller named cannot be read, written, or understood.
    #[error("{file}: {reason}")]
    File {
        /// The path as given, and the line if there is one.
        file: String,
        /// What is wrong.
        reason: String,
    },
    /// The call asks for what does not go together, or is not there.
    #[error("{0}")]
    Call(String),
}

impl DesktopError {
    /// A file, and what the system says of it.
    pub(crate) fn file(path: &Path, what: &str, error: &dyn std::fmt::Display) -> Self {
        let reason = format!("{what} ({})", one_line(&error.to_string()).to_lowercase());
        Self::File { file: one_line(&path.display().to_string()), reason }
    }
}

/// Text without line breaks and other controls.
#[must_use]
pub fn one_line(text: &str) -> String {
    let parts: Vec<&str> = text.split_whitespace().collect();
    parts.join(" ").chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
}
