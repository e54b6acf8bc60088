//! A clock that counts instructions.
//!
//! QEMU with `-icount shift=4` lets 16 ns pass an instruction; the first timer of the MPS2 boards (Arm's APB timer of
//! the CMSDK, 32 bits) ticks every 40 ns. So an instruction is 2/5 of a tick, exactly and in every run. SysTick would
//! do too, but it wraps after forty million instructions: without a floating-point unit a step takes as many.
#![allow(unsafe_code)]

/// The timer's registers: control, value (counts down), reload.
const CONTROL: *mut u32 = 0x4000_0000 as *mut u32;
const VALUE: *mut u32 = 0x4000_0004 as *mut u32;
const RELOAD: *mut u32 = 0x4000_0008 as *mut u32;

/// Counts the instructions between two looks.
#[derive(Debug)]
pub struct Clock {
    last: u32,
}

impl Clock {
    /// Starts the timer.
    pub fn start() -> Self {
        for (register, value) in [(RELOAD, u32::MAX), (VALUE, u32::MAX), (CONTROL, 1)] {
            // SAFETY: these words are the timer's own and nobody else's; every value is one it takes.
            unsafe { register.write_volatile(value) };
        }
        Self { last: now() }
    }

    /// Begins a section.
    pub fn begin(&mut self) {
        self.last = now();
    }

    /// Instructions since [`Clock::begin`]. A section of ten thousand million is not told from a short one.
    pub fn instructions(&self) -> u64 {
        u64::from(self.last.wrapping_sub(now())) * 5 / 2
    }
}

fn now() -> u32 {
    // SAFETY: reading the timer changes nothing.
    unsafe { VALUE.read_volatile() }
}
