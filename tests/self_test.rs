//! Promise: a processor that is set up wrongly is noticed before it turns a page.

#![allow(unsafe_code, reason = "only inline assembly sets the modes that must be noticed")]

use dogleaf_core::Book;
use dogleaf_core::selftest::{SelfTest, golden_step};

fn run() -> SelfTest {
    SelfTest::run(&mut Box::new(Book::EMPTY))
}

/// Where the hash stands that firmware carries with it.
const GOLDEN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../core/src/selftest/golden.rs");

/// With `DOGLEAF_BLESS` set the hash is written anew; the core has it from its next build on.
fn blessed(found: u64) -> bool {
    if std::env::var_os("DOGLEAF_BLESS").is_none() {
        return false;
    }
    let text = std::fs::read_to_string(GOLDEN).expect("the generated file");
    let head = text.split("0x").next().expect("a head");
    let digits: Vec<String> =
        (0..4).rev().map(|n| format!("{:04x}", found >> (16 * n) & 0xffff)).collect();
    std::fs::write(GOLDEN, format!("{head}0x{};\n", digits.join("_"))).expect("it can be written");
    true
}

#[test]
fn this_processor_passes() {
    let found = golden_step(&mut Box::new(Book::EMPTY));
    if blessed(found) {
        return;
    }
    let changed = "did the model change on purpose? cargo ci golden --bless";
    assert_eq!(run(), SelfTest::Passed, "the golden step's hash is {found:#018x}: {changed}");
}

#[test]
fn what_the_book_held_does_not_matter() {
    let mut book = Box::new(Book::EMPTY);
    let _ = golden_step(&mut book);
    assert_eq!(SelfTest::run(&mut book), run(), "what the book held does not matter");
}

/// Runs the self test with other bits in the unit's control register, then puts the register back.
#[cfg(target_arch = "x86_64")]
fn with_modes(bits: u32) -> SelfTest {
    use core::arch::asm;
    let mut book = Box::new(Book::EMPTY);
    let mut before = 0_u32;
    // SAFETY: writes and reads four bytes of this frame; the modes are as they were before anyone else computes.
    unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut before) };
    let wrong = before | bits;
    // SAFETY: as above.
    unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const wrong) };
    let found = std::hint::black_box(SelfTest::run(&mut book));
    // SAFETY: as above.
    unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const before) };
    found
}

#[cfg(target_arch = "x86_64")]
#[test]
fn wrong_modes_are_noticed() {
    let modes = [
        ("down", 0x2000, SelfTest::RoundingWrong),
        ("up", 0x4000, SelfTest::RoundingWrong),
        ("towards zero", 0x6000, SelfTest::RoundingWrong),
        ("results flushed", 0x8000, SelfTest::SubnormalsFlushed),
        ("operands flushed", 0x0040, SelfTest::SubnormalsFlushed),
    ];
    for (mode, bits, expected) in modes {
        assert_eq!(with_modes(bits), expected, "{mode}");
    }
    let modes = [SelfTest::RoundingWrong, SelfTest::SubnormalsFlushed];
    assert!(!modes.contains(&run()), "the modes were put back");
}
