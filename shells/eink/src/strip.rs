//! The key frames of a whole turn, ahead of time: for a key press, where nothing the reader does can change them, and for
//! processors that cannot compute a turn while it is seen.

use crate::panel::Panel;
use crate::plan::Policy;
use crate::pose::{self, Faces, Pose};
use dogleaf_core::grid::G11x8;
use dogleaf_core::reading::{Reading, Refusal, Tape};
use dogleaf_core::real::Real;

/// Most key frames of a turn.
pub const MOST: usize = 12;

/// The poses of a turn, half a kilobyte each. For the caller to place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Strip {
    poses: heapless::Vec<Pose, MOST>,
    faces: Faces,
}

impl Strip {
    /// Nothing: for the caller to place.
    pub const EMPTY: Self = Self {
        poses: heapless::Vec::new(),
        faces: Faces { left: None, right: None, up: None, down: None },
    };

    /// Turns leaves on, or back, to the end, and keeps the key frames this panel has time for. The book is then open at
    /// the page after; its notices tell so.
    ///
    /// # Cost
    ///
    /// A whole turn: some ninety world steps.
    ///
    /// # Errors
    ///
    /// As [`Reading::turn`]; then nothing was changed.
    pub fn turn<R: Real>(
        &mut self,
        reading: &mut Reading<R, G11x8>,
        forward: bool,
        (panel, policy): (&Panel, &Policy),
        tape: &mut impl Tape,
    ) -> Result<(), Refusal> {
        reading.turn(forward, 1)?;
        self.fall(reading, 0, (panel, policy), tape);
        Ok(())
    }

    /// Lets the leaf that nobody holds fall to the end, and keeps the key frames that come after progress `last`.
    ///
    /// # Cost
    ///
    /// As many world steps as the fall has, some sixty.
    pub fn fall<R: Real>(
        &mut self,
        reading: &mut Reading<R, G11x8>,
        mut last: u16,
        (panel, policy): (&Panel, &Policy),
        tape: &mut impl Tape,
    ) {
        self.poses.clear();
        let keys = policy.keys(panel);
        reading.ahead(tape, |book| {
            let Some(pose) = Pose::of(book) else { return };
            let due = policy.next(last, keys).is_some_and(|t| pose.progress() >= t);
            if due && self.poses.len() < usize::from(keys) {
                last = pose.progress();
                self.faces = Faces::of(book);
                // It has room: there are no more keys than places.
                let _ = self.poses.push(pose);
            }
        });
    }

    /// The key frames, in order.
    #[must_use]
    pub fn poses(&self) -> &[Pose] {
        &self.poses
    }

    /// Which pages are seen while the leaf is in the air.
    #[must_use]
    pub fn faces(&self) -> &Faces {
        &self.faces
    }

    /// Takes the poses of a turn that was computed elsewhere, written one after another by [`Pose::to_bytes`]; for the
    /// book as it lies open here.
    ///
    /// # Errors
    ///
    /// None; false if there is no pose, one is cut short or there are too many. Nothing was changed then.
    #[must_use]
    pub fn read(&mut self, bytes: &[u8], faces: Faces) -> bool {
        let count = bytes.len() / pose::BYTES;
        if count == 0 || count > MOST || !bytes.len().is_multiple_of(pose::BYTES) {
            return false;
        }
        self.poses.clear();
        for pose in bytes.chunks_exact(pose::BYTES).filter_map(Pose::from_bytes) {
            let _ = self.poses.push(pose);
        }
        self.faces = faces;
        true
    }
}
