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

use core::arch::global_asm;

// A function of its own and not an instruction inside another: the compiler lets those name the unit's registers
// only where the unit also has double precision, which a Cortex-M4 has not.
global_asm!(
    ".fpu fpv4-sp-d16",
    ".section .text.dogleaf_root,\"ax\",%progbits",
    ".global dogleaf_root",
    ".type dogleaf_root,%function",
    ".thumb_func",
    "dogleaf_root:",
    "vsqrt.f32 s0, s0",
    "bx lr",
    ".size dogleaf_root, . - dogleaf_root",
    ".text",
);

unsafe extern "C" {
    fn dogleaf_root(value: f32) -> f32;
}

/// Square root, correctly rounded.
#[inline(always)]
#[must_use]
pub fn root(value: f32) -> f32 {
    // SAFETY: takes a number in the first register of the unit and answers in it, as the ABI says; reads and
    // writes nothing else.
    unsafe { dogleaf_root(value) }
}
