//! The square root of Arm's floating-point unit.
//!
//! `core` has no stable square root and `libm` computes it in integers on Arm: forty-six instructions for one.
//! IEEE 754 demands the correctly rounded root of both, so the bits are the same; `cargo ci hashes` compares
//! them with every other target's.
//!
//! This is the one instruction the core needs and cannot write: a crate of its own keeps the core's promise
//! that it has no `unsafe`. It is empty on every target but Arm's with a hard-float ABI.
#![no_std]
#![cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#![allow(unsafe_code, reason = "an instruction can only be written with it")]

use core::arch::asm;

/// Square root, correctly rounded.
#[inline(always)]
#[must_use]
pub fn root(value: f32) -> f32 {
    let result: f32;
    // SAFETY: reads one register and writes another; the hard-float ABI says that the unit is there.
    unsafe {
        asm!("vsqrt.f32 {0}, {1}", lateout(sreg) result, in(sreg) value, options(pure, nomem, nostack, preserves_flags));
    }
    result
}
