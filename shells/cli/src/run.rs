//! `dogleaf run`: a scene, frame by frame, into whatever was asked for.

mod json;
mod obj;
mod picture;
mod summary;

pub(crate) use json::Work;

use crate::args::RunArgs;
use crate::error::CliError;
use crate::progress;
use crate::scene::Scene;
use crate::sim::{self, Feed, Pose, Sim};
use dogleaf_core::step::StepReport;
use std::path::Path;

/// How long a scene runs on after its last sample when nobody says how many frames, microseconds.
const MOST_US: u64 = 20_000_000;

/// One frame, as every output gets it.
struct Frame<'a> {
    /// Counted from 0; frame 0 is the scene before anything moved.
    number: u32,
    time_s: f64,
    report: &'a StepReport,
    pose: &'a Pose,
    sim: &'a dyn Sim,
}

/// Where frames go.
struct Outputs {
    json: Option<json::Lines>,
    obj: Option<obj::Folder>,
    picture: Option<picture::Picture>,
    summary: summary::Summary,
}

impl Outputs {
    fn open(args: &RunArgs, scene: &Scene) -> Result<Self, CliError> {
        let json = args.json.as_ref().map(|to| json::Lines::open(to, args, scene));
        let obj = args.obj.as_ref().map(|to| obj::Folder::create(to));
        let picture = args.out.as_ref().map(|to| picture::Picture::open(to, scene));
        Ok(Self {
            json: json.transpose()?,
            obj: obj.transpose()?,
            picture: picture.transpose()?,
            summary: summary::Summary::default(),
        })
    }

    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), CliError> {
        self.summary.take(frame);
        if let Some(json) = &mut self.json {
            json.frame(frame)?;
        }
        if let Some(obj) = &self.obj {
            obj.frame(frame.number, frame.pose.leaf.as_ref(), &frame.sim.shot()?)?;
        }
        if let Some(picture) = &mut self.picture {
            picture.frame(frame)?;
        }
        Ok(())
    }
}

/// Runs a scene.
pub(crate) fn run(args: &RunArgs) -> Result<(), CliError> {
    let scene = Scene::load(&args.scene)?;
    if args.wav.is_some() {
        return Err(CliError::Call("--wav: no sound in this scene".into()));
    }
    let mut sim = sim::build(&scene, args.real, args.fidelity.into())?;
    if args.record.is_some() {
        sim.record()?;
    }
    let mut outputs = Outputs::open(args, &scene)?;
    each_frame(args, &scene, sim.as_mut(), |frame| outputs.frame(frame))?;
    if let Some(json) = outputs.json {
        json.finish()?;
    }
    if let Some(to) = &args.record {
        keep_recording(sim.as_mut(), to)?;
    }
    if let Some(picture) = outputs.picture {
        picture.finish()?;
    }
    if args.json.as_ref().is_none_or(|to| to.as_os_str() != "-") {
        outputs.summary.print(args, &scene, sim.bytes())?;
    }
    Ok(())
}

/// Runs the scene and shows every frame.
fn each_frame(
    args: &RunArgs,
    scene: &Scene,
    sim: &mut dyn Sim,
    mut show: impl FnMut(&Frame<'_>) -> Result<(), CliError>,
) -> Result<(), CliError> {
    let mut feed = Feed::new(&scene.samples, scene.world.step_us);
    let frames = args.frames.unwrap_or_else(|| most_frames(scene));
    let bar = progress::bar(u64::from(frames), "frames");
    let mut report = StepReport::default();
    for number in 0..frames {
        if number > 0 {
            report = feed.advance(sim, scene.frame_us);
        }
        let pose = sim.pose();
        let time_s = f64::from(number) * f64::from(scene.frame_us) * 1e-6;
        show(&Frame { number, time_s, report: &report, pose: &pose, sim })?;
        bar.inc(1);
        if args.frames.is_none() && number > 0 && feed.done() && sim.resting() {
            break;
        }
    }
    bar.finish_and_clear();
    Ok(())
}

fn most_frames(scene: &Scene) -> u32 {
    let last_us = scene.samples.last().map_or(0, |s| s.t_us);
    let frames = last_us.saturating_add(MOST_US) / u64::from(scene.frame_us);
    u32::try_from(frames).unwrap_or(u32::MAX)
}

fn keep_recording(sim: &mut dyn Sim, to: &Path) -> Result<(), CliError> {
    let recording = sim.recording()?;
    std::fs::write(to, &recording.bytes).map_err(|e| CliError::write(to, &e))?;
    if !recording.complete {
        eprintln!("dogleaf: the recording was full after {} steps", recording.steps);
    }
    Ok(())
}
