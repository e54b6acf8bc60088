//! `dogleaf bench`: what a step costs on this machine, part by part.
//!
//! A slow turn is played on a book at 11x8, in `f32` and `f64` by turns, and every step with a leaf in
//! the air is timed: leaf, blocks, boards, contact, line search; the mesh is not part of a step. Then
//! the parts are timed one by one on the poses of that turn. Then ribbons, beside the seed's own method. Of every figure the least of all rounds
//! is told: the machine can only make it larger.

pub(crate) mod alloc;
mod machine;
mod parts;
mod poses;
mod report;
mod ribbons;
pub(crate) mod times;
mod turn;

use crate::args::BenchArgs;
use crate::error::CliError;
use crate::files::say_json;
use crate::progress;
use dogleaf_core::grid::{G11x8, Grid};
use dogleaf_core::real::Real;
use report::{Bytes, Report, Side};
use times::Times;

/// The grid measured.
type Measured = G11x8;

/// Measures and prints.
pub(crate) fn bench(args: &BenchArgs) -> Result<(), CliError> {
    let report = measure(args.turns)?;
    if args.json {
        say_json(&report)?;
    } else {
        report.print().map_err(|e| CliError::write("standard output".as_ref(), &e))?;
    }
    let n = report.allocations + report.ribbons.allocations();
    if n > 0 {
        return Err(CliError::Check(format!("{n} allocations during the steps, none expected")));
    }
    Ok(())
}

fn measure(rounds: u32) -> Result<Report, CliError> {
    let bar = progress::bar(u64::from(rounds) + 1, "turns");
    let mut narrow = Bench::<f32, Measured>::new()?;
    let mut wide = Bench::<f64, Measured>::new()?;
    // The first round warms caches and branch predictors and is not counted.
    for round in 0..=rounds {
        narrow.round(round > 0)?;
        wide.round(round > 0)?;
        bar.inc(1);
    }
    bar.set_message("ribbons");
    let ribbons = ribbons::ribbons()?;
    bar.finish_and_clear();
    Ok(Report {
        machine: machine::machine(),
        grid: [Measured::NX, Measured::NZ],
        rounds,
        allocations: narrow.allocations + wide.allocations,
        f32: narrow.side(),
        f64: wide.side(),
        ribbons,
    })
}

/// One scalar's measurements.
struct Bench<R: Real, G: Grid> {
    turn: turn::Turn<R, G>,
    parts: parts::Parts<R, G>,
    played: turn::Played,
    steps: Times,
    by_part: [Times; parts::NAMES.len()],
    allocations: u64,
}

impl<R: Real, G: Grid> Bench<R, G> {
    fn new() -> Result<Self, CliError> {
        let mut turn = turn::Turn::new();
        let poses = poses::poses(&mut turn)?;
        Ok(Self {
            parts: parts::Parts::new(poses),
            played: turn.play()?,
            turn,
            steps: Times::default(),
            by_part: Default::default(),
            allocations: 0,
        })
    }

    /// One turn and its parts; a round that does not count only warms up.
    fn round(&mut self, counts: bool) -> Result<(), CliError> {
        let played = self.turn.play()?;
        let by_part = self.parts.time();
        self.allocations += played.allocations;
        if counts {
            self.steps.round(&played.micros);
            for (times, micros) in self.by_part.iter_mut().zip(&by_part) {
                times.round(micros);
            }
        }
        self.played = played;
        Ok(())
    }

    fn side(&self) -> Side {
        Side {
            real: R::NAME,
            steps: self.played.micros.len(),
            step_us: self.steps.figures(),
            parts: parts::report(&self.by_part, self.steps.figures().median),
            counts: self.played.counts,
            bytes: Bytes::of::<R, G>(),
            hash: format!("{:016x}", self.played.hash),
            trail: format!("{:016x}", self.played.trail),
        }
    }
}
