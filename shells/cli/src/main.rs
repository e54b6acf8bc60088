//! The program `dogleaf`: turns the pages of a real book, runs scenes, replays recordings, measures.
//!
//! Every word of the command line is one module; `main` only chooses, and turns an error into one
//! line and an exit code.

mod args;
mod bench;
mod cost;
mod eink;
mod error;
mod files;
mod gesture;
mod grid;
mod picture;
mod progress;
mod replay;
mod run;
mod scene;
mod sim;
mod turn;

use args::{Cli, Command};
use clap::Parser;
use clap::error::ErrorKind;
use error::CliError;
use std::process::ExitCode;

#[global_allocator]
static ALLOCATOR: bench::alloc::Counting = bench::alloc::Counting;

/// Stack of the thread that works: the finest grid in `f64` is built on it.
const STACK: usize = 256 << 20;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return refuse(&error),
    };
    let work = move || command(&cli.command);
    let worker = std::thread::Builder::new().stack_size(STACK).spawn(work);
    let outcome = worker.map(std::thread::JoinHandle::join);
    match outcome {
        Ok(Ok(Ok(()))) => ExitCode::SUCCESS,
        Ok(Ok(Err(error))) => fail(&error),
        // A panic has already said where; it is a bug of ours.
        Ok(Err(_)) | Err(_) => ExitCode::from(101),
    }
}

fn command(command: &Command) -> Result<(), CliError> {
    match command {
        Command::Turn(args) => turn::turn(args),
        Command::Run(args) => run::run(args),
        Command::Replay(args) => replay::replay(args),
        Command::Bench(args) => bench::bench(args),
        Command::Cost(args) => cost::cost(args),
        Command::Eink(args) => eink::eink(args),
        Command::Gestures(args) => gesture::write_all(&args.folder),
    }
}

fn fail(error: &CliError) -> ExitCode {
    if !matches!(error, CliError::Gone) {
        eprintln!("dogleaf: {}", error::one_line(&error.to_string()));
    }
    ExitCode::from(error.exit_code())
}

/// Help and version go out as they are; anything else is one line.
fn refuse(error: &clap::Error) -> ExitCode {
    let asked = [ErrorKind::DisplayHelp, ErrorKind::DisplayVersion];
    let nothing = error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand;
    if asked.contains(&error.kind()) || nothing {
        let _ = error.print();
        return ExitCode::from(if nothing { 2 } else { 0 });
    }
    let text = error.to_string();
    let parts = text.split("Usage:").next().unwrap_or(&text);
    let parts = parts.split("For more information").next().unwrap_or(parts);
    let line = error::one_line(parts);
    eprintln!("dogleaf: {}", line.strip_prefix("error: ").unwrap_or(&line));
    ExitCode::from(2)
}
