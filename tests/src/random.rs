//! Random numbers for tests: a PCG32 with a seed, so that what failed can be run again.

use dogleaf_core::real::V3;

/// A stream of random numbers.
#[derive(Debug, Clone)]
pub struct Pcg(u64);

impl Pcg {
    /// The stream of a seed.
    pub fn new(seed: u64) -> Self {
        let mut stream = Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let _ = stream.word();
        stream
    }
    /// Thirty-two random bits.
    pub fn word(&mut self) -> u32 {
        let old = self.0;
        self.0 = old.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        let mixed = (((old >> 18) ^ old) >> 27) as u32;
        mixed.rotate_right((old >> 59) as u32)
    }
    /// Sixty-four random bits.
    pub fn long(&mut self) -> u64 {
        u64::from(self.word()) << 32 | u64::from(self.word())
    }
    /// A number of `least..greatest`, evenly.
    pub fn within(&mut self, least: f64, greatest: f64) -> f64 {
        least + (greatest - least) * (self.long() >> 11) as f64 / (1_u64 << 53) as f64
    }
    /// A number below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        self.within(0.0, count as f64) as usize
    }
    /// `count` numbers of `-1..1`.
    pub fn numbers(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.within(-1.0, 1.0)).collect()
    }
    /// A vector in a cube of `-1..1`.
    pub fn v3(&mut self) -> V3<f64> {
        V3([self.within(-1.0, 1.0), self.within(-1.0, 1.0), self.within(-1.0, 1.0)])
    }
}
