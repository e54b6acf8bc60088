//! Instructions by what they were spent on, and sleep.

use crate::clock::Clock;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use dogleaf_eink_reader::desk::Part;

/// SysTick's ticks in a microsecond.
const TICKS: u64 = 25;
/// Longest sleep in one go: SysTick has 24 bits.
const LONGEST_US: u64 = 500_000;

/// Counts instructions by part while the processor is awake.
#[derive(Debug)]
pub struct Meter {
    clock: Clock,
    part: Part,
    spent: [u64; 3],
}

impl Meter {
    /// Everything begins as [`Part::Other`].
    pub fn start() -> Self {
        Self { clock: Clock::start(), part: Part::Other, spent: [0; 3] }
    }

    /// What follows is spent on something else.
    pub fn turn_to(&mut self, part: Part) {
        self.close();
        self.part = part;
    }

    /// Books what was spent since the last look.
    pub fn close(&mut self) {
        let count = self.clock.instructions();
        if let Some(slot) = self.spent.get_mut(self.part as usize) {
            *slot += count;
        }
        self.clock.begin();
    }

    /// What follows does not count before now.
    pub fn open(&mut self) {
        self.clock.begin();
    }

    /// Instructions since the last call, in the order of [`Part`]; counted anew from here.
    pub fn take(&mut self) -> [u64; 3] {
        self.close();
        core::mem::take(&mut self.spent)
    }
}

/// Sleeps until SysTick wakes the processor.
pub struct Nap {
    timer: SYST,
    /// How often it slept, and how long, microseconds.
    pub count: u32,
    /// Microseconds asleep.
    pub us: u64,
}

impl core::fmt::Debug for Nap {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Nap")
    }
}

impl Nap {
    /// With the timer that wakes it.
    pub fn new(mut timer: SYST) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        Self { timer, count: 0, us: 0 }
    }

    /// Sleeps so long. The image must have an exception `SysTick`, even an empty one.
    pub fn sleep(&mut self, us: u64) {
        let mut left = us;
        // As many rounds as there are half seconds, and one.
        while left > 0 {
            let part = if left < LONGEST_US { left } else { LONGEST_US };
            left -= part;
            self.timer.set_reload((part * TICKS) as u32);
            self.timer.clear_current();
            self.timer.enable_interrupt();
            self.timer.enable_counter();
            cortex_m::asm::wfi();
            self.timer.disable_counter();
            self.timer.disable_interrupt();
            self.count += 1;
        }
        self.us += us;
    }
}
