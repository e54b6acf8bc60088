//! The caps: how much of a stranger's file is taken in, and why each number.

/// Entries of an archive or files of a folder; the thickest comic volumes have about 2,000.
pub const MAX_ENTRIES: usize = 20_000;

/// Bytes an archive's directory may have: room for [`MAX_ENTRIES`] names of 300 letters each.
pub const MAX_DIRECTORY_BYTES: u64 = 8 << 20;

/// Bytes of one picture file, counted as they are inflated, whatever the header says.
pub const MAX_PICTURE_BYTES: u64 = 64 << 20;

/// Inflated bytes per packed byte: pictures hardly pack at all, 100 is already a bomb.
pub const MAX_RATIO: u64 = 100;

/// Inflated bytes up to which [`MAX_RATIO`] is not asked for: small blank pages do pack well.
pub const RATIO_FREE_BYTES: u64 = 100 << 10;

/// Pixels along one side of a picture, in files and in what [`Book::page`](crate::Book::page)
/// returns.
pub const MAX_SIDE_PX: u32 = 16_384;

/// Pixels of one picture, in files and in what [`Book::page`](crate::Book::page) returns.
pub const MAX_PIXELS: u64 = 64_000_000;

/// Bytes a picture may take while it is decoded: [`MAX_PIXELS`] of four bytes, and scratch.
pub const MAX_DECODE_BYTES: u64 = 256 << 20;

/// Bytes of a PDF file, which is held in memory whole.
pub const MAX_PDF_BYTES: u64 = 512 << 20;

/// Pages of a PDF.
pub const MAX_PDF_PAGES: usize = 10_000;

/// How often longer than wide, or wider than long, a page may be.
pub const MAX_ELONGATION: f32 = 200.0;

/// How far a picture is enlarged: more shows no more, it only blurs.
pub const MAX_ENLARGEMENT: f64 = 2.0;
