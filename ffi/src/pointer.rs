//! What fingers do, in the app's pixels.

use crate::error::DogleafError;
use crate::options::mirrored;
use dogleaf_core::hand::{self, Sample};

mirrored! {
    /// What a pointer did.
    Phase = hand::Phase {
        /// Pressed.
        Down,
        /// Moved while pressed.
        Move,
        /// Let go: the leaf falls with the speed it has.
        Up,
        /// Taken away by the system: the leaf goes back where it came from.
        Cancel,
    }
}

/// One pointer sample.
#[derive(Debug, Clone, Copy, PartialEq, uniffi::Record)]
pub struct PointerSample {
    /// When, microseconds of the clock that [`Book::step`](crate::Book::step) is called with.
    pub time_us: u64,
    /// Which finger, modulo 64; a second one flips leaves behind the one the first holds.
    pub id: u8,
    /// What it did.
    pub phase: Phase,
    /// Across the view, pixels from its left edge.
    pub x: f32,
    /// Down the view, pixels from its top edge.
    pub y: f32,
    /// Leaves to take up at once; read at [`Phase::Down`], zero means one.
    pub leaves: u16,
}

impl PointerSample {
    /// In the core's 1/256 pixel; a place far outside every screen counts as its edge.
    pub(crate) fn sample(&self) -> Result<Sample, DogleafError> {
        let place = |v: f32| {
            let scaled = (f64::from(v) * 256.0).round();
            v.is_finite().then_some(scaled as i32)
        };
        let (Some(x), Some(y)) = (place(self.x), place(self.y)) else {
            return Err(DogleafError::Pointer("a pointer is at no finite place".to_owned()));
        };
        let Self { time_us: t_us, id, phase, leaves, .. } = *self;
        Ok(Sample { t_us, id, phase: phase.into(), x, y, leaves })
    }
}
