//! The mip chain: every level halves the one before, averaged in square roots of light.
//!
//! Print averaged in light itself turns pale grey long before it turns unreadable, as it does in a
//! photograph taken from afar. The mean of the roots keeps strokes darker and the text legible.

use super::Level;

/// Extends `first` down to a single texel.
pub(super) fn chain(first: Level) -> Vec<Level> {
    let mut levels = vec![first];
    loop {
        let last = &levels[levels.len() - 1];
        if last.width == 1 && last.height == 1 {
            return levels;
        }
        let next = halve(last);
        levels.push(next);
    }
}

/// Averages two by two; an odd last row or column is folded into its neighbour by clamping.
fn halve(fine: &Level) -> Level {
    let (width, height) = (fine.width.div_ceil(2), fine.height.div_ceil(2));
    let mut texels = Vec::with_capacity(width * height);
    for y in 0..height {
        let rows = [2 * y, (2 * y + 1).min(fine.height - 1)].map(|r| r * fine.width);
        for x in 0..width {
            let columns = [2 * x, (2 * x + 1).min(fine.width - 1)];
            texels.push(mean([
                fine.texels[rows[0] + columns[0]],
                fine.texels[rows[0] + columns[1]],
                fine.texels[rows[1] + columns[0]],
                fine.texels[rows[1] + columns[1]],
            ]));
        }
    }
    Level { width, height, texels }
}

/// Mean of four texels.
fn mean(four: [[u8; 4]; 4]) -> [u8; 4] {
    std::array::from_fn(|c| {
        let sum: u16 = four.iter().map(|t| u16::from(t[c])).sum();
        ((sum + 2) / 4) as u8
    })
}
