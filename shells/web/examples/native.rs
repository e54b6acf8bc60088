//! What a browser must come to, done natively: `native FILE.dlr [--mesh OUT]` runs a recording, prints how long steps take
//! and the hash at the end. `native --gesture FILE.jsonl WIDTH HEIGHT UNTIL_US --mesh OUT` plays a gesture and writes the vertices.

use dogleaf_core::hand::{Phase, Sample};
use dogleaf_web::replay::Otherwise;
use dogleaf_web::{BookOptions, Desk, Replay};
use std::error::Error;
use std::fs;
use std::time::Instant;

/// Runs through a recording; the first ones are not counted.
const RUNS: usize = 40;
const FRAME_US: u64 = 16_667;

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = args.iter().map(String::as_str).collect();
    match words.as_slice() {
        [file] => timed(&fs::read(file)?),
        ["--gesture", file, width, height, until, "--mesh", out] => {
            let options = BookOptions::new(24, width.parse()?, height.parse()?);
            mesh(options, &fs::read_to_string(file)?, until.parse()?, out)
        }
        _ => {
            Err("usage: native FILE.dlr | --gesture FILE.jsonl WIDTH HEIGHT UNTIL_US --mesh OUT"
                .into())
        }
    }
}

/// Median and best of the steps with a leaf in the air, microseconds.
fn timed(bytes: &[u8]) -> Result<(), Box<dyn Error>> {
    let mut best: Vec<f64> = Vec::new();
    let mut all = Vec::new();
    let mut last = 0;
    for _ in 0..RUNS {
        let mut replay = Replay::open(bytes, Otherwise::default())?;
        let mut step = 0;
        while let kind @ 1.. = replay.prepare() {
            let start = Instant::now();
            replay.step();
            let took = start.elapsed().as_secs_f64() * 1e6;
            if kind == 2 {
                all.push(took);
                match best.get_mut(step) {
                    Some(b) => *b = b.min(took),
                    None => best.push(took),
                }
                step += 1;
            }
        }
        if let Some(step) = replay.diverged {
            return Err(format!("step {step} diverges").into());
        }
        last = replay.hash();
    }
    let median = |times: &mut Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times.get(times.len() / 2).copied().unwrap_or_default()
    };
    println!(
        "{{\"median_us\":{:.2},\"best_us\":{:.2},\"hash\":\"{last:016x}\"}}",
        median(&mut all),
        median(&mut best)
    );
    Ok(())
}

/// Plays a gesture frame by frame, as a page does.
fn mesh(
    mut options: BookOptions,
    gesture: &str,
    until: u64,
    out: &str,
) -> Result<(), Box<dyn Error>> {
    options.book.open_at = 8;
    let mut desk = Desk::open(&options)?;
    let mut samples = gesture.lines().map(sample).peekable();
    for frame in 0..=until / FRAME_US {
        let now = frame * FRAME_US;
        while let Some(sample) = samples.next_if(|s| s.as_ref().is_ok_and(|s| s.t_us <= now)) {
            desk.pointer(sample?)?;
        }
        desk.step(now);
    }
    let bytes: Vec<u8> = desk.mesh.vertices.iter().flat_map(bytes).collect();
    fs::write(out, bytes)?;
    println!("{:016x}", desk.paper().book().state_hash());
    Ok(())
}

fn bytes(v: &dogleaf_core::mesh::Vertex) -> Vec<u8> {
    v.position.iter().chain(&v.normal).chain(&v.uv).flat_map(|f| f.to_le_bytes()).collect()
}

/// One line `{"t_us":0,"id":0,"phase":"down","x":1,"y":2}`.
fn sample(line: &str) -> Result<Sample, Box<dyn Error>> {
    let value = |key: &str| -> Option<&str> {
        let rest = line.split_once(&format!("\"{key}\":"))?.1;
        Some(rest.split([',', '}']).next()?.trim().trim_matches('"'))
    };
    let number = |key: &str| value(key).unwrap_or("0").parse::<i64>();
    let phase = value("phase").and_then(|w| Phase::ALL.iter().find(|(name, _)| *name == w));
    let (_, phase) = phase.ok_or_else(|| format!("no phase in {line}"))?;
    let (x, y) = (number("x")? as i32, number("y")? as i32);
    let (id, leaves) = (number("id")? as u8, number("leaves")? as u16);
    Ok(Sample { t_us: number("t_us")? as u64, id, phase: *phase, x, y, leaves })
}
