//! The power-on self test: whether this processor, as it is set up now, computes what all others compute.
//!
//! The same bits need a floating-point unit that rounds to nearest and keeps subnormals. Both are modes
//! that start-up code, an audio thread or another library may have changed; neither shows in a picture
//! until two devices drift apart. So a shell asks once, before it opens a book.
//!
//! Source: ours. Checked by `tests/self_test.rs`, which sets the modes wrong and looks that it is noticed.

mod golden;
mod modes;

use crate::book::Book;
use crate::grid::G11x8;
use crate::hand::View;
use crate::scene::{BookSpec, Fidelity, PaperSpec, WorldSpec};

/// What the self test found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[must_use]
pub enum SelfTest {
    /// This processor computes as all others do.
    Passed,
    /// Sums are not rounded to nearest, ties to even.
    RoundingWrong,
    /// Numbers below the smallest normal one are taken for zero, going in or coming out.
    SubnormalsFlushed,
    /// The modes are right, and yet a step of a book ends elsewhere: the compiler, a library, or the chip.
    GoldenStepDiffers,
}

/// World steps that are taken.
const STEPS: u32 = 4;

impl SelfTest {
    /// Runs it in a book that is not in use; [open](Book::open) it afterwards, whatever it held before.
    ///
    /// # Cost
    ///
    /// Four steps with a leaf in the air. No clock, no memory of its own.
    // Inlined, as [`golden_step`]: else this crate would hold a second copy of the whole step beside the shell's.
    #[inline]
    pub fn run(book: &mut Book<f32, G11x8>) -> Self {
        if !(modes::rounds_to_nearest::<f32>() && modes::rounds_to_nearest::<f64>()) {
            Self::RoundingWrong
        } else if !(modes::keeps_subnormals::<f32>() && modes::keeps_subnormals::<f64>()) {
            Self::SubnormalsFlushed
        } else if golden_step(book) != golden::STEP {
            Self::GoldenStepDiffers
        } else {
            Self::Passed
        }
    }

    /// Lower-case name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::RoundingWrong => "rounding wrong",
            Self::SubnormalsFlushed => "subnormals flushed",
            Self::GoldenStepDiffers => "golden step differs",
        }
    }
}

/// The hash of a book after a few steps with a leaf in the air; nothing it could be opened with differs.
#[inline]
pub fn golden_step(book: &mut Book<f32, G11x8>) -> u64 {
    let (spec, paper, world) = (BookSpec::default(), PaperSpec::default(), WorldSpec::default());
    let view = View::reading(spec.width_m, spec.height_m, 960, 720);
    if book.open(&spec, &paper, &world, &view, Fidelity::Standard).is_err() {
        return 0;
    }
    if !book.take_up(true, 1) {
        return 0;
    }
    for _ in 0..STEPS {
        let _ = book.step();
    }
    book.state_hash()
}
