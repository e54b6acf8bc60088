//! Reading a ribbon's recording, and playing it again: every answer but a sound recording is an error.

use super::head::{ASKED, Asked, BASE, END, Head, STEP, frame, state, state_numbers};
use super::{KIND, VERSION};
use crate::effect::ribbon::frame::Frame;
use crate::effect::ribbon::spec::RibbonSpec;
use crate::effect::ribbon::{Report, Ribbon};
use crate::real::{Real, V3};
use crate::record::crc::Crc;
use crate::record::header::preamble;
use crate::record::wire::{Done, In, Wire};
use crate::record::{Divergence, MAX_BYTES, MAX_RECORDS, RecordError, Tier, Verdict};

/// The most segments of any ribbon that is read: as many as contact can count.
const MOST_SEGMENTS: usize = 60_000;

/// A recording that has been read through once and found sound.
#[derive(Debug, Clone, Copy)]
pub struct Reader<'a> {
    head: Head,
    /// From the state on.
    rest: In<'a>,
    steps: u32,
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
        let (body, sum) = bytes.split_last_chunk().ok_or(RecordError::Truncated)?;
        let mut crc = Crc::START;
        crc.take(body);
        if crc.value() != u32::from_le_bytes(*sum) {
            return Err(RecordError::Checksum);
        }
        let (mut rest, mut head) = (In(body), Head::blank());
        preamble::<KIND, VERSION>(&mut rest)?;
        head.fields(&mut rest)?;
        head.spec.check(MOST_SEGMENTS)?;
        let mut stream = rest;
        for _ in 0..state_numbers(head.spec.segments) {
            stream.u64(&mut 0)?;
        }
        let mut tape = Tape::of(stream);
        while tape.next()?.is_some() {}
        Ok(Self { head, rest, steps: tape.steps })
    }
    /// What the ribbon was opened with.
    pub fn spec(&self) -> &RibbonSpec {
        &self.head.spec
    }
    /// Numbers it was made with.
    pub fn tier(&self) -> Tier {
        self.head.tier
    }
    /// Steps it holds.
    pub fn steps(&self) -> u32 {
        self.steps
    }
}

/// Steps, and what was asked before each.
#[derive(Debug)]
struct Tape<'a> {
    stream: In<'a>,
    steps: u32,
    asked: Asked,
    /// It was asked anew since the last step.
    anew: bool,
    base: Option<Frame<f64>>,
}

impl<'a> Tape<'a> {
    fn of(stream: In<'a>) -> Self {
        Self { stream, steps: 0, asked: Asked::nothing(), anew: false, base: None }
    }

    /// The next step's `h` and hash. Every turn takes at least a tag from the stream, so this ends.
    fn next(&mut self) -> Result<Option<(f64, u64)>, RecordError> {
        (self.anew, self.base) = (false, None);
        loop {
            let mut tag = 0;
            self.stream.u8(&mut tag)?;
            match tag {
                ASKED => self.asked(),
                BASE => self.base(),
                STEP => return self.step().map(Some),
                END => return self.end().map(|()| None),
                _ => Err(RecordError::Unknown("record")),
            }?;
        }
    }
    fn asked(&mut self) -> Done {
        self.anew = true;
        self.asked.fields(&mut self.stream)
    }
    fn base(&mut self) -> Done {
        let mut base = Frame::at(V3([0.0; 3]));
        frame(&mut base, &mut self.stream)?;
        self.base = Some(base);
        Ok(())
    }
    fn step(&mut self) -> Result<(f64, u64), RecordError> {
        let (mut h, mut hash) = (0.0, 0);
        self.stream.f64(&mut h)?;
        self.stream.u64(&mut hash)?;
        self.steps += 1;
        if self.steps > MAX_RECORDS { Err(RecordError::TooMany) } else { Ok((h, hash)) }
    }
    fn end(&mut self) -> Done {
        let mut said = 0;
        self.stream.u32(&mut said)?;
        if said != self.steps {
            return Err(RecordError::Counts);
        }
        if self.stream.0.is_empty() { Ok(()) } else { Err(RecordError::Trailing) }
    }
}

/// Opens `ribbon` as the recorded one was and takes it through all steps, also beyond a divergence. `step` is what was
/// handed to the recorder: [`Ribbon::step`], or one with the same contact.
///
/// # Errors
///
/// A recording of other numbers, or of more segments than `ribbon` has room for; the ribbon is then unchanged.
pub fn replay<R: Real, const N: usize>(
    reader: &Reader<'_>,
    ribbon: &mut Ribbon<R, N>,
    mut step: impl FnMut(&mut Ribbon<R, N>, f64) -> Report<R>,
) -> Result<Verdict, RecordError> {
    let mut player = Player::start(reader, ribbon)?;
    while player.step(ribbon, &mut step)? {}
    Ok(player.verdict)
}

/// A recording that is played again a step at a time, beside others whose ribbons touch it.
#[derive(Debug)]
pub struct Player<'a> {
    tape: Tape<'a>,
    verdict: Verdict,
}

impl<'a> Player<'a> {
    /// Opens `ribbon` as the recorded one was.
    ///
    /// # Errors
    ///
    /// As [`replay`].
    pub fn start<R: Real, const N: usize>(
        reader: &Reader<'a>,
        ribbon: &mut Ribbon<R, N>,
    ) -> Result<Self, RecordError> {
        let (recorded, here) = (reader.head.tier, Tier::of::<R>());
        if recorded != here {
            return Err(RecordError::Tier { recorded, here });
        }
        ribbon.open(&reader.head.spec, reader.head.origin)?;
        let mut stream = reader.rest;
        state(ribbon, &mut stream)?;
        ribbon.body().stand();
        let verdict = Verdict {
            steps: 0,
            diverged: None,
            final_hash: ribbon.state_hash(),
            refused: 0,
            same_build: reader.head.same_build(),
        };
        Ok(Self { tape: Tape::of(stream), verdict })
    }

    /// Takes it through the next step; false where there is none.
    ///
    /// # Errors
    ///
    /// None for a recording that [`Reader::open`] has found sound.
    pub fn step<R: Real, const N: usize>(
        &mut self,
        ribbon: &mut Ribbon<R, N>,
        step: impl FnOnce(&mut Ribbon<R, N>, f64) -> Report<R>,
    ) -> Result<bool, RecordError> {
        let (tape, verdict) = (&mut self.tape, &mut self.verdict);
        let Some((h, expected)) = tape.next()? else { return Ok(false) };
        if tape.anew {
            tape.asked.give(ribbon);
        }
        if let Some(base) = &tape.base {
            let Frame { t, b, n, p } = base;
            let [t, b, n, p] = [t, b, n, p].map(|v| V3(v.0.map(R::of)));
            ribbon.carry(&Frame { t, b, n, p });
        }
        let _ = step(ribbon, h);
        let found = ribbon.state_hash();
        if verdict.diverged.is_none() && found != expected {
            verdict.diverged = Some(Divergence { step: verdict.steps, expected, found });
        }
        (verdict.steps, verdict.final_hash) = (verdict.steps.saturating_add(1), found);
        Ok(true)
    }

    /// What was found so far.
    pub fn verdict(&self) -> &Verdict {
        &self.verdict
    }
}
