//! What the app is told.

use crate::event::Event;

/// Notices kept until they are read; older ones are dropped and counted.
pub const NOTICES: usize = 32;

/// A haptic tick: what a finger would feel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Tick {
    /// A leaf comes off its block.
    Lift,
    /// It passes the vertical.
    Over,
    /// It lies.
    Land,
    /// One more leaf slips into the hand, or out of it.
    Flip,
}

/// One fact for the app. Exactly one `Committed` or `Cancelled` ends every `Lifted`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
        /// As [`BookSpec::open_at`](crate::scene::BookSpec::open_at).
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
    Tick(Tick),
    /// Everything is at rest; nothing has to be drawn until the next input.
    Asleep,
}

/// Notices not read yet.
#[derive(Debug, Clone)]
pub(super) struct Notices {
    queue: heapless::Deque<Notice, NOTICES>,
    dropped: u32,
}

impl Notices {
    pub(super) const EMPTY: Self = Self { queue: heapless::Deque::new(), dropped: 0 };

    pub(super) fn push(&mut self, notice: Notice) {
        if self.queue.is_full() {
            let _ = self.queue.pop_front();
            self.dropped = self.dropped.saturating_add(1);
        }
        let _ = self.queue.push_back(notice);
    }

    pub(super) fn take(&mut self) -> Option<Notice> {
        self.queue.pop_front()
    }

    pub(super) fn dropped(&self) -> u32 {
        self.dropped
    }

    /// What an event of the book means to the app.
    pub(super) fn tell(&mut self, event: Event, pages: u32) {
        match event {
            Event::Lifted { from_right, leaves } => {
                self.push(Notice::Lifted { from_right, leaves });
                self.push(Notice::Tick(Tick::Lift));
            }
            Event::Held { leaves } => {
                self.push(Notice::Held { leaves });
                self.push(Notice::Tick(Tick::Flip));
            }
            Event::Committed { page } => {
                self.push(Notice::Committed { page });
                self.push(Notice::Tick(Tick::Land));
                self.push(Notice::Announce { page, pages });
            }
            Event::Cancelled => {
                self.push(Notice::Cancelled);
                self.push(Notice::Tick(Tick::Land));
            }
            Event::Asleep => self.push(Notice::Asleep),
        }
    }
}
