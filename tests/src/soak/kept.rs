//! Cases worth keeping: a failing one becomes a recording, which needs no generator to be played again.

use super::case::{Case, Scribe};
use crate::watch::Watch;
use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Sample, View};
use dogleaf_core::real::Real;
use dogleaf_core::record::{Reader, Record, RecordError, Recorder, Setup, Sink};
use dogleaf_core::scene::{Formulation, Handling};
use std::path::{Path, PathBuf};

/// A recording in memory.
#[derive(Debug, Default)]
struct Bytes(Vec<u8>);

impl Sink for Bytes {
    fn put(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        self.0.extend_from_slice(bytes);
        Ok(())
    }
}

/// Writes down what is done, and the hash after every step.
struct Pen(Recorder<Bytes>);

impl<R: Real> Scribe<R> for Pen {
    // What a full recording refuses it has said at its end: a case of minutes never gets there.
    fn input(&mut self, sample: &Sample) {
        let _ = self.0.input(sample);
    }
    fn look(&mut self, view: &View) {
        let _ = self.0.look(view);
    }
    fn step(&mut self, book: &mut Book<R, G11x8>) {
        let _ = self.0.step(book.state_hash());
    }
}

/// The recording of a case.
///
/// # Errors
///
/// What no book opens with.
pub fn record<R: Real>(case: &Case) -> Result<Vec<u8>, RecordError> {
    let scene = &case.scene;
    let setup = Setup {
        book: scene.book,
        paper: scene.paper,
        world: scene.world,
        view: scene.view,
        fidelity: scene.fidelity,
        formulation: Formulation::Condensed,
        handling: Handling::default(),
    };
    let mut pen = Pen(Recorder::start::<R, G11x8>(Bytes::default(), &setup)?);
    let _ = case.run::<R>(&mut pen);
    Ok(pen.0.finish()?.0)
}

/// Writes the recording of a case into a folder; answers where it lies now.
///
/// # Errors
///
/// One line about what could not be written.
pub fn keep<R: Real>(case: &Case, seed: u64, folder: &Path) -> Result<PathBuf, String> {
    let file = folder.join(format!("soak_{seed}_{}_{}.dlr", case.number, R::NAME));
    let bytes = record::<R>(case).map_err(|e| e.to_string())?;
    std::fs::create_dir_all(folder)
        .and_then(|()| std::fs::write(&file, bytes))
        .map_err(|e| format!("{}: {e}", file.display()))?;
    Ok(file)
}

/// Plays a kept recording without asking whether its hashes still hold; answers what was seen.
///
/// # Errors
///
/// What no recording is.
pub fn play<R: Real>(reader: &Reader<'_>) -> Result<(Box<Book<R, G11x8>>, Watch), RecordError> {
    let mut book = Box::new(Book::<R, G11x8>::EMPTY);
    reader.header().setup.open(&mut book)?;
    let mut seen = Watch::default();
    for record in reader.records() {
        match record? {
            Record::Input(sample) => drop(book.input(sample)),
            Record::Look(view) => book.look(&view)?,
            Record::Step { .. } => {
                let report = book.step();
                seen.see(&mut book, &report);
            }
        }
    }
    Ok((book, seen))
}
