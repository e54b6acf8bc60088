//! The recorded slow turn, one step at a call, for a runner that has a clock.

use crate::work::{Pick, Work};
use dogleaf_core::record::{Reader, Record, Records};

/// The golden slow turn.
static RECORDING: &[u8] = include_bytes!("../../../fixtures/recordings/slow_turn_f32.dlr");

/// What the next step will be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Timed {
    /// No leaf is in the air.
    Idle,
    /// A leaf is.
    Leaf,
    /// The recording has ended.
    End,
}

/// A recording under way.
#[derive(Debug)]
pub struct Timing {
    records: Option<Records<'static>>,
    /// Steps whose hash was not the recorded one.
    pub different: u32,
    expected: u64,
}

impl Timing {
    /// Before a recording.
    pub const NONE: Self = Self { records: None, different: 0, expected: 0 };

    /// From the start of the recording.
    pub fn begin(work: &mut Work) -> Self {
        let reader = Reader::open(RECORDING).ok();
        let book = &mut f32::of_work(work).book;
        let opened = reader.filter(|r| r.header().setup.open(book).is_ok());
        Self { records: opened.map(|r| r.records()), different: 0, expected: 0 }
    }

    /// Hands over the input before the next step. Compares the hash after the last one, apart from its time.
    pub fn prepare(&mut self, work: &mut Work) -> Timed {
        let book = &mut f32::of_work(work).book;
        if self.expected != 0 && self.expected != book.state_hash() {
            self.different += 1;
        }
        loop {
            match self.records.as_mut().and_then(Iterator::next) {
                Some(Ok(Record::Input(sample))) => {
                    let _ = book.input(sample);
                }
                Some(Ok(Record::Look(view))) => {
                    let _ = book.look(&view);
                }
                Some(Ok(Record::Step { hash })) => {
                    self.expected = hash;
                    return if book.leaf().is_some() { Timed::Leaf } else { Timed::Idle };
                }
                _ => return Timed::End,
            }
        }
    }

    /// The step itself: what is to be timed.
    pub fn step(work: &mut Work) {
        let _ = f32::of_work(work).book.step();
    }
}
