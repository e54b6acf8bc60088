//! Runs other programs: says what it runs, lets their output through, times them.
//!
//! What is said here goes to stderr, as cargo's own words do; stdout belongs to the answers.

use std::ffi::OsStr;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

use crate::tally::Tally;

/// What cargo tells the program it runs about that program's own package; not for grandchildren.
const OWN: [&str; 5] =
    ["CARGO_PKG_", "CARGO_MANIFEST_", "CARGO_BIN_", "CARGO_CRATE_", "CARGO_PRIMARY_"];

/// `program args..`, without the variables that belong to this crate.
pub(crate) fn command<S: AsRef<OsStr>>(
    program: impl AsRef<OsStr>,
    args: impl IntoIterator<Item = S>,
) -> Command {
    let mut c = Command::new(program);
    c.args(args);
    for (name, _) in std::env::vars_os() {
        if name.to_str().is_some_and(|n| OWN.iter().any(|own| n.starts_with(own))) {
            c.env_remove(name);
        }
    }
    c
}

/// `cargo args..`.
pub(crate) fn cargo<S: AsRef<OsStr>>(args: impl IntoIterator<Item = S>) -> Command {
    command("cargo", args)
}

/// Runs a command with its output passed through.
pub(crate) fn run(c: &mut Command) -> Result<(), String> {
    let text = show(c);
    eprintln!("> {text}");
    let start = Instant::now();
    let status = c.status().map_err(|e| format!("{text}: {e}"))?;
    verdict(&text, status, start)
}

/// Like [`run`], and counts the tests that its output speaks of.
pub(crate) fn run_counting(c: &mut Command) -> (Result<(), String>, Tally) {
    let mut tally = Tally::default();
    let result = stream(c, &mut tally);
    (result, tally)
}

fn stream(c: &mut Command, tally: &mut Tally) -> Result<(), String> {
    let text = show(c);
    eprintln!("> {text}");
    let start = Instant::now();
    let mut child = c.stdout(Stdio::piped()).spawn().map_err(|e| format!("{text}: {e}"))?;
    if let Some(out) = child.stdout.take() {
        copy(out, &mut std::io::stdout(), tally).map_err(|e| format!("{text}: {e}"))?;
    }
    let status = child.wait().map_err(|e| format!("{text}: {e}"))?;
    verdict(&text, status, start)
}

/// Line by line, as bytes: a test may print what is no UTF-8.
fn copy(from: impl Read, to: &mut impl Write, tally: &mut Tally) -> std::io::Result<()> {
    let mut from = BufReader::new(from);
    let mut line = Vec::new();
    while from.read_until(b'\n', &mut line)? > 0 {
        tally.read(&String::from_utf8_lossy(&line));
        to.write_all(&line)?;
        to.flush()?;
        line.clear();
    }
    Ok(())
}

fn verdict(text: &str, status: std::process::ExitStatus, start: Instant) -> Result<(), String> {
    let took = start.elapsed().as_secs_f64();
    if status.success() {
        eprintln!("  ok, {took:.1} s");
        return Ok(());
    }
    eprintln!("  FAILED ({status}), {took:.1} s");
    Err(format!("`{text}` failed ({status})"))
}

/// Runs them all, also after one that fails, and names those that failed.
pub(crate) fn run_each(commands: impl IntoIterator<Item = Command>) -> Result<(), String> {
    let failures: Vec<String> =
        commands.into_iter().filter_map(|mut c| run(&mut c).err()).collect();
    if failures.is_empty() { Ok(()) } else { Err(failures.join("; ")) }
}

/// What a command prints, if it succeeds; its complaints are passed through.
pub(crate) fn output(c: &mut Command) -> Result<String, String> {
    let text = show(c);
    let done = c.stderr(Stdio::inherit()).output().map_err(|e| format!("{text}: {e}"))?;
    if !done.status.success() {
        return Err(format!("`{text}` failed ({})", done.status));
    }
    Ok(String::from_utf8_lossy(&done.stdout).into_owned())
}

/// Whether a command can be started and succeeds; what it prints is thrown away.
pub(crate) fn succeeds(c: &mut Command) -> bool {
    c.stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|s| s.success())
}

/// Installs Debian packages where that is allowed: as root, with apt. `false` where it is not.
pub(crate) fn apt_install(packages: &[&str]) -> bool {
    let root = output(&mut command("id", ["-u"])).is_ok_and(|id| id.trim() == "0");
    if !root || !Path::new("/usr/bin/apt-get").exists() {
        return false;
    }
    // A fresh container has no package lists; an old list is good enough to try first.
    let install = || {
        let mut c = command("apt-get", ["install", "-y", "-q", "--no-install-recommends"]);
        c.args(packages).env("DEBIAN_FRONTEND", "noninteractive");
        run(&mut c).is_ok()
    };
    install() || (run(&mut command("apt-get", ["update", "-q"])).is_ok() && install())
}

/// Where this project's builds go.
pub(crate) fn target_dir() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| PathBuf::from("target"), PathBuf::from)
}

/// Whether nothing may be skipped.
pub(crate) fn is_ci() -> bool {
    std::env::var("CI").is_ok_and(|v| v == "true" || v == "1")
}

/// The command as one would type it.
fn show(c: &Command) -> String {
    let set = c.get_envs().filter_map(|(k, v)| Some((k, v?)));
    let mut parts: Vec<String> =
        set.map(|(k, v)| format!("{}={}", k.display(), quote(v))).collect();
    parts.push(quote(c.get_program()));
    parts.extend(c.get_args().map(quote));
    parts.join(" ")
}

fn quote(s: &OsStr) -> String {
    let s = s.to_string_lossy();
    if s.is_empty() || s.contains([' ', '"', '$']) { format!("'{s}'") } else { s.into_owned() }
}

#[cfg(test)]
mod check {
    use super::{command, copy, run_each, show, succeeds};
    use crate::tally::Tally;

    #[test]
    fn shows_what_one_would_type() {
        let mut c = command("cargo", ["doc", "--no-deps"]);
        c.env("RUSTDOCFLAGS", "-D warnings");
        assert_eq!(show(&c), "RUSTDOCFLAGS='-D warnings' cargo doc --no-deps");
    }

    #[test]
    fn a_missing_program_is_a_failure_not_a_panic() {
        assert!(!succeeds(&mut command("no-such-program-here", ["x"])), "it does not exist");
        let why = run_each([command("no-such-program-here", ["x"])]).err();
        assert!(why.is_some_and(|w| w.contains("no-such-program-here")), "the message names it");
    }

    #[test]
    fn output_that_is_no_utf8_still_counts() {
        let mut t = Tally::default();
        let mut out = Vec::new();
        let text = b"\xff\xfe\ntest result: ok. 3 passed; 0 failed; 0 ignored\n";
        assert!(copy(&text[..], &mut out, &mut t).is_ok(), "bytes are copied as they are");
        assert_eq!(out, text, "bytes are copied as they are");
        assert_eq!(t.passed, 3);
    }
}
