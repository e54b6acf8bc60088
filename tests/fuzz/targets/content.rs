//! Archives and images: the readers of strangers' files, taken in by their files, without the PDF reader.
//!
//! The first byte chooses: an archive, an image, or an image in a sound archive.
#![no_main]
#![allow(dead_code, unreachable_pub, reason = "the shell's files, of which only a share is used")]

#[path = "../../../shells/content/src/archive.rs"]
mod archive;
#[path = "../../../shells/content/src/budget.rs"]
mod budget;
#[path = "../../../shells/content/src/decode.rs"]
mod decode;
#[path = "../../../shells/content/src/error.rs"]
mod error;
#[path = "../../../shells/content/src/fit.rs"]
mod fit;
#[path = "../../../shells/content/src/guard.rs"]
mod guard;
#[path = "../../../shells/content/src/kind.rs"]
mod kind;
#[path = "../../../shells/content/src/limits.rs"]
pub mod limits;
#[path = "../../../shells/content/src/names.rs"]
mod names;
#[path = "../../../shells/content/src/natural.rs"]
mod natural;
#[path = "../../../shells/content/src/picture.rs"]
mod picture;
#[path = "../../../shells/content/src/scale.rs"]
mod scale;

use decode::{Amount, ImageFiles};
use libfuzzer_sys::fuzz_target;
use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::sync::{Mutex, OnceLock, PoisonError};

/// Pages looked at, and how large they are drawn.
const PAGES: usize = 3;
const BOX: (u32, u32) = (48, 64);

/// One image in memory.
struct One(Vec<u8>);

impl ImageFiles for One {
    fn count(&self) -> usize {
        1
    }
    fn name(&self, _: usize) -> &str {
        "page"
    }
    fn bytes(&self, _: usize, amount: Amount) -> Result<Vec<u8>, String> {
        let most = amount.limit().and_then(|n| usize::try_from(n).ok()).unwrap_or(usize::MAX);
        Ok(self.0[..self.0.len().min(most)].to_vec())
    }
}

fuzz_target!(|data: &[u8]| {
    let Some((&kind, rest)) = data.split_first() else { return };
    match kind % 3 {
        0 => archive(rest),
        1 => draw(&One(rest.to_vec())),
        _ => archive(&wrapped(rest)),
    }
});

/// What is drawn is what was asked for, whatever the file says of itself.
fn draw(files: &dyn ImageFiles) {
    for i in 0..files.count().min(PAGES) {
        if let Ok((width, height)) = decode::page_size(files, i) {
            assert!(width >= 1.0 && height >= 1.0, "a page of {width} by {height}");
        }
        if let Ok(picture) = decode::page(files, i, BOX) {
            let (width, height) = (picture.width, picture.height);
            assert!(width <= BOX.0 && height <= BOX.1, "{width} by {height} in {BOX:?}");
        }
    }
    assert!(decode::page_size(files, files.count()).is_err() || files.count() == 1, "no such page");
}

fn archive(bytes: &[u8]) {
    static FILE: OnceLock<Mutex<File>> = OnceLock::new();
    let file = FILE.get_or_init(|| Mutex::new(scratch()));
    let mut file = file.lock().unwrap_or_else(PoisonError::into_inner);
    file.set_len(0).and_then(|()| file.seek(SeekFrom::Start(0))).expect("a scratch file");
    file.write_all(bytes).and_then(|()| file.rewind()).expect("a scratch file");
    let handle = file.try_clone().expect("a scratch file");
    if let Ok(archive) = archive::Archive::open(handle) {
        draw(&archive);
    }
}

/// A file without a name.
fn scratch() -> File {
    let path = std::env::temp_dir().join(format!("dogleaf-fuzz-{}", std::process::id()));
    let open = File::options().read(true).write(true).create(true).truncate(true).open(&path);
    let file = open.expect("a scratch file");
    let _ = std::fs::remove_file(&path);
    file
}

/// An archive of one stored image.
fn wrapped(image: &[u8]) -> Vec<u8> {
    let mut writer = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let stored =
        zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    let done = writer.start_file("page.png", stored).map_err(|e| e.to_string());
    done.and_then(|()| writer.write_all(image).map_err(|e| e.to_string())).expect("in memory");
    writer.finish().expect("in memory").into_inner()
}
