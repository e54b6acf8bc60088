//! A recording beside the book: everything it is handed and every hash it has, into a `.dlr` file.

use crate::error::DesktopError;
use dogleaf_core::grid::Grid;
use dogleaf_core::hand::{Sample, View};
use dogleaf_core::reading::Tape;
use dogleaf_core::real::Real;
use dogleaf_core::record::{self, RecordError, Setup, Sink};
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

/// Where a recording goes.
struct FileSink(BufWriter<File>);

impl Sink for FileSink {
    fn put(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        self.0.write_all(bytes).map_err(|_| RecordError::Sink)
    }
}

/// Writes down what a book is handed, or nothing.
#[derive(Default)]
pub struct Recorder {
    running: Option<record::Recorder<FileSink>>,
    /// Why it stopped.
    fault: Option<RecordError>,
}

impl Recorder {
    /// Starts a recording of a book opened with `setup`.
    ///
    /// # Errors
    ///
    /// A file nobody can write to.
    pub fn start<R: Real, G: Grid>(path: &Path, setup: &Setup) -> Result<Self, DesktopError> {
        let unwritten = |e: std::io::Error| DesktopError::file(path, "cannot be written", &e);
        let sink = FileSink(BufWriter::new(File::create(path).map_err(unwritten)?));
        let running = Some(record::Recorder::start::<R, G>(sink, setup)?);
        Ok(Self { running, fault: None })
    }

    /// Ends the recording; one that grew too long ends where it did.
    ///
    /// # Errors
    ///
    /// The disc is full.
    pub fn finish(&mut self) -> Result<(), DesktopError> {
        let Some(running) = self.running.take() else { return Ok(()) };
        let mut sink = running.finish()?;
        sink.0.flush().map_err(|_| RecordError::Sink)?;
        match self.fault.take() {
            Some(fault @ RecordError::Sink) => Err(fault.into()),
            _ => Ok(()),
        }
    }

    fn take(
        &mut self,
        what: impl FnOnce(&mut record::Recorder<FileSink>) -> Result<(), RecordError>,
    ) {
        if let Some(Err(fault)) = self.running.as_mut().map(what) {
            self.fault.get_or_insert(fault);
        }
    }
}

impl Tape for Recorder {
    fn input(&mut self, sample: &Sample) {
        self.take(|r| r.input(sample));
    }
    fn look(&mut self, view: &View) {
        self.take(|r| r.look(view));
    }
    fn step(&mut self, hash: impl FnOnce() -> u64) {
        self.take(|r| r.step(hash()));
    }
}

impl std::fmt::Debug for Recorder {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let steps = self.running.as_ref().map(record::Recorder::steps);
        f.debug_struct("Recorder").field("steps", &steps).field("fault", &self.fault).finish()
    }
}
