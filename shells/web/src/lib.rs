//! dogleaf for browsers: the raw half. `js/` makes of it what a page uses; nothing here knows a page.
//!
//! ```text
//! per frame    pointer(..)        each sample since the last frame
//!              step(now)          -> bits; the rest of the answer lies in `figures`
//!              notices(), pieces() only if the answer says so
//! once         addresses of vertices, indices, figures: they stay; the memory's buffer may be made anew by the browser
//! ```
//!
//! What crosses is numbers, words and bytes. Everything but [`raw`] also works on a host, where tests compare with it.

pub mod desk;
pub mod error;
pub mod mesh;
pub mod options;
pub mod raw;
pub mod replay;
pub mod view;

pub use desk::Desk;
pub use error::Refused;
pub use options::BookOptions;
pub use replay::Replay;
