//! The animation of a scene: blank paper, for a scene has no book to read from.

use super::Frame;
use crate::error::CliError;
use crate::picture::{Film, Look, Pages, Set};
use crate::scene::{Body, Scene};
use dogleaf_core::scene::Direction;
use dogleaf_render::anim::Writer;
use std::path::Path;

/// Frames of an animation a second, at most: players make a mess of more.
const MOST_FPS: f64 = 30.0;

/// Frames on their way into an animation.
pub(super) struct Picture {
    look: Look,
    film: Film,
    writer: Writer,
    /// Every so many frames of the scene are shown.
    every: u32,
}

impl Picture {
    pub(super) fn open(out: &Path, scene: &Scene) -> Result<Self, CliError> {
        let (direction, cover) = match scene.body {
            Body::Book(book) => (book.direction, Some(book.cover)),
            Body::Leaf(_) | Body::Nothing => (Direction::Ltr, None),
        };
        let floor_m = scene.ribbons.iter().find_map(|r| r.floor_m);
        let thickness_m = (scene.paper.thickness_mm * 1e-3) as f32;
        let set = Set { view: scene.view, direction, cover, floor_m, thickness_m };
        let rate = 1e6 / f64::from(scene.frame_us);
        let every = (rate / MOST_FPS - 0.01).ceil().max(1.0) as u32;
        let fps = (rate / f64::from(every)).round().max(1.0) as u32;
        let look = Look::new(set, Pages::new(None))?;
        let [width, height] = look.size();
        let writer = Writer::create(out, width, height, fps)?;
        Ok(Self { look, film: Film::default(), writer, every })
    }

    pub(super) fn frame(&mut self, frame: &Frame<'_>) -> Result<(), CliError> {
        if frame.number.is_multiple_of(self.every) {
            self.film.add(frame.sim.shot()?);
        }
        Ok(())
    }

    pub(super) fn finish(mut self) -> Result<(), CliError> {
        self.film.write(&mut self.look, self.writer)
    }
}
