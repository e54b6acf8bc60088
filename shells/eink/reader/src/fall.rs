//! The fall of a leaf that was let go: computed at once, its key frames kept until the panel has time for them.
//!
//! So the processor is busy once a turn and sleeps while the panel works; and one that cannot keep pace with a falling leaf
//! shows the same pictures as one that can.

use dogleaf_core::grid::G11x8;
use dogleaf_core::reading::Reading;
use dogleaf_eink::{Faces, Panel, Policy, Pose, Strip};

/// Key frames that wait. Six kilobytes, for the caller to place.
#[derive(Debug, Clone)]
pub struct Fall {
    strip: Strip,
    shown: usize,
}

impl Fall {
    /// Nothing waits: for the caller to place.
    pub const EMPTY: Self = Self { strip: Strip::EMPTY, shown: 0 };

    /// Lets the leaf fall, and keeps what is due after progress `last`.
    pub fn compute(
        &mut self,
        reading: &mut Reading<f32, G11x8>,
        last: u16,
        panel: &Panel,
        policy: &Policy,
    ) {
        self.shown = 0;
        self.strip.fall(reading, last, (panel, policy), &mut ());
    }

    /// The next key frame and the pages seen about it.
    pub fn take(&mut self) -> Option<(Pose, Faces)> {
        let pose = self.strip.poses().get(self.shown)?;
        self.shown += 1;
        Some((*pose, *self.strip.faces()))
    }

    /// Whether some still wait.
    #[must_use]
    pub fn waits(&self) -> bool {
        self.shown < self.strip.poses().len()
    }

    /// A finger takes over: what waits is forgotten.
    pub fn forget(&mut self) {
        self.shown = self.strip.poses().len();
    }
}
