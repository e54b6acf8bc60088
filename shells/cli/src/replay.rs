//! `dogleaf replay`: a recording run again, hash by hash.

use crate::args::ReplayArgs;
use crate::error::{CliError, shown};
use crate::files::{say, say_json};
use crate::grid::{GridName, with_grid};
use dogleaf_core::Book;
use dogleaf_core::grid::Grid;
use dogleaf_core::real::Real;
use dogleaf_core::record::{self, MAX_BYTES, Reader, RecordError, Tier, Verdict};
use serde::Serialize;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// What a replay found.
#[derive(Serialize)]
struct Found {
    steps: u32,
    inputs: u32,
    refused: u32,
    real: String,
    grid: [u8; 2],
    same_build: bool,
    diverged: Option<Diverged>,
    final_hash: String,
}

/// The first step whose hash is another.
#[derive(Serialize)]
struct Diverged {
    step: u32,
    expected: String,
    found: String,
}

/// Replays a recording; a divergence is a failed check.
pub(crate) fn replay(args: &ReplayArgs) -> Result<(), CliError> {
    let file = shown(&args.recording);
    let refuse = |error| CliError::Recording { file: file.clone(), error };
    let bytes = read(&args.recording)?;
    let reader = Reader::open(&bytes).map_err(refuse)?;
    let verdict = run_again(&reader).map_err(refuse)?;
    let found = found(&reader, &verdict);
    if args.json {
        say_json(&found)?;
    } else {
        let Found { steps, inputs, real, grid: [nx, nz], final_hash, .. } = &found;
        say(&format!(
            "{steps} steps, {inputs} samples, {real}, {nx}x{nz} nodes: hash {final_hash}\n"
        ))?;
    }
    let Some(diverged) = verdict.diverged else { return Ok(()) };
    let why = if verdict.same_build { "" } else { " (made by another build of the core)" };
    Err(CliError::Check(format!("{file}: {diverged}{why}")))
}

fn read(path: &Path) -> Result<Vec<u8>, CliError> {
    let refuse = |e| CliError::read(path, &e);
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(refuse)?;
    file.take(MAX_BYTES as u64 + 1).read_to_end(&mut bytes).map_err(refuse)?;
    Ok(bytes)
}

/// On the scalar and the grid it was made with.
fn run_again(reader: &Reader<'_>) -> Result<Verdict, RecordError> {
    let header = reader.header();
    let unknown = RecordError::Unknown("grid");
    let grid = GridName::of(header.grid.map(f64::from)).ok_or(unknown)?;
    with_grid!(grid, G => match header.tier {
        Tier::F32 => on::<f32, G>(reader),
        Tier::F64 => on::<f64, G>(reader),
    })
}

fn on<R: Real, G: Grid>(reader: &Reader<'_>) -> Result<Verdict, RecordError> {
    let mut book = Box::new(Book::<R, G>::EMPTY);
    record::replay(reader, &mut book)
}

fn found(reader: &Reader<'_>, verdict: &Verdict) -> Found {
    let hash = |h: u64| format!("{h:016x}");
    Found {
        steps: verdict.steps,
        inputs: reader.inputs(),
        refused: verdict.refused,
        real: reader.header().tier.to_string(),
        grid: reader.header().grid,
        same_build: verdict.same_build,
        diverged: verdict.diverged.map(|d| Diverged {
            step: d.step,
            expected: hash(d.expected),
            found: hash(d.found),
        }),
        final_hash: hash(verdict.final_hash),
    }
}
