//! The recording of what a book is asked and given, while one is wanted.

use crate::error::DogleafError;
use dogleaf_core::grid::Grid;
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

/// A recorder, while one is wanted.
pub(crate) type Journal = Option<Recorder<Bytes>>;

pub(crate) fn start<R: Real, G: Grid>(setup: &Setup) -> Result<Journal, DogleafError> {
    Ok(Some(Recorder::start::<R, G>(Bytes::default(), setup)?))
}

/// The bytes of a `.dlr` file.
pub(crate) fn stop(journal: &mut Journal) -> Result<Vec<u8>, DogleafError> {
    let none = || DogleafError::Recording("nothing is being recorded".to_owned());
    Ok(journal.take().ok_or_else(none)?.finish()?.0)
}
