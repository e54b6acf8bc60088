//! What the panel looked like: a sheet of pictures in rows, an animation, or a folder.

use crate::error::CliError;
use dogleaf_eink::{Panel, Simulated};
use dogleaf_render::anim::Writer;
use std::path::{Path, PathBuf};

/// Frames a second of an animation: a panel's pictures last a tenth of a second and more.
const FPS: u32 = 20;
const FRAME_US: u32 = 1_000_000 / FPS;
/// How long the first and the last picture stand, frames.
const STAND: u32 = 20;
/// A sheet shows so many in a row, each this much smaller, a gap between them.
const ACROSS: usize = 3;
const SMALLER: usize = 2;
const GAP: usize = 8;
/// Brightness between them.
const GROUND: u8 = 150;

/// Pictures of a panel on their way into a file.
#[derive(Debug)]
pub(super) struct Show {
    out: PathBuf,
    size: [usize; 2],
    /// What the panel looked like, one brightness a pixel, and for how many frames.
    pictures: Vec<(Vec<u8>, u32)>,
    /// Not for a sheet: its size is known at the end.
    writer: Option<Writer>,
}

impl Show {
    pub(super) fn create(out: &Path, panel: &Panel) -> Result<Self, CliError> {
        let size = [panel.width, panel.height].map(usize::from);
        let sheet = out.extension().is_some_and(|e| e.eq_ignore_ascii_case("png"));
        let [w, h] = size.map(|n| n as u32);
        let writer = if sheet { None } else { Some(Writer::create(out, w, h, FPS)?) };
        Ok(Self { out: out.to_owned(), size, pictures: Vec::new(), writer })
    }

    pub(super) fn add(&mut self, glass: &Simulated<'_>, busy_us: u32) -> Result<(), CliError> {
        self.pictures.push((glass.looks().collect(), busy_us.div_ceil(FRAME_US)));
        Ok(())
    }

    pub(super) fn finish(self) -> Result<(), CliError> {
        match self.writer {
            Some(writer) => animate(writer, &self.pictures),
            None => sheet(&self.out, self.size, &self.pictures),
        }
    }
}

fn animate(mut writer: Writer, pictures: &[(Vec<u8>, u32)]) -> Result<(), CliError> {
    let last = pictures.len().saturating_sub(1);
    for (n, (picture, frames)) in pictures.iter().enumerate() {
        let stand = if n == 0 || n == last { STAND } else { *frames };
        let rgb = rgb(picture);
        for _ in 0..stand {
            writer.push(&rgb)?;
        }
    }
    Ok(writer.finish().map(|_| ())?)
}

fn sheet(out: &Path, [w, h]: [usize; 2], pictures: &[(Vec<u8>, u32)]) -> Result<(), CliError> {
    let [sw, sh] = [w / SMALLER, h / SMALLER];
    let width = pictures.len().min(ACROSS) * (sw + GAP) + GAP;
    let height = pictures.len().div_ceil(ACROSS) * (sh + GAP) + GAP;
    let mut all = vec![GROUND; width * height];
    for (n, (picture, _)) in pictures.iter().enumerate() {
        let [left, top] = [GAP + n % ACROSS * (sw + GAP), GAP + n / ACROSS * (sh + GAP)];
        for y in 0..sh {
            for x in 0..sw {
                all[(top + y) * width + left + x] = mean(picture, w, x, y);
            }
        }
    }
    let mut writer = Writer::create(out, width as u32, height as u32, 1)?;
    writer.push(&rgb(&all))?;
    Ok(writer.finish().map(|_| ())?)
}

/// Mean brightness of a square of pixels.
fn mean(picture: &[u8], width: usize, x: usize, y: usize) -> u8 {
    let square = (0..SMALLER).flat_map(|dy| (0..SMALLER).map(move |dx| (dx, dy)));
    let at = |(dx, dy)| (SMALLER * y + dy) * width + SMALLER * x + dx;
    let sum: u32 = square.map(at).filter_map(|i| picture.get(i)).map(|&l| u32::from(l)).sum();
    (sum / (SMALLER * SMALLER) as u32) as u8
}

fn rgb(luma: &[u8]) -> Vec<u8> {
    luma.iter().flat_map(|&l| [l; 3]).collect()
}
