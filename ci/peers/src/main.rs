//! `cargo ci peers`: what a step's linear algebra costs with Eigen, in the process that times ours.
//!
//! Ratios inside one process on one machine are what to trust; the microseconds are this machine's.

mod bench;
mod eigen;
mod machine;
mod matrices;
mod oracle;
mod ours;
mod report;
#[cfg(test)]
mod synthetic;
#[cfg(test)]
mod triplets;
mod turn;

use std::process::ExitCode;

use bench::{Contender, race};
use eigen::{Eigen, Method};
use oracle::Oracle;
use ours::{Condensed, Step};

/// How many times faster than `SparseLU`'s factor and solve our whole step in `f32` is promised to be.
const PROMISE: f64 = 40.0;

const USAGE: &str = "usage: cargo ci peers [--json] [--repeats N]

  --json        one JSON object instead of the table
  --repeats N   how often every matrix is factored by everyone (default 7)

Ends with 1 if a promised ratio is missed.";

/// What the caller asked for.
#[derive(Debug)]
struct Options {
    json: bool,
    repeats: usize,
}

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let options = match parse(&args) {
        Ok(options) => options,
        Err(why) => {
            eprintln!("peers: {why}\n\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    match compare(&options) {
        Ok((text, kept)) => {
            println!("{text}");
            if kept { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
        Err(why) => {
            eprintln!("peers: {why}");
            ExitCode::FAILURE
        }
    }
}

fn parse(args: &[String]) -> Result<Options, String> {
    let mut options = Options { json: false, repeats: 7 };
    let mut args = args.iter();
    while let Some(arg) = args.next() {
        match arg.as_str() {
            "--json" => options.json = true,
            "--repeats" => {
                let n = args.next().and_then(|n| n.parse().ok()).filter(|n| *n > 0);
                options.repeats = n.ok_or("--repeats wants a number above 0")?;
            }
            other => return Err(format!("unexpected `{other}`")),
        }
    }
    Ok(options)
}

/// The comparison as text, and whether what is promised was seen.
fn compare(options: &Options) -> Result<(String, bool), String> {
    let turn = turn::corner_turn()?;
    let set = &turn.set;
    let mut lu = Eigen::new(Method::SparseLu, set)?;
    let mut ldlt = Eigen::new(Method::SimplicialLdlt, set)?;
    let mut oracle = Oracle::new(&turn).ok_or("no matrices")?;
    let mut leaf_single = Condensed::new("dogleaf leaf solve, f32", &turn.scene, &turn.single);
    let mut leaf_double = Condensed::new("dogleaf leaf solve, f64", &turn.scene, &turn.double);
    let mut single = Step::new("dogleaf whole step, f32", Some(PROMISE), &turn.single);
    let mut double = Step::new("dogleaf whole step, f64", None, &turn.double);
    let field: &mut [&mut dyn Contender] = &mut [
        &mut lu,
        &mut ldlt,
        &mut oracle,
        &mut leaf_single,
        &mut leaf_double,
        &mut single,
        &mut double,
    ];
    let rows = race(field, set, options.repeats);
    if let Some(why) = rows.first().and_then(|baseline| baseline.figures.as_ref().err()) {
        return Err(format!("the baseline failed: {why}"));
    }
    let text = if options.json { report::json } else { report::table };
    Ok((text(set, &rows, options.repeats), report::kept(&rows)))
}
