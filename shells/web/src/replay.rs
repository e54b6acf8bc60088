//! A recording run again, step by step: as it was made, to compare hashes; or otherwise, to see what that changes.

use crate::error::Refused;
use crate::options::named;
use dogleaf_core::Book;
use dogleaf_core::grid::{G11x8, Grid};
use dogleaf_core::record::{Reader, Record};
use dogleaf_core::scene::Fidelity;

/// Places across and along the leaf at which shapes are compared.
pub const PLACES: [usize; 2] = [13, 9];

/// What is done otherwise than it was recorded.
#[derive(Debug, Clone, Copy, Default)]
pub struct Otherwise<'a> {
    /// Nodes of the leaf, such as `11x8`.
    pub grid: Option<&'a str>,
    /// What accuracy is bought.
    pub fidelity: Option<&'a str>,
    /// Internal step, microseconds.
    pub step_us: Option<u32>,
}

/// A recording under way.
#[derive(Debug)]
pub struct Replay {
    run: Box<dyn Run>,
    records: Vec<Record>,
    at: usize,
    /// What the next step must end with.
    expected: Option<u64>,
    /// Steps taken.
    pub steps: u32,
    /// The first step whose hash is another; counted only where nothing is done otherwise.
    pub diverged: Option<u32>,
    /// World steps of the physics: as many as recorded ones unless their length is another.
    pub inner: u32,
    as_made: bool,
    frame_us: u32,
}

impl Replay {
    /// Opens the book of a recording.
    ///
    /// # Errors
    ///
    /// `recording`: these bytes are none, or of another grid than the one asked for; `refused`: a word that means nothing.
    pub fn open(bytes: &[u8], otherwise: Otherwise<'_>) -> Result<Self, Refused> {
        let reader = Reader::open(bytes)?;
        let mut setup = reader.header().setup;
        let frame_us = setup.world.step_us;
        if let Some(name) = otherwise.fidelity {
            setup.fidelity = named("fidelity", name, &Fidelity::ALL)?;
        }
        setup.world.step_us = otherwise.step_us.unwrap_or(frame_us);
        let mut run = grid(otherwise.grid, &reader)?;
        run.open(&setup)?;
        Ok(Self {
            run,
            records: reader.records().collect::<Result<_, _>>()?,
            at: 0,
            expected: None,
            steps: 0,
            diverged: None,
            inner: 0,
            as_made: setup == reader.header().setup && otherwise.grid.is_none(),
            frame_us,
        })
    }

    /// Hands over what came before the next step. 0 at the end, 1 where nothing is in the air, 2 where a leaf is.
    pub fn prepare(&mut self) -> u32 {
        while let Some(record) = self.records.get(self.at) {
            match record {
                Record::Step { hash } => {
                    self.expected = Some(*hash);
                    return 1 + u32::from(self.run.aloft());
                }
                other => self.run.hand_over(other),
            }
            self.at += 1;
        }
        0
    }

    /// Takes the step, of the time that it was recorded with.
    pub fn step(&mut self) {
        let Some(expected) = self.expected.take() else { return };
        self.inner = self.inner.saturating_add(self.run.pass(self.frame_us, self.as_made));
        if self.as_made && self.diverged.is_none() && self.run.hash() != expected {
            self.diverged = Some(self.steps);
        }
        self.steps += 1;
        self.at += 1;
    }

    /// Hash of the state.
    #[must_use]
    pub fn hash(&self) -> u64 {
        self.run.hash()
    }

    /// The leaf in the air that a finger leads, at [`PLACES`], in page widths, three numbers each; nothing without one.
    #[must_use]
    pub fn shape(&self) -> Vec<f32> {
        self.run.shape()
    }
}

#[cfg(not(feature = "grids"))]
fn grid(name: Option<&str>, reader: &Reader<'_>) -> Result<Box<dyn Run>, Refused> {
    match name {
        None | Some("11x8") => {
            reader.header().fits::<f32, G11x8>()?;
            Ok(running::<G11x8>())
        }
        Some(_) => Err(Refused::new("refused", "this build has one grid, 11x8")),
    }
}

#[cfg(feature = "grids")]
fn grid(name: Option<&str>, reader: &Reader<'_>) -> Result<Box<dyn Run>, Refused> {
    use dogleaf_core::grid::{G6x5, G8x6, G16x12};
    reader.header().fits::<f32, G11x8>()?;
    let make = named::<fn() -> Box<dyn Run>>(
        "grid",
        name.unwrap_or("11x8"),
        &[
            ("6x5", running::<G6x5>),
            ("8x6", running::<G8x6>),
            ("11x8", running::<G11x8>),
            ("16x12", running::<G16x12>),
        ],
    )?;
    Ok(make())
}

fn running<G: Grid>() -> Box<dyn Run> {
    Box::new(Book::<f32, G>::EMPTY)
}

/// A book on some grid.
trait Run: std::fmt::Debug {
    fn open(&mut self, setup: &dogleaf_core::record::Setup) -> Result<(), Refused>;
    fn hand_over(&mut self, record: &Record);
    fn aloft(&self) -> bool;
    /// Lets a recorded step's time pass; answers the internal steps taken.
    fn pass(&mut self, frame_us: u32, as_made: bool) -> u32;
    fn hash(&self) -> u64;
    fn shape(&self) -> Vec<f32>;
}

impl<G: Grid> Run for Book<f32, G> {
    fn open(&mut self, setup: &dogleaf_core::record::Setup) -> Result<(), Refused> {
        Ok(setup.open(self)?)
    }

    fn hand_over(&mut self, record: &Record) {
        // What was refused when it was recorded is refused again.
        let _ = match record {
            Record::Input(sample) => self.input(*sample).is_ok(),
            Record::Look(view) => self.look(view).is_ok(),
            Record::Step { .. } => true,
        };
    }

    fn aloft(&self) -> bool {
        self.leaf().is_some()
    }

    fn pass(&mut self, frame_us: u32, as_made: bool) -> u32 {
        if as_made { self.step().steps } else { self.advance(frame_us).steps }
    }

    fn hash(&self) -> u64 {
        self.state_hash()
    }

    fn shape(&self) -> Vec<f32> {
        let Some(leaf) = self.leaf().filter(|_| self.held().is_some()) else { return Vec::new() };
        let width = self.units().length(self.spec().width_m) as f32;
        let [across, along] = PLACES;
        let mut out = Vec::with_capacity(3 * across * along);
        for a in 0..across {
            let (i, wi) = cubic(a, across, G::NX);
            for b in 0..along {
                let (k, wk) = cubic(b, along, G::NZ);
                for c in 0..3 {
                    let at = |m: usize, n: usize| wi[m] * wk[n] * leaf.x.at(i + m, k + n).0[c];
                    let sum: f32 = (0..16).map(|n| at(n / 4, n % 4)).sum();
                    out.push(sum / width);
                }
            }
        }
        out
    }
}

/// First of the four nodes round a place, and the weights of the cubic through them.
fn cubic(place: usize, of: usize, nodes: usize) -> (usize, [f32; 4]) {
    let s = (place * (nodes - 1)) as f32 / (of - 1) as f32;
    let first = (s as usize).clamp(1, nodes - 3) - 1;
    let t = s - first as f32;
    let [a, b, c, d] = [t, t - 1.0, t - 2.0, t - 3.0];
    (first, [-b * c * d / 6.0, a * c * d / 2.0, -a * b * d / 2.0, a * b * c / 6.0])
}

#[cfg(test)]
mod check {
    use super::{Otherwise, Replay, cubic};

    const GOLDEN: &[u8] = include_bytes!("../../../fixtures/recordings/slow_turn_f32.dlr");

    fn through(otherwise: Otherwise<'_>) -> (Replay, usize) {
        let mut replay = Replay::open(GOLDEN, otherwise).expect("a sound recording");
        let mut shapes = 0;
        while replay.prepare() > 0 {
            replay.step();
            shapes += usize::from(!replay.shape().is_empty());
        }
        (replay, shapes)
    }

    #[test]
    fn the_golden_turn_ends_as_recorded() {
        let (replay, shapes) = through(Otherwise::default());
        assert_eq!(replay.diverged, None);
        assert!(replay.steps > 100 && shapes > 60, "{} steps, {shapes} led", replay.steps);
    }

    #[test]
    fn another_fidelity_is_another_state_and_the_same_frames() {
        let (golden, _) = through(Otherwise::default());
        let fine = Otherwise { fidelity: Some("fine"), step_us: Some(8_333), ..Default::default() };
        let (other, _) = through(fine);
        assert_eq!(other.steps, golden.steps);
        assert!(2 * other.inner > 3 * golden.inner, "{} for {}", other.inner, golden.inner);
    }

    #[test]
    fn bytes_that_are_no_recording_are_refused_in_one_line() {
        let why = Replay::open(b"DLR?", Otherwise::default()).map_err(|e| e.kind).err();
        assert_eq!(why, Some("recording"));
    }

    #[test]
    fn a_cubic_is_read_exactly() {
        let f = |x: f32| x * x * x - 2.0 * x;
        for place in 0..13 {
            let (first, w) = cubic(place, 13, 6);
            let read: f32 = (0..4).map(|n| w[n] * f((first + n) as f32)).sum();
            assert!((read - f(place as f32 * 5.0 / 12.0)).abs() < 1e-4, "at {place}");
        }
    }
}
