//! A few printed pages in the firmware's constants: sixteen greys, and nothing where the paper is blank.
//!
//! ```text
//! "DLP1"  width u16  height u16  first u16  pages u16
//! pages times  where u32                                     from the beginning
//! page         strips: 4 rows each, of tiles of 4x4 pixels
//!   strip      before u16                                    tiles of the page before this strip
//!              groups of 8 tiles: there u8 (a bit a tile)  before u8 (in this strip)
//!   tiles      8 bytes each: 4 rows of 4 levels, the left one in the low half
//! ```
//!
//! Little end first. A tile that is blank is not there; so a page of verse takes a fifth of its pixels' bytes, and each pixel
//! is found without a search.

use dogleaf_eink::Print;

/// What a file of pages begins with.
pub const MAGIC: [u8; 4] = *b"DLP1";
/// Pixels of a tile's side.
pub const SIDE: usize = 4;
/// Bytes of a tile.
pub const TILE: usize = SIDE * SIDE / 2;
/// Bytes before the pages' places.
pub const HEAD: usize = 12;
/// White.
const BLANK: u8 = 255;

/// Pages that were built in.
#[derive(Debug, Clone, Copy)]
pub struct Built<'a> {
    bytes: &'a [u8],
    size: [u16; 2],
    first: u16,
    pages: u16,
}

impl<'a> Built<'a> {
    /// Looks at the head of a file of pages; none if it is none. A page that is cut short is blank from there on.
    #[must_use]
    pub fn open(bytes: &'a [u8]) -> Option<Self> {
        let (magic, _) = bytes.split_first_chunk()?;
        let [w, h, first, pages] = [4, 6, 8, 10].map(|at| u16_at(bytes, at));
        let built = Self { bytes, size: [w?, h?], first: first?, pages: pages? };
        (*magic == MAGIC).then_some(built)
    }

    /// Pixels across and down.
    #[must_use]
    pub fn size(&self) -> [u16; 2] {
        self.size
    }

    /// Bytes of a strip's head.
    fn strip(&self) -> usize {
        2 + 2 * usize::from(self.size[0]).div_ceil(SIDE).div_ceil(8)
    }

    /// The bytes of a page; its strips stand first.
    fn page(&self, page: u32) -> Option<&'a [u8]> {
        let page =
            page.checked_sub(u32::from(self.first)).filter(|&p| p < u32::from(self.pages))?;
        self.bytes.get(u32_at(self.bytes, HEAD + 4 * page as usize)? as usize..)
    }

    /// Bytes of a page's strips.
    fn strips(&self) -> usize {
        usize::from(self.size[1]).div_ceil(SIDE) * self.strip()
    }

    fn level(&self, page: u32, x: u16, y: u16) -> Option<u8> {
        let page = self.page(page)?;
        let (x, y) = (usize::from(x), usize::from(y));
        let strip = page.get(y / SIDE * self.strip()..)?;
        let pair = *page.get(self.tile(strip, x)? + (y % SIDE * SIDE + x % SIDE) / 2)?;
        Some(if x.is_multiple_of(2) { pair & 15 } else { pair >> 4 })
    }

    /// Where in its page the tile of column `x` begins; none if it is blank.
    fn tile(&self, strip: &[u8], x: usize) -> Option<usize> {
        let (column, bit) = (x / SIDE / 8, x / SIDE % 8);
        let there = *strip.get(2 + 2 * column)?;
        if there >> bit & 1 == 0 {
            return None;
        }
        let before = usize::from(u16_at(strip, 0)?)
            + usize::from(*strip.get(3 + 2 * column)?)
            + usize::from(BITS.get(usize::from(there & ((1 << bit) - 1))).copied()?);
        Some(self.strips() + before * TILE)
    }
}

impl Print for Built<'_> {
    fn luma(&self, page: u32, x: u16, y: u16) -> u8 {
        self.level(page, x, y).map_or(BLANK, |level| level * 17)
    }

    fn row(&self, page: u32, x: u16, y: u16, out: &mut [u8]) {
        let (x, y) = (usize::from(x), usize::from(y));
        let bytes = self.page(page).unwrap_or_default();
        let strip = bytes.get(y / SIDE * self.strip()..).unwrap_or_default();
        // A tile at a time; the first may be entered in its middle.
        let (mut x, mut rest) = (x, out);
        while !rest.is_empty() {
            let (part, others) = rest.split_at_mut((SIDE - x % SIDE).min(rest.len()));
            let tile = self.tile(strip, x).map(|at| at + y % SIDE * (SIDE / 2));
            match tile.and_then(|at| bytes.get(at..)?.first_chunk::<2>()) {
                Some(pairs) => {
                    let four = [pairs[0] & 15, pairs[0] >> 4, pairs[1] & 15, pairs[1] >> 4];
                    let levels = four.iter().skip(x % SIDE);
                    part.iter_mut().zip(levels).for_each(|(luma, level)| *luma = level * 17);
                }
                None => part.fill(BLANK),
            }
            x += part.len();
            rest = others;
        }
    }
}

/// Bits that are set in the numbers below 128: a Cortex-M0 would count them one by one.
const BITS: [u8; 128] = {
    let mut bits = [0; 128];
    let mut n = 0;
    while n < 128 {
        bits[n] = (n as u8).count_ones() as u8;
        n += 1;
    }
    bits
};

fn u16_at(bytes: &[u8], at: usize) -> Option<u16> {
    bytes.get(at..)?.first_chunk().map(|b| u16::from_le_bytes(*b))
}

fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    bytes.get(at..)?.first_chunk().map(|b| u32::from_le_bytes(*b))
}
