//! The fall of a leaf that was let go: computed at once, its key frames kept until the panel has time for them.
//!
//! So the processor is busy once a turn and sleeps while the panel works; and one that cannot keep pace with a falling leaf
//! shows the same pictures as one that can.

use dogleaf_core::grid::G11x8;
use dogleaf_core::reading::Reading;
use dogleaf_eink::strip::MOST;
use dogleaf_eink::{Faces, Panel, Policy, Pose};

/// Key frames that wait. Six kilobytes, for the caller to place.
#[derive(Debug, Clone)]
pub struct Fall {
    poses: [Pose; MOST],
    faces: Faces,
    kept: usize,
    shown: usize,
}

impl Fall {
    /// Nothing waits: for the caller to place.
    pub const EMPTY: Self = Self {
        poses: [Pose::ZERO; MOST],
        faces: Faces { left: None, right: None, up: None, down: None },
        kept: 0,
        shown: 0,
    };

    /// Lets the leaf fall, and keeps what is due after progress `last`.
    ///
    /// # Cost
    ///
    /// As many world steps as the fall has, some sixty.
    pub fn compute(
        &mut self,
        reading: &mut Reading<f32, G11x8>,
        mut last: u16,
        panel: &Panel,
        policy: &Policy,
    ) {
        (self.kept, self.shown) = (0, 0);
        let keys = policy.keys(panel);
        reading.ahead(&mut (), |book| {
            let Some(pose) = Pose::of(book) else { return };
            let next = (0..keys).map(|n| Policy::threshold(n, keys)).find(|&t| t > last);
            let due = next.is_some_and(|t| pose.progress() >= t);
            if let Some(place) = self.poses.get_mut(self.kept).filter(|_| due) {
                (*place, last) = (pose, pose.progress());
                self.faces = Faces::of(book);
                self.kept += 1;
            }
        });
    }

    /// The next key frame and the pages seen about it.
    pub fn next(&mut self) -> Option<(Pose, Faces)> {
        let pose = self.poses.get(..self.kept)?.get(self.shown)?;
        self.shown += 1;
        Some((*pose, self.faces))
    }

    /// Whether some still wait.
    #[must_use]
    pub fn waits(&self) -> bool {
        self.shown < self.kept
    }

    /// A finger takes over: what waits is forgotten.
    pub fn forget(&mut self) {
        self.kept = 0;
    }
}
