//! Promise: every sum and product has the bits of the host's unit.

use crate::{HIDDEN, INFINITY, SIGN, add, mul};

/// Pairs that are tried.
const PAIRS: u32 = 4_000_000;

/// Where the bits of a number are special: zeros, the ends of every range, halves, all ones.
const EDGES: [u32; 16] = [
    0,
    1,
    2,
    HIDDEN - 2,
    HIDDEN - 1,
    HIDDEN,
    HIDDEN + 1,
    0x3f00_0000,
    0x3f7f_ffff,
    0x3f80_0000,
    0x3f80_0001,
    0x7f7f_fffe,
    0x7f7f_ffff,
    INFINITY,
    INFINITY + 1,
    0x7fff_ffff,
];

/// Bits that repeat nothing for long: a linear generator's, mixed.
struct Bits(u64);

impl Bits {
    fn next(&mut self) -> u32 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let x = (self.0 >> 32) as u32;
        (x ^ x >> 15).wrapping_mul(0x9e37_79b1)
    }
}

fn same(ours: u32, unit: f32) -> bool {
    ours == unit.to_bits() || (unit.is_nan() && f32::from_bits(ours).is_nan())
}

/// The first pair whose sum or product is another than the unit's.
fn wrong(a: u32, b: u32) -> Option<(&'static str, u32, u32)> {
    let (x, y) = (f32::from_bits(a), f32::from_bits(b));
    if !same(add(a, b), x + y) {
        return Some(("sum", a, b));
    }
    (!same(mul(a, b), x * y)).then_some(("product", a, b))
}

#[test]
fn edges_with_edges() {
    let all = || EDGES.into_iter().flat_map(|e| [e, e | SIGN]);
    let found = all().find_map(|a| all().find_map(|b| wrong(a, b)));
    assert_eq!(found, None, "in bits, as decimal numbers");
}

#[test]
fn edges_with_anything() {
    let mut bits = Bits(1);
    for edge in EDGES {
        let found = (0..PAIRS / 32).find_map(|_| wrong(edge | bits.next() & SIGN, bits.next()));
        assert_eq!(found, None, "in bits, as decimal numbers");
    }
}

#[test]
fn anything_with_anything() {
    let mut bits = Bits(2);
    let found = (0..PAIRS).find_map(|_| wrong(bits.next(), bits.next()));
    assert_eq!(found, None, "in bits, as decimal numbers");
}

#[test]
fn neighbours_in_size() {
    // Exponents up to thirty apart, so that sums cancel, tie and lose their last bits; few bits set, for ties.
    let mut bits = Bits(3);
    for _ in 0..PAIRS {
        let (a, b) = (bits.next(), bits.next());
        let few = if a & 1 == 0 { u32::MAX } else { !0 << (b & 31) };
        let near = a.wrapping_sub((bits.next() % 30) << 23) & (INFINITY | SIGN);
        assert_eq!(wrong(a & few, near | (b & few & (HIDDEN - 1))), None, "in bits");
    }
}

#[test]
fn around_the_smallest() {
    // Products that are subnormal, or would be but for their rounding.
    let mut bits = Bits(4);
    for _ in 0..PAIRS {
        let (a, b) = (bits.next(), bits.next());
        let e_a = 1 + (a >> 8) % 200;
        let e_b = 102_u32.wrapping_sub(e_a).wrapping_add((b >> 8) % 30) & 255;
        let of = |e: u32, m: u32| e << 23 | m & (HIDDEN - 1);
        assert_eq!(wrong(of(e_a, a), of(e_b, b)), None, "in bits");
    }
}
