//! What a run came to, in a few lines.

use super::Frame;
use crate::args::RunArgs;
use crate::error::CliError;
use crate::scene::Scene;
use crate::sim::EventName;
use dogleaf_core::step::StepReport;
use std::io::Write;

/// Counts and extremes over the frames.
#[derive(Debug, Default)]
pub(super) struct Summary {
    frames: u32,
    time_s: f64,
    total: StepReport,
    stretch_max: f64,
    events: Vec<String>,
    free_edge: Option<[f64; 2]>,
    hash: String,
}

impl Summary {
    pub(super) fn take(&mut self, frame: &Frame<'_>) {
        self.frames += 1;
        self.time_s = frame.time_s;
        self.total.add(frame.report);
        self.stretch_max = self.stretch_max.max(frame.pose.stretch.max);
        self.events.extend(frame.pose.events.iter().map(|e| told(e, frame.time_s)));
        self.free_edge = frame.pose.leaf.as_ref().and_then(|leaf| {
            let edge = leaf.nodes.get(leaf.nodes.len().checked_sub(leaf.nz)?..)?;
            let mean = |c: usize| edge.iter().map(|p| p[c]).sum::<f64>() / edge.len() as f64;
            Some([mean(0), mean(1)])
        });
        self.hash.clone_from(&frame.pose.hash);
    }

    pub(super) fn print(
        &self,
        args: &RunArgs,
        scene: &Scene,
        bytes: usize,
    ) -> Result<(), CliError> {
        let mut out = std::io::stdout().lock();
        self.lines(&mut out, args, scene, bytes)
            .map_err(|e| CliError::write("standard output".as_ref(), &e))
    }

    fn lines(
        &self,
        out: &mut impl Write,
        args: &RunArgs,
        scene: &Scene,
        bytes: usize,
    ) -> std::io::Result<()> {
        let (body, grid) = (scene.body.name(), scene.grid);
        let (real, fidelity) = (args.real.name(), args.fidelity.name());
        writeln!(out, "scene      {body}, {grid} nodes, {real}, {fidelity}, {bytes} bytes")?;
        writeln!(out, "frames     {} ({:.3} s)", self.frames, self.time_s)?;
        let t = &self.total;
        writeln!(
            out,
            "work       {} steps, {} Newton steps, {} cuts, {} passes, {} pushed",
            t.steps, t.newton_steps, t.cuts, t.passes, t.pushed
        )?;
        writeln!(out, "status     {} at worst", t.status.name())?;
        writeln!(out, "stretch    {:.3} % at most", 100.0 * self.stretch_max)?;
        if let Some([x, y]) = self.free_edge {
            writeln!(out, "free edge  {:.2} mm across, {:.2} mm up", 1e3 * x, 1e3 * y)?;
        }
        for event in &self.events {
            writeln!(out, "event      {event}")?;
        }
        writeln!(out, "hash       {}", self.hash)
    }
}

fn told(event: &EventName, time_s: f64) -> String {
    match event {
        EventName::Lifted { from_right, leaves } => {
            let side = if *from_right { "right" } else { "left" };
            let noun = if *leaves == 1 { "leaf" } else { "leaves" };
            format!("{time_s:.3} s: {leaves} {noun} lifted from the {side}")
        }
        EventName::Held { leaves } => format!("{time_s:.3} s: {leaves} in the hand"),
        EventName::Committed { page } => format!("{time_s:.3} s: turned, open at page {page}"),
        EventName::Cancelled => format!("{time_s:.3} s: put back"),
        EventName::Asleep => format!("{time_s:.3} s: at rest"),
    }
}
