//! Lines of text to semihosting's console, which the emulator shows on stderr.

use core::ffi::CStr;
use semihosting::sys::arm_compat::sys_write0;

/// Longest line, bytes; what is beyond is cut off.
const MOST: usize = 120;

/// A line in the making.
#[derive(Debug, Clone)]
pub struct Line {
    /// The last one stays a nought.
    bytes: [u8; MOST + 1],
    length: usize,
}

impl Default for Line {
    fn default() -> Self {
        Self::new()
    }
}

impl Line {
    /// An empty line.
    pub fn new() -> Self {
        Self { bytes: [0; MOST + 1], length: 0 }
    }

    /// Adds one byte.
    #[must_use]
    #[inline(never)]
    pub fn byte(mut self, byte: u8) -> Self {
        if let Some(place) = self.bytes.get_mut(self.length).filter(|_| self.length < MOST) {
            *place = byte;
            self.length += 1;
        }
        self
    }

    /// Adds words.
    #[must_use]
    #[inline(never)]
    pub fn text(self, text: &str) -> Self {
        text.bytes().fold(self, Self::byte)
    }

    /// Adds a number, in decimal digits.
    #[must_use]
    #[inline(never)]
    pub fn number(mut self, number: u32) -> Self {
        let mut power = 1_000_000_000;
        let mut begun = false;
        while power > 0 {
            let digit = (number / power) % 10;
            begun |= digit > 0 || power == 1;
            if begun {
                self = self.byte(b'0' + digit as u8);
            }
            power /= 10;
        }
        self
    }

    /// Adds a hash, in sixteen hexadecimal digits.
    #[must_use]
    #[inline(never)]
    pub fn hash(mut self, hash: u64) -> Self {
        for place in (0..16).rev() {
            let digit = (hash >> (4 * place)) as u8 & 15;
            self = self.byte(if digit < 10 { b'0' + digit } else { b'a' + digit - 10 });
        }
        self
    }

    /// Says the line. Where nobody listens, nothing happens.
    pub fn say(self) {
        let line = self.byte(b'\n');
        if let Ok(text) = CStr::from_bytes_until_nul(&line.bytes) {
            sys_write0(text);
        }
    }
}
