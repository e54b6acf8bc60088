//! A clock that counts instructions.
//!
//! QEMU with `-icount shift=4` lets 16 ns pass an instruction; SysTick of the MPS2 boards ticks every 40 ns.
//! So an instruction is 2/5 of a tick, exactly and in every run.

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;

/// SysTick counts down from here.
const FULL: u32 = 0x00ff_ffff;

/// Counts the instructions between two looks.
pub struct Clock {
    timer: SYST,
    last: u32,
}

impl core::fmt::Debug for Clock {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Clock")
    }
}

impl Clock {
    /// Starts the timer.
    pub fn new(mut timer: SYST) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(FULL);
        timer.clear_current();
        timer.enable_counter();
        // The first look after the start can be zero.
        while SYST::get_current() == 0 {}
        Self { timer, last: 0 }
    }

    /// Begins a section.
    pub fn begin(&mut self) {
        let _ = self.timer.has_wrapped();
        self.last = SYST::get_current();
    }

    /// Instructions since [`Clock::begin`]; nothing if there were more than forty million.
    pub fn instructions(&mut self) -> Option<u32> {
        let now = SYST::get_current();
        // One pass through zero is told from more only by the order; a section twice as long is not.
        let wrapped = self.timer.has_wrapped();
        if wrapped && now <= self.last {
            return None;
        }
        let ticks = self.last.wrapping_sub(now) & FULL;
        Some((u64::from(ticks) * 5 / 2) as u32)
    }
}
