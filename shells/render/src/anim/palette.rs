//! Few colours for a picture: median cut, with ordered dithering.

/// Bits a channel keeps in the histogram.
const BITS: u32 = 6;
/// Cells of the histogram.
const CELLS: usize = 1 << (3 * BITS);
/// How far dithering moves a colour at most, levels.
const DITHER: f32 = 5.0;

/// Colours, and which of them each cell of the colour cube gets.
#[derive(Debug)]
pub(super) struct Palette {
    colours: Vec<[u8; 3]>,
    /// Index by cell, found when first asked for.
    nearest: Vec<Option<u8>>,
}

/// Some cells of the histogram.
struct Box_ {
    cells: Vec<u32>,
    weight: u64,
}

impl Palette {
    /// At most `most` colours for these RGB pixels.
    pub(super) fn of(rgb: &[u8], most: usize) -> Self {
        let mut counts = vec![0_u32; CELLS];
        rgb.chunks_exact(3).for_each(|p| counts[cell([p[0], p[1], p[2]])] += 1);
        let used: Vec<u32> = (0..CELLS as u32).filter(|&c| counts[c as usize] > 0).collect();
        let mut boxes = vec![Box_::new(used, &counts)];
        while boxes.len() < most {
            let widest = (0..boxes.len()).max_by_key(|&i| boxes[i].urgency());
            let Some(halves) = widest.and_then(|i| boxes[i].split(&counts).map(|h| (i, h))) else {
                break;
            };
            let (i, (low, high)) = halves;
            boxes[i] = low;
            boxes.push(high);
        }
        let colours: Vec<[u8; 3]> = boxes.iter().map(|b| b.mean(&counts)).collect();
        Self { colours, nearest: vec![None; CELLS] }
    }

    /// Red, green and blue of every colour, 256 in all.
    pub(super) fn bytes(&self) -> Vec<u8> {
        let mut bytes: Vec<u8> = self.colours.iter().flatten().copied().collect();
        bytes.resize(256 * 3, 0);
        bytes
    }

    /// Index of every pixel, dithered by its place so that a still part stays still.
    pub(super) fn draw(&mut self, rgb: &[u8], width: usize) -> Vec<u8> {
        const BAYER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];
        let dithered = |(i, p): (usize, &[u8])| {
            let offset = (f32::from(BAYER[(i / width) & 3][(i % width) & 3]) / 15.0 - 0.5) * DITHER;
            let move_ = |c: u8| (f32::from(c) + offset + 0.5).clamp(0.0, 255.0) as u8;
            let cell = cell([move_(p[0]), move_(p[1]), move_(p[2])]);
            *self.nearest[cell].get_or_insert_with(|| closest(&self.colours, cell as u32))
        };
        rgb.chunks_exact(3).enumerate().map(dithered).collect()
    }
}

impl Box_ {
    fn new(cells: Vec<u32>, counts: &[u32]) -> Self {
        let weight = cells.iter().map(|&c| u64::from(counts[c as usize])).sum();
        Self { cells, weight }
    }

    /// The axis along which the cells spread widest, and how far.
    fn widest(&self) -> (usize, u32) {
        let spread = |axis: usize| {
            let places = || self.cells.iter().map(|&c| place(c)[axis]);
            places().max().unwrap_or(0) - places().min().unwrap_or(0)
        };
        (0..3).map(|a| (a, spread(a))).max_by_key(|(_, s)| *s).unwrap_or((0, 0))
    }

    /// How much it needs to be split: wide and not too rarely seen.
    fn urgency(&self) -> u64 {
        if self.cells.len() < 2 {
            0
        } else {
            u64::from(self.widest().1).pow(2) * (1 + self.weight.isqrt())
        }
    }

    /// Two halves of about equal weight; `None` if there is only one cell.
    fn split(&self, counts: &[u32]) -> Option<(Self, Self)> {
        if self.cells.len() < 2 {
            return None;
        }
        let axis = self.widest().0;
        let mut cells = self.cells.clone();
        cells.sort_by_key(|&c| (place(c)[axis], c));
        let mut seen = 0;
        let half = cells.iter().position(|&c| {
            seen += u64::from(counts[c as usize]);
            seen * 2 >= self.weight
        });
        let at = half.map_or(1, |h| h + 1).clamp(1, cells.len() - 1);
        let high = cells.split_off(at);
        Some((Self::new(cells, counts), Self::new(high, counts)))
    }

    fn mean(&self, counts: &[u32]) -> [u8; 3] {
        std::array::from_fn(|axis| {
            let sum: u64 = self
                .cells
                .iter()
                .map(|&c| u64::from(counts[c as usize]) * u64::from(place(c)[axis]))
                .sum();
            let middle = sum as f32 / self.weight.max(1) as f32 + 0.5;
            (middle * (1 << (8 - BITS)) as f32).min(255.0) as u8
        })
    }
}

/// Cell of a colour.
fn cell(rgb: [u8; 3]) -> usize {
    rgb.iter().fold(0, |cell, &c| cell << BITS | usize::from(c >> (8 - BITS)))
}

/// A cell's place along the three axes.
fn place(cell: u32) -> [u32; 3] {
    let mask = (1 << BITS) - 1;
    [cell >> (2 * BITS), cell >> BITS & mask, cell & mask]
}

fn closest(colours: &[[u8; 3]], cell: u32) -> u8 {
    let middle = place(cell).map(|p| ((p << (8 - BITS)) + (1 << (7 - BITS))) as i32);
    let away = |c: &[u8; 3]| (0..3).map(|a| (i32::from(c[a]) - middle[a]).pow(2)).sum::<i32>();
    let best = colours.iter().enumerate().min_by_key(|(_, c)| away(c));
    best.map_or(0, |(i, _)| i as u8)
}
