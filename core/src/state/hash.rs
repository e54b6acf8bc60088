//! The state hash: 64-bit FNV-1a over the bits of the numbers, field by field, little end first.

use crate::real::Real;

/// A running hash. Equal states give equal hashes on every target; NaN is canonical.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fnv(u64);

impl Default for Fnv {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fnv {
    /// Takes one word in, byte by byte.
    #[inline(never)]
    pub fn word(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    /// Takes one scalar in.
    #[inline(never)]
    pub fn real<R: Real>(&mut self, value: R) {
        self.word(value.bits());
    }
    /// The hash so far.
    pub fn value(self) -> u64 {
        self.0
    }
}
