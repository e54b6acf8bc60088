//! What one step of the leaf is asked.

use crate::real::V3;
use crate::state::{Grab, Root};

/// What one step is asked: time step, forces, and what is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ask<R> {
    /// Time step `h`, seconds.
    pub h: R,
    /// `e^(-c h)`: what damping leaves of a velocity over one step.
    pub keep: R,
    /// Acceleration of free fall.
    pub gravity: V3<R>,
    /// How the spine column is held.
    pub root: Root<R>,
    /// What the hand holds.
    pub grab: Option<Grab<R>>,
}
