//! The stream after the head: one piece is a tag and its fields.

use super::MAX_RECORDS;
use super::error::RecordError;
use super::header::view_fields;
use super::wire::{Done, In, Ruler, Wire};
use crate::hand::{Phase, Sample, View};

/// How many of what a recording holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Totals {
    pub(super) inputs: u32,
    pub(super) looks: u32,
    pub(super) steps: u32,
}

impl Totals {
    fn all(self) -> u32 {
        self.inputs.saturating_add(self.looks).saturating_add(self.steps)
    }
    /// With one piece more, unless that is too many.
    pub(super) fn with(mut self, piece: &Piece) -> Result<Self, RecordError> {
        let (field, more) = match piece {
            Piece::Input(_) => (&mut self.inputs, 1),
            Piece::Look(_) => (&mut self.looks, 1),
            Piece::Step(_) => (&mut self.steps, 1),
            Piece::Again(count) => (&mut self.steps, *count),
            Piece::End(_) => return Ok(self),
        };
        *field = field.saturating_add(more);
        if self.all() <= MAX_RECORDS { Ok(self) } else { Err(RecordError::TooMany) }
    }
}

/// One piece of the stream.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Piece {
    Input(Sample),
    Look(View),
    Step(u64),
    Again(u32),
    End(Totals),
}

const NO_SAMPLE: Sample = Sample { t_us: 0, id: 0, phase: Phase::Down, x: 0, y: 0, leaves: 0 };
const NO_VIEW: View =
    View { eye_m: [0.0; 3], target_m: [0.0; 3], fov_y_deg: 0.0, width_px: 0, height_px: 0 };

impl Piece {
    fn tag(&self) -> u8 {
        match self {
            Self::Input(_) => 1,
            Self::Look(_) => 2,
            Self::Step(_) => 3,
            Self::Again(_) => 4,
            Self::End(_) => 255,
        }
    }
    fn blank(tag: u8) -> Result<Self, RecordError> {
        let kinds = [
            Self::Input(NO_SAMPLE),
            Self::Look(NO_VIEW),
            Self::Step(0),
            Self::Again(0),
            Self::End(Totals::default()),
        ];
        let known = kinds.into_iter().find(|kind| kind.tag() == tag);
        known.ok_or(RecordError::Unknown("record"))
    }
    fn fields(&mut self, wire: &mut impl Wire) -> Done {
        match self {
            Self::Input(Sample { t_us, id, phase, x, y, leaves }) => {
                wire.u64(t_us)?;
                wire.u8(id)?;
                wire.code(phase)?;
                wire.i32(x)?;
                wire.i32(y)?;
                wire.u16(leaves)
            }
            Self::Look(view) => view_fields(view, wire),
            Self::Step(hash) => wire.u64(hash),
            Self::Again(count) => wire.u32(count),
            Self::End(Totals { inputs, looks, steps }) => {
                [inputs, looks, steps].into_iter().try_for_each(|count| wire.u32(count))
            }
        }
    }

    /// Writes it.
    pub(super) fn write(mut self, wire: &mut impl Wire) -> Done {
        wire.u8(&mut self.tag())?;
        self.fields(wire)
    }
    /// Reads the next one.
    pub(super) fn read(wire: &mut In<'_>) -> Result<Self, RecordError> {
        let mut tag = 0;
        wire.u8(&mut tag)?;
        let mut piece = Self::blank(tag)?;
        piece.fields(wire)?;
        Ok(piece)
    }
    /// Bytes it takes.
    pub(super) fn length(self) -> usize {
        let mut ruler = Ruler::default();
        // A ruler refuses nothing.
        let _ = self.write(&mut ruler);
        ruler.0
    }
}
