//! What no reader does and every program must bear: a seeded storm of samples.

use dogleaf_core::hand::{Phase, Sample};

/// Samples of the storm, over some twelve seconds.
const SAMPLES: u64 = 900;
const EVERY_US: u64 = 6_667;

/// Permuted congruential numbers, 32 bits each.
struct Pcg(u64);

impl Pcg {
    fn next(&mut self) -> u32 {
        let old = self.0;
        self.0 =
            old.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mixed = (((old >> 18) ^ old) >> 27) as u32;
        mixed.rotate_right((old >> 59) as u32)
    }
    fn below(&mut self, n: u32) -> u32 {
        self.next() % n
    }
}

/// Fingers that press twice, lift what they never pressed, jump over the screen and far beyond, take up
/// more leaves than there are, two at a time, at the same microsecond, with long pauses.
pub(super) fn storm(seed: u64, [width, height]: [u32; 2]) -> Vec<Sample> {
    let mut pcg = Pcg(seed);
    let mut t_us = 0;
    let mut samples = Vec::new();
    for n in 0..SAMPLES {
        t_us += match pcg.below(16) {
            0 => 0,
            1 => 20 * EVERY_US,
            _ => EVERY_US,
        };
        let phase = match pcg.below(12) {
            0 | 1 => Phase::Down,
            2 => Phase::Up,
            3 if n % 3 == 0 => Phase::Cancel,
            _ => Phase::Move,
        };
        let [x, y] = [place(&mut pcg, width), place(&mut pcg, height)];
        let leaves = [0, 0, 1, 3, u16::MAX][pcg.below(5) as usize];
        let leaves = if phase == Phase::Down { leaves } else { 0 };
        samples.push(Sample { t_us, id: u8::from(pcg.below(5) == 0), phase, x, y, leaves });
    }
    // In the end nobody holds anything, so that it must come to rest.
    let end = |id| Sample { t_us, id, phase: Phase::Up, x: 0, y: 0, leaves: 0 };
    samples.extend([end(0), end(1)]);
    samples
}

/// Mostly on the screen, at times beyond it, seldom as far as a number goes.
fn place(pcg: &mut Pcg, side: u32) -> i32 {
    let side = i32::try_from(256 * side).unwrap_or(i32::MAX);
    let on_screen = pcg.below(side.unsigned_abs()).cast_signed();
    match pcg.below(40) {
        0 => i32::MIN,
        1 => i32::MAX,
        2..=5 => on_screen.saturating_mul(9).saturating_sub(side.saturating_mul(4)),
        _ => on_screen,
    }
}
