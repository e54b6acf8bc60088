//! Which pictures of a turn are shown: when, where on the panel, with which waveform.
//!
//! | rule | why |
//! |---|---|
//! | a key frame only where the leaf has come an equal share of its way since the last one | the direction is to be read off three pictures |
//! | none while the panel is busy | it would be drawn over half a picture |
//! | its rectangle holds the leaf and the leaf before | nothing half erased stays |
//! | the first one takes greys to two tones (`Du`) wherever the leaf may go, the others are `A2` | `A2` from grey leaves ghosts |
//! | at rest, everything touched once more in greys (`Glr16`, else `Gl16`) | the page is exact, and its white is white |
//! | after so many partial pictures the whole panel (`Gc16`) | what was not driven keeps its ghost |

use crate::panel::{Panel, Waveform};
use crate::pose::Faces;
use crate::rect::Rect;

/// What moves over the panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Style {
    /// The leaf itself.
    #[default]
    Leaf,
    /// A stripe a picture: the page after the turn comes where the leaf's edge has been, and nothing else changes.
    Stripe,
}

/// How much motion a reader wants to see on this panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Policy {
    /// What moves.
    pub style: Style,
    /// Key frames of a turn at most, 1 to 12; a panel that is slow gets fewer.
    pub key_frames: u8,
    /// How long a turn may keep the panel busy, the settled page included, microseconds.
    pub turn_us: u32,
    /// Partial pictures after which the next settled page is a full refresh.
    pub full_after: u16,
}

/// Which picture is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Picture {
    /// The turn as it is now, in two tones.
    Moving,
    /// The open pages.
    Settled,
}

/// One picture for the panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Update {
    /// What changes; whole columns of eight pixels.
    pub rect: Rect,
    /// How.
    pub waveform: Waveform,
    /// What is shown.
    pub picture: Picture,
    /// How long the panel is busy with it, microseconds.
    pub busy_us: u32,
}

/// The leaf in the air, as the planner sees it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Aloft {
    /// How far over: [`Pose::progress`](crate::Pose::progress).
    pub progress: u16,
    /// Every pixel it or its shadow may cover.
    pub reach: Rect,
    /// Where the middle of its fore-edge is seen, pixels from the left.
    pub edge_x: u16,
    /// A finger holds it: it may go back and forth, and is followed as long as it does.
    pub held: bool,
}

/// The key frame that is on the panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Shown {
    progress: u16,
    reach: Rect,
    edge_x: u16,
}

/// What is on the panel, and what is to come. Some 100 bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Planner {
    panel: Panel,
    policy: Policy,
    /// Where the two pages lie, both together.
    pages: Rect,
    /// What the settled picture shows; none before the first.
    settled: Option<Faces>,
    shown: Option<Shown>,
    /// Part of the panel that shows two tones.
    two_tone: Rect,
    /// Part that moving pictures have touched.
    touched: Rect,
    /// Key frames since the leaf was let go.
    free: u8,
    partial: u16,
    busy_until_us: u64,
}

impl Policy {
    /// Three or four key frames, a second in all, a full refresh every sixth turn or so.
    pub const READER: Self =
        Self { style: Style::Leaf, key_frames: 4, turn_us: 1_100_000, full_after: 24 };

    /// The fewest pixels that show which way it goes.
    pub const STRIPE: Self = Self { style: Style::Stripe, ..Self::READER };

    /// Key frames of a free turn that fit its time on a panel: at least one.
    #[must_use]
    pub fn keys(&self, panel: &Panel) -> u8 {
        let settled = panel.takes_us(settled(panel, false));
        let left = self.turn_us.saturating_sub(settled).saturating_sub(panel.du_us);
        let fit = 1 + left / panel.frame_us().max(1);
        fit.min(u32::from(self.key_frames.clamp(1, 12))) as u8
    }

    /// Progress at which key frame `n` of `keys` is taken: equal shares, but never upright, where nothing tells the
    /// direction.
    #[must_use]
    pub fn threshold(n: u8, keys: u8) -> u16 {
        const UPRIGHT: [u16; 2] = [430, 594];
        let even = 1_024 * (u16::from(n) + 1) / (u16::from(keys) + 1);
        match even {
            431..=512 => UPRIGHT[0],
            513..=593 => UPRIGHT[1],
            _ => even,
        }
    }

    /// Progress at which the key frame after one at `last` is due; none if there is no more.
    #[must_use]
    pub fn next(&self, last: u16, keys: u8) -> Option<u16> {
        (0..keys).map(|n| Self::threshold(n, keys)).find(|&t| t > last)
    }
}

/// The waveform of a settled page.
fn settled(panel: &Panel, full: bool) -> Waveform {
    match (full, panel.grey, panel.glr16_us) {
        (true, ..) => Waveform::Gc16,
        (false, true, Some(_)) => Waveform::Glr16,
        (false, true, None) => Waveform::Gl16,
        (false, false, _) => Waveform::Du,
    }
}

impl Planner {
    /// A panel that shows nothing yet. `pages`: where pages lie on it.
    #[must_use]
    pub fn new(panel: Panel, policy: Policy, pages: [Rect; 2]) -> Self {
        let [left, right] = pages;
        Self {
            panel,
            policy,
            pages: left.union(right),
            settled: None,
            shown: None,
            two_tone: Rect::NONE,
            touched: Rect::NONE,
            free: 0,
            partial: 0,
            busy_until_us: 0,
        }
    }

    /// What the panel is to show now, if anything. It is then taken to be busy with it.
    ///
    /// Asked at any time, as often as one likes; what there is to say depends on the leaf and the time alone.
    pub fn look(&mut self, now_us: u64, faces: &Faces, leaf: Option<&Aloft>) -> Option<Update> {
        if now_us < self.busy_until_us {
            return None;
        }
        let update = match leaf {
            Some(leaf) if self.settled.is_some() => self.follow(leaf)?,
            Some(_) => return None,
            None => self.settle(faces)?,
        };
        self.busy_until_us = now_us.saturating_add(u64::from(update.busy_us));
        Some(update)
    }

    /// Whether a leaf that has come so far would be shown now: worth asking before it is looked at closely.
    #[must_use]
    pub fn is_due(&self, now_us: u64, progress: u16, held: bool) -> bool {
        now_us >= self.busy_until_us && self.settled.is_some() && self.is_far(progress, held)
    }

    /// When the panel is done with what it shows.
    #[must_use]
    pub fn busy_until_us(&self) -> u64 {
        self.busy_until_us
    }

    /// Whether the panel shows something else than these pages at rest: it has to be asked again.
    #[must_use]
    pub fn owes(&self, faces: &Faces) -> bool {
        !self.touched.is_empty() || !self.shows(faces)
    }

    /// What the panel shows is lost (it was off, something else was drawn): the next page is a full refresh.
    pub fn forget(&mut self) {
        self.rest();
        (self.settled, self.partial) = (None, 0);
    }

    /// No leaf is on the panel any more.
    fn rest(&mut self) {
        (self.shown, self.free) = (None, 0);
        (self.two_tone, self.touched) = (Rect::NONE, Rect::NONE);
    }

    /// Partial pictures since the last full refresh.
    #[must_use]
    pub fn partial(&self) -> u16 {
        self.partial
    }

    fn shows(&self, faces: &Faces) -> bool {
        self.settled.is_some_and(|s| [s.left, s.right] == [faces.left, faces.right])
    }

    /// A key frame, if the leaf has come far enough.
    fn follow(&mut self, leaf: &Aloft) -> Option<Update> {
        if !self.is_far(leaf.progress, leaf.held) {
            return None;
        }
        self.free = if leaf.held { 0 } else { self.free + 1 };
        let before = self.shown.replace(Shown {
            progress: leaf.progress,
            reach: leaf.reach,
            edge_x: leaf.edge_x,
        });
        let rect = match self.policy.style {
            Style::Leaf => before.map_or(Rect::NONE, |b| b.reach).union(leaf.reach),
            Style::Stripe => self.stripe(before, leaf),
        };
        let rect = rect.aligned(self.panel.width);
        if rect.is_empty() {
            return None;
        }
        Some(self.moving(rect))
    }

    /// The leaf has come a share of its way since the last picture.
    fn is_far(&self, progress: u16, held: bool) -> bool {
        let keys = self.policy.keys(&self.panel);
        let last = self.shown.map_or(0, |s| s.progress);
        if held {
            return progress.abs_diff(last) >= 1_024 / (u16::from(keys) + 1);
        }
        // The next share of the way that is not behind it yet.
        let next = self.policy.next(last, keys);
        self.free < keys && next.is_some_and(|t| progress >= t)
    }

    /// Columns the edge has passed since the last picture.
    fn stripe(&self, before: Option<Shown>, leaf: &Aloft) -> Rect {
        let pages = self.pages;
        let inside = |x: u16| x.max(pages.x0).min(pages.x1);
        let from = before.map_or_else(
            || if leaf.edge_x > pages.x0 + pages.width() / 2 { pages.x1 } else { pages.x0 },
            |b| inside(b.edge_x),
        );
        let to = inside(leaf.edge_x);
        Rect::new(from.min(to), pages.y0, from.max(to), pages.y1)
    }

    fn moving(&mut self, rect: Rect) -> Update {
        let fast = self.panel.a2_us.is_some() && self.two_tone.holds(&rect);
        let (rect, waveform) = if fast {
            (rect, Waveform::A2)
        } else if self.panel.a2_us.is_some() && self.policy.style == Style::Leaf {
            // Wherever the leaf may go: after this `A2` will do.
            let swept = rect.union(self.pages).union(self.two_tone).aligned(self.panel.width);
            self.two_tone = swept;
            (swept, Waveform::Du)
        } else {
            (rect, Waveform::Du)
        };
        self.touched = self.touched.union(rect);
        self.partial = self.partial.saturating_add(1);
        self.update(rect, waveform, Picture::Moving)
    }

    /// The open pages, if the panel does not show them as they are.
    fn settle(&mut self, faces: &Faces) -> Option<Update> {
        if !self.owes(faces) {
            return None;
        }
        let full = self.settled.is_none() || self.partial >= self.policy.full_after;
        let turned = if self.shows(faces) { Rect::NONE } else { self.pages };
        let part = self.touched.union(turned).aligned(self.panel.width);
        let rect = if full { self.panel.whole() } else { part };
        self.settled = Some(*faces);
        self.rest();
        self.partial = if full { 0 } else { self.partial.saturating_add(1) };
        Some(self.update(rect, settled(&self.panel, full), Picture::Settled))
    }

    fn update(&self, rect: Rect, waveform: Waveform, picture: Picture) -> Update {
        Update { rect, waveform, picture, busy_us: self.panel.takes_us(waveform) }
    }
}
