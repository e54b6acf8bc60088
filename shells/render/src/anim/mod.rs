//! Frames into a file: animated WebP, GIF, PNG, or a folder of numbered pictures.
//!
//! Only the part of a frame that changed is written, and a frame equal to the one before only
//! makes that one last longer. Everything is written under a temporary name and renamed at the
//! end, so that a run that fails leaves no half file behind.

mod apng;
mod folder;
mod gif;
mod palette;
mod part;
mod shot;
mod webp;

use std::path::Path;

use crate::error::AnimError;
use part::Part;
use shot::{Clock, Rect, Shot};

/// Highest frame rate that can be written, frames a second.
pub const MAX_FPS: u32 = 240;

/// One format's way to put shots into a file.
trait Film: std::fmt::Debug {
    /// Adds a shot.
    fn show(&mut self, shot: &Shot) -> Result<(), AnimError>;
    /// Completes the file.
    fn close(&mut self) -> Result<(), AnimError>;
    /// Whether a shot of frames `from..to` lasts long enough for the format's players.
    fn lasts(&self, _clock: Clock, _from: u64, _to: u64) -> bool {
        true
    }
    /// Levels by which a pixel may differ from what is on the screen before it is written again.
    fn slack(&self) -> u8 {
        0
    }
    /// Whether pixels that may stay are left out one by one, and not only outside the rectangle.
    fn skips_same(&self) -> bool {
        false
    }
    /// Whether every frame is wanted whole, equal or not.
    fn wants_all(&self) -> bool {
        false
    }
}

/// Writes an animation frame by frame.
///
/// # Shapes and units
///
/// Frames are RGB bytes, sRGB, rows from the top: `3 · width · height` bytes.
///
/// # Example
///
/// ```
/// # fn main() -> Result<(), dogleaf_render::AnimError> {
/// let path = std::env::temp_dir().join("dogleaf_doc_example.webp");
/// let mut writer = dogleaf_render::anim::Writer::create(&path, 16, 16, 30)?;
/// writer.push(&[200; 16 * 16 * 3])?;
/// writer.finish()?;
/// # std::fs::remove_file(path).ok();
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Writer {
    size: (usize, usize),
    clock: Clock,
    film: Box<dyn Film>,
    part: Part,
    /// What is on the screen: the frames that went into shots.
    last: Vec<u8>,
    /// The shot not yet written, because its end is not known.
    open: Option<Shot>,
    /// A frame that came too soon for the format; shown if nothing follows.
    late: Option<Vec<u8>>,
    frames: u64,
}

impl Writer {
    /// Starts an animation. The ending of `path` says which: `.webp`, `.gif`, `.png` (animated PNG), or
    /// none for a folder of pictures `frame_0000.png`, `frame_0001.png`, ..
    ///
    /// # Errors
    ///
    /// [`AnimError::Format`] for another ending, [`AnimError::Shape`] for a size or rate the format
    /// cannot hold, [`AnimError::Io`] if nothing can be written there.
    pub fn create(path: &Path, width: u32, height: u32, fps: u32) -> Result<Self, AnimError> {
        let ending = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
        let ending = if path.is_dir() { None } else { ending };
        let most = match ending.as_deref() {
            Some("webp") => webp::MAX_SIDE,
            Some("gif" | "png") | None => u32::from(u16::MAX),
            Some(_) => return Err(AnimError::Format(path.to_owned())),
        };
        let sides = 1..=most;
        if !(sides.contains(&width) && sides.contains(&height) && (1..=MAX_FPS).contains(&fps)) {
            return Err(AnimError::Shape { width, height, fps });
        }
        let part = Part::new(path);
        let film: Box<dyn Film> = match ending.as_deref() {
            Some("webp") => Box::new(webp::Webp::create(part.open()?, width, height)?),
            Some("gif") => Box::new(gif::Gif::create(part.open()?, width, height)?),
            Some(_) => Box::new(apng::Apng::create(part.open()?, width, height)?),
            None => Box::new(folder::Folder::create(part.make_folder()?, width, height)),
        };
        let size = (width as usize, height as usize);
        Ok(Self {
            size,
            clock: Clock { fps },
            film,
            part,
            last: Vec::new(),
            open: None,
            late: None,
            frames: 0,
        })
    }

    /// Adds a frame.
    ///
    /// # Errors
    ///
    /// [`AnimError::Frame`] if the number of bytes is wrong, [`AnimError::Io`] or [`AnimError::Encoder`]
    /// from writing the frame before.
    pub fn push(&mut self, frame: &[u8]) -> Result<(), AnimError> {
        let needed = self.size.0 * self.size.1 * 3;
        if frame.len() != needed {
            return Err(AnimError::Frame { needed, got: frame.len() });
        }
        self.late = None;
        let start = self.open.as_ref().map(|shot| shot.from);
        match start {
            Some(start) if !self.film.lasts(self.clock, start, self.frames) => {
                self.late = Some(frame.to_vec());
            }
            _ => self.take(frame)?,
        }
        self.frames += 1;
        Ok(())
    }

    /// Frames pushed so far.
    #[must_use]
    pub fn frames(&self) -> u64 {
        self.frames
    }

    /// Completes the file and gives it its name.
    ///
    /// # Errors
    ///
    /// [`AnimError::Empty`] without a frame, [`AnimError::Io`], [`AnimError::Encoder`].
    pub fn finish(mut self) -> Result<(), AnimError> {
        if let Some(frame) = self.late.take() {
            // The last frame is what remains: the one before it is given its time first.
            let start = self.open.as_ref().map_or(0, |shot| shot.from);
            while !self.film.lasts(self.clock, start, self.frames) {
                self.frames += 1;
            }
            self.take(&frame)?;
            self.frames += 1;
        }
        self.cut()?;
        if self.frames == 0 {
            return Err(AnimError::Empty);
        }
        self.film.close()?;
        self.part.keep()
    }

    /// Begins a new shot with what changed in `frame`, if anything did.
    fn take(&mut self, frame: &[u8]) -> Result<(), AnimError> {
        let whole = Rect { x: 0, y: 0, width: self.size.0, height: self.size.1 };
        let (width, slack) = (self.size.0, self.film.slack());
        let rect = if self.last.is_empty() || self.film.wants_all() {
            Some(whole)
        } else {
            Rect::changed(&self.last, frame, width, slack)
        };
        let Some(rect) = rect else { return Ok(()) };
        self.cut()?;
        let rect = rect.even(self.size);
        let same = rect.unchanged(&self.last, frame, width, slack);
        let pixels = rect.crop(frame, width);
        self.keep_shown(frame, rect, &same);
        self.open = Some(Shot {
            rect,
            pixels,
            same,
            from: self.frames,
            to: self.frames,
            clock: self.clock,
        });
        Ok(())
    }

    /// Remembers what will be on the screen, so that small changes cannot add up unseen.
    fn keep_shown(&mut self, frame: &[u8], rect: Rect, same: &[bool]) {
        if self.last.is_empty() {
            self.last.extend_from_slice(frame);
            return;
        }
        let skip = self.film.skips_same();
        for (row, line) in rect.rows(self.size.0).enumerate() {
            for (i, at) in line.step_by(3).enumerate() {
                if !(skip && same[row * rect.width + i]) {
                    self.last[at..at + 3].copy_from_slice(&frame[at..at + 3]);
                }
            }
        }
    }

    /// Writes the open shot, which ends now.
    fn cut(&mut self) -> Result<(), AnimError> {
        match self.open.take() {
            Some(shot) => self.film.show(&Shot { to: self.frames, ..shot }),
            None => Ok(()),
        }
    }
}
