//! What must not be in an image, planted on purpose (feature `planted`): the checks of `cargo ci size` must
//! then all fail. A check that never fails checks nothing.
#![allow(unsafe_code)]

extern crate alloc;

use alloc::boxed::Box;
use core::alloc::{GlobalAlloc, Layout};
use core::hint::black_box;

/// Bytes of text, of statics and of stack: each more than is allowed.
const MUCH: usize = 200 * 1024;

static TEXT: [u8; MUCH] = [1; MUCH];

/// An allocator that has nothing to give.
struct Nothing;

// SAFETY: it never hands out memory.
unsafe impl GlobalAlloc for Nothing {
    unsafe fn alloc(&self, _: Layout) -> *mut u8 {
        core::ptr::null_mut()
    }
    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}

#[global_allocator]
static ALLOCATOR: Nothing = Nothing;

/// Uses too much of everything. `no` is nothing, but the compiler does not know.
pub fn misbehave(no: usize) {
    static mut RAM: [u8; MUCH] = [0; MUCH];
    let mut stack = [0_u8; MUCH];
    black_box(&mut stack);
    black_box(&raw mut RAM);
    black_box(&TEXT);
    black_box(dogleaf_core::mesh::indices::<dogleaf_core::grid::G11x8> as fn(&mut [u16]) -> _);
    if black_box(no) != 0 {
        black_box(Box::new(stack[no]));
    }
}
