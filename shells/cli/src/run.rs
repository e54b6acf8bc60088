//! `dogleaf run`: a scene, frame by frame, into whatever was asked for.

mod json;
mod obj;
mod summary;

pub(crate) use json::Work;

use crate::args::RunArgs;
use crate::error::CliError;
use crate::progress;
use crate::scene::Scene;
use crate::sim::{self, Feed, Pose, Sim};
use dogleaf_core::step::StepReport;

/// Frames run at most when nobody says how many.
const MOST_FRAMES: u32 = 1200;

/// One frame, as every output gets it.
pub(crate) struct Frame<'a> {
    /// Counted from 0; frame 0 is the scene before anything moved.
    pub(crate) number: u32,
    pub(crate) time_s: f64,
    pub(crate) report: &'a StepReport,
    pub(crate) pose: &'a Pose,
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
    let mut json = args.json.as_ref().map(|to| json::Lines::open(to, args, &scene)).transpose()?;
    let mut obj = args.obj.as_ref().map(|to| obj::Folder::create(to)).transpose()?;
    let mut summary = summary::Summary::default();
    each_frame(args, &scene, sim.as_mut(), |frame| {
        summary.take(frame);
        json.as_mut().map_or(Ok(()), |json| json.frame(frame))?;
        obj.as_mut().map_or(Ok(()), |obj| obj.frame(frame))
    })?;
    if let Some(json) = json {
        json.finish()?;
    }
    if let Some(to) = &args.record {
        keep_recording(sim.as_mut(), to)?;
    }
    if args.json.as_ref().is_none_or(|to| to.as_os_str() != "-") {
        summary.print(args, &scene, sim.bytes())?;
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
    let frames = args.frames.unwrap_or(MOST_FRAMES);
    let bar = progress::bar(u64::from(frames), "frames");
    let mut report = StepReport::default();
    for number in 0..frames {
        if number > 0 {
            report = feed.advance(sim, scene.frame_us);
        }
        let pose = sim.pose();
        let time_s = f64::from(number) * f64::from(scene.frame_us) * 1e-6;
        show(&Frame { number, time_s, report: &report, pose: &pose })?;
        bar.inc(1);
        if args.frames.is_none() && number > 0 && feed.done() && sim.resting() {
            break;
        }
    }
    bar.finish_and_clear();
    Ok(())
}

fn keep_recording(sim: &mut dyn Sim, to: &std::path::Path) -> Result<(), CliError> {
    let recording = sim.recording()?;
    std::fs::write(to, &recording.bytes).map_err(|e| CliError::write(to, &e))?;
    if !recording.complete {
        eprintln!("dogleaf: the recording was full after {} steps", recording.steps);
    }
    Ok(())
}
