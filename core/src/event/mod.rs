//! What happened, in the order it happened: read by the shell, never by the physics.

/// One fact. Exactly one `Committed` or `Cancelled` ends every `Lifted`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Event {
    /// Leaves were taken up from the block on this side.
    Lifted {
        /// Taken from the right block.
        from_right: bool,
        /// How many.
        leaves: u32,
    },
    /// A second finger added a leaf to those in the air, or gave one back.
    Held {
        /// How many are held now.
        leaves: u32,
    },
    /// The leaf came to rest on the other side: the book is now open at `page`.
    Committed {
        /// As [`BookSpec::open_at`](crate::scene::BookSpec::open_at).
        page: u32,
    },
    /// The leaf came to rest where it was taken from.
    Cancelled,
    /// Everything is at rest; nothing has to be drawn until the next input.
    Asleep,
}

/// Events a book keeps until they are read; older ones are dropped and counted.
pub const CAPACITY: usize = 16;

/// Events not read yet.
#[derive(Debug, Clone, Default)]
pub struct Events {
    queue: heapless::Deque<Event, CAPACITY>,
    dropped: u32,
}

impl Events {
    /// None.
    pub const EMPTY: Self = Self { queue: heapless::Deque::new(), dropped: 0 };

    pub(crate) fn push(&mut self, event: Event) {
        if self.queue.is_full() {
            let _ = self.queue.pop_front();
            self.dropped = self.dropped.saturating_add(1);
        }
        let _ = self.queue.push_back(event);
    }
    /// The oldest, taken out.
    pub fn take(&mut self) -> Option<Event> {
        self.queue.pop_front()
    }
    /// How many were lost because nobody read them.
    pub fn dropped(&self) -> u32 {
        self.dropped
    }
}
