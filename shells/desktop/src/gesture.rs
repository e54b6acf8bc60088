//! A recorded gesture: one pointer sample a line, `{"t_us":0,"id":0,"phase":"down","x":..,"y":..}`, places in 1/256
//! pixel. `id` may be left out; a `down` may say how many `leaves` to take up.

use crate::error::{DesktopError, one_line};
use dogleaf_core::hand::{Phase, Sample};
use serde::Deserialize;
use std::io::Read;
use std::path::Path;

/// Largest gesture file read, bytes.
const LARGEST: u64 = 128 << 20;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    t_us: u64,
    #[serde(default)]
    id: u8,
    phase: String,
    x: f64,
    y: f64,
    #[serde(default)]
    leaves: u16,
}

/// Reads a gesture file.
///
/// # Errors
///
/// It cannot be read; a line, by its number, that is no sample or runs back in time.
pub fn load(path: &Path) -> Result<Vec<Sample>, DesktopError> {
    let unread = |e: std::io::Error| DesktopError::file(path, "cannot be read", &e);
    let mut text = String::new();
    let file = std::fs::File::open(path).map_err(unread)?;
    file.take(LARGEST).read_to_string(&mut text).map_err(unread)?;
    parse(&text, &one_line(&path.display().to_string()))
}

/// Reads a gesture; empty lines are skipped.
///
/// # Errors
///
/// As [`load`]; `name` stands for the file.
pub fn parse(text: &str, name: &str) -> Result<Vec<Sample>, DesktopError> {
    let mut samples: Vec<Sample> = Vec::new();
    for (n, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let sample = sample(line).and_then(|sample| {
            let back = samples.last().is_some_and(|last| last.t_us > sample.t_us);
            if back { Err("t_us runs backwards".to_owned()) } else { Ok(sample) }
        });
        let refused = |reason| DesktopError::File { file: format!("{name}:{}", n + 1), reason };
        samples.push(sample.map_err(refused)?);
    }
    Ok(samples)
}

fn sample(line: &str) -> Result<Sample, String> {
    let line: Line = serde_json::from_str(line).map_err(|e| {
        let text = one_line(&e.to_string());
        // Its own line number is always 1.
        text.split(" at line ").next().unwrap_or(&text).to_owned()
    })?;
    let phase = Phase::ALL.into_iter().find(|(name, _)| *name == line.phase);
    let (_, phase) = phase.ok_or_else(|| format!("no phase is called {:?}", line.phase))?;
    let place = |v: f64| {
        let inside = (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&v);
        inside.then_some(v.round() as i32).ok_or_else(|| "a place beyond every screen".to_owned())
    };
    let (x, y) = (place(line.x)?, place(line.y)?);
    Ok(Sample { t_us: line.t_us, id: line.id, phase, x, y, leaves: line.leaves })
}
