//! Shots into an animation, in order; what did not change is not drawn again.

use super::{Look, Shot};
use crate::error::CliError;
use crate::progress;
use dogleaf_render::anim::Writer;

/// A shot and for how many frames it stands.
#[derive(Debug)]
struct Take {
    shot: Shot,
    frames: u32,
}

/// Shots kept until the physics is done.
#[derive(Debug, Default)]
pub(crate) struct Film {
    takes: Vec<Take>,
}

impl Film {
    /// One more frame.
    pub(crate) fn add(&mut self, shot: Shot) {
        match self.takes.last_mut() {
            Some(last) if last.shot == shot => last.frames += 1,
            _ => self.takes.push(Take { shot, frames: 1 }),
        }
    }

    /// The last shot stands for some frames more.
    pub(crate) fn hold(&mut self, frames: u32) {
        if let Some(last) = self.takes.last_mut() {
            last.frames += frames;
        }
    }

    /// Draws every shot and completes the animation.
    pub(crate) fn write(&self, look: &mut Look, mut writer: Writer) -> Result<(), CliError> {
        let bar = progress::bar(self.takes.len() as u64, "drawing");
        for take in &self.takes {
            let picture = look.draw(&take.shot)?;
            for _ in 0..take.frames {
                writer.push(picture)?;
            }
            bar.inc(1);
        }
        bar.finish_and_clear();
        writer.finish()?;
        Ok(())
    }
}
