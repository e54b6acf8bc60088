//! What of the board's memory is in use: statics by the linker's marks, the stack by its paint.
#![allow(unsafe_code)]

use cortex_m_rt::STACK_PAINT_VALUE;

// Marks that cortex-m-rt's linker script sets; only their addresses mean something.
unsafe extern "C" {
    static __sdata: u32;
    static __edata: u32;
    static __sbss: u32;
    static __ebss: u32;
    static _stack_start: u32;
    static _stack_end: u32;
}

/// Bytes of statics that begin with a value, and of those that begin as zero.
pub fn statics() -> (u32, u32) {
    let address = |mark: *const u32| mark as u32;
    (
        address(&raw const __edata) - address(&raw const __sdata),
        address(&raw const __ebss) - address(&raw const __sbss),
    )
}

/// The most bytes the stack has had since the reset.
pub fn stack() -> u32 {
    let (top, bottom) = (&raw const _stack_start, &raw const _stack_end);
    let mut mark = bottom;
    // SAFETY: the words between the two marks are the stack's, which is never moved and only read here.
    while mark < top && unsafe { mark.read_volatile() } == STACK_PAINT_VALUE {
        mark = mark.wrapping_add(1);
    }
    top as u32 - mark as u32
}
