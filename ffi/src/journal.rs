//! The recording of what a book is asked and given, while one is wanted.

use crate::error::DogleafError;
use dogleaf_core::grid::Grid;
use dogleaf_core::hand::{Sample, View};
use dogleaf_core::reading::Tape;
use dogleaf_core::real::Real;
use dogleaf_core::record::{RecordError, Recorder, Setup, Sink};

/// Bytes in memory.
#[derive(Debug, Default)]
pub(crate) struct Bytes(pub(crate) Vec<u8>);

impl Sink for Bytes {
    fn put(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        self.0.extend_from_slice(bytes);
        Ok(())
    }
}

/// A recorder that may be there. A full one takes no more and can still be finished, so its refusals are not told.
#[derive(Debug, Default)]
pub(crate) struct Journal(Option<Recorder<Bytes>>);

impl Journal {
    /// Starts anew; what was recorded before is dropped.
    pub(crate) fn start<R: Real, G: Grid>(&mut self, setup: &Setup) -> Result<(), DogleafError> {
        self.0 = Some(Recorder::start::<R, G>(Bytes::default(), setup)?);
        Ok(())
    }

    pub(crate) fn stop(&mut self) -> Result<Vec<u8>, DogleafError> {
        let none = || DogleafError::Recording("nothing is being recorded".to_owned());
        Ok(self.0.take().ok_or_else(none)?.finish()?.0)
    }
}

impl Tape for Journal {
    fn input(&mut self, sample: &Sample) {
        if let Some(recorder) = &mut self.0 {
            let _ = recorder.input(sample);
        }
    }
    fn look(&mut self, view: &View) {
        if let Some(recorder) = &mut self.0 {
            let _ = recorder.look(view);
        }
    }
    fn step(&mut self, hash: impl FnOnce() -> u64) {
        if let Some(recorder) = &mut self.0 {
            let _ = recorder.step(hash());
        }
    }
}
