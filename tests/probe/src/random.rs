//! Random numbers that are made of integers, so that they are the same everywhere.

use dogleaf_core::real::{LANES, Real, V2, V3};

/// Numbers that go wrong first: zeros of both signs, ones, subnormals, the very large, the odd ones out.
const SPECIAL: [f64; 12] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    1.0e-40,
    -1.0e-42,
    1.1754944e-38,
    1.0e30,
    -3.0e38,
    f64::INFINITY,
    f64::NAN,
    0.1,
];

/// PCG32.
#[derive(Debug, Clone)]
pub(crate) struct Random(u64);

impl Random {
    /// A sequence of its own for every name.
    pub(crate) fn named(name: &str) -> Self {
        let mut random = Self(0x853c_49e6_748f_ea9b);
        for byte in name.bytes() {
            random.0 = random.0.wrapping_add(u64::from(byte));
            let _ = random.next();
        }
        random
    }
    /// Thirty-two bits.
    pub(crate) fn next(&mut self) -> u32 {
        let old = self.0;
        self.0 =
            old.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let shifted = (((old >> 18) ^ old) >> 27) as u32;
        shifted.rotate_right((old >> 59) as u32)
    }
    /// In `0..below`.
    pub(crate) fn below(&mut self, below: u32) -> u32 {
        self.next() % below
    }
    /// In `-1..1`, on a grid of 2^-31: exact in `f64`.
    pub(crate) fn unit(&mut self) -> f64 {
        f64::from(self.next().cast_signed()) * (1.0 / 2_147_483_648.0)
    }
    /// In `-size..size`.
    pub(crate) fn within<R: Real>(&mut self, size: f64) -> R {
        R::of(self.unit() * size)
    }
    /// Any number, tame ones more often.
    pub(crate) fn wild<R: Real>(&mut self) -> R {
        let unit = self.unit();
        match self.below(16) {
            0 => R::of(SPECIAL[self.below(SPECIAL.len() as u32) as usize]),
            1..=3 => R::of(unit * power(self.below(48))),
            _ => R::of(unit * 2.0),
        }
    }
    /// Eight of them.
    pub(crate) fn eight<R: Real>(&mut self) -> [R; LANES] {
        core::array::from_fn(|_| self.wild())
    }
    /// A vector in a cube.
    pub(crate) fn v3<R: Real>(&mut self, size: f64) -> V3<R> {
        V3([self.within(size), self.within(size), self.within(size)])
    }
    /// A vector in a square.
    pub(crate) fn v2<R: Real>(&mut self, size: f64) -> V2<R> {
        V2([self.within(size), self.within(size)])
    }
}

/// `2^(n - 24)`, exactly.
fn power(n: u32) -> f64 {
    f64::from_bits(u64::from(1023 - 24 + n) << 52)
}
