//! A part of a panel.

/// Panels are driven in columns of so many pixels: one byte of a picture of one bit.
pub const ALIGN: u16 = 8;

/// A rectangle of pixels, from the top left one to, but without, the bottom right one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Rect {
    /// Left edge.
    pub x0: u16,
    /// Top edge.
    pub y0: u16,
    /// First column to the right that is not in it.
    pub x1: u16,
    /// First row below that is not in it.
    pub y1: u16,
}

impl Rect {
    /// No pixel.
    pub const NONE: Self = Self { x0: 0, y0: 0, x1: 0, y1: 0 };

    /// From one corner to the other; nothing if they are the wrong way round.
    #[must_use]
    pub const fn new(x0: u16, y0: u16, x1: u16, y1: u16) -> Self {
        if x0 < x1 && y0 < y1 { Self { x0, y0, x1, y1 } } else { Self::NONE }
    }

    /// No pixel is in it.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.x0 >= self.x1 || self.y0 >= self.y1
    }

    /// Columns.
    #[must_use]
    pub const fn width(&self) -> u16 {
        self.x1.saturating_sub(self.x0)
    }

    /// Rows.
    #[must_use]
    pub const fn height(&self) -> u16 {
        self.y1.saturating_sub(self.y0)
    }

    /// Pixels.
    #[must_use]
    pub const fn area(&self) -> u32 {
        self.width() as u32 * self.height() as u32
    }

    /// The smallest rectangle around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        if self.is_empty() {
            return other;
        }
        if other.is_empty() {
            return self;
        }
        Self {
            x0: self.x0.min(other.x0),
            y0: self.y0.min(other.y0),
            x1: self.x1.max(other.x1),
            y1: self.y1.max(other.y1),
        }
    }

    /// What both share.
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        Self::new(
            self.x0.max(other.x0),
            self.y0.max(other.y0),
            self.x1.min(other.x1),
            self.y1.min(other.y1),
        )
    }

    /// Every pixel of `other` is in it.
    #[must_use]
    pub fn holds(&self, other: &Self) -> bool {
        other.is_empty() || self.union(*other) == *self
    }

    /// Widened to whole columns of [`ALIGN`] pixels, on a panel so wide.
    #[must_use]
    pub fn aligned(self, width: u16) -> Self {
        if self.is_empty() {
            return Self::NONE;
        }
        let x1 = self.x1.div_ceil(ALIGN).saturating_mul(ALIGN).min(width);
        Self { x0: self.x0 / ALIGN * ALIGN, x1, ..self }
    }
}
