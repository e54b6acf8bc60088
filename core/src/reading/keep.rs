//! Surviving the death of the process: a snapshot is a recording in which nothing has happened yet.
//!
//! It holds what the book was opened with and the page it is open at. A leaf in the air counts as put back:
//! [`Reading::pause`] lets it come to rest first, wherever it falls.

use super::Reading;
use crate::grid::Grid;
use crate::real::Real;
use crate::record::{Reader, RecordError, Recorder, Sink};

/// Bytes a snapshot has at most.
pub const SNAPSHOT_BYTES: usize = 320;

impl<R: Real, G: Grid> Reading<R, G> {
    /// Writes what [`Reading::restore`] needs, [`SNAPSHOT_BYTES`] at most.
    ///
    /// # Errors
    ///
    /// [`RecordError::Sink`]: no room.
    pub fn snapshot<S: Sink>(&self, sink: S) -> Result<S, RecordError> {
        Recorder::start::<R, G>(sink, &self.setup())?.finish()
    }

    /// Opens the book of a snapshot, at rest at its page.
    ///
    /// # Errors
    ///
    /// What is no snapshot, or one of another grid or scalar; then nothing was changed.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        let snapshot = Reader::open(bytes)?;
        snapshot.header().fits::<R, G>()?;
        self.open(&snapshot.header().setup)
    }
}
