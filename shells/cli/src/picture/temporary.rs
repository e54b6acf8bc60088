//! Stands in for the render crate's animation writer until that exists: a folder of PPM files.
use crate::error::CliError;
use std::path::{Path, PathBuf};
pub(crate) struct Writer(PathBuf, u32, u32, u32);
impl Writer {
    pub(crate) fn create(out: &Path, w: u32, h: u32, _fps: u32) -> Result<Self, CliError> {
        std::fs::create_dir_all(out).map_err(|e| CliError::write(out, &e))?;
        Ok(Self(out.to_owned(), w, h, 0))
    }
    pub(crate) fn frame(&mut self, rgb: &[u8]) -> Result<(), CliError> {
        let path = self.0.join(format!("{:04}.ppm", self.3));
        self.3 += 1;
        let mut data = format!("P6 {} {} 255\n", self.1, self.2).into_bytes();
        data.extend_from_slice(rgb);
        std::fs::write(&path, data).map_err(|e| CliError::write(&path, &e))
    }
    pub(crate) fn finish(self) -> Result<(), CliError> {
        Ok(())
    }
}
