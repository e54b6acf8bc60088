//! A book, or a lone leaf.

use super::error::{SpecError, within};

/// How the boards are made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Cover {
    /// Two stiff boards hinged at the spine.
    #[default]
    Hard,
    /// The outer leaves are the cover.
    Soft,
}

/// Which way one reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Direction {
    /// Leaves turn from right to left.
    #[default]
    Ltr,
    /// Leaves turn from left to right.
    Rtl,
}

/// A bound book lying open on a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BookSpec {
    /// Width of a page, metres.
    pub width_m: f64,
    /// Height of a page, metres.
    pub height_m: f64,
    /// Printed pages; two a leaf.
    pub pages: u32,
    /// Page the book is open at; page 0 is before the first leaf.
    pub open_at: u32,
    /// Boards.
    pub cover: Cover,
    /// Reading direction.
    pub direction: Direction,
}

impl Default for BookSpec {
    fn default() -> Self {
        Self {
            width_m: 0.13,
            height_m: 0.20,
            pages: 320,
            open_at: 120,
            cover: Cover::default(),
            direction: Direction::default(),
        }
    }
}

impl BookSpec {
    /// The smallest of books.
    pub const ONE_LEAF: Self = Self {
        width_m: 0.13,
        height_m: 0.20,
        pages: 1,
        open_at: 0,
        cover: Cover::Hard,
        direction: Direction::Ltr,
    };

    /// Leaves in the book.
    pub fn leaves(&self) -> u32 {
        self.pages.div_ceil(2)
    }
    /// Leaves already read.
    pub fn read(&self) -> u32 {
        (self.open_at / 2).min(self.leaves())
    }

    /// Refuses a book that could not be built.
    ///
    /// # Errors
    ///
    /// The first field out of range: sides of 1 mm to 10 m, height over width 0.2 to 5, 1 to 20,000 pages.
    pub fn check(&self) -> Result<(), SpecError> {
        within("book.width_m", self.width_m, 0.001, 10.0)?;
        within("book.height_m", self.height_m, 0.001, 10.0)?;
        within("book.height_m over book.width_m", self.height_m / self.width_m, 0.2, 5.0)?;
        within("book.pages", f64::from(self.pages), 1.0, 20_000.0)?;
        within("book.open_at", f64::from(self.open_at), 0.0, f64::from(self.pages) + 1.0)
    }
}

/// A lone leaf held along its spine edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeafSpec {
    /// Spine to fore-edge, metres.
    pub width_m: f64,
    /// Tail to head, metres.
    pub height_m: f64,
    /// Tangent at the clamp above the horizontal, degrees.
    pub clamp_angle_deg: f64,
    /// Curvature it starts with, 1/m.
    pub curl_per_m: f64,
}

impl Default for LeafSpec {
    fn default() -> Self {
        Self { width_m: 0.15, height_m: 0.20, clamp_angle_deg: 0.0, curl_per_m: 0.0 }
    }
}

impl LeafSpec {
    /// Refuses a leaf that could not be laid.
    ///
    /// # Errors
    ///
    /// The first field out of range.
    pub fn check(&self) -> Result<(), SpecError> {
        within("leaf.width_m", self.width_m, 0.001, 10.0)?;
        within("leaf.height_m", self.height_m, 0.001, 10.0)?;
        within("leaf.height_m over leaf.width_m", self.height_m / self.width_m, 0.2, 5.0)?;
        within("leaf.clamp_angle_deg", self.clamp_angle_deg, -180.0, 180.0)?;
        within("leaf.curl_per_m times leaf.width_m", self.curl_per_m * self.width_m, -6.0, 6.0)
    }
}
