//! What must come out the same, to the bit, on every target and at every level of optimisation.
//!
//! A [`Probe`] is a scene or an operation; running it gives one hash. Scenes show *that* something
//! differs; operations, each over two thousand random cases, name *what* does. Runners only print:
//! `src/main.rs` on hosts, `shells/eink/firmware/src/bin/probe.rs` on a board, `src/web.rs` in WebAssembly.
#![no_std]

mod fold;
mod hand;
mod kernel;
mod matrix;
mod numbers;
mod random;
#[cfg(feature = "ribbon")]
mod ribbon;
mod scenes;
mod strip;
mod timing;
#[cfg(target_arch = "wasm32")]
pub mod web;
mod work;

pub use matrix::Matrix;
pub use scenes::SCENES;
pub use timing::{Timed, Timing};
pub use work::{Pick, Tier, Work};

/// Random cases of every operation on numbers.
pub const CASES: usize = 2000;

/// Something whose hash is the same everywhere.
#[derive(Debug, Clone, Copy)]
pub struct Probe {
    /// `scene` or `operation`.
    pub kind: &'static str,
    /// Which.
    pub name: &'static str,
    /// The numbers it runs on.
    pub tier: &'static str,
    /// Runs it.
    pub run: fn(&mut Work) -> u64,
}

/// Every scene and operation of one tier, operations first: the first that differs is the cause.
pub fn probes<R: Pick>() -> impl Iterator<Item = Probe> {
    let make = |kind| {
        move |(name, run): (&'static str, fn(&mut Work) -> u64)| Probe {
            kind,
            name,
            tier: R::NAME,
            run,
        }
    };
    let operations = numbers::table::<R>()
        .into_iter()
        .chain(kernel::table::<R>())
        .chain(matrix::table::<R>())
        .chain(strip::table::<R>())
        .chain(hand::table::<R>());
    let scenes = scenes::table::<R>().into_iter();
    #[cfg(feature = "ribbon")]
    let (operations, scenes) =
        (operations.chain(ribbon::operations::<R>()), scenes.chain(ribbon::scenes::<R>()));
    operations.map(make("operation")).chain(scenes.map(make("scene")))
}

/// One row of a table of probes.
type Row = (&'static str, fn(&mut Work) -> u64);
