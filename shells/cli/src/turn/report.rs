//! What a turn came to: a few lines, or one object.

use super::play::Figures;
use crate::error::CliError;
use crate::files::{say, say_json};
use serde::Serialize;

#[derive(Serialize)]
struct Report<'a> {
    steps: u32,
    step_us: StepUs,
    stretch: Stretch,
    committed_page: Option<u32>,
    simulated: &'a [&'static str],
    #[serde(skip_serializing_if = "Option::is_none")]
    ribbon: Option<Ribbon>,
    out: &'a str,
}

/// What the bookmark cost, and where it ended.
#[derive(Serialize)]
struct Ribbon {
    steps: u32,
    step_us: StepUs,
    newton_steps: f64,
    marks_page: u32,
    lies: &'static str,
}

#[derive(Serialize)]
struct StepUs {
    median: f64,
    p99: f64,
}

#[derive(Serialize)]
struct Stretch {
    max: f64,
    avg_max: f64,
    rms: f64,
}

/// Prints the figures of a turn.
pub(super) fn print(figures: &Figures, json: bool, out: &str) -> Result<(), CliError> {
    let [median, p99] = figures.step_us();
    let [max, avg_max, rms] = figures.stretch();
    let report = Report {
        steps: figures.steps,
        step_us: StepUs { median, p99 },
        stretch: Stretch { max, avg_max, rms },
        committed_page: figures.committed,
        simulated: &figures.simulated,
        ribbon: figures.ribbon.as_ref().map(ribbon),
        out,
    };
    if json { say_json(&report) } else { say(&lines(&report, figures)) }
}

fn ribbon(of: &super::sewn::Figures) -> Ribbon {
    let [median, p99] = of.step_us();
    Ribbon {
        steps: of.steps(),
        step_us: StepUs { median, p99 },
        newton_steps: of.newton_steps(),
        marks_page: of.marks,
        lies: of.lies,
    }
}

fn lines(r: &Report<'_>, figures: &Figures) -> String {
    let percent = |share: f64| 100.0 * share;
    let turned = match r.committed_page {
        Some(page) => format!("turned: open at page {page}"),
        None => "put back".to_owned(),
    };
    format!(
        "{turned}\n\
         steps      {}, {:.1} µs median, {:.1} µs p99, {} at worst\n\
         stretch    {:.2} % at most, {:.2} % mean of the largest, {:.3} % RMS\n\
         simulated  {}\n\
         {}written    {}\n",
        r.steps,
        r.step_us.median,
        r.step_us.p99,
        figures.total.status.name(),
        percent(r.stretch.max),
        percent(r.stretch.avg_max),
        percent(r.stretch.rms),
        r.simulated.join(", "),
        r.ribbon.as_ref().map(told).unwrap_or_default(),
        r.out,
    )
}

fn told(r: &Ribbon) -> String {
    format!(
        "ribbon     {} steps, {:.1} µs median, {:.1} µs p99, {:.1} Newton steps; at page {}, {}\n",
        r.steps, r.step_us.median, r.step_us.p99, r.newton_steps, r.marks_page, r.lies
    )
}
