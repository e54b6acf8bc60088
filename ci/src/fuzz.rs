//! `fuzz` and `soak`: what is thrown at the code at random, a little of it in every check, a lot of it by hand.
//!
//! The fuzz targets are built with the compiler's own coverage counters and without a sanitizer: the core has no
//! `unsafe`, and so the pinned stable toolchain and a C++ compiler are all that is needed.

use std::path::PathBuf;
use std::process::Command;

use crate::shell::{apt_install, cargo, command, output, run, run_each, succeeds, target_dir};
use crate::tally::Tally;
use crate::words::{Result, Stop};

const MANIFEST: &str = "tests/fuzz/Cargo.toml";
/// Inputs found worth keeping, and small.
const SEEDS: &str = "fixtures/fuzz";
/// Where failing cases of a soak are kept.
const KEPT: &str = "fixtures/gestures/hard";

/// Every target, and how many inputs the smoke test gives it: a few seconds each.
const TARGETS: [(&str, u32); 5] = [
    ("recording", 20_000),
    ("gesture", 300),
    ("step", 500),
    ("scene", 100_000),
    ("content", 20_000),
];

/// Counters per edge, their places, and what is compared with what: libFuzzer's three wishes.
const FLAGS: [&str; 6] = [
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
    "--cfg fuzzing",
];

/// What a call asks for.
#[derive(Debug, PartialEq, Eq)]
struct Ask<'a> {
    /// Seconds for each target; the smoke test counts inputs instead.
    seconds: Option<u32>,
    targets: Vec<(&'a str, u32)>,
}

fn ask(args: &[String]) -> std::result::Result<Ask<'_>, Stop> {
    let mut ask = Ask { seconds: None, targets: Vec::new() };
    let mut rest = args.iter();
    while let Some(arg) = rest.next() {
        if arg == "--seconds" {
            let n = rest.next().and_then(|n| n.parse().ok());
            ask.seconds = Some(n.ok_or(Stop::Usage("--seconds needs a number".into()))?);
        } else {
            let known = TARGETS.iter().find(|t| t.0 == arg);
            let names = TARGETS.map(|t| t.0).join(", ");
            let unknown = || Stop::Usage(format!("no target `{arg}`: there are {names}"));
            ask.targets.push(*known.ok_or_else(unknown)?);
        }
    }
    if ask.targets.is_empty() {
        ask.targets = TARGETS.to_vec();
    }
    Ok(ask)
}

/// `cargo ci fuzz [--seconds N] [TARGET..]`.
pub(crate) fn fuzz(args: &[String]) -> Result {
    let ask = ask(args)?;
    let named = std::env::var_os("CXX").unwrap_or_else(|| "c++".into());
    if !succeeds(&mut command(named, ["--version"])) && !apt_install(&["g++"]) {
        return Err(Stop::Skipped("no C++ compiler for libFuzzer: install g++".into()));
    }
    let host = host()?;
    build(&host, &ask)?;
    let each = ask.targets.iter().map(|target| one(&host, target, ask.seconds));
    run_each(each.collect::<std::result::Result<Vec<_>, String>>()?)?;
    Ok(Tally::default())
}

fn folder() -> PathBuf {
    target_dir().join("fuzz")
}

fn host() -> std::result::Result<String, String> {
    let text = output(&mut command("rustc", ["-vV"]))?;
    let line = text.lines().find_map(|l| l.strip_prefix("host: "));
    line.map(str::to_owned).ok_or("rustc does not name its host".into())
}

/// With a target named, so that build scripts are spared the counters.
fn build(host: &str, ask: &Ask<'_>) -> std::result::Result<(), String> {
    let mut c = cargo(["build", "--release", "--locked", "--manifest-path", MANIFEST, "--target"]);
    c.arg(host).arg("--target-dir").arg(folder());
    for (target, _) in &ask.targets {
        c.args(["--bin", target]);
    }
    run(c.env("RUSTFLAGS", FLAGS.join(" ")))
}

fn one(
    host: &str,
    (target, runs): &(&str, u32),
    seconds: Option<u32>,
) -> std::result::Result<Command, String> {
    let corpus = folder().join(if seconds.is_some() { "corpus" } else { "smoke" }).join(target);
    if seconds.is_none() {
        // The same inputs every time: nothing is left from last time.
        let _ = std::fs::remove_dir_all(&corpus);
    }
    let found = folder().join("found").join(target);
    for folder in [&corpus, &found] {
        std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    }
    let mut c = command(folder().join(host).join("release").join(target), ["-timeout=60"]);
    match seconds {
        Some(n) => c.arg(format!("-max_total_time={n}")).arg("-print_final_stats=1"),
        None => c.arg(format!("-runs={runs}")).args(["-seed=1", "-verbosity=0", "-print_funcs=0"]),
    };
    c.arg(format!("-artifact_prefix={}/", found.display())).arg("-rss_limit_mb=3000");
    c.arg(corpus).arg(format!("{SEEDS}/{target}"));
    Ok(c)
}

/// `cargo ci soak [--steps N] [--seed S] [--real f32|f64] [--threads T] [--json FILE] [--case C]`.
pub(crate) fn soak(args: &[String]) -> Result {
    let mut c =
        cargo(["run", "--quiet", "--release", "-p", "dogleaf-tests", "--bin", "soak", "--"]);
    c.args(["--keep", KEPT]).args(args);
    run(&mut c)?;
    Ok(Tally::default())
}

#[cfg(test)]
mod check {
    use super::{TARGETS, ask};

    fn args(list: &[&str]) -> Vec<String> {
        list.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn all_targets_unless_some_are_named() {
        let none = args(&[]);
        assert!(ask(&none).is_ok_and(|a| a.targets == TARGETS && a.seconds.is_none()), "smoke");
        let some = args(&["--seconds", "9", "scene"]);
        assert!(ask(&some).is_ok_and(|a| a.targets.len() == 1 && a.seconds == Some(9)), "long");
    }

    #[test]
    fn slips_of_the_pen_are_refused() {
        for bad in [&["scent"][..], &["--seconds"], &["--seconds", "long"]] {
            assert!(ask(&args(bad)).is_err(), "{bad:?}");
        }
    }

    #[test]
    fn every_target_is_built_and_has_seeds() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let manifest = std::fs::read_to_string(root.join(super::MANIFEST)).expect("it is there");
        for (target, _) in TARGETS {
            assert!(manifest.contains(&format!("name = \"{target}\"")), "{target} is no binary");
            assert!(root.join(super::SEEDS).join(target).is_dir(), "{target} has no seeds");
        }
    }
}
