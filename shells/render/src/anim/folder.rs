//! A folder of numbered PNG pictures.

use std::path::PathBuf;

use super::Film;
use super::apng::still;
use super::shot::Shot;
use crate::error::AnimError;

/// Writes `frame_0000.png` and so on.
#[derive(Debug)]
pub(super) struct Folder {
    folder: PathBuf,
    size: (u32, u32),
}

impl Folder {
    pub(super) fn create(folder: PathBuf, width: u32, height: u32) -> Self {
        Self { folder, size: (width, height) }
    }
}

impl Film for Folder {
    fn show(&mut self, shot: &Shot) -> Result<(), AnimError> {
        let path = self.folder.join(format!("frame_{:04}.png", shot.from));
        let bytes = still(self.size.0, self.size.1, &shot.pixels)?;
        std::fs::write(&path, bytes).map_err(|source| AnimError::Io { path, source })
    }

    fn close(&mut self) -> Result<(), AnimError> {
        Ok(())
    }

    fn wants_all(&self) -> bool {
        true
    }
}
