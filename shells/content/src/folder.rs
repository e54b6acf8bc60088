//! The images of a folder: which files are pages, and their bytes, never more than allowed.

use crate::decode::{Amount, ImageFiles};
use crate::error::{Fault, io_words};
use crate::limits::{MAX_ENTRIES, MAX_PICTURE_BYTES};
use crate::{names, natural};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// A folder that has been listed; folders inside it are not looked into.
pub(crate) struct Folder {
    pages: Vec<(String, PathBuf)>,
}

impl Folder {
    pub(crate) fn open(path: &Path) -> Result<Self, Fault> {
        let mut pages = Vec::new();
        for (seen, entry) in std::fs::read_dir(path)?.enumerate() {
            if seen == MAX_ENTRIES {
                let reason = format!("more than {MAX_ENTRIES} files");
                return Err(Fault::TooLarge(reason));
            }
            let path = entry?.path();
            let name = file_name(&path);
            // A pipe or a device with an image's name would block whoever opens it.
            if names::is_page(&name) && path.is_file() {
                pages.push((name, path));
            }
        }
        pages.sort_by(|a, b| natural::compare(&a.0, &b.0));
        Ok(Self { pages })
    }
}

impl ImageFiles for Folder {
    fn count(&self) -> usize {
        self.pages.len()
    }

    fn name(&self, i: usize) -> &str {
        self.pages.get(i).map_or("", |page| &page.0)
    }

    fn bytes(&self, i: usize, amount: Amount) -> Result<Vec<u8>, String> {
        let (_, path) = self.pages.get(i).ok_or("no such page")?;
        read(path, amount.limit().unwrap_or(MAX_PICTURE_BYTES + 1))
    }
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn read(path: &Path, limit: u64) -> Result<Vec<u8>, String> {
    let told = |e: std::io::Error| io_words(&e);
    let mut bytes = Vec::new();
    File::open(path).map_err(told)?.take(limit).read_to_end(&mut bytes).map_err(told)?;
    if bytes.len() as u64 > MAX_PICTURE_BYTES {
        return Err(format!("its file is over {} MiB", MAX_PICTURE_BYTES >> 20));
    }
    Ok(bytes)
}
