//! What a page or node may call: probes by number, and the recording step by step.
#![allow(unsafe_code)]

use crate::{Probe, Timed, Timing, Work, probes};

static mut WORK: Work = Work::EMPTY;
static mut TIMING: Timing = Timing::NONE;

/// The memory of the probes.
fn work() -> &'static mut Work {
    // SAFETY: the module has one thread, and no export calls another: one reference at a time.
    unsafe { &mut *(&raw mut WORK) }
}

fn timing() -> &'static mut Timing {
    // SAFETY: as above.
    unsafe { &mut *(&raw mut TIMING) }
}

fn probe(n: usize) -> Option<Probe> {
    probes::<f32>().chain(probes::<f64>()).nth(n)
}

/// Word `part` of probe `n`'s line: kind, tier, name.
fn word(n: usize, part: usize) -> &'static str {
    probe(n).and_then(|p| [p.kind, p.tier, p.name].get(part).copied()).unwrap_or("")
}

/// Where a word of a probe's line stands in memory.
#[unsafe(no_mangle)]
pub extern "C" fn word_at(n: usize, part: usize) -> *const u8 {
    word(n, part).as_ptr()
}

/// How long it is; nothing where there is no such probe.
#[unsafe(no_mangle)]
pub extern "C" fn word_length(n: usize, part: usize) -> usize {
    word(n, part).len()
}

/// Runs probe `n`.
#[unsafe(no_mangle)]
pub extern "C" fn run(n: usize) -> u64 {
    probe(n).map_or(0, |p| (p.run)(work()))
}

/// Rewinds the recording.
#[unsafe(no_mangle)]
pub extern "C" fn timing_begin() {
    *timing() = Timing::begin(work());
}

/// What the next step will be: 0 the end, 1 without a leaf, 2 with one.
#[unsafe(no_mangle)]
pub extern "C" fn timing_prepare() -> u32 {
    match timing().prepare(work()) {
        Timed::End => 0,
        Timed::Idle => 1,
        Timed::Leaf => 2,
    }
}

/// The step.
#[unsafe(no_mangle)]
pub extern "C" fn timing_step() {
    Timing::step(work());
}

/// Steps that had another hash than the recorded one.
#[unsafe(no_mangle)]
pub extern "C" fn timing_different() -> u32 {
    timing().different
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
