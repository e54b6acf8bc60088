//! An eye on a book while it moves: what a test wants to know about a run, counted once for all tests.

use crate::depth::deepest;
use dogleaf_core::Book;
use dogleaf_core::event::Event;
use dogleaf_core::grid::Grid;
use dogleaf_core::real::Real;
use dogleaf_core::step::{StepReport, StepStatus};

/// Ratios of an edge to its rest length that a sheet of paper can have.
pub const BAND: (f64, f64) = (0.5, 1.6);

/// Stretch over many pictures.
#[derive(Debug, Clone, Copy, Default)]
pub struct Figures {
    sum_max: f64,
    sum_sq: f64,
    /// Pictures with a leaf in the air.
    pub frames: u32,
    /// Largest magnitude of all.
    pub worst: f64,
}

impl Figures {
    fn take(&mut self, max: f64, rms: f64) {
        self.sum_max += max;
        self.sum_sq += rms * rms;
        self.frames += 1;
        self.worst = if max > self.worst { max } else { self.worst };
    }
    /// Adds another run.
    pub fn add(&mut self, o: &Self) {
        self.sum_max += o.sum_max;
        self.sum_sq += o.sum_sq;
        self.frames += o.frames;
        self.worst = self.worst.max(o.worst);
    }
    /// Mean over the pictures of each one's largest magnitude.
    pub fn mean_max(&self) -> f64 {
        self.sum_max / f64::from(self.frames.max(1))
    }
    /// Root mean square over all edges of all pictures.
    pub fn rms(&self) -> f64 {
        (self.sum_sq / f64::from(self.frames.max(1))).sqrt()
    }
}

/// What was seen of one run.
#[derive(Debug, Clone, Default)]
pub struct Watch {
    /// Pictures seen.
    pub frames: u32,
    /// Stretch over the pictures with a leaf in the air.
    pub air: Figures,
    /// Stretch over those in which a finger held it.
    pub drag: Figures,
    /// All work together, and the worst status.
    pub work: StepReport,
    /// Pictures by status.
    pub statuses: [u32; 6],
    /// The last picture's status.
    pub last: StepStatus,
    /// Everything that happened.
    pub events: Vec<Event>,
    /// The first picture in which everything slept after the last time it did not.
    pub rest: Option<u32>,
    /// Highest a node of the last leaf seen was above its block, page widths: what its merging smooths out.
    pub gap: f64,
    /// Deepest a node of a leaf lay inside a block, page widths.
    pub sunk: f64,
    /// The blocks fold over themselves: how deep a leaf is in them has no answer.
    pub folded: bool,
    /// First complaint about a state no book may be in.
    pub complaint: Option<String>,
}

impl Watch {
    /// Looks at a book after a picture, and takes its events.
    pub fn see<R: Real, G: Grid>(&mut self, book: &mut Book<R, G>, report: &StepReport) {
        self.frames += 1;
        self.work.add(report);
        self.last = report.status;
        if let Some(count) = self.statuses.get_mut(report.status as usize) {
            *count += 1;
        }
        self.events.extend(core::iter::from_fn(|| book.take_event()));
        self.stretch(book);
        self.rest = (!book.needs_frame()).then(|| self.rest.unwrap_or(self.frames));
        if self.complaint.is_none() {
            let what = fault(book).or_else(|| self.sinks(book));
            self.complaint = what.map(|what| format!("picture {}: {what}", self.frames));
        }
    }

    fn stretch<R: Real, G: Grid>(&mut self, book: &Book<R, G>) {
        let Some(leaf) = book.leaf() else { return };
        let nodes = (0..G::NX).flat_map(|i| (0..G::NZ).map(move |k| (i, k)));
        let top = nodes.fold(R::ZERO, |m, (i, k)| m.larger(leaf.x.at(i, k).0[1]));
        let side = usize::from(leaf.x.at(G::NX - 1, 0).0[0] > R::ZERO);
        self.gap = (top - book.binding().thickness()[side]).wide() / 12.0;
        if !matches!(self.last, StepStatus::Held | StepStatus::Recovered) {
            self.sunk = self.sunk.max(deepest(book) / 12.0);
        }
        let s = book.stretch();
        self.air.take(s.max().wide(), s.rms().wide());
        if book.held().is_some() {
            self.drag.take(s.max().wide(), s.rms().wide());
        }
    }

    /// Deeper in a block than half a leaf after the collision passes; a pose that was kept had none.
    fn sinks<R: Real, G: Grid>(&self, book: &Book<R, G>) -> Option<String> {
        let kept = matches!(self.last, StepStatus::Held | StepStatus::Recovered);
        let (depth, half) = (deepest(book), book.binding().half_held().wide());
        (!kept && !self.folded && depth > half)
            .then(|| format!("{depth:.4} deep in a block, half a leaf is {half:.4}"))
    }

    /// How often leaves were taken up, came to lie on the other side, came back.
    pub fn turns(&self) -> [usize; 3] {
        let count = |is: fn(&Event) -> bool| self.events.iter().filter(|e| is(e)).count();
        [
            count(|e| matches!(e, Event::Lifted { .. })),
            count(|e| matches!(e, Event::Committed { .. })),
            count(|e| matches!(e, Event::Cancelled)),
        ]
    }
    /// The page the last turn opened.
    pub fn page(&self) -> Option<u32> {
        self.events.iter().rev().find_map(|e| match e {
            Event::Committed { page } => Some(*page),
            _ => None,
        })
    }
    /// Pictures in which the last good pose had to be kept.
    pub fn kept(&self) -> u32 {
        self.statuses[StepStatus::Held as usize] + self.statuses[StepStatus::Recovered as usize]
    }
}

/// What no book may be, whatever is done to it: not finite, out of the band, of other than its leaves.
pub fn fault<R: Real, G: Grid>(book: &Book<R, G>) -> Option<String> {
    let strips = book.blocks().iter().flat_map(|b| b.x.iter().chain(&b.v));
    let boards = book.boards().into_iter().flatten().flat_map(|b| b.x.iter().chain(&b.v));
    if !strips.chain(boards).flat_map(|v| v.0).all(Real::finite) {
        return Some("a block is not finite".into());
    }
    let (own, all) = (book.spec().leaves(), book.binding().all());
    if own != all {
        return Some(format!("{all} leaves of {own}"));
    }
    if let Err(error) = book.spec().check() {
        return Some(format!("open at page {}: {error}", book.spec().open_at));
    }
    let leaf = book.leaf()?;
    if !(leaf.x.finite() && leaf.v.finite() && leaf.pushed.finite()) {
        return Some("the leaf is not finite".into());
    }
    let s = book.stretch();
    let (least, most) = (1.0 + s.smallest.wide(), 1.0 + s.largest.wide());
    (least < BAND.0 || most > BAND.1).then(|| format!("edges from {least:.2} to {most:.2} of rest"))
}
