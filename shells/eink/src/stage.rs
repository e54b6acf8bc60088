//! Where the pages stand on the panel, and where a place above them is seen.

use crate::panel::Panel;
use crate::pose::UNIT;
use crate::rect::Rect;
use dogleaf_core::hand::View;
use dogleaf_core::scene::BookSpec;

/// Half the vertical opening of the camera, and its tangent.
const HALF_DEG: f64 = 10.0;
const HALF_TAN: f64 = 0.176_326_980_708_464_98;
/// Places on the panel are counted in 1/16 pixel.
pub(crate) const SUB: i32 = 16;
/// No vertex is brought further out than this, 1/16 pixel.
const FAR: i64 = 1 << 16;

/// How many pages the panel shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Layout {
    /// Both open pages.
    #[default]
    Spread,
    /// The right page alone.
    Right,
    /// The left page alone.
    Left,
}

/// Why a book cannot be put on a panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StageError {
    /// Its page has no size, or would have fewer than 32 pixels across or down.
    Page,
    /// The panel is none.
    Panel(crate::PanelError),
}

impl core::fmt::Display for StageError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Page => f.write_str("the page is too small for this panel"),
            Self::Panel(why) => why.fmt(f),
        }
    }
}

impl core::error::Error for StageError {}

/// A camera straight above the open page, as high as a reader's eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stage {
    panel: [u16; 2],
    /// Where the left and the right page lie; empty where none is seen.
    pages: [Rect; 2],
    /// Size of a page, pixels.
    page: [u16; 2],
    /// Where the spine's middle is seen, 1/16 pixel.
    spine: [i32; 2],
    /// Height of the eye above the page, [`UNIT`]s a width.
    eye: i32,
    /// `x = spine + X gain / (eye - Y)`, 1/16 pixel.
    gain: i64,
    width_m: f64,
}

/// A place on the panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Place {
    /// From the left and the top, 1/16 pixel.
    pub(crate) x: i32,
    pub(crate) y: i32,
    /// Away from the eye, 14 bits.
    pub(crate) depth: u16,
}

impl Stage {
    /// Puts a book's pages on a panel as large as they fit, in the middle.
    ///
    /// # Errors
    ///
    /// [`StageError`].
    pub fn new(book: &BookSpec, panel: &Panel, layout: Layout) -> Result<Self, StageError> {
        panel.check().map_err(StageError::Panel)?;
        let across = if layout == Layout::Spread { panel.width / 2 } else { panel.width };
        let page = fitted(book, across, panel.height).ok_or(StageError::Page)?;
        let [w, h] = page;
        let top = (panel.height - h) / 2;
        let middle = panel.width / 2;
        let left_edge = match layout {
            Layout::Spread => middle,
            Layout::Right => middle - w / 2,
            Layout::Left => middle - w / 2 + w,
        };
        let none = Rect::NONE;
        let left = Rect::new(left_edge.saturating_sub(w), top, left_edge, top + h);
        let right = Rect::new(left_edge, top, left_edge + w, top + h);
        let pages = match layout {
            Layout::Spread => [left, right],
            Layout::Right => [none, right],
            Layout::Left => [left, none],
        };
        let eye = f64::from(panel.height) * 0.5 / HALF_TAN / f64::from(w) * f64::from(UNIT);
        let spine_y = i32::from(top) * SUB + i32::from(h) * SUB / 2;
        Ok(Self {
            panel: [panel.width, panel.height],
            pages,
            page,
            spine: [i32::from(left_edge) * SUB, spine_y],
            eye: eye as i32,
            gain: eye as i64 * i64::from(w) * i64::from(SUB) / i64::from(UNIT),
            width_m: book.width_m,
        })
    }

    /// The camera for the core's hand, above a page so thick a block high: what is touched is what is seen.
    #[must_use]
    pub fn view(&self, block_m: f64) -> View {
        let metres = self.width_m / f64::from(self.page[0].max(1));
        let off = |at: u16, spine: i32| f64::from(i32::from(at) * SUB / 2 - spine) * metres / 16.0;
        let [x, z] = [off(self.panel[0], self.spine[0]), off(self.panel[1], self.spine[1])];
        let height = f64::from(self.panel[1]) * 0.5 / HALF_TAN * metres;
        View {
            eye_m: [x, block_m + height, z],
            target_m: [x, block_m, z],
            fov_y_deg: 2.0 * HALF_DEG,
            width_px: u32::from(self.panel[0]),
            height_px: u32::from(self.panel[1]),
        }
    }

    /// Where the left and the right page lie; empty where none is seen.
    #[must_use]
    pub fn pages(&self) -> [Rect; 2] {
        self.pages
    }

    /// Size of a page, pixels: the size its picture has to have.
    #[must_use]
    pub fn page(&self) -> [u16; 2] {
        self.page
    }

    /// Everything.
    #[must_use]
    pub fn whole(&self) -> Rect {
        Rect::new(0, 0, self.panel[0], self.panel[1])
    }

    /// Where the spine is seen, pixels from the left.
    #[must_use]
    pub fn spine_x(&self) -> u16 {
        (self.spine[0] / SUB).clamp(0, i32::from(u16::MAX)) as u16
    }

    /// Where the eye is, as a pose has it.
    pub(crate) fn eye(&self) -> [i32; 3] {
        let off = |at: u16, spine: i32| {
            (i32::from(at) * SUB / 2 - spine) * (UNIT / SUB) / i32::from(self.page[0].max(1))
        };
        [off(self.panel[0], self.spine[0]), self.eye, off(self.panel[1], self.spine[1])]
    }

    /// Where a place above the pages is seen.
    pub(crate) fn project(&self, [x, y, z]: [i32; 3]) -> Place {
        // Never closer to the eye than a fifth of its height.
        let away = (self.eye - y).max(self.eye / 5).max(1);
        let seen = |c: i32, middle: i32| {
            let at = i64::from(middle) + i64::from(c) * self.gain / i64::from(away);
            at.clamp(-FAR, FAR) as i32
        };
        let depth = (i64::from(away) * 8_192 / i64::from(self.eye.max(1))).clamp(0, 16_000) as u16;
        Place { x: seen(x, self.spine[0]), y: seen(z, self.spine[1]), depth }
    }
}

/// Pixels of a page that fits the box.
fn fitted(book: &BookSpec, across: u16, down: u16) -> Option<[u16; 2]> {
    let aspect = book.height_m / book.width_m;
    if !(aspect.is_finite() && aspect > 0.0) {
        return None;
    }
    let tall = f64::from(across) * aspect;
    let (w, h) = if tall <= f64::from(down) {
        (f64::from(across), tall)
    } else {
        (f64::from(down) / aspect, f64::from(down))
    };
    let page = [w as u16, h as u16];
    page.iter().all(|&n| n >= 32).then_some(page)
}
