//! Making a recording of a ribbon.

use super::head::{ASKED, Asked, BASE, END, Head, STEP, frame, state};
use super::{KIND, VERSION};
use crate::effect::ribbon::frame::Frame;
use crate::effect::ribbon::{Report, Ribbon};
use crate::real::Real;
use crate::record::crc::Crc;
use crate::record::header::preamble;
use crate::record::wire::{Done, Out, Ruler, Wire};
use crate::record::{MAX_BYTES, MAX_RECORDS, RecordError, Sink};

/// Bytes of the end and the checksum.
const TAIL: usize = 1 + 4 + 4;

/// Makes a recording beside a ribbon: every step of it is taken through [`Recorder::step`].
///
/// # Errors
///
/// After [`RecordError::Full`] it takes nothing more and can still be finished; after [`RecordError::Sink`] it is lost.
#[derive(Debug)]
pub struct Recorder<S, R> {
    out: Out<S>,
    limit: usize,
    steps: u32,
    asked: Option<Asked>,
    base: Frame<R>,
    ended: Option<RecordError>,
}

impl<S: Sink, R: Real> Recorder<S, R> {
    /// Starts with a ribbon as it is now.
    ///
    /// # Errors
    ///
    /// A sink too small even for an empty recording, or one that failed.
    pub fn start<const N: usize>(sink: S, ribbon: &mut Ribbon<R, N>) -> Result<Self, RecordError> {
        let limit = sink.room().min(MAX_BYTES);
        let mut head = Head::of(ribbon);
        let mut ruler = Ruler::default();
        whole(&mut head, ribbon, &mut ruler)?;
        if ruler.0.saturating_add(TAIL) > limit {
            return Err(RecordError::Full);
        }
        let mut out = Out { sink, crc: Crc::START, written: 0 };
        whole(&mut head, ribbon, &mut out)?;
        let base = ribbon.posed().kept_base;
        Ok(Self { out, limit, steps: 0, asked: None, base, ended: None })
    }

    /// Takes a step of `h` seconds and records it, with what the ribbon is asked and where its start was carried since the
    /// last one. `step` is the caller's: [`Ribbon::step`], or one with contact.
    ///
    /// # Errors
    ///
    /// Full, or the sink failed. The step is taken all the same: its report stands beside.
    pub fn step<const N: usize>(
        &mut self,
        ribbon: &mut Ribbon<R, N>,
        h: f64,
        step: impl FnOnce(&mut Ribbon<R, N>, f64) -> Report<R>,
    ) -> (Report<R>, Result<(), RecordError>) {
        let asked = Some(Asked::of(ribbon)).filter(|asked| self.asked.as_ref() != Some(asked));
        let base = Some(ribbon.posed().kept_base).filter(|base| self.base != *base);
        let report = step(ribbon, h);
        self.base = ribbon.posed().kept_base;
        let done = self.put(News { asked, base, h, hash: ribbon.state_hash() });
        (report, done)
    }

    fn put(&mut self, mut news: News<R>) -> Result<(), RecordError> {
        self.ended.map_or(Ok(()), Err)?;
        let mut ruler = Ruler::default();
        news.fields(&mut ruler)?;
        let length = self.out.written.saturating_add(ruler.0).saturating_add(TAIL);
        if length > self.limit || self.steps >= MAX_RECORDS {
            self.ended = Some(RecordError::Full);
            return Err(RecordError::Full);
        }
        news.fields(&mut self.out).inspect_err(|_| self.ended = Some(RecordError::Sink))?;
        self.steps += 1;
        if news.asked.is_some() {
            self.asked = news.asked;
        }
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
        self.out.u8(&mut { END })?;
        self.out.u32(&mut self.steps)?;
        let mut crc = self.out.crc.value();
        self.out.u32(&mut crc)?;
        Ok(self.out.sink)
    }
}

/// What a step adds to a recording.
struct News<R> {
    asked: Option<Asked>,
    base: Option<Frame<R>>,
    h: f64,
    hash: u64,
}

impl<R: Real> News<R> {
    fn fields(&mut self, wire: &mut impl Wire) -> Done {
        if let Some(asked) = &mut self.asked {
            wire.u8(&mut { ASKED })?;
            asked.fields(wire)?;
        }
        if let Some(base) = &mut self.base {
            wire.u8(&mut { BASE })?;
            frame(base, wire)?;
        }
        wire.u8(&mut { STEP })?;
        wire.f64(&mut self.h)?;
        wire.u64(&mut self.hash)
    }
}

/// All that stands before the first step.
fn whole<R: Real, const N: usize>(
    head: &mut Head,
    ribbon: &mut Ribbon<R, N>,
    wire: &mut impl Wire,
) -> Done {
    preamble::<KIND, VERSION>(wire)?;
    head.fields(wire)?;
    state(ribbon, wire)
}
