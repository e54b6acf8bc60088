//! Making a recording.

use super::MAX_BYTES;
use super::crc::Crc;
use super::error::RecordError;
use super::header::{Header, Setup};
use super::piece::{Piece, Totals};
use super::wire::{Out, Wire};
use crate::grid::Grid;
use crate::hand::{Sample, View};
use crate::real::Real;

/// Bytes of the checksum.
const CRC: usize = 4;

/// Where a recording goes: a buffer here, a file in a shell. Pieces are short; a file wants a buffer.
pub trait Sink {
    /// Takes all of the bytes.
    ///
    /// # Errors
    ///
    /// [`RecordError::Sink`] where it cannot; the recording is then lost.
    fn put(&mut self, bytes: &[u8]) -> Result<(), RecordError>;

    /// How many bytes it has room for. A recorder stops early enough to finish inside.
    fn room(&self) -> usize {
        MAX_BYTES
    }
}

impl<S: Sink + ?Sized> Sink for &mut S {
    fn put(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        (**self).put(bytes)
    }
    fn room(&self) -> usize {
        (**self).room()
    }
}

/// Writes into a caller's buffer.
#[derive(Debug)]
pub struct SliceSink<'a> {
    buffer: &'a mut [u8],
    used: usize,
}

impl<'a> SliceSink<'a> {
    /// From the start of a buffer.
    pub fn new(buffer: &'a mut [u8]) -> Self {
        Self { buffer, used: 0 }
    }
    /// What was written.
    pub fn written(&self) -> &[u8] {
        self.buffer.get(..self.used).unwrap_or(&[])
    }
}

impl Sink for SliceSink<'_> {
    fn put(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        let end = self.used.saturating_add(bytes.len());
        let place = self.buffer.get_mut(self.used..end).ok_or(RecordError::Sink)?;
        // By hand: `copy_from_slice` keeps a panic in the image, although the lengths are equal.
        place.iter_mut().zip(bytes).for_each(|(slot, &byte)| *slot = byte);
        self.used = end;
        Ok(())
    }
    fn room(&self) -> usize {
        self.buffer.len().saturating_sub(self.used)
    }
}

/// Makes a recording beside a book: what the book is handed is handed here too, in the same order.
///
/// # Errors
///
/// After [`RecordError::Full`] it takes nothing more, so that it never has holes, and can still be
/// finished. After [`RecordError::Sink`] it is lost.
#[derive(Debug)]
pub struct Recorder<S> {
    out: Out<S>,
    limit: usize,
    totals: Totals,
    last: Option<u64>,
    /// Steps since the last piece whose hash was the last one again.
    again: u32,
    ended: Option<RecordError>,
}

impl<S: Sink> Recorder<S> {
    /// Starts the recording of a book with scalars `R` on grid `G`, opened with `setup`.
    ///
    /// # Errors
    ///
    /// A setup no book opens with; a sink too small even for an empty recording.
    pub fn start<R: Real, G: Grid>(sink: S, setup: &Setup) -> Result<Self, RecordError> {
        setup.check()?;
        let limit = sink.room().min(MAX_BYTES);
        let out = Out { sink, crc: Crc::START, written: 0 };
        let mut this =
            Self { out, limit, totals: Totals::default(), last: None, again: 0, ended: None };
        let mut header = Header::of::<R, G>(setup);
        let mut ruler = super::wire::Ruler::default();
        header.fields(&mut ruler)?;
        this.make_room(ruler.0)?;
        header.fields(&mut this.out)?;
        Ok(this)
    }

    /// The book was handed a sample; hand it over whether or not the book took it.
    ///
    /// # Errors
    ///
    /// Full, or the sink failed.
    pub fn input(&mut self, sample: &Sample) -> Result<(), RecordError> {
        self.add(Piece::Input(*sample))
    }

    /// The book looks from elsewhere from now on.
    ///
    /// # Errors
    ///
    /// A view the book refused too; full, or the sink failed.
    pub fn look(&mut self, view: &View) -> Result<(), RecordError> {
        view.check()?;
        self.add(Piece::Look(*view))
    }

    /// The book took one world step and has this hash now.
    ///
    /// # Errors
    ///
    /// Full, or the sink failed.
    pub fn step(&mut self, hash: u64) -> Result<(), RecordError> {
        if self.last != Some(hash) {
            self.add(Piece::Step(hash))?;
            self.last = Some(hash);
            return Ok(());
        }
        self.open()?;
        self.totals = self.totals.with(&Piece::Step(hash)).map_err(|_| self.close())?;
        self.again += 1;
        Ok(())
    }

    /// Ends the recording and gives the sink back.
    ///
    /// # Errors
    ///
    /// The sink failed, now or before.
    pub fn finish(mut self) -> Result<S, RecordError> {
        if self.ended == Some(RecordError::Sink) {
            return Err(RecordError::Sink);
        }
        self.flush()?;
        Piece::End(self.totals).write(&mut self.out)?;
        let mut crc = self.out.crc.value();
        self.out.u32(&mut crc)?;
        Ok(self.out.sink)
    }

    /// Steps recorded so far.
    pub fn steps(&self) -> u32 {
        self.totals.steps
    }

    fn add(&mut self, piece: Piece) -> Result<(), RecordError> {
        self.open()?;
        let totals = self.totals.with(&piece).map_err(|_| self.close())?;
        let waiting = if self.again > 0 { Piece::Again(0).length() } else { 0 };
        self.make_room(waiting + piece.length())?;
        self.flush()?;
        piece.write(&mut self.out).inspect_err(|_| self.ended = Some(RecordError::Sink))?;
        self.totals = totals;
        Ok(())
    }

    /// Writes the repetitions that wait.
    fn flush(&mut self) -> Result<(), RecordError> {
        if self.again > 0 {
            let done = Piece::Again(self.again).write(&mut self.out);
            done.inspect_err(|_| self.ended = Some(RecordError::Sink))?;
            self.again = 0;
        }
        Ok(())
    }

    /// Makes sure that so many bytes fit, and an end after them.
    fn make_room(&mut self, bytes: usize) -> Result<(), RecordError> {
        let end = Piece::Again(0).length() + Piece::End(self.totals).length() + CRC;
        let fits = self.out.written.saturating_add(bytes + end) <= self.limit;
        if fits { Ok(()) } else { Err(self.close()) }
    }

    fn open(&self) -> Result<(), RecordError> {
        self.ended.map_or(Ok(()), Err)
    }
    fn close(&mut self) -> RecordError {
        self.ended = Some(RecordError::Full);
        RecordError::Full
    }
}
