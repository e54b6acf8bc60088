//! `cargo ci peers`: what a step's linear algebra costs with Eigen, in the process that times ours.
//!
//! Ratios inside one process on one machine are what to trust; the microseconds are this machine's.

mod bench;
mod eigen;
mod matrices;
mod report;
mod synthetic;

use std::process::ExitCode;

use bench::{Contender, race};
use eigen::{Eigen, Method};

const USAGE: &str = "usage: cargo ci peers [--json] [--repeats N]

  --json        one JSON object instead of the table
  --repeats N   how often every matrix is factored by everyone (default 7)";

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
        Ok(text) => {
            println!("{text}");
            ExitCode::SUCCESS
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

fn compare(options: &Options) -> Result<String, String> {
    let set = synthetic::page_turn();
    let mut lu = Eigen::new(Method::SparseLu, &set)?;
    let mut ldlt = Eigen::new(Method::SimplicialLdlt, &set)?;
    let field: &mut [&mut dyn Contender] = &mut [&mut lu, &mut ldlt];
    let rows = race(field, &set, options.repeats);
    if let Some(why) = rows.first().and_then(|baseline| baseline.figures.as_ref().err()) {
        return Err(format!("the baseline failed: {why}"));
    }
    let text = if options.json { report::json } else { report::table };
    Ok(text(&set, &rows, options.repeats))
}
