//! The ribbon bookmark of `--ribbon`: laid before the first frame, moved by the book, drawn beside it.

use crate::bench::times;
use crate::error::CliError;
use crate::picture::{Shot, band_shot};
use crate::scene::Fabric;
use dogleaf_core::Book;
use dogleaf_core::effect::ribbon::bookmark::{Bookmark, BookmarkSpec, Layer};
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::Sample;
use dogleaf_core::real::Real;
use dogleaf_core::scene::{BookSpec, Direction};
use std::time::Instant;

/// A step of the book, microseconds.
const STEP_US: u32 = 16_667;
/// Steps at most until it lies before the first frame.
const LAYING: u32 = 360;

/// What is told of it.
#[derive(Debug)]
pub(super) struct Figures {
    micros: Vec<f64>,
    newton_steps: u64,
    /// The page read last where it lies.
    pub(super) marks: u32,
    pub(super) lies: &'static str,
}

impl Figures {
    /// Median and 99th percentile.
    pub(super) fn step_us(&self) -> [f64; 2] {
        let figures = times::figures(&self.micros);
        [figures.median, figures.p99]
    }
    /// Steps it took beside the turn.
    pub(super) fn steps(&self) -> u32 {
        self.micros.len() as u32
    }
    /// Newton steps a step.
    pub(super) fn newton_steps(&self) -> f64 {
        self.newton_steps as f64 / self.micros.len().max(1) as f64
    }
}

/// Leaves on the left of a bookmark at a page; at page 0, where the book is open.
pub(super) fn place(page: u32, book: &BookSpec) -> Result<u32, CliError> {
    if page > book.pages {
        return Err(CliError::Call(format!("--ribbon={page}: the last page is {}", book.pages)));
    }
    let open_at = if page == 0 { book.open_at } else { page };
    let read = BookSpec { open_at, ..*book }.read();
    Ok(if book.direction == Direction::Ltr { read } else { book.leaves() - read })
}

/// The page read last where so many leaves lie on the left.
fn page(place: u32, book: &BookSpec) -> u32 {
    2 * if book.direction == Direction::Ltr { place } else { book.leaves() - place }
}

/// A bookmark, once there is one.
#[derive(Debug, Default)]
pub(super) struct Sewn {
    bookmark: Option<Box<Bookmark<f32, G11x8>>>,
    /// From the middle of the leaves to head and tail, metres.
    half_m: f64,
    micros: Vec<f64>,
    newton_steps: u64,
}

impl Sewn {
    /// Beside step 0 it is sewn in and comes to lie; then it follows.
    pub(super) fn follow(
        &mut self,
        step: u64,
        book: &Book<f32, G11x8>,
        place: u32,
    ) -> Result<(), CliError> {
        if step == 0 {
            let mut bookmark = Box::new(Bookmark::EMPTY);
            bookmark.open(&BookmarkSpec { place, ..BookmarkSpec::default() }, book)?;
            for _ in 0..LAYING {
                if !bookmark.needs_frame() {
                    break;
                }
                let _ = bookmark.follow(book, STEP_US);
            }
            (self.bookmark, self.half_m) = (Some(bookmark), 0.5 * book.spec().height_m);
            return Ok(());
        }
        let Some(bookmark) = &mut self.bookmark else { return Ok(()) };
        let start = Instant::now();
        let report = bookmark.follow(book, STEP_US);
        if report.trials > 0 {
            self.micros.push(start.elapsed().as_nanos() as f64 * 1e-3);
            self.newton_steps += u64::from(report.iterations);
        }
        Ok(())
    }

    /// Whether a sample is the bookmark's, and not the book's.
    pub(super) fn takes(&mut self, book: &Book<f32, G11x8>, sample: &Sample) -> bool {
        self.bookmark.as_mut().is_some_and(|b| b.touch(book, sample))
    }

    /// Whether it has yet to come to lie.
    pub(super) fn moves(&self) -> bool {
        self.bookmark.as_ref().is_some_and(|b| b.needs_frame())
    }

    /// The shot with the bookmark in it.
    pub(super) fn beside(&self, mut shot: Shot) -> Shot {
        if let Some(bookmark) = &self.bookmark {
            let all: Vec<_> =
                bookmark.pairs().map(|pair| pair.map(|p| p.0.map(Real::wide))).collect();
            // Between leaves nobody sees it: what comes out at the head, and at the tail.
            let mut inside = (0..all.len()).filter(|&j| bookmark.hidden(j));
            let first = inside.next().unwrap_or(all.len() - 1);
            let last = inside.next_back().unwrap_or(first);
            for seen in [0..first + 1, last..all.len()] {
                let mut rims = all[seen.clone()].to_vec();
                if seen.len() < all.len() {
                    self.cut(&mut rims, seen.start == 0);
                }
                if rims.len() > 1 {
                    shot.bands.push(band_shot(&rims, Fabric::Satin));
                }
            }
        }
        shot
    }

    /// Cuts what goes in between the leaves where they end, rim by rim.
    fn cut(&self, rims: &mut [[[f64; 3]; 2]], head: bool) {
        if head {
            rims.reverse();
        }
        let beyond = |p: &[f64; 3]| p[2].abs() - self.half_m;
        for rim in 0..2 {
            let Some(first) = rims.iter().position(|pair| beyond(&pair[rim]) > 0.0) else {
                continue;
            };
            let Some(inner) = first.checked_sub(1).map(|j| rims[j][rim]) else { continue };
            let outer = rims[first][rim];
            let share = beyond(&outer) / (beyond(&outer) - beyond(&inner));
            let edge = std::array::from_fn(|i| outer[i] + (inner[i] - outer[i]) * share);
            rims[..first].iter_mut().for_each(|pair| pair[rim] = edge);
        }
        if head {
            rims.reverse();
        }
    }

    /// What it came to.
    pub(super) fn figures(self, book: &Book<f32, G11x8>) -> Option<Figures> {
        let bookmark = self.bookmark?;
        let lies = match Layer::of(book, bookmark.place()) {
            Layer::Open(_) => "on the open pages",
            Layer::Block(0) => "between leaves on the left",
            Layer::Block(_) => "between leaves on the right",
            Layer::Held => "between leaves in the air",
        };
        let marks = page(bookmark.place(), book.spec());
        Some(Figures { micros: self.micros, newton_steps: self.newton_steps, marks, lies })
    }
}
