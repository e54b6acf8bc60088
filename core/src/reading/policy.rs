//! What of a turn is seen. What becomes of it is the same under every policy: the same book is simulated, with
//! the same input, and only the pictures differ.

use crate::scene::SpecError;

/// Shortest time between two pictures on an electronic paper panel, microseconds.
pub const EINK_US: u64 = 120_000;
/// Bounds of a turn's cap, microseconds.
const CAPS_US: (u32, u32) = (50_000, 10_000_000);

/// How much motion is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MotionPolicy {
    /// Every frame.
    #[default]
    Full,
    /// At most one picture between the page before and the page after: the leaf as it was let go.
    Reduced,
    /// No picture but the page after.
    None,
    /// A picture every [`EINK_US`] at most, and the page after.
    EInk,
}

impl MotionPolicy {
    /// Every policy with its name.
    pub const ALL: [(&'static str, Self); 4] = [
        ("full", Self::Full),
        ("reduced", Self::Reduced),
        ("none", Self::None),
        ("eink", Self::EInk),
    ];

    /// Whether a leaf in the air is seen as long as a finger holds it.
    pub(super) fn follows(self) -> bool {
        matches!(self, Self::Full | Self::EInk)
    }
}

/// What moves, and for how long at most.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Motion {
    /// What is shown.
    pub policy: MotionPolicy,
    /// Longest time from letting a leaf go until it lies, microseconds; none leaves it to the paper.
    pub cap_us: Option<u32>,
}

impl Motion {
    /// Everything, as long as it takes.
    pub const FULL: Self = Self { policy: MotionPolicy::Full, cap_us: None };

    /// Refuses what no turn keeps.
    ///
    /// # Errors
    ///
    /// `motion.cap_us` outside 50 ms to 10 s.
    pub fn check(&self) -> Result<(), SpecError> {
        match self.cap_us {
            Some(cap) if !(CAPS_US.0..=CAPS_US.1).contains(&cap) => {
                Err(SpecError::OutOfRange("motion.cap_us"))
            }
            _ => Ok(()),
        }
    }

    /// How many times as fast a free leaf falls so that most have landed within the cap.
    pub(super) fn haste(self) -> u64 {
        /// Most leaves lie after this long.
        const TYPICAL_US: u32 = 1_100_000;
        self.cap_us.map_or(1, |cap| u64::from(TYPICAL_US.div_ceil(cap.max(1))).clamp(1, 8))
    }
}
