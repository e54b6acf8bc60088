//! A book as a scene.

use super::{Bytes, Energy, LeafNodes, Pose, Recording, Sim};
use crate::error::CliError;
use crate::picture::{Shot, book_indices, book_shot};
use crate::scene::Scene;
use dogleaf_core::Book;
use dogleaf_core::grid::Grid;
use dogleaf_core::hand::Sample;
use dogleaf_core::real::{Real, V2};
use dogleaf_core::record::{Recorder, Setup};
use dogleaf_core::scene::{BookSpec, Fidelity, Formulation, Handling};
use dogleaf_core::step::StepReport;
use std::sync::Arc;

struct BookSim<R: Real, G: Grid> {
    book: Book<R, G>,
    setup: Setup,
    indices: Arc<[u16]>,
    recorder: Option<Recorder<Bytes>>,
    /// The recorder took everything so far.
    complete: bool,
}

/// Opens the book of a scene.
pub(super) fn build<R: Real, G: Grid>(
    scene: &Scene,
    book: &BookSpec,
    fidelity: Fidelity,
) -> Result<Box<dyn Sim>, CliError> {
    let setup = Setup {
        book: *book,
        paper: scene.paper,
        world: scene.world,
        view: scene.view,
        fidelity,
        formulation: Formulation::Condensed,
        handling: Handling::default(),
    };
    let book = Book::<R, G>::EMPTY;
    let indices = book_indices::<G>()?;
    let mut sim = Box::new(BookSim { book, setup, indices, recorder: None, complete: true });
    setup.open(&mut sim.book)?;
    Ok(sim)
}

impl<R: Real, G: Grid> Sim for BookSim<R, G> {
    fn input(&mut self, sample: Sample) -> bool {
        if let Some(recorder) = &mut self.recorder {
            self.complete &= recorder.input(&sample).is_ok();
        }
        self.book.input(sample).is_ok()
    }

    fn step(&mut self) -> StepReport {
        let report = self.book.step();
        if let Some(recorder) = &mut self.recorder {
            self.complete &= recorder.step(self.book.state_hash()).is_ok();
        }
        report
    }

    fn now_us(&self) -> u64 {
        self.book.now_us()
    }

    fn resting(&self) -> bool {
        !self.book.needs_frame()
    }

    fn pose(&mut self) -> Pose {
        let events = std::iter::from_fn(|| self.book.take_event()).map(Into::into).collect();
        let book = &self.book;
        Pose {
            hash: format!("{:016x}", book.state_hash()),
            leaf: book.leaf().map(|leaf| LeafNodes::of(leaf, book.units())),
            midline: Some(midline(book)),
            ribbons: Vec::new(),
            stretch: book.stretch().into(),
            energy: Energy::of(book.energy(), book.units()),
            events,
        }
    }

    fn shot(&self) -> Result<Shot, CliError> {
        book_shot(&self.book, &self.indices)
    }

    fn record(&mut self) -> Result<(), CliError> {
        self.recorder = Some(Recorder::start::<R, G>(Bytes::default(), &self.setup)?);
        Ok(())
    }

    fn recording(&mut self) -> Result<Recording, CliError> {
        let Some(recorder) = self.recorder.take() else { return Ok(Recording::default()) };
        let steps = recorder.steps();
        Ok(Recording { bytes: recorder.finish()?.0, steps, complete: self.complete })
    }

    fn bytes(&self) -> usize {
        size_of_val(&self.book)
    }
}

/// The left block from its fore-edge in, the binding's centre, the right block outwards.
fn midline<R: Real, G: Grid>(book: &Book<R, G>) -> Vec<[f64; 2]> {
    let [left, right] = book.blocks();
    let metres = |v: &V2<R>, sign: f64| {
        let [x, y] = v.0.map(|c| book.units().to_metres(c.wide()));
        [sign * x, y]
    };
    let left = left.x.iter().rev().map(|v| metres(v, -1.0));
    let right = right.x.iter().map(|v| metres(v, 1.0));
    left.chain(std::iter::once([0.0, 0.0])).chain(right).collect()
}
