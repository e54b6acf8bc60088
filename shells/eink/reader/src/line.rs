//! What is said of a picture: one line, the same on every target, without `core::fmt`, which alone would bring panics into
//! a firmware that has none.

use crate::desk::Shot;
use dogleaf_core::state::Fnv;
use dogleaf_eink::{Picture, Simulated};

/// Longest line, bytes; what is beyond is cut off.
const MOST: usize = 120;

/// A line in the making.
#[derive(Debug, Clone)]
pub struct Text {
    bytes: [u8; MOST],
    length: usize,
}

impl Text {
    /// An empty line.
    pub const EMPTY: Self = Self { bytes: [0; MOST], length: 0 };

    /// The line so far.
    #[must_use]
    pub fn as_str(&self) -> &str {
        self.bytes.get(..self.length).and_then(|b| core::str::from_utf8(b).ok()).unwrap_or("")
    }

    /// Adds words.
    pub fn text(&mut self, text: &str) -> &mut Self {
        text.bytes().for_each(|byte| self.byte(byte));
        self
    }

    /// Adds a number in decimal digits, at least so many characters wide.
    pub fn number(&mut self, number: u32, width: u32) -> &mut Self {
        let mut begun = false;
        for place in (0..10).rev() {
            // A power of ten is never nothing, but the compiler would keep the panic.
            let digit = number.checked_div(10_u32.wrapping_pow(place)).unwrap_or(0) % 10;
            begun |= digit > 0 || place == 0;
            if begun {
                self.byte(b'0' + digit as u8);
            } else if place < width {
                self.byte(b' ');
            }
        }
        self
    }

    /// Adds a hash in sixteen hexadecimal digits.
    pub fn hash(&mut self, hash: u64) -> &mut Self {
        for place in (0..16).rev() {
            let digit = (hash >> (4 * place)) as u8 & 15;
            self.byte(if digit < 10 { b'0' + digit } else { b'a' + digit - 10 });
        }
        self
    }

    fn byte(&mut self, byte: u8) {
        if let Some(place) = self.bytes.get_mut(self.length) {
            *place = byte;
            self.length += 1;
        }
    }
}

/// When, what, with which waveform, where; how far over the leaf is; the hash of what the panel looks like.
pub fn told(line: &mut Text, shot: &Shot, glass: &Simulated<'_>) {
    let update = &shot.update;
    let what = match update.picture {
        Picture::Moving => " turn ",
        Picture::Settled => " page ",
    };
    line.number((shot.at_us / 1_000) as u32, 5).text(" ms").text(what);
    let name = update.waveform.name();
    line.text(name).text("     ".get(name.len()..).unwrap_or(""));
    let rect = update.rect;
    for n in [rect.x0, rect.y0, rect.x1, rect.y1] {
        line.number(u32::from(n), 4);
    }
    match shot.progress {
        Some(progress) => line.number(u32::from(progress), 6),
        None => line.text("     -"),
    };
    line.text("  ").hash(looks(glass));
}

/// The hash of what every pixel looks like.
#[must_use]
pub fn looks(glass: &Simulated<'_>) -> u64 {
    let mut hash = Fnv::default();
    let mut word = 0;
    for (n, look) in glass.looks().enumerate() {
        word = word << 8 | u64::from(look);
        if n % 8 == 7 {
            hash.word(word);
        }
    }
    hash.word(word);
    hash.value()
}
