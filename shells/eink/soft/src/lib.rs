//! Adding and multiplying single floats in integers, for processors that have no unit for it and no long
//! multiplication (ARMv6-M).
//!
//! IEEE 754 leaves no choice: to the nearest, ties to even, subnormals kept; so the bits are those of every unit.
//! `compiler-builtins` does the same for every width of number and every processor in one generic text, and takes
//! a third more instructions for the recorded turn on a Cortex-M0. Five of six instructions of a step are spent here.
//!
//! On a 32-bit Arm with a software ABI the crate *is* the run-time functions `__aeabi_fadd`, `__aeabi_fsub` and
//! `__aeabi_fmul`: name it with `use dogleaf_soft as _;` and the linker prefers them to the weak ones of
//! `compiler-builtins`. Elsewhere it is two pure functions on bits, which the tests compare with the host's unit.
//!
//! | symbol | name here | meaning |
//! |---|---|---|
//! | s | `SIGN` | sign |
//! | e | `exponent` | biased exponent: 0 for zero and subnormals, 255 for infinities and NaN |
//! | m | `fraction` | fraction with its hidden bit |
#![no_std]

mod add;
mod mul;
#[cfg(all(target_arch = "arm", not(target_abi = "eabihf")))]
mod symbols;
#[cfg(test)]
mod tests;

pub use add::add;
pub use mul::mul;

/// The sign's bit.
const SIGN: u32 = 1 << 31;
/// The fraction's bits.
const FRACTION: u32 = HIDDEN - 1;
/// The bit that every normal number has and none stores.
const HIDDEN: u32 = 1 << 23;
/// An infinity without its sign; what is above it is NaN.
const INFINITY: u32 = 255 << 23;
/// Makes a NaN quiet.
const QUIET: u32 = 1 << 22;
