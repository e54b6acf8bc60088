//! Where leaves are bound, and how many lie on which side.
//!
//! The binding edge is level, its centre fixed (`C_fix`); both its ends are held, see `ARCHITECTURE.md`,
//! "The spine". Leaves stand along it in reading order: those of the left block from the left end,
//! those of the right block from the right end, the held ones between.

use crate::collision::Profile;
use crate::constraint::binding::{place, progress};
use crate::real::{Real, V2};
use crate::state::strip::{BLOCK, Strip};

/// The binding edge and the count of leaves along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Binding<R> {
    /// Thickness of one leaf.
    pub leaf: R,
    /// Leaves in the left and right block.
    pub leaves: [u32; 2],
    /// Leaves in the air as one.
    pub held: u32,
    /// The held ones were taken from the right block.
    pub from_right: bool,
}

impl<R: Real> Binding<R> {
    /// No leaves.
    pub const ZERO: Self = Self { leaf: R::ZERO, leaves: [0; 2], held: 0, from_right: true };

    /// Leaves in the book.
    pub fn all(&self) -> u32 {
        self.leaves[0] + self.leaves[1] + self.held
    }
    /// Half the length of the binding edge.
    pub fn half(&self) -> R {
        self.leaf * R::of(0.5 * f64::from(self.all()))
    }
    /// Thickness of the left and right block.
    pub fn thickness(&self) -> [R; 2] {
        self.leaves.map(|n| self.leaf * R::of(f64::from(n)))
    }
    /// Half the thickness of what is held.
    pub fn half_held(&self) -> R {
        self.leaf * R::of(0.5 * f64::from(self.held))
    }
    /// `q` of Eq. 7.
    pub fn q(&self) -> f64 {
        progress(self.leaves[0], self.held, self.all())
    }
    /// Where the held leaves are bound.
    pub fn root(&self) -> V2<R> {
        let half = self.half();
        place(V2([-half, R::ZERO]), V2([half, R::ZERO]), R::of(self.q()))
    }
    /// The outlines of both blocks.
    pub fn profiles(&self, blocks: &[Strip<R, BLOCK>; 2]) -> [Profile<R>; 2] {
        let [left, right] = self.thickness();
        [Profile::new(&blocks[0], left), Profile::new(&blocks[1], right)]
    }
}
