//! What the images of this folder share: text without `core::fmt`, a clock that counts instructions,
//! and the painted stack.
//!
//! Nothing here formats through `core::fmt`, because that alone would bring panics into an image whose
//! promise is that it has none.
#![no_std]

pub mod clock;
pub mod memory;
#[cfg(feature = "reader")]
pub mod meter;
#[cfg(feature = "planted")]
pub mod planted;
pub mod say;
pub mod tally;

// Of these the symbols are what is wanted: critical sections, and sums and products in integers.
use cortex_m as _;
#[cfg(not(target_abi = "eabihf"))]
use dogleaf_soft as _;

pub use clock::Clock;
pub use say::Line;
pub use tally::Tally;

/// Ends the run on the emulator: 0 where all is well, 1 else.
pub fn leave(well: bool) -> ! {
    semihosting::process::exit(if well { 0 } else { 1 })
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    Line::new().text("panicked").say();
    leave(false)
}
