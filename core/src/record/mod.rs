//! Recordings: what a book was asked and given, and the hash it had after every step.
//!
//! A `.dlr` file is a journal, not a picture of memory: every field is written on its own, little end
//! first, so a recording made on a phone replays on a server, and one from last year says clearly
//! that it is too old instead of turning into nonsense.
//!
//! ```text
//! "DLR1"  version u16  tier u8 (4 = f32, 8 = f64)  nx u8  nz u8  made_by u64
//! book    width_m f64  height_m f64  pages u32  open_at u32  cover u8  direction u8
//! paper   areal_mass_gsm f64  thickness_mm f64  youngs_gpa f64  poisson f64
//!         weights u8 (0 = none, 1 = these: bend_3d bend_2d glue iso_3d position, f64 each)
//! world   gravity 3 f64  damping_per_s f64  step_us u32  seed u64
//! view    eye_m 3 f64  target_m 3 f64  fov_y_deg f64  width_px u32  height_px u32
//! fidelity u8  formulation u8  grip f64  pages u8
//!   1 input   t_us u64  id u8  phase u8  x i32  y i32  leaves u16
//!   2 look    view, as above
//!   3 step    hash u64
//!   4 again   count u32: so many more steps ended with the hash of the last one
//! 255 end     inputs u32  looks u32  steps u32
//! crc u32     CRC-32 of all before it; nothing may follow
//! ```
//!
//! Records stand in the order of the calls. At most [`MAX_BYTES`] and [`MAX_RECORDS`], where `again`
//! counts as the steps it stands for: no file, however made, can ask for more work than that.
//!
//! # Hard case
//!
//! A file is believed only after [`Reader::open`] has seen all of it: right length, version, checksum,
//! codes, specs and counts. Source: ours. Checked by `tests/replay.rs` and `tests/recording_refused.rs`.

pub(crate) mod code;
pub(crate) mod crc;
mod error;
pub(crate) mod header;
mod piece;
mod read;
mod replay;
pub(crate) mod wire;
mod write;

pub use error::RecordError;
pub use header::{Header, MADE_BY, Setup, Tier};
pub use read::{Reader, Record, Records};
pub use replay::{Compared, Divergence, Verdict, replay, replay_with};
pub use write::{Recorder, Sink, SliceSink};

/// What every recording begins with.
pub const MAGIC: [u8; 4] = *b"DLR1";
/// The same as a number.
pub(crate) const KIND: u32 = u32::from_le_bytes(MAGIC);
/// The layout this build writes, and the only one it reads. A new field or code means a new version.
pub const VERSION: u16 = 2;
/// Longest recording, bytes.
pub const MAX_BYTES: usize = 16 << 20;
/// Most inputs, looks and steps together: almost five hours at sixty steps a second.
pub const MAX_RECORDS: u32 = 1 << 20;
