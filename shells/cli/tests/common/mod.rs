//! The built program, its fixtures, and a folder of each test's own.

#![allow(dead_code, reason = "each test file uses its share")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The program's answer to a command line.
pub(crate) fn dogleaf(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_dogleaf")).args(args).output().expect("it starts")
}

/// Its standard output, where it must succeed.
pub(crate) fn told(args: &[&str]) -> String {
    let output = dogleaf(args);
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{args:?} failed: {error}");
    String::from_utf8(output.stdout).expect("text")
}

/// Its one line of error and its exit code, where it must fail.
pub(crate) fn refused(args: &[&str]) -> (String, i32) {
    let output = dogleaf(args);
    let error = String::from_utf8(output.stderr).expect("text");
    assert_eq!(error.trim_end().lines().count(), 1, "one line: {error:?}");
    assert!(error.starts_with("dogleaf: "), "its name first: {error:?}");
    assert!(!error.contains("panicked"), "no panic: {error}");
    (error.trim_end().to_owned(), output.status.code().expect("a code"))
}

/// A file of `fixtures/`.
pub(crate) fn fixture(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures").join(name);
    path.to_str().expect("a path").to_owned()
}

/// A folder that is empty when a test begins.
pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// A file of a folder, as an argument.
pub(crate) fn arg(folder: &Path, name: &str) -> String {
    folder.join(name).to_str().expect("a path").to_owned()
}

/// The lines of JSON of a run.
pub(crate) fn run_lines(args: &[&str]) -> Vec<serde_json::Value> {
    let all = [&["run", "--json", "-"], args].concat();
    told(&all).lines().map(|l| serde_json::from_str(l).expect("JSON")).collect()
}
