//! What a reader keeps in memory, in one place: for the caller to put into a `static`.

use crate::fall::Fall;
use dogleaf_core::grid::G11x8;
use dogleaf_core::reading::Reading;
use dogleaf_eink::{Band, Sheet};

/// Pixels of a band: sixteen rows across the panel of 800, and the one above them.
pub const CELLS: usize = 800 * 17;

/// Everything large but the panel's own pixels.
#[derive(Debug)]
pub struct Room {
    /// The book.
    pub reading: Reading<f32, G11x8>,
    /// Key frames that wait.
    pub fall: Fall,
    /// The leaf as it is seen.
    pub sheet: Sheet,
    /// Rows of pixels.
    pub band: Band<CELLS>,
}

impl Room {
    /// Nothing open: for the caller to place.
    pub const EMPTY: Self =
        Self { reading: Reading::EMPTY, fall: Fall::EMPTY, sheet: Sheet::EMPTY, band: Band::EMPTY };
}
