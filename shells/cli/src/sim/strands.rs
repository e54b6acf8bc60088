//! The recording of a scene with ribbons: one file that holds the core's recordings, the book's and every ribbon's, and
//! what the ribbons could touch.
//!
//! ```text
//! "DLS1"  version u16  step_us u32
//! body    length u32, so many bytes: the book's recording, or none
//! count u16, each ribbon: contact u8  floor u8  height f64  length u32, so many bytes: its recording
//! crc u32 CRC-32 of all before it; nothing may follow
//! ```
//!
//! A floor's height is in the ribbon's own coordinates. Ribbons are replayed side by side, each against the others where
//! they are by then, as they were run.

use super::band::{Floor, Room, bent, room};
use crate::scene::MOST_SEGMENTS;
use dogleaf_core::effect::ribbon::Ribbon;
use dogleaf_core::effect::ribbon::record::{Player, Reader};
use dogleaf_core::real::Real;
use dogleaf_core::record::{MAX_BYTES, RecordError, Tier, Verdict};

/// What it begins with.
const MAGIC: &[u8; 4] = b"DLS1";
/// The layout written and read here.
const VERSION: u16 = 1;

/// A ribbon's recording and what it could touch.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Strand {
    pub(crate) bytes: Vec<u8>,
    pub(crate) contact: bool,
    pub(crate) floor: Option<f64>,
}

/// All recordings of a scene.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Bundle {
    pub(crate) step_us: u32,
    /// The book's.
    pub(crate) body: Option<Vec<u8>>,
    pub(crate) strands: Vec<Strand>,
}

impl Bundle {
    /// Whether bytes are meant to be one.
    pub(crate) fn meant(bytes: &[u8]) -> bool {
        bytes.starts_with(MAGIC)
    }

    /// As a file.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        let mut out = MAGIC.to_vec();
        out.extend(VERSION.to_le_bytes());
        out.extend(self.step_us.to_le_bytes());
        let body = self.body.as_deref().unwrap_or(&[]);
        let piece = |out: &mut Vec<u8>, bytes: &[u8]| {
            out.extend((bytes.len() as u32).to_le_bytes());
            out.extend(bytes);
        };
        piece(&mut out, body);
        out.extend((self.strands.len() as u16).to_le_bytes());
        for strand in &self.strands {
            out.extend([u8::from(strand.contact), u8::from(strand.floor.is_some())]);
            out.extend(strand.floor.unwrap_or(0.0).to_le_bytes());
            piece(&mut out, &strand.bytes);
        }
        out.extend(crc32(&out).to_le_bytes());
        out
    }

    /// From a file; what is inside is not looked into.
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, RecordError> {
        if bytes.len() > MAX_BYTES {
            return Err(RecordError::TooLarge);
        }
        let (body, sum) = bytes.split_last_chunk().ok_or(RecordError::Truncated)?;
        let mut rest = body;
        if &take::<4>(&mut rest)? != MAGIC {
            return Err(RecordError::NotARecording);
        }
        let version = u16::from_le_bytes(take(&mut rest)?);
        if version != VERSION {
            return Err(RecordError::Version(version));
        }
        if crc32(body) != u32::from_le_bytes(*sum) {
            return Err(RecordError::Checksum);
        }
        let step_us = u32::from_le_bytes(take(&mut rest)?);
        let body = Some(piece(&mut rest)?).filter(|bytes| !bytes.is_empty());
        let count = u16::from_le_bytes(take(&mut rest)?);
        let strands = (0..count).map(|_| strand(&mut rest)).collect::<Result<_, _>>()?;
        if !rest.is_empty() {
            return Err(RecordError::Trailing);
        }
        Ok(Self { step_us, body, strands })
    }
}

fn take<const N: usize>(rest: &mut &[u8]) -> Result<[u8; N], RecordError> {
    let (field, after) = rest.split_first_chunk().ok_or(RecordError::Truncated)?;
    *rest = after;
    Ok(*field)
}

fn piece(rest: &mut &[u8]) -> Result<Vec<u8>, RecordError> {
    let length = u32::from_le_bytes(take(rest)?) as usize;
    let (piece, after) = rest.split_at_checked(length).ok_or(RecordError::Truncated)?;
    *rest = after;
    Ok(piece.to_vec())
}

fn strand(rest: &mut &[u8]) -> Result<Strand, RecordError> {
    let [contact, floor] = take(rest)?.map(|flag: u8| match flag {
        0 | 1 => Ok(flag == 1),
        _ => Err(RecordError::Unknown("flag of a ribbon")),
    });
    let height = f64::from_le_bytes(take(rest)?);
    if !height.is_finite() {
        return Err(RecordError::Unknown("height of a floor"));
    }
    Ok(Strand { contact: contact?, floor: floor?.then_some(height), bytes: piece(rest)? })
}

/// CRC-32 of zip files, bit by bit.
fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |sum, &byte| {
        (0..8).fold(sum ^ u32::from(byte), |s, _| (s >> 1) ^ (0xedb8_8320 & (s & 1).wrapping_neg()))
    })
}

/// A ribbon that is replayed.
struct Played<'a, R: Real> {
    ribbon: Box<Ribbon<R, MOST_SEGMENTS>>,
    player: Player<'a>,
    contact: bool,
    floor: Floor<R>,
}

/// What a ribbon's replay found.
#[derive(Debug)]
pub(crate) struct StrandFound {
    pub(crate) segments: usize,
    pub(crate) tier: Tier,
    pub(crate) verdict: Verdict,
}

/// Runs all ribbons of a bundle again, on the numbers they were made with.
pub(crate) fn replay(bundle: &Bundle) -> Result<Vec<StrandFound>, RecordError> {
    let open = |s: &'_ Strand| Reader::open(&s.bytes).map(|r| r.tier());
    match bundle.strands.first().map(open).transpose()? {
        None => Ok(Vec::new()),
        Some(Tier::F32) => on::<f32>(bundle),
        Some(Tier::F64) => on::<f64>(bundle),
    }
}

fn on<R: Real>(bundle: &Bundle) -> Result<Vec<StrandFound>, RecordError> {
    let mut played = Vec::new();
    for strand in &bundle.strands {
        let reader = Reader::open(&strand.bytes)?;
        let mut ribbon = Box::new(Ribbon::<R, MOST_SEGMENTS>::EMPTY);
        let player = Player::start(&reader, &mut ribbon)?;
        let floor = strand.floor.map_or(Floor(None), Floor::at);
        played.push(Played { ribbon, player, contact: strand.contact, floor });
    }
    let mut near = played.iter().any(|p| p.contact).then(room::<R>);
    let mut more = !played.is_empty();
    while more {
        more = false;
        for k in 0..played.len() {
            more |= step(&mut played, k, bundle.step_us, near.as_deref_mut())?;
        }
    }
    let found = |p: Played<'_, R>| StrandFound {
        segments: p.ribbon.spec().segments,
        tier: Tier::of::<R>(),
        verdict: *p.player.verdict(),
    };
    Ok(played.into_iter().map(found).collect())
}

/// The next step of one, against the others where they are by then; false where it has none.
fn step<R: Real>(
    played: &mut [Played<'_, R>],
    k: usize,
    step_us: u32,
    near: Option<&mut Room<R>>,
) -> Result<bool, RecordError> {
    let Some((before, rest)) = played.split_at_mut_checked(k) else { return Ok(false) };
    let Some((own, after)) = rest.split_first_mut() else { return Ok(false) };
    let Some(near) = near.filter(|_| own.contact) else {
        return own.player.step(&mut own.ribbon, |ribbon, h| ribbon.step(h));
    };
    own.player.step(&mut own.ribbon, |ribbon, h| {
        near.begin(ribbon, f64::from(step_us) * 1e-6);
        near.surface = own.floor;
        let others = before.iter().chain(after.iter()).filter(|o| o.contact);
        others.for_each(|o| near.add(&o.ribbon));
        bent(ribbon, h, near)
    })
}
