//! The plan of a turn: a table, or one object.

use super::play::{Shot, Told};
use crate::error::CliError;
use crate::files::{say, say_json};
use dogleaf_eink::Picture;
use serde::Serialize;

#[derive(Serialize)]
struct Report {
    page: u32,
    busy_us: u64,
    driven_px: u64,
    pictures: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    at_us: u64,
    picture: &'static str,
    waveform: &'static str,
    rect: [u16; 4],
    progress: Option<f64>,
    ghost_worst: u8,
    ghost_mean_permille: u32,
}

/// Prints what was shown.
pub(super) fn print(told: &Told, json: bool) -> Result<(), CliError> {
    let report = Report {
        page: told.page,
        busy_us: told.counts.busy_us,
        driven_px: told.counts.driven,
        pictures: told.shots.iter().map(row).collect(),
    };
    if json { say_json(&report) } else { say(&lines(&report)) }
}

fn row(shot: &Shot) -> Row {
    let rect = shot.update.rect;
    Row {
        at_us: shot.at_us,
        picture: match shot.update.picture {
            Picture::Moving => "turn",
            Picture::Settled => "page",
        },
        waveform: shot.update.waveform.name(),
        rect: [rect.x0, rect.y0, rect.width(), rect.height()],
        progress: shot.progress.map(|p| f64::from(p) / 1_024.0),
        ghost_worst: shot.ghost.worst,
        ghost_mean_permille: shot.ghost.mean_permille,
    }
}

fn lines(report: &Report) -> String {
    let mut text =
        String::from("     at  picture  waveform  rectangle          way  ghost, worst, of 255\n");
    for r in &report.pictures {
        let [x, y, w, h] = r.rect;
        let way = r.progress.map_or_else(String::new, |p| format!("{:.0} %", 100.0 * p));
        let at = r.at_us / 1_000;
        text += &format!(
            "{at:>4} ms  {:<7}  {:<8}  {:<16} {way:>5}  {}\n",
            r.picture,
            r.waveform,
            format!("{w}x{h} at {x},{y}"),
            r.ghost_worst
        );
    }
    text + &format!(
        "open at page {}; the panel was busy for {} ms and drove {} pixels\n",
        report.page,
        report.busy_us / 1_000,
        report.driven_px
    )
}
