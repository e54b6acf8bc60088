//! The images of a CBZ: which entries are pages, and their bytes, never more than allowed.

use crate::budget::Budget;
use crate::decode::{Amount, ImageFiles};
use crate::error::{Fault, io_words, one_line};
use crate::guard::guarded;
use crate::limits::{
    MAX_DIRECTORY_BYTES, MAX_ENTRIES, MAX_PICTURE_BYTES, MAX_RATIO, RATIO_FREE_BYTES,
};
use crate::{names, natural};
use std::fs::File;
use std::io::{BufReader, ErrorKind, Read};
use std::sync::{Arc, Mutex, PoisonError};
use zip::read::{ZipArchiveMetadata, ZipFileEntry};
use zip::result::{ZipError, ZipResult};
use zip::{ZipArchive, ZipReadOptions};

/// Bytes of a local header without its name: the least that lies before an entry's data.
const LOCAL_HEADER_BYTES: u64 = 30;

/// An open archive whose directory has been checked.
pub(crate) struct Archive {
    directory: Arc<ZipArchiveMetadata>,
    file: Mutex<BufReader<File>>,
    pages: Vec<Entry>,
}

struct Entry {
    name: String,
    index: usize,
}

impl Archive {
    pub(crate) fn open(file: File) -> Result<Self, Fault> {
        let bounded = Budget::new(BufReader::new(file), MAX_DIRECTORY_BYTES);
        let archive = guarded(|| ZipArchive::new(bounded))
            .map_err(|_| Fault::Broken("its list of entries is damaged".into()))?
            .map_err(directory_fault)?;
        let directory = archive.metadata();
        check_directory(&directory, archive.central_directory_start())?;
        let pages = pages(&directory)?;
        let file = Mutex::new(archive.into_inner().into_inner());
        Ok(Self { directory, file, pages })
    }

    fn inflate(&self, entry: ZipFileEntry<'_>, amount: Amount) -> Result<Vec<u8>, String> {
        let (packed, size) = (entry.compressed_size(), entry.size());
        let cap = inflated_cap(packed);
        let bomb = |size: u64| format!("it inflates from {packed} bytes to {size} or more");
        if size > cap {
            return Err(bomb(size));
        }
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        let reader = entry.with_reader(&mut *file, ZipReadOptions::new()).map_err(|e| told(&e))?;
        // The size was only a claim.
        let limit = amount.limit().unwrap_or(u64::MAX).min(cap + 1);
        let mut bytes = Vec::new();
        reader.take(limit).read_to_end(&mut bytes).map_err(|e| packed_words(&e))?;
        if bytes.len() as u64 > cap { Err(bomb(cap)) } else { Ok(bytes) }
    }
}

impl ImageFiles for Archive {
    fn count(&self) -> usize {
        self.pages.len()
    }

    fn name(&self, i: usize) -> &str {
        self.pages.get(i).map_or("", |page| &page.name)
    }

    fn bytes(&self, i: usize, amount: Amount) -> Result<Vec<u8>, String> {
        let page = self.pages.get(i).ok_or("no such page")?;
        self.inflate(self.directory.entry(page.index).map_err(|e| told(&e))?, amount)
    }
}

/// Bytes an entry may inflate to, from what it is packed in.
fn inflated_cap(packed: u64) -> u64 {
    packed.saturating_mul(MAX_RATIO).clamp(RATIO_FREE_BYTES, MAX_PICTURE_BYTES)
}

/// An error in our own words; the crate's speak to programmers.
fn told(error: &ZipError) -> String {
    match error {
        ZipError::Io(e) => packed_words(e),
        ZipError::CompressionMethodNotSupported(method) => {
            format!("it is packed by method {method}, only stored and deflate are read")
        }
        ZipError::UnsupportedArchive(_) => "this kind of zip archive is not supported".into(),
        _ => "it is not a sound zip archive".into(),
    }
}

fn packed_words(error: &std::io::Error) -> String {
    match error.kind() {
        // A wrong checksum comes as `Other`, a truncated stream as one of the rest.
        ErrorKind::InvalidData
        | ErrorKind::InvalidInput
        | ErrorKind::UnexpectedEof
        | ErrorKind::Other => "its packed bytes are damaged".into(),
        _ => io_words(error),
    }
}

fn directory_fault(error: ZipError) -> Fault {
    match error {
        ZipError::Io(e) if e.kind() == ErrorKind::QuotaExceeded => Fault::TooLarge(format!(
            "its list of entries is over {} MiB",
            MAX_DIRECTORY_BYTES >> 20
        )),
        ZipError::Io(e) if e.kind() != ErrorKind::UnexpectedEof => e.into(),
        other => Fault::Broken(told(&other)),
    }
}

fn check_directory(directory: &ZipArchiveMetadata, end: u64) -> Result<(), Fault> {
    if directory.len() > MAX_ENTRIES {
        let found = directory.len();
        return Err(Fault::TooLarge(format!("{found} entries, at most {MAX_ENTRIES} are read")));
    }
    if directory.has_duplicate_names() {
        return Err(Fault::Broken("two entries have the same name".into()));
    }
    check_overlap(directory, end)
}

/// Two entries that share bytes are how a small archive is made to inflate without end.
fn check_overlap(directory: &ZipArchiveMetadata, end: u64) -> Result<(), Fault> {
    let mut spans = (0..directory.len())
        .map(|i| directory.entry(i).map(|e| span(&e)))
        .collect::<ZipResult<Vec<_>>>()
        .map_err(|e| Fault::Broken(told(&e)))?;
    spans.sort_unstable();
    spans.push((end, end));
    if spans.windows(2).any(|pair| pair[0].1 > pair[1].0) {
        return Err(Fault::Broken("its entries overlap".into()));
    }
    Ok(())
}

fn span(entry: &ZipFileEntry<'_>) -> (u64, u64) {
    let start = entry.header_start();
    (start, start.saturating_add(LOCAL_HEADER_BYTES).saturating_add(entry.compressed_size()))
}

/// The entries that are pages, in the order a reader means.
fn pages(directory: &ZipArchiveMetadata) -> Result<Vec<Entry>, Fault> {
    let mut pages = Vec::new();
    for index in 0..directory.len() {
        let entry = directory.entry(index).map_err(|e| Fault::Broken(told(&e)))?;
        let name = entry_name(&entry);
        if names::is_foreign_mark(&name) {
            return Err(Fault::NotABook("it is an epub, an office document or a program".into()));
        }
        if names::escapes(&name) {
            return Err(Fault::Broken(format!("entry {} leaves the archive", one_line(&name))));
        }
        if entry.is_file() && names::is_page(&name) {
            if entry.encrypted() {
                return Err(Fault::PasswordProtected);
            }
            pages.push(Entry { name, index });
        }
    }
    pages.sort_by(|a, b| natural::compare(&a.name, &b.name));
    Ok(pages)
}

fn entry_name(entry: &ZipFileEntry<'_>) -> String {
    match entry.name() {
        Ok(name) => name.into_owned(),
        Err(_) => String::from_utf8_lossy(entry.name_raw()).into_owned(),
    }
}
