//! A panel of numbers: what its pixels were told, and what they look like. For tests, firmware on emulators, documents.
//!
//! A real pixel keeps a share of what it looked like before. The shares here are round numbers of the order in which
//! panels differ, not one maker's.
//!
//! | driven by | keeps of the difference | which pixels are driven |
//! |---|---|---|
//! | `A2` from two tones; from grey | 12 %; 35 % | those that change |
//! | `Du` | 8 % | those that change |
//! | `Gl16` | 4 % | all but those that stay white |
//! | `Glr16` | 3 % | all |
//! | `Gc16` | 0 | all |

use crate::panel::{Panel, Waveform};
use crate::rect::Rect;
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Size};
use embedded_graphics_core::pixelcolor::{Gray4, GrayColor};

/// One pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cell {
    /// What the controller is to show next, 0 black to 15 white.
    next: u8,
    /// What it last drove the pixel to.
    told: u8,
    /// What the pixel looks like, 0 to 255.
    looks: u8,
}

/// How far a panel looks from what it was told.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Ghost {
    /// The worst pixel, of 255.
    pub worst: u8,
    /// The mean, in thousandths of 255.
    pub mean_permille: u32,
    /// Pixels off by more than a tenth.
    pub seen: u32,
}

/// What the panel has done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Pictures, in the order of [`Waveform::ALL`].
    pub pictures: [u32; 5],
    /// Pixels that were driven.
    pub driven: u64,
    /// Microseconds it was busy.
    pub busy_us: u64,
}

/// A panel; its pixels are the caller's.
#[derive(Debug)]
pub struct Simulated<'a> {
    panel: Panel,
    cells: &'a mut [Cell],
    counts: Counts,
}

impl Cell {
    /// Mid grey: a panel nobody has driven yet.
    pub const NEW: Self = Self { next: 15, told: 8, looks: 128 };

    fn drive(&mut self, waveform: Waveform) -> bool {
        let aim = match waveform.is_two_tone() {
            true if self.next >= 8 => 15,
            true => 0,
            false => self.next,
        };
        let (grey, same) = (!matches!(self.told, 0 | 15), aim == self.told);
        let keeps = match waveform {
            Waveform::A2 | Waveform::Du if same => return false,
            Waveform::Gl16 if same && aim == 15 => return false,
            Waveform::A2 if grey => 90,
            Waveform::A2 => 31,
            Waveform::Du => 20,
            Waveform::Gl16 => 10,
            Waveform::Glr16 => 8,
            Waveform::Gc16 => 0,
        };
        let (to, from) = (i32::from(aim) * 17, i32::from(self.looks));
        self.looks = (to + (from - to) * keeps / 256).clamp(0, 255) as u8;
        self.told = aim;
        true
    }
}

impl<'a> Simulated<'a> {
    /// A panel on a caller's pixels; none if these are too few.
    #[must_use]
    pub fn new(panel: Panel, cells: &'a mut [Cell]) -> Option<Self> {
        let cells = cells.get_mut(..usize::from(panel.width) * usize::from(panel.height))?;
        cells.fill(Cell::NEW);
        Some(Self { panel, cells, counts: Counts::default() })
    }

    /// A panel whose pixels are already in use; what it has done is counted anew.
    #[must_use]
    pub fn again(panel: Panel, cells: &'a mut [Cell]) -> Option<Self> {
        let cells = cells.get_mut(..usize::from(panel.width) * usize::from(panel.height))?;
        Some(Self { panel, cells, counts: Counts::default() })
    }

    /// The panel it is.
    #[must_use]
    pub fn panel(&self) -> &Panel {
        &self.panel
    }

    /// Drives the pixels of a rectangle to what was drawn there.
    pub fn refresh(&mut self, rect: Rect, waveform: Waveform) {
        let mut driven = 0;
        for cell in rows(self.cells, self.panel.width, rect).flatten() {
            driven += u64::from(cell.drive(waveform));
        }
        self.counts.driven += driven;
        self.counts.busy_us += u64::from(self.panel.takes_us(waveform));
        let which = Waveform::ALL.iter().position(|(_, w)| *w == waveform);
        if let Some(count) = which.and_then(|n| self.counts.pictures.get_mut(n)) {
            *count += 1;
        }
    }

    /// What it has done so far.
    #[must_use]
    pub fn counts(&self) -> Counts {
        self.counts
    }

    /// What each pixel looks like, row by row, 0 to 255.
    pub fn looks(&self) -> impl Iterator<Item = u8> + '_ {
        self.cells.iter().map(|c| c.looks)
    }

    /// What each pixel was told, row by row, 0 to 15.
    pub fn told(&self) -> impl Iterator<Item = u8> + '_ {
        self.cells.iter().map(|c| c.told)
    }

    /// How far it looks from what it was told.
    #[must_use]
    pub fn ghost(&self) -> Ghost {
        let mut ghost = Ghost::default();
        let mut sum = 0_u64;
        for cell in &*self.cells {
            let off = cell.looks.abs_diff(cell.told * 17);
            ghost.worst = ghost.worst.max(off);
            ghost.seen += u32::from(off > 25);
            sum += u64::from(off);
        }
        let all = self.cells.len().max(1) as u64 * 255;
        ghost.mean_permille = (sum * 1_000 / all) as u32;
        ghost
    }
}

fn rows(cells: &mut [Cell], width: u16, rect: Rect) -> impl Iterator<Item = &mut [Cell]> {
    let columns = usize::from(rect.x0)..usize::from(rect.x1);
    let all = cells.chunks_exact_mut(usize::from(width).max(1));
    let some = all.skip(usize::from(rect.y0)).take(usize::from(rect.height()));
    some.map(move |row| row.get_mut(columns.clone()).unwrap_or_default())
}

impl OriginDimensions for Simulated<'_> {
    fn size(&self) -> Size {
        Size::new(u32::from(self.panel.width), u32::from(self.panel.height))
    }
}

impl DrawTarget for Simulated<'_> {
    type Color = Gray4;
    type Error = core::convert::Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Pixel<Self::Color>>,
    {
        let width = usize::from(self.panel.width);
        for Pixel(at, colour) in pixels {
            let (Ok(x), Ok(y)) = (usize::try_from(at.x), usize::try_from(at.y)) else { continue };
            if x >= width {
                continue;
            }
            if let Some(cell) = self.cells.get_mut(y * width + x) {
                cell.next = colour.luma();
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(
        &mut self,
        area: &embedded_graphics_core::primitives::Rectangle,
        colors: I,
    ) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Self::Color>,
    {
        let mut colours = colors.into_iter();
        let rect = seen(area, self.panel);
        for cell in rows(self.cells, self.panel.width, rect).flatten() {
            let Some(colour) = colours.next() else { break };
            cell.next = colour.luma();
        }
        Ok(())
    }
}

/// A rectangle of `embedded-graphics` that lies on the panel: our own do.
fn seen(area: &embedded_graphics_core::primitives::Rectangle, panel: Panel) -> Rect {
    let place = |n: i32| n.clamp(0, i32::from(u16::MAX)) as u16;
    let (x, y) = (place(area.top_left.x), place(area.top_left.y));
    let far = |from: u16, size: u32| from.saturating_add(size.min(u32::from(u16::MAX)) as u16);
    Rect::new(x, y, far(x, area.size.width), far(y, area.size.height)).intersection(panel.whole())
}
