//! The whole part of a square root, the same on every target.

/// `⌊√n⌋`, bit by bit. Cost: sixteen rounds.
pub(crate) fn root(n: u32) -> u32 {
    let (mut left, mut found, mut bit) = (n, 0_u32, 1_u32 << 30);
    for _ in 0..16 {
        if left >= found.wrapping_add(bit) {
            left = left.wrapping_sub(found.wrapping_add(bit));
            found = (found >> 1).wrapping_add(bit);
        } else {
            found >>= 1;
        }
        bit >>= 2;
    }
    found
}

#[cfg(test)]
mod check {
    use super::root;

    #[test]
    fn squares_and_their_neighbours() {
        for k in (1..=65_535_u32).step_by(17).chain([65_535]) {
            let n = k * k;
            assert_eq!([root(n - 1), root(n), root(n + 1)], [k - 1, k, k], "about {k} squared");
        }
        assert_eq!([root(0), root(u32::MAX)], [0, 65_535], "the ends");
    }
}
