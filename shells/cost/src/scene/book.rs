//! A whole book: blocks, contact, a finger on glass. Its motion hangs on who touches whom first, so only events and
//! what needs no reference are taken from it.

use super::{Look, Sim};
use crate::CostError;
use crate::axes::{Config, Form, GridName, with_types};
use crate::judge::depth::deepest;
use crate::judge::gesture::{Gesture, Scene};
use dogleaf_core::Book;
use dogleaf_core::event::Event;
use dogleaf_core::grid::Grid;
use dogleaf_core::hand::Sample;
use dogleaf_core::mesh::{Layout, Vertex, vertices};
use dogleaf_core::real::Real;
use dogleaf_core::scene::units::WIDTH;
use dogleaf_core::scene::{Fidelity, Settings};
use dogleaf_core::seed::{SeedBook, SeedGrid};
use dogleaf_core::step::StepReport;

/// Opens the book of a scene, its gesture in hand.
///
/// # Errors
///
/// What the core refuses; the seed's equations on a grid they have no pattern for.
pub fn open(scene: &str, config: &Config) -> Result<Box<dyn Sim>, CostError> {
    let (rate, substeps) = config.world();
    let mut stage = Scene::default();
    stage.world.step_us = 1_000_000_u32.div_ceil(rate);
    let samples = gesture(scene, &stage);
    let dials = Settings { substeps, ..config.settings() };
    match config.form {
        Form::Ours => with_types!(config, R, G => ours::<R, G>(&stage, dials, samples)),
        Form::Seed { .. } if config.grid == GridName::G11x8 => {
            seeds::<f64, dogleaf_core::grid::G11x8>(&stage, config, dials, samples)
        }
        Form::Seed { .. } => Err(CostError::NoPattern(config.grid)),
    }
}

/// What the finger does.
fn gesture(scene: &str, stage: &Scene) -> Vec<Sample> {
    let eye = stage.eye();
    if scene == "peek" {
        let (corner, lifted) = (eye.page(0.92, 0.88), eye.above(0.35, 0.25, 0.8));
        return Gesture::press(corner).to(lifted, 600_000).hold(500_000).to(corner, 600_000).up();
    }
    Gesture::corner_turn(&eye, 2024)
}

fn ours<R: Real, G: Grid>(
    stage: &Scene,
    dials: Settings,
    samples: Vec<Sample>,
) -> Result<Box<dyn Sim>, CostError> {
    let mut book = stage.open::<R, G>()?;
    book.set_settings(dials)?;
    Ok(Box::new(BookSim { book, hand: Finger::new(samples), mesh: Vec::new() }))
}

fn seeds<R: Real, G: SeedGrid>(
    stage: &Scene,
    config: &Config,
    dials: Settings,
    samples: Vec<Sample>,
) -> Result<Box<dyn Sim>, CostError> {
    let mut book = Box::new(SeedBook::<R, G>::EMPTY);
    let settings = config.seed().unwrap_or_default();
    let s = stage;
    book.open(&s.book, &s.paper, &s.world, &s.view, Fidelity::Standard, settings)?;
    book.book_mut().set_settings(dials)?;
    Ok(Box::new(SeedSim { book, hand: Finger::new(samples), step_us: s.world.step_us }))
}

/// Samples not yet due, and whether the leaf has come to lie.
struct Finger {
    samples: Vec<Sample>,
    next: usize,
    settled: bool,
}

impl Finger {
    fn new(samples: Vec<Sample>) -> Self {
        Self { samples, next: 0, settled: false }
    }

    /// Hands over what is due until a moment.
    fn touch<R: Real, G: Grid>(&mut self, book: &mut Book<R, G>, until_us: u64) {
        while let Some(sample) = self.samples.get(self.next).filter(|s| s.t_us <= until_us) {
            // A sample the book refuses is counted in its report.
            let _ = book.input(*sample);
            self.next += 1;
        }
    }

    fn see<R: Real, G: Grid>(&mut self, book: &mut Book<R, G>) -> bool {
        while let Some(event) = book.take_event() {
            self.settled |= matches!(event, Event::Committed { .. } | Event::Cancelled);
        }
        self.settled
    }
}

fn look<R: Real, G: Grid>(book: &Book<R, G>) -> Option<Look> {
    let leaf = book.leaf()?;
    let thickness = book.binding().half_held().wide() * 2.0;
    let depth = deepest(book) / thickness;
    Some(Look { depth, ..Look::of(leaf, book.sheet(), book.energy()) })
}

fn edge<R: Real, G: Grid>(book: &Book<R, G>) -> Option<f64> {
    let leaf = book.leaf()?;
    let root = book.binding().root().0[0].wide();
    let sum = (0..G::NZ).fold(0.0, |s, k| s + leaf.x.at(G::NX - 1, k).0[0].wide() - root);
    Some(sum / (WIDTH * G::NZ as f64))
}

struct BookSim<R: Real, G: Grid> {
    book: Box<Book<R, G>>,
    hand: Finger,
    mesh: Vec<Vertex>,
}

impl<R: Real, G: Grid> Sim for BookSim<R, G> {
    fn step(&mut self, t_s: f64) -> StepReport {
        self.hand.touch(&mut self.book, (t_s * 1e6) as u64);
        self.book.step()
    }
    fn look(&self) -> Option<Look> {
        look(&self.book)
    }
    fn edge(&self) -> Option<f64> {
        edge(&self.book)
    }
    fn settled(&mut self) -> bool {
        self.hand.see(&mut self.book)
    }
    fn mesh(&mut self) -> usize {
        self.mesh.resize(Layout::<G>::VERTICES, Vertex::default());
        // The room is the layout's own, so nothing is refused.
        let _ = vertices(&self.book, &mut self.mesh);
        self.mesh.len() * size_of::<Vertex>()
    }
    fn bytes(&self) -> usize {
        size_of::<Book<R, G>>()
    }
}

struct SeedSim<R: Real, G: SeedGrid> {
    book: Box<SeedBook<R, G>>,
    hand: Finger,
    step_us: u32,
}

impl<R: Real, G: SeedGrid> Sim for SeedSim<R, G> {
    fn step(&mut self, t_s: f64) -> StepReport {
        let book = self.book.book_mut();
        self.hand.touch(book, (t_s * 1e6) as u64);
        self.book.advance(self.step_us)
    }
    fn look(&self) -> Option<Look> {
        look(self.book.book())
    }
    fn edge(&self) -> Option<f64> {
        edge(self.book.book())
    }
    fn settled(&mut self) -> bool {
        self.hand.see(self.book.book_mut())
    }
    fn bytes(&self) -> usize {
        size_of::<SeedBook<R, G>>()
    }
}
