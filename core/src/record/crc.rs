//! CRC-32 as in zip and PNG: polynomial `0xedb88320`, reflected.
//!
//! # Cost
//!
//! Four bits at a time from a table of 64 bytes: small enough for firmware, and a file is read once.

/// The checksum of `"123456789"` by definition.
#[cfg(test)]
const CHECK: u32 = 0xcbf4_3926;

/// Remainders of the sixteen values of four bits.
const TABLE: [u32; 16] = [
    0x0000_0000,
    0x1db7_1064,
    0x3b6e_20c8,
    0x26d9_30ac,
    0x76dc_4190,
    0x6b6b_51f4,
    0x4db2_6158,
    0x5005_713c,
    0xedb8_8320,
    0xf00f_9344,
    0xd6d6_a3e8,
    0xcb61_b38c,
    0x9b64_c2b0,
    0x86d3_d2d4,
    0xa00a_e278,
    0xbdbd_f21c,
];

/// A running checksum.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Crc(u32);

impl Crc {
    /// Of nothing.
    pub(crate) const START: Self = Self(u32::MAX);

    /// Takes bytes in.
    pub(crate) fn take(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 ^= u32::from(byte);
            self.nibble();
            self.nibble();
        }
    }
    fn nibble(&mut self) {
        let row = TABLE.get((self.0 & 15) as usize).copied().unwrap_or(0);
        self.0 = row ^ (self.0 >> 4);
    }
    /// The checksum so far.
    pub(crate) fn value(self) -> u32 {
        !self.0
    }
}

#[cfg(test)]
mod tests {
    use super::{CHECK, Crc};

    #[test]
    fn the_check_value() {
        let mut whole = Crc::START;
        whole.take(b"123456789");
        let mut parts = Crc::START;
        parts.take(b"1234");
        parts.take(b"");
        parts.take(b"56789");
        assert_eq!((whole.value(), parts.value()), (CHECK, CHECK));
    }
}
