//! The static library for the iPhone. An archive needs no linker of Apple's.

use std::path::PathBuf;
use std::process::Command;

use crate::shell::{command, run, succeeds, target_dir};
use crate::tools;
use crate::words::Stop;

const TARGET: &str = "aarch64-apple-ios";

/// Builds it, and prints how large it is.
pub(crate) fn build() -> Result<(), Stop> {
    let (mut c, folder) = way()?;
    c.args([
        "--profile",
        "mobile",
        "--package",
        "dogleaf-ffi",
        "--lib",
        "--crate-type",
        "staticlib",
    ]);
    c.args(["--target", TARGET]).arg("--target-dir").arg(&folder);
    run(&mut c)?;
    let file = folder.join(TARGET).join("mobile").join("libdogleaf_ffi.a");
    let bytes = std::fs::metadata(&file).map_err(|e| format!("{}: {e}", file.display()))?.len();
    let megabytes = bytes as f64 / 1e6;
    println!(
        "{TARGET}: libdogleaf_ffi.a has {megabytes:.1} MB, before an app's linker drops what it does not call"
    );
    Ok(())
}

/// The toolchain in use, if it has the target; else one that builds the standard library itself.
fn way() -> Result<(Command, PathBuf), Stop> {
    let folder = target_dir().join("ios");
    let why = match tools::target(TARGET) {
        Ok(()) => return Ok((command("cargo", ["rustc"]), folder)),
        Err(why) => why,
    };
    let nightly = ["run", "nightly", "rustc", "--version"];
    let source = ["component", "add", "rust-src", "--toolchain", "nightly"];
    if succeeds(&mut command("rustup", nightly)) && succeeds(&mut command("rustup", source)) {
        let std = "-Zbuild-std=std,panic_unwind";
        let c = command("rustup", ["run", "nightly", "cargo", "rustc", std]);
        return Ok((c, folder.join("nightly")));
    }
    Err(Stop::Skipped(why))
}
