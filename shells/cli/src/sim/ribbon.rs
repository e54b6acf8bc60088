//! Ribbons as a scene, alone or beside a book or a leaf.

use super::band::{Band, Room, heard, room};
use super::strands::{Bundle, Strand};
use super::{Energy, EventName, Pose, Recording, Sim, Strain};
use crate::error::CliError;
use crate::picture::Shot;
use crate::scene::Scene;
use dogleaf_core::effect::ribbon::Settings;
use dogleaf_core::hand::Sample;
use dogleaf_core::real::Real;
use dogleaf_core::scene::Fidelity;
use dogleaf_core::state::Fnv;
use dogleaf_core::step::StepReport;

/// Slower than this, metres per second, a ribbon is still.
const STILL: f64 = 1e-3;
/// How long it has to be, microseconds.
const STILL_US: u64 = 500_000;

struct Ribbons<R: Real> {
    /// The book or the leaf.
    beside: Option<Box<dyn Sim>>,
    bands: Vec<Band<R>>,
    /// Where one of them touches anything.
    near: Option<Box<Room<R>>>,
    step_us: u32,
    now_us: u64,
    moved_us: u64,
    /// Sounds not yet told.
    heard: Vec<EventName>,
}

/// Lays the ribbons of a scene.
pub(super) fn build<R: Real>(
    scene: &Scene,
    beside: Option<Box<dyn Sim>>,
    fidelity: Fidelity,
) -> Result<Box<dyn Sim>, CliError> {
    let settings = Settings::of::<R>(fidelity);
    let band = |part| Band::<R>::lay(part, &scene.world, &settings);
    let bands: Result<Vec<_>, CliError> = scene.ribbons.iter().map(band).collect();
    let (bands, step_us) = (bands?, scene.world.step_us);
    let near = bands.iter().any(|band| band.contact).then(room);
    Ok(Box::new(Ribbons {
        beside,
        bands,
        near,
        step_us,
        now_us: 0,
        moved_us: 0,
        heard: Vec::new(),
    }))
}

impl<R: Real> Sim for Ribbons<R> {
    fn input(&mut self, sample: Sample) -> bool {
        self.beside.as_mut().is_some_and(|sim| sim.input(sample))
    }

    fn step(&mut self) -> StepReport {
        let alone = || StepReport { steps: 1, ..StepReport::default() };
        let mut report = self.beside.as_mut().map_or_else(alone, |sim| sim.step());
        self.now_us += u64::from(self.step_us);
        for k in 0..self.bands.len() {
            // One after the other, each against the others where they are by then.
            look(self.near.as_deref_mut(), &self.bands, k, self.step_us, |_| true);
            let Some((before, rest)) = self.bands.split_at_mut_checked(k) else { break };
            let Some((band, after)) = rest.split_first_mut() else { break };
            let near = self.near.as_deref_mut().filter(|_| band.contact);
            let stepped = band.step(self.now_us, self.step_us, near, [before, after]);
            report.status = report.status.worse(stepped.status);
            self.heard.extend(heard(k, &stepped.sound));
        }
        let moving = |band: &Band<R>| band.fastest() > STILL || band.turning(self.now_us);
        if self.bands.iter().any(moving) {
            self.moved_us = self.now_us;
        }
        report
    }

    fn now_us(&self) -> u64 {
        self.now_us
    }

    fn resting(&self) -> bool {
        self.now_us >= self.moved_us + STILL_US && self.beside.as_ref().is_none_or(|s| s.resting())
    }

    fn pose(&mut self) -> Pose {
        let mut pose = self.beside.as_mut().map_or_else(nothing, |sim| sim.pose());
        let mut hash = Fnv::default();
        hash.word(u64::from_str_radix(&pose.hash, 16).unwrap_or(0));
        let mut stretch = pose.stretch;
        for k in 0..self.bands.len() {
            // Each meeting of two is told of once.
            look(self.near.as_deref_mut(), &self.bands, k, 0, |other| other < k);
            let band = &mut self.bands[k];
            let near = self.near.as_deref_mut().filter(|_| band.contact);
            let touching = near.map_or(0.0, |near| band.touching(near));
            hash.word(band.hash());
            let rims = band.rims(touching);
            pose.energy = pose.energy.and(rims.energy);
            stretch.max = stretch.max.max(rims.stretch.max);
            stretch.rms = stretch.rms.max(rims.stretch.rms);
            pose.ribbons.push(rims);
        }
        pose.events.append(&mut self.heard);
        pose.stretch = stretch;
        pose.hash = format!("{:016x}", hash.value());
        pose
    }

    fn shot(&self) -> Result<Shot, CliError> {
        let mut shot = self.beside.as_ref().map_or_else(|| Ok(Shot::bare()), |sim| sim.shot())?;
        shot.bands.extend(self.bands.iter().map(Band::shot));
        Ok(shot)
    }

    fn record(&mut self) -> Result<(), CliError> {
        self.beside.as_mut().map_or(Ok(()), |sim| sim.record())?;
        Ok(self.bands.iter_mut().try_for_each(Band::record)?)
    }

    fn recording(&mut self) -> Result<Recording, CliError> {
        let mut complete = true;
        let body = match &mut self.beside {
            Some(sim) => {
                let recording = sim.recording()?;
                complete &= recording.complete;
                Some(recording.bytes)
            }
            None => None,
        };
        let mut strands = Vec::<Strand>::new();
        for band in &mut self.bands {
            let (strand, all) = band.recording()?;
            complete &= all;
            strands.push(strand);
        }
        let bytes = Bundle { step_us: self.step_us, body, strands }.bytes();
        let steps = u32::try_from(self.now_us / u64::from(self.step_us)).unwrap_or(u32::MAX);
        Ok(Recording { bytes, steps, complete })
    }

    fn bytes(&self) -> usize {
        let own: usize = self.bands.iter().map(Band::bytes).sum();
        let near = self.near.as_deref().map_or(0, size_of_val);
        own + near + self.beside.as_ref().map_or(0, |sim| sim.bytes())
    }
}

/// Finds what is near a band that touches anything, among those of the others that are wanted.
fn look<R: Real>(
    near: Option<&mut Room<R>>,
    bands: &[Band<R>],
    k: usize,
    step_us: u32,
    wanted: impl Fn(usize) -> bool,
) {
    let Some(near) = near.filter(|_| bands[k].contact) else { return };
    let others = bands.iter().enumerate().filter(|(other, _)| *other != k && wanted(*other));
    bands[k].look(near, step_us, others.map(|(_, band)| band));
}

/// What is seen of no body.
fn nothing() -> Pose {
    Pose {
        hash: String::new(),
        leaf: None,
        midline: None,
        ribbons: Vec::new(),
        stretch: Strain { max: 0.0, rms: 0.0 },
        energy: Energy { kinetic: 0.0, potential: 0.0 },
        events: Vec::new(),
    }
}
