//! Pointer samples: integers only, so that every shell hands over the same bits.

/// What a pointer did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Phase {
    /// Pressed.
    Down,
    /// Moved while pressed.
    Move,
    /// Let go: the leaf falls with the speed it has.
    Up,
    /// Taken away by the system: the leaf goes back where it came from.
    Cancel,
}

impl Phase {
    /// Every phase with the name a gesture file uses.
    pub const ALL: [(&'static str, Self); 4] =
        [("down", Self::Down), ("move", Self::Move), ("up", Self::Up), ("cancel", Self::Cancel)];
}

/// One pointer sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sample {
    /// When, microseconds since the book was opened.
    pub t_us: u64,
    /// Which pointer.
    pub id: u8,
    /// What it did.
    pub phase: Phase,
    /// Across the view, 1/256 pixel from its left edge.
    pub x: i32,
    /// Down the view, 1/256 pixel from its top edge.
    pub y: i32,
    /// Leaves to take up at once; read at [`Phase::Down`], zero means one.
    pub leaves: u16,
}
