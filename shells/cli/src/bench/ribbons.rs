//! Ribbons: what a step costs, and how much sooner Newton's method is where the seed's own method comes to.

use super::alloc;
use super::times::{Figures, figures};
use crate::error::CliError;
use dogleaf_core::effect::ribbon::Ribbon;
use dogleaf_cost::ribbon::race::{Race, race};
use dogleaf_cost::ribbon::scenes::{Scene, fall, helix, torsion};
use serde::Serialize;
use std::io::{self, Write};
use std::time::Instant;

/// Steps of a scene that are raced.
const RACED: u32 = 20;

/// One scene.
#[derive(Serialize)]
pub(super) struct Row {
    segments: usize,
    /// A step to what the eye can tell, f64.
    step_us: Figures,
    allocations: u64,
    #[serde(flatten)]
    race: Race,
}

/// All scenes, and what a ribbon takes.
#[derive(Serialize)]
pub(super) struct Ribbons {
    scenes: Vec<Row>,
    /// Bytes of a ribbon of at most 50 and 150 segments, in f32 and f64.
    bytes: [[usize; 2]; 2],
}

impl Ribbons {
    /// Allocations during the steps.
    pub(super) fn allocations(&self) -> u64 {
        self.scenes.iter().map(|row| row.allocations).sum()
    }

    /// The table.
    pub(super) fn print(&self, out: &mut impl Write) -> io::Result<()> {
        writeln!(
            out,
            "\nribbons, f64: to a gap of 1e-6, mean over the steps that both bring there, of {RACED}"
        )?;
        writeln!(
            out,
            "{:<14} {:>8} {:>8} {:>9} {:>7} {:>8} {:>8} {:>7} {:>8} {:>9} {:>7}",
            "scene",
            "step us",
            "p99",
            "Newton it",
            "us",
            "seed it",
            "us",
            "ratio",
            "both of",
            "over all",
            "lower"
        )?;
        for Row { step_us, race: r, .. } in &self.scenes {
            writeln!(
                out,
                "{:<14} {:>8.0} {:>8.0} {:>9.1} {:>7.0} {:>8.0} {:>8.0} {:>6.0}x {:>3} of {:<2} {:>3}{:>5.0}x {:>3}:{:<3}",
                r.scene,
                step_us.median,
                step_us.p99,
                r.newton_iterations,
                r.newton_us,
                r.seed_iterations,
                r.seed_us,
                r.ratio,
                r.both_arrive,
                r.steps,
                ">",
                r.at_least,
                r.better[0],
                r.better[1]
            )?;
        }
        writeln!(
            out,
            "over all: what the seed's method had spent where it gave up; lower: ends lower than the other's, Newton's to the seed's"
        )?;
        let [[a, b], [c, d]] = self.bytes;
        writeln!(out, "bytes of a ribbon: 50 segments {a} (f32), {b}; 150 segments {c}, {d}")
    }
}

/// Plays and races every scene.
pub(super) fn ribbons() -> Result<Ribbons, CliError> {
    let scenes: [fn() -> Result<Scene, _>; 4] =
        [|| helix("helix h=0.01", 0.01), || helix("helix h=0.05", 0.05), fall, || torsion(0.05)];
    let rows: Result<Vec<Row>, CliError> =
        scenes.iter().map(|open| Ok(row(open()?, open()?))).collect();
    let bytes = [
        [size_of::<Ribbon<f32, 50>>(), size_of::<Ribbon<f64, 50>>()],
        [size_of::<Ribbon<f32, 150>>(), size_of::<Ribbon<f64, 150>>()],
    ];
    Ok(Ribbons { scenes: rows?, bytes })
}

fn row(mut scene: Scene, again: Scene) -> Row {
    let segments = scene.ribbon.spec().segments;
    let mut micros = Vec::with_capacity(scene.steps as usize);
    let mut allocations = 0;
    for step in 0..scene.steps {
        scene.ask(step);
        let before = alloc::count();
        let start = Instant::now();
        scene.ribbon.step_under(scene.h, &scene.floor);
        micros.push(start.elapsed().as_nanos() as f64 * 1e-3);
        allocations += alloc::count() - before;
    }
    Row {
        segments,
        step_us: figures(&micros),
        allocations,
        race: race(again, scene.steps.div_ceil(RACED)),
    }
}
