//! Golden tables: a test prints its whole table anew and compares it with the file in `fixtures/golden`.

use std::fmt::Write as _;
use std::path::PathBuf;

/// The variable that makes a mismatch a new table instead of a failure.
const BLESS: &str = "DOGLEAF_BLESS";
/// What to do about a mismatch.
const HOW: &str = "If every change is meant: `cargo ci golden --bless`, read `git diff fixtures/golden`, and say why in CHANGELOG.md.";

fn file(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../fixtures/golden").join(name)
}

/// Compares a table with its file, or writes the file where the table is blessed.
///
/// # Errors
///
/// Both tables side by side, where they differ, and how to bless.
pub fn compare(name: &str, found: &str) -> Result<(), String> {
    if std::env::var_os(BLESS).is_some_and(|v| v == "1") {
        let wrote = std::fs::write(file(name), found);
        println!("{name}: blessed\n{found}");
        return wrote.map_err(|error| format!("{name} cannot be written: {error}"));
    }
    let expected = std::fs::read_to_string(file(name)).unwrap_or_default().replace("\r\n", "\n");
    println!("{found}");
    match beside(&expected, found) {
        Some(both) => Err(format!("fixtures/golden/{name} differs.\n{both}\n{HOW}")),
        None => Ok(()),
    }
}

/// Both tables, line by line; lines that differ are marked and stand one above the other.
pub fn beside(expected: &str, found: &str) -> Option<String> {
    if expected == found {
        return None;
    }
    let (mut old, mut new) = (expected.lines(), found.lines());
    let mut both = String::new();
    loop {
        let lines = (old.next(), new.next());
        let wrote = match lines {
            (None, None) => return Some(both),
            (a, b) if a == b => writeln!(both, "         | {}", a.unwrap_or_default()),
            (a, b) => writeln!(
                both,
                "expected | {}\nfound    | {}",
                a.unwrap_or("(nothing)"),
                b.unwrap_or("(nothing)")
            ),
        };
        // A text in memory takes every line.
        debug_assert!(wrote.is_ok(), "a text takes every line");
    }
}
