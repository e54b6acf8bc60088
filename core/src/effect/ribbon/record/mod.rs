//! Recordings of a ribbon: how it was, what it was asked before each step, and the hash it had after it.
//!
//! A file of its own beside the book's, by the same rules: a journal written field by field, little end first, believed only
//! after all of it has been seen.
//!
//! ```text
//! "DLB1"  version u16  tier u8 (4 = f32, 8 = f64)  made_by u64
//! spec    length_m width_m rigidity_nm areal_mass_gsm regularisation damping_per_s perturbation f64
//!         segments u32  bending mass resample root closure u8  seed u64
//! origin  3 f64
//! state   base t b n p, 12 f64  joint 2 f64  multipliers 6 f64  shifts 2 f64
//!         each segment: psi c, velocities of A and B, 8 f64  end: velocities of A and B, 6 f64
//!   1 asked   gravity 3 f64  settings: iterations trials shifts u32, tolerance closure barrier f64, thorough u8
//!             springs u8, each: crease u32 rim u8 target 3 f64 stiffness f64
//!             guides u8, each: segment u32 normal 3 f64 stiffness f64
//!   2 base    t b n p, 12 f64: the start was carried there
//!   3 step    h f64  hash u64
//! 255 end     steps u32
//! crc u32     CRC-32 of all before it; nothing may follow
//! ```
//!
//! `asked` and `base` stand where they changed. Numbers of `f32` are written as `f64`, which keeps them. A book's
//! versions count apart.
//!
//! # Hard case
//!
//! Contact and loads of a caller's own are not in it: who plays it hands them in again, as the step of [`replay`], or of
//! [`Player`] where ribbons touch each other.
//!
//! Source: ours. Checked by `tests/ribbon_record.rs`.

mod head;
mod read;
mod write;

pub use read::{Player, Reader, replay};
pub use write::Recorder;

/// What a ribbon's recording begins with.
pub const MAGIC: [u8; 4] = *b"DLB1";
/// The same as a number.
const KIND: u32 = u32::from_le_bytes(MAGIC);
/// The layout this build writes, and the only one it reads.
pub const VERSION: u16 = 3;
