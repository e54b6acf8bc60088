//! Animated GIF: plays everywhere, 255 colours a shot.

use std::borrow::Cow;
use std::fs::File;
use std::io::{BufWriter, Write};

use super::Film;
use super::palette::Palette;
use super::shot::{Clock, Shot};
use crate::error::AnimError;

/// Shortest time players respect, hundredths of a second; what is shorter they slow down to ten.
const SHORTEST: u64 = 2;
/// Index for pixels that stay as they are.
const CLEAR: u8 = 255;

/// Less than this is lost in the coding anyway, levels.
const SLACK: u8 = 2;

/// An animated GIF in the making.
pub(super) struct Gif {
    /// Taken when the file is closed.
    encoder: Option<gif::Encoder<BufWriter<File>>>,
}

impl std::fmt::Debug for Gif {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Gif")
    }
}

impl Gif {
    pub(super) fn create(
        file: BufWriter<File>,
        width: u32,
        height: u32,
    ) -> Result<Self, AnimError> {
        let mut encoder =
            gif::Encoder::new(file, width as u16, height as u16, &[]).map_err(|e| failed(&e))?;
        encoder.set_repeat(gif::Repeat::Infinite).map_err(|e| failed(&e))?;
        Ok(Self { encoder: Some(encoder) })
    }
}

impl Film for Gif {
    fn show(&mut self, shot: &Shot) -> Result<(), AnimError> {
        let mut palette = Palette::of(&shot.pixels, usize::from(CLEAR));
        let mut indices = palette.draw(&shot.pixels, shot.rect.width);
        for (index, _) in indices.iter_mut().zip(&shot.same).filter(|(_, same)| **same) {
            *index = CLEAR;
        }
        let frame = gif::Frame {
            delay: shot.lasts(100).min(u64::from(u16::MAX)) as u16,
            dispose: gif::DisposalMethod::Keep,
            transparent: Some(CLEAR),
            left: shot.rect.x as u16,
            top: shot.rect.y as u16,
            width: shot.rect.width as u16,
            height: shot.rect.height as u16,
            palette: Some(palette.bytes()),
            buffer: Cow::Owned(indices),
            ..Default::default()
        };
        match &mut self.encoder {
            Some(encoder) => encoder.write_frame(&frame).map_err(|e| failed(&e)),
            None => Err(failed(&"already closed")),
        }
    }

    fn slack(&self) -> u8 {
        SLACK
    }

    fn skips_same(&self) -> bool {
        true
    }

    fn close(&mut self) -> Result<(), AnimError> {
        let Some(encoder) = self.encoder.take() else { return Ok(()) };
        // Taking the file back writes the trailer.
        let mut file = encoder.into_inner().map_err(|e| failed(&e))?;
        file.flush().map_err(|e| failed(&e))
    }

    fn lasts(&self, clock: Clock, from: u64, to: u64) -> bool {
        clock.at(to, 100) - clock.at(from, 100) >= SHORTEST
    }
}

fn failed(what: &impl std::fmt::Display) -> AnimError {
    AnimError::Encoder { format: "GIF", message: what.to_string() }
}
