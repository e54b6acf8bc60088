//! The names under which compilers for Arm call them (run-time ABI, Section 4.1.2).
#![allow(unsafe_code, reason = "a symbol's name is a promise to the linker")]

use crate::SIGN;

/// `a + b`.
#[unsafe(no_mangle)]
extern "C" fn __aeabi_fadd(a: u32, b: u32) -> u32 {
    crate::add(a, b)
}

/// `a - b`.
#[unsafe(no_mangle)]
extern "C" fn __aeabi_fsub(a: u32, b: u32) -> u32 {
    // A copy: most sums of a step are differences, and a second call would be a tenth of one.
    crate::add(a, b ^ SIGN)
}

/// `a b`.
#[unsafe(no_mangle)]
extern "C" fn __aeabi_fmul(a: u32, b: u32) -> u32 {
    crate::mul(a, b)
}
