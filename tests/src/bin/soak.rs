//! `soak [--steps N] [--seed S] [--real f32|f64] [--threads T] [--case C] [--keep FOLDER] [--json FILE]`: see
//! [`dogleaf_tests::soak`]. Behind `cargo ci soak`.

use dogleaf_core::real::Real;
use dogleaf_tests::soak::{Ask, Case, Sum, kept::keep, soak};
use std::io::{IsTerminal, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

/// Failing cases that are kept; one more would teach nothing.
const MOST_KEPT: usize = 20;

/// What was asked for.
struct Call {
    ask: Ask,
    real: String,
    only: Option<u64>,
    keep: Option<PathBuf>,
    json: Option<PathBuf>,
}

fn main() -> ExitCode {
    match call(std::env::args().skip(1)) {
        Ok(call) if call.real == "f64" => run::<f64>(&call),
        Ok(call) => run::<f32>(&call),
        Err(why) => {
            eprintln!("soak: {why}");
            ExitCode::from(2)
        }
    }
}

fn call(mut args: impl Iterator<Item = String>) -> Result<Call, String> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let ask = Ask { steps: 200_000, seed: 1, threads };
    let mut call = Call { ask, real: "f32".into(), only: None, keep: None, json: None };
    while let Some(name) = args.next() {
        let value = args.next().ok_or(format!("{name} needs a value"))?;
        let number = || value.parse::<u64>().map_err(|_| format!("{name}: `{value}` is no number"));
        match name.as_str() {
            "--steps" => call.ask.steps = number()?,
            "--seed" => call.ask.seed = number()?,
            "--threads" => call.ask.threads = number()?.clamp(1, 256) as usize,
            "--case" => call.only = Some(number()?),
            "--real" if ["f32", "f64"].contains(&value.as_str()) => call.real = value,
            "--keep" => call.keep = Some(value.into()),
            "--json" => call.json = Some(value.into()),
            _ => return Err(format!("`{name} {value}` makes no sense")),
        }
    }
    Ok(call)
}

fn run<R: Real>(call: &Call) -> ExitCode {
    if let Some(number) = call.only {
        let case = Case::new(call.ask.seed, number);
        let names: Vec<_> = case.gestures.iter().map(|g| g.0).collect();
        println!("{:#?}\n{names:?}, waits {:?}, looks {:?}", case.scene, case.waits, case.looks);
        let outcome = case.run_safely::<R>();
        println!("{outcome:#?}");
        return if outcome.faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE };
    }
    let start = Instant::now();
    let mut said = Instant::now();
    let seen = std::io::stderr().is_terminal();
    let sum = soak::<R>(&call.ask, |sum| {
        if seen && said.elapsed().as_millis() > 500 {
            said = Instant::now();
            let share = 100.0 * sum.steps as f64 / call.ask.steps.max(1) as f64;
            eprint!("\rsoak {share:5.1} %, {} failed ", sum.failures.len());
            let _ = std::io::stderr().flush();
        }
    });
    if seen {
        eprintln!("\rsoak done in {:.0} s          ", start.elapsed().as_secs_f64());
    }
    finish::<R>(call, &sum)
}

fn finish<R: Real>(call: &Call, sum: &Sum) -> ExitCode {
    println!("{sum}");
    for failure in sum.failures.iter().take(MOST_KEPT) {
        let case = Case::new(sum.seed, failure.case);
        if let Some(folder) = &call.keep {
            match keep::<R>(&case, sum.seed, folder) {
                Ok(file) => println!("  kept case {}: {}", failure.case, file.display()),
                Err(why) => eprintln!("soak: {why}"),
            }
        }
    }
    if let Some(file) = &call.json
        && let Err(why) = std::fs::write(file, sum.json() + "\n")
    {
        eprintln!("soak: {}: {why}", file.display());
        return ExitCode::FAILURE;
    }
    let complaints = sum.complaints();
    complaints.iter().for_each(|what| println!("  {what}"));
    if complaints.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
