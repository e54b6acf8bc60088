//! What the app is told.

use crate::options::mirrored;
use dogleaf_core::reading;

mirrored! {
    /// A haptic tick: what a finger would feel.
    Tick = reading::Tick {
        /// A leaf comes off its block.
        Lift,
        /// It passes the vertical.
        Over,
        /// It lies.
        Land,
        /// One more leaf slips into the hand, or out of it.
        Flip,
    }
}

/// One fact for the app. Exactly one `Committed` or `Cancelled` ends every `Lifted`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, uniffi::Enum)]
pub enum Notice {
    /// Leaves were taken up from the block on this side.
    Lifted {
        /// Taken from the right block.
        from_right: bool,
        /// How many.
        leaves: u32,
    },
    /// A second finger changed how many are held.
    Held {
        /// How many are held now.
        leaves: u32,
    },
    /// The book is open at another page now.
    Committed {
        /// As [`BookOptions::open_at`](crate::BookOptions::open_at).
        page: u32,
    },
    /// The leaf was put back.
    Cancelled,
    /// For a screen reader, once the page lies: the page and how many there are.
    Announce {
        /// First page that is open.
        page: u32,
        /// Pages of the book.
        pages: u32,
    },
    /// For the vibrator.
    Haptic {
        /// What a finger would feel.
        tick: Tick,
    },
    /// Everything is at rest; nothing has to be drawn until the next input.
    Asleep,
}

impl From<reading::Notice> for Notice {
    fn from(notice: reading::Notice) -> Self {
        use reading::Notice as Core;
        match notice {
            Core::Lifted { from_right, leaves } => Self::Lifted { from_right, leaves },
            Core::Held { leaves } => Self::Held { leaves },
            Core::Committed { page } => Self::Committed { page },
            Core::Cancelled => Self::Cancelled,
            Core::Announce { page, pages } => Self::Announce { page, pages },
            Core::Tick(tick) => Self::Haptic { tick: tick.into() },
            Core::Asleep => Self::Asleep,
        }
    }
}
