//! What one frame answers.

use crate::eink::PanelUpdate;
use crate::options::mirrored;
use dogleaf_core::step;

mirrored! {
    /// How the physics of a frame went. A bad number is a status, never a crash.
    StepStatus = step::StepStatus {
        /// Nothing moved and nothing had to.
        Asleep,
        /// As it should.
        Converged,
        /// With a shorter step.
        Reduced,
        /// Nothing improved it; the pose was kept.
        Stalled,
        /// Numbers became non-finite; the last good pose was kept.
        Held,
        /// An edge left what paper can be; the last good pose was kept.
        Recovered,
    }
}

/// What one call of [`Book::step`](crate::Book::step) did.
#[derive(Debug, Clone, Copy, PartialEq, uniffi::Record)]
pub struct FrameInfo {
    /// The mesh was made anew: upload it and draw.
    pub draw: bool,
    /// Call again at the next frame; else not before the next input.
    pub needs_frame: bool,
    /// Number of the mesh; moves when the vertices do.
    pub generation: u64,
    /// Number of the list of pieces; moves when one of them shows another page, comes or goes.
    pub pieces_generation: u64,
    /// Notices waiting.
    pub notices: u32,
    /// Largest stretch of the leaf's edges, as a share of their length.
    pub stretch: f32,
    /// Share of the light that passes the leaf in the air: none while it lies on a page, or for a stack.
    pub through: f32,
    /// The same of the leaf that slips into the hand or out of it.
    pub flying_through: f32,
    /// How the physics went.
    pub status: StepStatus,
    /// The picture that electronic paper is to show now, under `MotionPolicy::EInk` only; then `draw` says whether there is one.
    pub panel: Option<PanelUpdate>,
}
