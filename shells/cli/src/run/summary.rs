//! What a run came to, in a few lines.

use super::Frame;
use crate::args::RunArgs;
use crate::error::CliError;
use crate::scene::Scene;
use crate::sim::{EventName, RibbonWork, Rims};
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
    ribbons: Vec<Told>,
    hash: String,
}

impl Summary {
    pub(super) fn take(&mut self, frame: &Frame<'_>) {
        self.frames += 1;
        self.time_s = frame.time_s;
        self.total.add(frame.report);
        self.stretch_max = self.stretch_max.max(frame.pose.stretch.max);
        self.events.extend(frame.pose.events.iter().filter_map(|e| told(e, frame.time_s)));
        self.free_edge = frame.pose.leaf.as_ref().and_then(|leaf| {
            let edge = leaf.nodes.get(leaf.nodes.len().checked_sub(leaf.nz)?..)?;
            let mean = |c: usize| edge.iter().map(|p| p[c]).sum::<f64>() / edge.len() as f64;
            Some([mean(0), mean(1)])
        });
        self.ribbons.resize(frame.pose.ribbons.len(), Told::default());
        for (told, rims) in self.ribbons.iter_mut().zip(&frame.pose.ribbons) {
            told.take(rims);
        }
        for event in &frame.pose.events {
            self.hear(event);
        }
        self.hash.clone_from(&frame.pose.hash);
    }

    fn hear(&mut self, event: &EventName) {
        let (EventName::Touched { ribbon, .. } | EventName::Snapped { ribbon, .. }) = event else {
            return;
        };
        if let Some(told) = self.ribbons.get_mut(*ribbon) {
            told.heard.take(event);
        }
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
        let grid =
            scene.body.name().map_or_else(String::new, |_| format!(", {} nodes", scene.grid));
        let parts = scene.parts().join(" and ");
        let (real, fidelity) = (args.real.name(), args.fidelity.name());
        writeln!(out, "scene      {parts}{grid}, {real}, {fidelity}, {bytes} bytes")?;
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
        for (k, told) in self.ribbons.iter().enumerate() {
            told.line(out, k)?;
        }
        for event in &self.events {
            writeln!(out, "event      {event}")?;
        }
        writeln!(out, "hash       {}", self.hash)
    }
}

/// What a ribbon came to.
#[derive(Debug, Clone, Default)]
struct Told {
    work: RibbonWork,
    /// Frames whose solves did not all converge.
    short: u32,
    gap: Option<f64>,
    energy: f64,
    end: [f64; 3],
    heard: Heard,
}

/// What a ribbon sounded like.
#[derive(Debug, Clone, Default)]
struct Heard {
    touches: u32,
    fastest: f64,
    snaps: u32,
    strongest: f64,
}

impl Heard {
    fn take(&mut self, event: &EventName) {
        match event {
            EventName::Touched { vertices, m_per_s, .. } => {
                self.touches += vertices;
                self.fastest = self.fastest.max(*m_per_s);
            }
            EventName::Snapped { joules, .. } => {
                self.snaps += 1;
                self.strongest = self.strongest.max(*joules);
            }
            _ => {}
        }
    }

    fn line(&self, out: &mut impl Write) -> std::io::Result<()> {
        let Self { touches, fastest, snaps, strongest } = self;
        if touches + snaps == 0 {
            return Ok(());
        }
        writeln!(
            out,
            "           {touches} vertices heard to touch, at {fastest:.3} m/s at most; {snaps} steps that snap, {:.3} mJ at most",
            1e3 * strongest
        )
    }
}

impl Told {
    fn take(&mut self, rims: &Rims) {
        self.work.add(&rims.work);
        self.short += u32::from(rims.status != "converged");
        self.gap = rims.gap.map(|gap| gap.max(self.gap.unwrap_or(0.0)));
        self.energy = rims.energy.kinetic + rims.energy.potential;
        if let (Some(a), Some(b)) = (rims.rim_a.last(), rims.rim_b.last()) {
            self.end = std::array::from_fn(|i| 500.0 * (a[i] + b[i]));
        }
    }

    fn line(&self, out: &mut impl Write, number: usize) -> std::io::Result<()> {
        let ([x, y, z], w) = (self.end, &self.work);
        let closed =
            self.gap.map_or_else(String::new, |gap| format!(", open by {gap:.1e} at most"));
        writeln!(
            out,
            "ribbon {number:<3} {} steps, {} Newton steps, {} factorisations, {} trials; {} frames short of converged{closed}",
            w.steps, w.newton_steps, w.factorisations, w.trials, self.short
        )?;
        writeln!(out, "           ends at {x:.2}, {y:.2}, {z:.2} mm; {:.6} J", self.energy)?;
        self.heard.line(out)
    }
}

fn told(event: &EventName, time_s: f64) -> Option<String> {
    Some(match event {
        EventName::Lifted { from_right, leaves } => {
            let side = if *from_right { "right" } else { "left" };
            let noun = if *leaves == 1 { "leaf" } else { "leaves" };
            format!("{time_s:.3} s: {leaves} {noun} lifted from the {side}")
        }
        EventName::Held { leaves } => format!("{time_s:.3} s: {leaves} in the hand"),
        EventName::Committed { page } => format!("{time_s:.3} s: turned, open at page {page}"),
        EventName::Cancelled => format!("{time_s:.3} s: put back"),
        EventName::Asleep => format!("{time_s:.3} s: at rest"),
        // Told with their ribbons, in sum.
        EventName::Touched { .. } | EventName::Snapped { .. } => return None,
    })
}
