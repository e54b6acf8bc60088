//! The second finger: while the first holds a leaf, leaves behind it are added and given back. Book Sec. 4.1.
//!
//! A swipe towards the middle of the picture adds the next leaf of the block the held ones came from, a swipe
//! away from it gives the last one back; whoever swipes on flips on.

use super::Book;
use crate::event::Event;
use crate::grid::Grid;
use crate::hand::{Phase, Sample};
use crate::real::Real;

/// Way of a swipe that flips one leaf, as a share of the picture's width.
const SWIPE: f64 = 1.0 / 16.0;

/// A finger beside the one that holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Beside {
    id: u8,
    /// From where the next flip is measured, 1/256 pixel.
    x: i32,
}

impl Beside {
    /// All of it, for a state hash.
    pub(super) fn digest(self) -> u64 {
        u64::from(self.id) | u64::from(self.x as u32) << 8
    }
}

impl<R: Real, G: Grid> Book<R, G> {
    /// A finger comes down while another holds a leaf. One is enough.
    pub(super) fn come_beside(&mut self, sample: &Sample) -> bool {
        if self.beside.is_some() {
            return false;
        }
        self.beside = Some(Beside { id: sample.id, x: sample.x });
        true
    }

    /// What the second finger does. Answers nothing if the sample is not of it.
    pub(super) fn swipe(&mut self, sample: &Sample) -> Option<bool> {
        let beside = self.beside.filter(|b| b.id == sample.id)?;
        match sample.phase {
            Phase::Down => return Some(false),
            Phase::Up | Phase::Cancel => self.beside = None,
            Phase::Move => self.swiped(beside, sample),
        }
        Some(true)
    }

    fn swiped(&mut self, beside: Beside, sample: &Sample) {
        let middle = self.camera.centre[0].wide() * 256.0;
        let way = f64::from(sample.x) - f64::from(beside.x);
        let far = SWIPE * 2.0 * middle;
        if way.abs() < far {
            return;
        }
        let x = f64::from(beside.x) + if way < 0.0 { -far } else { far };
        self.beside = Some(Beside { x: x as i32, ..beside });
        let inwards = (way < 0.0) == (f64::from(beside.x) > middle);
        self.flip(inwards);
    }

    /// Takes one more leaf from the block the held ones came from, or gives one back. Answers whether it could.
    fn flip(&mut self, more: bool) -> bool {
        let Some(there) = self.binding.leaves.get_mut(usize::from(self.binding.from_right)) else {
            return false;
        };
        let held = self.binding.held;
        let (left, now) = if more {
            (there.checked_sub(1), held.checked_add(1))
        } else {
            (there.checked_add(1), held.checked_sub(1).filter(|&n| n > 0))
        };
        let (Some(left), Some(now)) = (left, now) else { return false };
        *there = left;
        self.binding.held = now;
        self.soften();
        self.note(Event::Held { leaves: now });
        self.wake();
        true
    }
}
