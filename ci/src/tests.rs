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
        for mut call in calls(release, rest) {
            let (result, counts) = run_counting(&mut call);
            tally += counts;
            failures.extend(result.err());
        }
    }
    if failures.is_empty() { Ok(tally) } else { Err(Stop::Failed(failures.join("; "), tally)) }
}

/// The package whose golden table counts the instructions of a release, linked as a release is.
const COUNTED: &str = "dogleaf-cost";
/// The package of the promises; its tables are modules of one program.
const PROMISED: &str = "dogleaf-tests";
/// What all other tests run in: a release's speed without minutes of linking.
const SWIFT: [&str; 2] = ["--profile", "swift"];

/// What is tested in debug too: the numbers, and what every shell shares. The other shells' tests run once, optimised,
/// with their overflows checked all the same (`profile.swift`).
const DEBUGGED: [&str; 6] =
    ["dogleaf-core", PROMISED, "dogleaf-eink", "dogleaf-eink-reader", "dogleaf-soft", "dogleaf-ci"];

/// Everything, unless the caller names packages: then only those.
fn calls(release: bool, rest: &[String]) -> Vec<Command> {
    let named = |a: &&String| {
        a.starts_with("-p") || a.starts_with("--package") || a.starts_with("--manifest-path")
    };
    let named = rest.iter().take_while(|a| *a != "--").find(named).is_some();
    let call = |args: &[&str]| {
        let mut c = cargo(["test", "--no-fail-fast"]);
        c.args(args).args(rest);
        c
    };
    match (release, named) {
        (false, false) => vec![call(&DEBUGGED.map(|name| ["-p", name]).concat())],
        (false, true) => vec![call(&[])],
        (true, true) => vec![call(&["--release"])],
        (true, false) => vec![
            call(&[SWIFT[0], SWIFT[1], "--workspace", "--exclude", COUNTED]),
            call(&["--release", "-p", COUNTED]),
        ],
    }
}

/// `cargo ci golden [--bless]`: the tables under `fixtures/golden`, built as `test --release` builds them.
pub(crate) fn golden(args: &[String]) -> Result {
    let bless = flag(args, "--bless")?;
    let mut promised = cargo(["test"]);
    promised.args(SWIFT).args([
        "-p",
        PROMISED,
        "--test",
        "promises",
        "--",
        "golden::",
        "self_test::",
    ]);
    let mut others = cargo(["test"]);
    others.args(SWIFT).args(["--workspace", "--test", "golden"]);
    others.args(["--exclude", COUNTED, "--exclude", PROMISED]);
    // The tables that take minutes have been compared by `test --release`; they are blessed with the others.
    if bless {
        promised.args(["hard_cases::", "soak::"]).env("DOGLEAF_BLESS", "1");
        others.env("DOGLEAF_BLESS", "1");
    }
    run(&mut promised)?;
    let mut ribbons = cargo(["test"]);
    ribbons.args(SWIFT).args(["-p", PROMISED, "--test", "ribbons", "--", "ribbon_golden::"]);
    if bless {
        ribbons.env("DOGLEAF_BLESS", "1");
    }
    run(&mut ribbons)?;
    run(&mut others)?;
    let mut counted = cargo(["test", "--release", "-p", COUNTED, "--test", "golden"]);
    if bless {
        counted.env("DOGLEAF_BLESS", "1");
    }
    run(&mut counted)?;
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
    let (result, tally) = run_counting(&mut cargo(["test", "--release", "-p", COUNTED]));
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
    use super::calls;

    fn shown(release: bool, rest: &[&str]) -> String {
        let rest: Vec<String> = rest.iter().map(ToString::to_string).collect();
        let line = |c: &std::process::Command| {
            let args: Vec<String> = c.get_args().map(|a| a.display().to_string()).collect();
            args.join(" ")
        };
        calls(release, &rest).iter().map(line).collect::<Vec<_>>().join(", ")
    }

    #[test]
    fn the_workspace_unless_packages_are_named() {
        let debugged = super::DEBUGGED.map(|name| format!("-p {name}")).join(" ");
        assert_eq!(shown(false, &[]), format!("test --no-fail-fast {debugged}"));
        let both = "test --no-fail-fast --profile swift --workspace --exclude dogleaf-cost kkt, \
                    test --no-fail-fast --release -p dogleaf-cost kkt";
        assert_eq!(shown(true, &["kkt"]), both);
        let one = "test --no-fail-fast --release -p dogleaf-core";
        assert_eq!(shown(true, &["-p", "dogleaf-core"]), one);
        assert_eq!(shown(false, &["-p", "dogleaf-core"]), "test --no-fail-fast -p dogleaf-core");
        let all = format!("test --no-fail-fast {debugged} -- -p");
        assert_eq!(shown(false, &["--", "-p"]), all, "what follows goes to the tests");
    }
}
