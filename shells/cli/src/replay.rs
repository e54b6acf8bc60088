//! `dogleaf replay`: a recording run again, hash by hash.

use crate::args::ReplayArgs;
use crate::error::{CliError, shown};
use crate::files::{say, say_json};
use crate::grid::{GridName, with_grid};
use crate::sim::{Bundle, StrandFound, replay_strands};
use dogleaf_core::Book;
use dogleaf_core::grid::Grid;
use dogleaf_core::real::Real;
use dogleaf_core::record::{self, Divergence, MAX_BYTES, Reader, RecordError, Tier, Verdict};
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
    if Bundle::meant(&bytes) {
        return replay_bundle(args, &bytes);
    }
    let reader = Reader::open(&bytes).map_err(refuse)?;
    let verdict = run_again(&reader).map_err(refuse)?;
    let found = found(&reader, &verdict);
    if args.json {
        say_json(&found)?;
    } else {
        say(&found.line())?;
    }
    judged(&file, &verdict)
}

/// A divergence is a failed check.
fn judged(what: &str, verdict: &Verdict) -> Result<(), CliError> {
    let Some(diverged) = verdict.diverged else { return Ok(()) };
    let why = if verdict.same_build { "" } else { " (made by another build of the core)" };
    Err(CliError::Check(format!("{what}: {diverged}{why}")))
}

/// What the replay of a scene with ribbons found.
#[derive(Serialize)]
struct AllFound {
    #[serde(skip_serializing_if = "Option::is_none")]
    book: Option<Found>,
    ribbons: Vec<RibbonFound>,
}

/// What a ribbon's replay found.
#[derive(Serialize)]
struct RibbonFound {
    steps: u32,
    real: String,
    segments: usize,
    same_build: bool,
    diverged: Option<Diverged>,
    final_hash: String,
}

/// Replays the book of a bundle, where there is one, and its ribbons.
fn replay_bundle(args: &ReplayArgs, bytes: &[u8]) -> Result<(), CliError> {
    let file = shown(&args.recording);
    let refuse = |error| CliError::Recording { file: file.clone(), error };
    let bundle = Bundle::read(bytes).map_err(refuse)?;
    let reader = bundle.body.as_deref().map(Reader::open).transpose().map_err(refuse)?;
    let body = reader.as_ref().map(run_again).transpose().map_err(refuse)?;
    let strands = replay_strands(&bundle).map_err(refuse)?;
    let all = AllFound {
        book: reader.as_ref().zip(body.as_ref()).map(|(reader, verdict)| found(reader, verdict)),
        ribbons: strands.iter().map(ribbon_found).collect(),
    };
    if args.json {
        say_json(&all)?;
    } else {
        all.book.as_ref().map_or(Ok(()), |book| say(&book.line()))?;
        for (k, RibbonFound { steps, real, segments, final_hash, .. }) in
            all.ribbons.iter().enumerate()
        {
            say(&format!(
                "ribbon {k}: {steps} steps, {real}, {segments} segments: hash {final_hash}\n"
            ))?;
        }
    }
    body.as_ref().map_or(Ok(()), |verdict| judged(&file, verdict))?;
    let mut ribbons = strands.iter().enumerate();
    ribbons.try_for_each(|(k, s)| judged(&format!("{file}, ribbon {k}"), &s.verdict))
}

fn ribbon_found(strand: &StrandFound) -> RibbonFound {
    let verdict = &strand.verdict;
    RibbonFound {
        steps: verdict.steps,
        real: strand.tier.to_string(),
        segments: strand.segments,
        same_build: verdict.same_build,
        diverged: verdict.diverged.map(Diverged::of),
        final_hash: hex(verdict.final_hash),
    }
}

fn hex(hash: u64) -> String {
    format!("{hash:016x}")
}

impl Diverged {
    fn of(d: Divergence) -> Self {
        Self { step: d.step, expected: hex(d.expected), found: hex(d.found) }
    }
}

impl Found {
    fn line(&self) -> String {
        let Self { steps, inputs, real, grid: [nx, nz], final_hash, .. } = self;
        format!("{steps} steps, {inputs} samples, {real}, {nx}x{nz} nodes: hash {final_hash}\n")
    }
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
    Found {
        steps: verdict.steps,
        inputs: reader.inputs(),
        refused: verdict.refused,
        real: reader.header().tier.to_string(),
        grid: reader.header().grid,
        same_build: verdict.same_build,
        diverged: verdict.diverged.map(Diverged::of),
        final_hash: hex(verdict.final_hash),
    }
}
