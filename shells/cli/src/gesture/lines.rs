//! One pointer sample a line: `{"t_us":0,"id":0,"phase":"down","x":..,"y":..}`, places in 1/256 pixel.
//!
//! `id` may be left out; a `down` may say how many `leaves` to take up.

use crate::error::{CliError, one_line, shown};
use crate::files::read_text;
use dogleaf_core::hand::{Phase, Sample};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Samples of one gesture at most: a finger at 1000 Hz for a quarter of an hour.
const MOST: usize = 1_000_000;

/// Largest gesture file read, bytes.
const LARGEST: u64 = 128 << 20;

/// A gesture is refused; nothing was run.
#[derive(Debug, thiserror::Error)]
#[error("{file}:{line}: {reason}")]
pub(crate) struct GestureError {
    file: String,
    line: usize,
    reason: String,
}

/// A line.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    t_us: u64,
    #[serde(default)]
    id: u8,
    phase: Name,
    #[serde(deserialize_with = "place")]
    x: i32,
    #[serde(deserialize_with = "place")]
    y: i32,
    #[serde(default, skip_serializing_if = "is_zero")]
    leaves: u16,
}

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Name {
    Down,
    Move,
    Up,
    Cancel,
}

/// A place in 1/256 pixel; a fraction is rounded to the nearest.
fn place<'de, D: serde::Deserializer<'de>>(from: D) -> Result<i32, D::Error> {
    let value = f64::deserialize(from)?.round();
    let inside = (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&value);
    let refused = || serde::de::Error::custom("a place beyond every screen");
    inside.then_some(value as i32).ok_or_else(refused)
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks for a reference")]
fn is_zero(leaves: &u16) -> bool {
    *leaves == 0
}

impl From<Line> for Sample {
    fn from(l: Line) -> Self {
        let phase = match l.phase {
            Name::Down => Phase::Down,
            Name::Move => Phase::Move,
            Name::Up => Phase::Up,
            Name::Cancel => Phase::Cancel,
        };
        Self { t_us: l.t_us, id: l.id, phase, x: l.x, y: l.y, leaves: l.leaves }
    }
}

impl From<&Sample> for Line {
    fn from(s: &Sample) -> Self {
        let phase = match s.phase {
            Phase::Down => Name::Down,
            Phase::Move => Name::Move,
            Phase::Up => Name::Up,
            Phase::Cancel => Name::Cancel,
        };
        Self { t_us: s.t_us, id: s.id, phase, x: s.x, y: s.y, leaves: s.leaves }
    }
}

/// Reads a gesture file.
pub(crate) fn load(path: &Path) -> Result<Vec<Sample>, CliError> {
    let text = read_text(path, LARGEST)?;
    Ok(parse(&text, &shown(path))?)
}

/// Reads a gesture; empty lines are skipped, time must not run backwards.
pub(crate) fn parse(text: &str, file: &str) -> Result<Vec<Sample>, GestureError> {
    let mut samples: Vec<Sample> = Vec::new();
    for (n, line) in text.lines().enumerate().filter(|(_, l)| !l.trim().is_empty()) {
        let refuse = |reason| GestureError { file: file.to_owned(), line: n + 1, reason };
        let line: Line = serde_json::from_str(line).map_err(|e| refuse(in_line(&e)))?;
        let sample = Sample::from(line);
        if samples.last().is_some_and(|last| last.t_us > sample.t_us) {
            return Err(refuse("t_us runs backwards".to_owned()));
        }
        if samples.len() == MOST {
            return Err(refuse(format!("a gesture of more than {MOST} samples is refused")));
        }
        samples.push(sample);
    }
    Ok(samples)
}

/// What serde says, without its own line number, which is always 1.
fn in_line(error: &serde_json::Error) -> String {
    let text = one_line(&error.to_string());
    match text.split_once(" at line 1 column ") {
        Some((what, column)) => format!("{what} (column {column})"),
        None => text,
    }
}

/// Writes a gesture.
pub(crate) fn to_lines(samples: &[Sample]) -> String {
    let mut text = String::new();
    for sample in samples {
        text += &serde_json::to_string(&Line::from(sample)).unwrap_or_default();
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back() {
        let text = "{\"t_us\":0,\"id\":1,\"phase\":\"down\",\"x\":-3,\"y\":70000,\"leaves\":9}\n\
                    {\"t_us\":5,\"id\":1,\"phase\":\"cancel\",\"x\":1,\"y\":2}\n";
        let samples = parse(text, "g").expect("sound");
        assert_eq!(samples.len(), 2, "two lines");
        assert_eq!(to_lines(&samples), text, "the same text");
    }

    #[test]
    fn faults_name_their_line() {
        for (text, wanted) in [
            ("\n{\"t_us\":0}", "g:2: missing field `phase` (column 10)"),
            ("{\"t_us\":0,\"phase\":\"fly\",\"x\":0,\"y\":0}", "unknown variant `fly`"),
            ("{\"t_us\":0,\"phase\":\"up\",\"x\":\"0\",\"y\":0}", "expected f64"),
            ("{\"t_us\":0,\"phase\":\"up\",\"x\":1e12,\"y\":0}", "beyond every screen"),
            (
                "{\"t_us\":9,\"phase\":\"up\",\"x\":0,\"y\":0}\n{\"t_us\":8,\"phase\":\"up\",\"x\":0,\"y\":0}",
                "g:2: t_us runs backwards",
            ),
        ] {
            let error = parse(text, "g").expect_err("refused").to_string();
            assert!(error.contains(wanted), "{error} should say {wanted}");
        }
    }
}
