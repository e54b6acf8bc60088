//! Reading a recording: every answer but a sound recording is an error.

use super::crc::Crc;
use super::error::RecordError;
use super::header::{Header, preamble};
use super::piece::{Piece, Totals};
use super::wire::In;
use super::{KIND, MAX_BYTES, VERSION};
use crate::hand::{Sample, View};

/// One thing that happened.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Record {
    /// The book was handed a sample.
    Input(Sample),
    /// The reader looked from elsewhere.
    Look(View),
    /// The book took one world step.
    Step {
        /// The hash of its state after it.
        hash: u64,
    },
}

/// A recording that has been read through once and found sound.
#[derive(Debug, Clone, Copy)]
pub struct Reader<'a> {
    header: Header,
    stream: In<'a>,
    totals: Totals,
}

impl<'a> Reader<'a> {
    /// Reads all of `bytes` once.
    ///
    /// # Errors
    ///
    /// The first thing that is wrong; see [`RecordError`].
    pub fn open(bytes: &'a [u8]) -> Result<Self, RecordError> {
        if bytes.len() > MAX_BYTES {
            return Err(RecordError::TooLarge);
        }
        // What another version holds, and where its checksum stands, is not known here.
        preamble::<KIND, VERSION>(&mut In(bytes))?;
        let mut stream = In(checked(bytes)?);
        let mut header = Header::blank();
        header.fields(&mut stream)?;
        header.setup.check()?;
        Ok(Self { header, stream, totals: scan(stream)? })
    }

    /// What the recording is of.
    pub fn header(&self) -> &Header {
        &self.header
    }
    /// World steps it holds.
    pub fn steps(&self) -> u32 {
        self.totals.steps
    }
    /// Pointer samples it holds.
    pub fn inputs(&self) -> u32 {
        self.totals.inputs
    }
    /// What happened, in order. Ends after the last record or the first error.
    pub fn records(&self) -> Records<'a> {
        Records { stream: Some(self.stream), last: None, again: 0 }
    }
}

/// The bytes before the checksum, if they have it.
fn checked(bytes: &[u8]) -> Result<&[u8], RecordError> {
    let (body, sum) = bytes.split_last_chunk().ok_or(RecordError::Truncated)?;
    let mut crc = Crc::START;
    crc.take(body);
    if crc.value() == u32::from_le_bytes(*sum) { Ok(body) } else { Err(RecordError::Checksum) }
}

/// Reads the stream to its end, and counts.
fn scan(mut stream: In<'_>) -> Result<Totals, RecordError> {
    let mut totals = Totals::default();
    loop {
        // Every piece takes at least its tag from the stream, so this ends.
        let piece = Piece::read(&mut stream)?;
        totals = totals.with(&piece)?;
        match piece {
            Piece::Look(view) => view.check()?,
            Piece::Again(count) if count == 0 || totals.steps == count => {
                return Err(RecordError::Repeat);
            }
            Piece::End(said) if said != totals => return Err(RecordError::Counts),
            Piece::End(_) if !stream.0.is_empty() => return Err(RecordError::Trailing),
            Piece::End(_) => return Ok(totals),
            _ => {}
        }
    }
}

/// What happened, in order: see [`Reader::records`].
#[derive(Debug, Clone)]
pub struct Records<'a> {
    /// Nothing once it has ended.
    stream: Option<In<'a>>,
    last: Option<u64>,
    again: u32,
}

impl Records<'_> {
    fn read(&mut self) -> Result<Option<Record>, RecordError> {
        let Some(stream) = &mut self.stream else { return Ok(None) };
        Ok(match Piece::read(stream)? {
            Piece::Input(sample) => Some(Record::Input(sample)),
            Piece::Look(view) => Some(Record::Look(view)),
            Piece::Step(hash) => {
                self.last = Some(hash);
                Some(Record::Step { hash })
            }
            Piece::Again(count) => {
                self.again = count;
                Some(self.repeat().ok_or(RecordError::Repeat)?)
            }
            Piece::End(_) => None,
        })
    }
    /// The last step once more, while there are repetitions.
    fn repeat(&mut self) -> Option<Record> {
        self.again = self.again.checked_sub(1)?;
        self.last.map(|hash| Record::Step { hash })
    }
}

impl Iterator for Records<'_> {
    type Item = Result<Record, RecordError>;

    fn next(&mut self) -> Option<Self::Item> {
        if let Some(step) = self.repeat() {
            return Some(Ok(step));
        }
        let next = self.read().transpose();
        if !matches!(next, Some(Ok(_))) {
            self.stream = None;
        }
        next
    }
}

impl core::iter::FusedIterator for Records<'_> {}
