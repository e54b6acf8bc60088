//! `test` and `golden`: cargo's tests, in the profiles that the promises speak of.

use std::process::Command;

use crate::shell::{apt_install, cargo, run, run_counting, succeeds};
use crate::tally::Tally;
use crate::words::{Result, Stop, flag};

/// `cargo ci test [--debug|--release] [ARG..]`.
pub(crate) fn test(args: &[String]) -> Result {
    let (profiles, rest): (&[bool], _) = match args.first().map(String::as_str) {
        Some("--debug") => (&[false], &args[1..]),
        Some("--release") => (&[true], &args[1..]),
        _ => (&[false, true], args),
    };
    let mut tally = Tally::default();
    let mut failures = Vec::new();
    for &release in profiles {
        let (result, counts) = run_counting(&mut command(release, rest));
        tally += counts;
        failures.extend(result.err());
    }
    if failures.is_empty() { Ok(tally) } else { Err(Stop::Failed(failures.join("; "), tally)) }
}

/// Everything, unless the caller names packages: then only those.
fn command(release: bool, rest: &[String]) -> Command {
    let mut c = cargo(["test", "--no-fail-fast"]);
    let named = |a: &&String| {
        a.starts_with("-p") || a.starts_with("--package") || a.starts_with("--manifest-path")
    };
    if rest.iter().take_while(|a| *a != "--").find(named).is_none() {
        c.arg("--workspace");
    }
    if release {
        c.arg("--release");
    }
    c.args(rest);
    c
}

/// `cargo ci golden [--bless]`: the tables under `fixtures/golden`, in release.
///
/// The whole workspace is named so that cargo builds the same features as `test --release` did.
pub(crate) fn golden(args: &[String]) -> Result {
    let bless = flag(args, "--bless")?;
    let mut c =
        cargo(["test", "--workspace", "--release", "--test", "golden", "--test", "self_test"]);
    // The tables that take minutes have been compared by `test --release`; they are blessed with the others.
    if bless {
        c.args(["--test", "hard_cases", "--test", "soak"]);
        c.env("DOGLEAF_BLESS", "1");
    }
    run(&mut c)?;
    if bless {
        println!("Blessed. Look at the difference, and say in CHANGELOG.md why the figures moved.");
    }
    Ok(Tally::default())
}

/// `cargo ci cost`: the tests of `dogleaf-cost`, and the report that fits into a minute, which must name no fidelity beaten.
pub(crate) fn cost(args: &[String]) -> Result {
    crate::words::no_args(args)?;
    // Without it instructions are not compared; errors are.
    let _ = succeeds(&mut command_of("valgrind")) || apt_install(&["valgrind"]);
    let (result, tally) = run_counting(&mut command(true, &["-p".into(), "dogleaf-cost".into()]));
    result.map_err(|why| Stop::Failed(why, tally))?;
    let mut c = cargo(["run", "--release", "-p", "dogleaf", "--", "cost", "--quick", "--out"]);
    run(c.arg(crate::shell::target_dir().join("cost")))?;
    Ok(tally)
}

fn command_of(program: &str) -> Command {
    crate::shell::command(program, ["--version"])
}

#[cfg(test)]
mod check {
    use super::command;

    fn shown(release: bool, rest: &[&str]) -> String {
        let rest: Vec<String> = rest.iter().map(ToString::to_string).collect();
        let args: Vec<String> =
            command(release, &rest).get_args().map(|a| a.display().to_string()).collect();
        args.join(" ")
    }

    #[test]
    fn the_workspace_unless_packages_are_named() {
        assert_eq!(shown(false, &[]), "test --no-fail-fast --workspace");
        assert_eq!(shown(true, &["kkt"]), "test --no-fail-fast --workspace --release kkt");
        assert_eq!(shown(false, &["-p", "dogleaf-core"]), "test --no-fail-fast -p dogleaf-core");
        assert_eq!(shown(false, &["--", "-p"]), "test --no-fail-fast --workspace -- -p");
    }
}
