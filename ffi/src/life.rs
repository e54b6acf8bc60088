//! A book through an app's life: into the background and back, through the death of the process, into a bug report.

use crate::book::{Book, Result};
use crate::desk::Desk;
use crate::journal;

#[uniffi::export]
impl Book {
    /// The app goes into the background: fingers are taken away, the leaf comes to rest.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn pause(&self) -> Result<()> {
        self.change(|desk| {
            desk.reading.pause(&mut desk.journal);
            Ok(())
        })
    }

    /// The app is back. Time that passed meanwhile does not count.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn resume(&self) -> Result<()> {
        self.change(|desk| {
            desk.reading.resume();
            Ok(())
        })
    }

    /// What `restore` needs, some 300 bytes. A leaf in the air counts as put back: `pause` lets it come to rest first.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn snapshot(&self) -> Result<Vec<u8>> {
        self.with(|desk| desk.snapshot())
    }

    /// Opens the book of a snapshot in place of this one; a recording under way is dropped.
    ///
    /// # Errors
    ///
    /// `Recording`: these bytes are no snapshot of this version, and nothing was changed; `Closed`.
    #[expect(clippy::needless_pass_by_value, reason = "what crosses the boundary is owned")]
    pub fn restore(&self, bytes: Vec<u8>) -> Result<()> {
        self.change(|desk| desk.become_snapshot(&bytes))
    }

    /// Page the book is open at.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn page(&self) -> Result<u32> {
        self.with(|desk| Ok(desk.reading.page()))
    }

    /// Pages of the book.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn pages(&self) -> Result<u32> {
        self.with(|desk| Ok(desk.reading.pages()))
    }

    /// Share of the book that is read, 0 to 1: what the two fore-edges show.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn progress(&self) -> Result<f64> {
        self.with(|desk| Ok(desk.reading.progress()))
    }

    /// Hash of the state: equal on every platform after the same calls.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn state_hash(&self) -> Result<u64> {
        self.with(|desk| Ok(desk.reading.book().state_hash()))
    }

    /// Whether everything is at rest.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn is_sleeping(&self) -> Result<bool> {
        self.with(|desk| Ok(!desk.reading.book().needs_frame()))
    }

    /// Records from now on what the book is given, and a hash a step. It is opened anew at its page for that.
    ///
    /// # Errors
    ///
    /// `Busy` unless everything is at rest; `Paused`; `Closed`.
    pub fn start_recording(&self) -> Result<()> {
        self.change(Desk::start_recording)
    }

    /// Ends the recording: the bytes of a `.dlr` file, which `dogleaf replay` runs again.
    ///
    /// # Errors
    ///
    /// `Recording`: none was started, or a panic or a restore dropped it; `Closed`.
    pub fn stop_recording(&self) -> Result<Vec<u8>> {
        self.with(|desk| journal::stop(&mut desk.journal))
    }
}
