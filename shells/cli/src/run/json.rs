//! JSON lines: a header, then one object a frame.

use super::Frame;
use crate::args::RunArgs;
use crate::error::{CliError, shown};
use crate::scene::Scene;
use crate::sim::Pose;
use dogleaf_core::step::StepReport;
use serde::Serialize;
use std::fs::File;
use std::io::{BufWriter, Write, stdout};
use std::path::{Path, PathBuf};

/// The first line.
#[derive(Serialize)]
struct Header<'a> {
    dogleaf: &'static str,
    real: &'static str,
    units: &'static str,
    fidelity: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    grid: Option<[usize; 2]>,
    step_us: u32,
    frame_us: u32,
    scene: String,
    parts: &'a [&'static str],
}

/// A line.
#[derive(Serialize)]
struct Line<'a> {
    frame: u32,
    time_s: f64,
    status: &'static str,
    #[serde(flatten)]
    pose: &'a Pose,
    work: Work,
}

/// What a frame cost, in counts.
#[derive(Debug, Clone, Copy, Default, Serialize)]
pub(crate) struct Work {
    steps: u32,
    newton_steps: u32,
    cuts: u32,
    regularised: u32,
    passes: u32,
    pushed: u32,
    clamped: u32,
    chain_solves: u32,
    nudged: u32,
    refused: u32,
}

impl From<&StepReport> for Work {
    fn from(r: &StepReport) -> Self {
        Self {
            steps: r.steps,
            newton_steps: r.newton_steps,
            cuts: r.cuts,
            regularised: r.regularised,
            passes: r.passes,
            pushed: r.pushed,
            clamped: r.clamped,
            chain_solves: r.chain_solves,
            nudged: r.nudged,
            refused: r.refused,
        }
    }
}

/// JSON lines on their way to a file or the standard output.
pub(super) struct Lines {
    to: Box<dyn Write>,
    path: PathBuf,
}

impl Lines {
    pub(super) fn open(path: &Path, args: &RunArgs, scene: &Scene) -> Result<Self, CliError> {
        let to: Box<dyn Write> = if path.as_os_str() == "-" {
            Box::new(BufWriter::new(stdout().lock()))
        } else {
            let file = File::create(path).map_err(|e| CliError::write(path, &e))?;
            Box::new(BufWriter::new(file))
        };
        let mut lines = Self { to, path: path.to_owned() };
        lines.put(&Header {
            dogleaf: env!("CARGO_PKG_VERSION"),
            real: args.real.name(),
            units: "SI",
            fidelity: args.fidelity.name(),
            grid: scene.body.name().map(|_| scene.grid.size()),
            step_us: scene.world.step_us,
            frame_us: scene.frame_us,
            scene: shown(&args.scene),
            parts: &scene.parts(),
        })?;
        Ok(lines)
    }

    pub(super) fn frame(&mut self, frame: &Frame<'_>) -> Result<(), CliError> {
        self.put(&Line {
            frame: frame.number,
            time_s: frame.time_s,
            status: frame.report.status.name(),
            pose: frame.pose,
            work: frame.report.into(),
        })
    }

    pub(super) fn finish(mut self) -> Result<(), CliError> {
        self.to.flush().map_err(|e| CliError::write(&self.path, &e))
    }

    fn put(&mut self, line: &impl Serialize) -> Result<(), CliError> {
        let written = serde_json::to_writer(&mut self.to, line)
            .map_err(std::io::Error::from)
            .and_then(|()| self.to.write_all(b"\n"));
        written.map_err(|e| CliError::write(&self.path, &e))
    }
}
