//! `cargo ci <word>`: the project's own commands, and the only place that knows toolchains and targets.
//!
//! A Rust program and not a `justfile`, so that nothing but cargo is needed.

mod all;
mod android;
mod bans;
mod bindings;
mod boards;
mod desktop;
mod eink;
mod fuzz;
mod hashes;
mod no_std;
mod peers;
mod shell;
mod seed_slots;
mod size;
mod slots;
mod source;
mod style;
mod swift;
mod tally;
mod tests;
mod tools;
mod tree;
mod web;
mod words;

use std::path::PathBuf;
use std::process::ExitCode;

use words::Stop;

fn main() -> ExitCode {
    if let Err(why) = std::env::set_current_dir(root()) {
        eprintln!("cargo ci: cannot enter {}: {why}", root().display());
        return ExitCode::FAILURE;
    }
    let args: Vec<String> = std::env::args().skip(1).collect();
    match args.first().map(String::as_str) {
        None | Some("-h" | "--help" | "help") => {
            println!("{}", words::usage());
            ExitCode::SUCCESS
        }
        Some(name) => match words::find(name) {
            Some(word) => answer(name, (word.run)(&args[1..])),
            None => misuse(&format!("unknown word `{name}`")),
        },
    }
}

/// The repository's root: cargo tells where this crate stands.
fn root() -> PathBuf {
    let here =
        std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| PathBuf::from("ci"), PathBuf::from);
    here.parent().map_or_else(|| PathBuf::from("."), PathBuf::from)
}

fn answer(name: &str, result: words::Result) -> ExitCode {
    match result {
        Ok(_) => ExitCode::SUCCESS,
        Err(Stop::Usage(why)) => misuse(&why),
        Err(Stop::Skipped(why)) => {
            println!("SKIPPED {name}: {why}");
            if shell::is_ci() { ExitCode::FAILURE } else { ExitCode::SUCCESS }
        }
        Err(Stop::Failed(why, _)) => {
            if !why.is_empty() {
                eprintln!("cargo ci {name}: {why}");
            }
            ExitCode::FAILURE
        }
    }
}

fn misuse(why: &str) -> ExitCode {
    eprintln!("cargo ci: {why}\n\n{}", words::usage());
    ExitCode::from(2)
}
