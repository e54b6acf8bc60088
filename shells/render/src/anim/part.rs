//! A file or folder under a temporary name until it is complete.

use std::fs::{self, File};
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use crate::error::AnimError;

/// Where something is written and what it will be called; removed when dropped before [`Part::keep`].
#[derive(Debug)]
pub(super) struct Part {
    target: PathBuf,
    temporary: PathBuf,
    kept: bool,
}

impl Part {
    pub(super) fn new(target: &Path) -> Self {
        let name = target.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let temporary = target.with_file_name(format!(".{name}.{}.part", std::process::id()));
        Self { target: target.to_owned(), temporary, kept: false }
    }

    /// Opens the temporary file.
    pub(super) fn open(&self) -> Result<BufWriter<File>, AnimError> {
        Ok(BufWriter::new(self.said(File::create(&self.temporary))?))
    }

    /// Makes the temporary folder.
    pub(super) fn make_folder(&self) -> Result<PathBuf, AnimError> {
        self.said(fs::create_dir_all(&self.temporary))?;
        Ok(self.temporary.clone())
    }

    /// Gives it its name. Into a folder that is there already the pictures are moved one by one.
    pub(super) fn keep(mut self) -> Result<(), AnimError> {
        if self.temporary.is_dir() && self.target.is_dir() {
            for entry in self.said(fs::read_dir(&self.temporary))? {
                let entry = self.said(entry)?;
                self.said(fs::rename(entry.path(), self.target.join(entry.file_name())))?;
            }
            return Ok(());
        }
        self.said(fs::rename(&self.temporary, &self.target))?;
        self.kept = true;
        Ok(())
    }

    /// Names the place in what the system says.
    fn said<T>(&self, result: std::io::Result<T>) -> Result<T, AnimError> {
        result.map_err(|source| AnimError::Io { path: self.target.clone(), source })
    }
}

impl Drop for Part {
    fn drop(&mut self) {
        if !self.kept {
            // Nothing can be done about a failure here, and nothing worse than litter comes of it.
            let _ = if self.temporary.is_dir() {
                fs::remove_dir_all(&self.temporary)
            } else {
                fs::remove_file(&self.temporary)
            };
        }
    }
}
