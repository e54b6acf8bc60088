//! From 256 brightnesses to two or sixteen. The threshold belongs to the place on the panel, so what does not change
//! does not crawl, and a part drawn again meets its neighbours.

mod table;

use table::{SIDE, THRESHOLDS};

/// How many tones are to be had.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Depth {
    /// Black and white.
    TwoTone,
    /// Sixteen greys.
    Sixteen,
}

impl Depth {
    /// The level at a place, 0 black to 15 white.
    ///
    /// # Accuracy
    ///
    /// On average over a table (32x32 pixels) the brightness asked for, to 1/255. Of sixteen greys `17 n` gives `n`
    /// everywhere; black stays black, white stays white.
    #[must_use]
    pub fn level(self, luma: u8, x: u16, y: u16) -> u8 {
        let threshold = threshold(x, y);
        match self {
            Self::TwoTone => {
                if u16::from(luma) > threshold {
                    15
                } else {
                    0
                }
            }
            Self::Sixteen => ((u16::from(luma) * 15 + threshold) / 255) as u8,
        }
    }
}

/// 0 to 254, each as often as the others.
fn threshold(x: u16, y: u16) -> u16 {
    let place = usize::from(y) % SIDE * SIDE + usize::from(x) % SIDE;
    u16::from(THRESHOLDS.get(place).copied().unwrap_or(127))
}
