//! A part of a picture and how long it is shown.

/// Frames into time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Clock {
    pub(super) fps: u32,
}

impl Clock {
    /// When a frame begins, in units of `1 / per_second` seconds. Rounding the place and not the
    /// length keeps a long animation in step.
    pub(super) fn at(self, frame: u64, per_second: u64) -> u64 {
        let fps = u64::from(self.fps);
        (frame * per_second + fps / 2) / fps
    }
}

/// Pixels that stay on the screen from frame `from` until frame `to`.
#[derive(Debug)]
pub(super) struct Shot {
    pub(super) rect: Rect,
    /// RGB of the rectangle.
    pub(super) pixels: Vec<u8>,
    /// For each pixel of the rectangle, whether it is as before; empty for the first shot.
    pub(super) same: Vec<bool>,
    pub(super) from: u64,
    pub(super) to: u64,
    pub(super) clock: Clock,
}

impl Shot {
    /// How long it is shown, in units of `1 / per_second` seconds, at least one.
    pub(super) fn lasts(&self, per_second: u64) -> u64 {
        (self.clock.at(self.to, per_second) - self.clock.at(self.from, per_second)).max(1)
    }
}

/// A rectangle of the picture, pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Rect {
    pub(super) x: usize,
    pub(super) y: usize,
    pub(super) width: usize,
    pub(super) height: usize,
}

impl Rect {
    /// The smallest rectangle that holds every pixel that differs by more than `slack` levels; `None`
    /// if none does.
    pub(super) fn changed(old: &[u8], new: &[u8], width: usize, slack: u8) -> Option<Self> {
        let (mut left, mut right) = (width, 0);
        let (mut top, mut bottom) = (usize::MAX, 0);
        for (y, (a, b)) in old.chunks_exact(width * 3).zip(new.chunks_exact(width * 3)).enumerate()
        {
            if a == b {
                continue;
            }
            let pixels = || a.chunks_exact(3).zip(b.chunks_exact(3));
            let differ = |(p, q): (&[u8], &[u8])| !alike(p, q, slack);
            let Some(first) = pixels().position(differ) else { continue };
            let last = pixels().rposition(differ).unwrap_or(first);
            (left, right) = (left.min(first), right.max(last + 1));
            (top, bottom) = (top.min(y), y + 1);
        }
        (left < right).then(|| Self { x: left, y: top, width: right - left, height: bottom - top })
    }

    /// Grown so that it begins at even pixels, which is all WebP can say, and does not touch the
    /// change with a lossy block's rim.
    pub(super) fn even(self, size: (usize, usize)) -> Self {
        let (x, y) = (self.x.saturating_sub(2) & !1, self.y.saturating_sub(2) & !1);
        let right = (self.x + self.width + 2).min(size.0);
        let bottom = (self.y + self.height + 2).min(size.1);
        Self { x, y, width: right - x, height: bottom - y }
    }

    /// The rectangle's own pixels.
    pub(super) fn crop(&self, frame: &[u8], width: usize) -> Vec<u8> {
        self.rows(width).flat_map(|row| &frame[row]).copied().collect()
    }

    /// For each pixel of the rectangle, whether it differs by no more than `slack` levels; empty if
    /// there is no `old`.
    pub(super) fn unchanged(&self, old: &[u8], new: &[u8], width: usize, slack: u8) -> Vec<bool> {
        if old.is_empty() {
            return Vec::new();
        }
        let mut same = Vec::with_capacity(self.width * self.height);
        for row in self.rows(width) {
            let pairs = old[row.clone()].chunks_exact(3).zip(new[row].chunks_exact(3));
            same.extend(pairs.map(|(a, b)| alike(a, b, slack)));
        }
        same
    }

    /// Byte range of each row.
    pub(super) fn rows(
        &self,
        width: usize,
    ) -> impl Iterator<Item = std::ops::Range<usize>> + use<> {
        let Self { x, y, width: w, height } = *self;
        (y..y + height).map(move |row| (row * width + x) * 3..(row * width + x + w) * 3)
    }
}

/// Whether two pixels differ by no more than `slack` levels in any channel.
fn alike(a: &[u8], b: &[u8], slack: u8) -> bool {
    a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) <= slack)
}
