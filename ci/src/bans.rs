//! Words that must not stand in the core's code, each with its reason. Tests and comments may have them.

use std::path::Path;

use crate::source::code_only;

/// What is banned, and why. A word that starts with a letter must not continue another word.
const BANNED: [(&str, &str); 15] = [
    ("mul_add", "one rounding on some targets, two on others"),
    ("fadd_fast", "not the same bits everywhere"),
    ("algebraic_", "not the same bits everywhere"),
    ("intrinsics", "not the same bits everywhere"),
    ("powi(", "its order of multiplications is unspecified"),
    ("std::", "the core is no_std"),
    ("extern crate", "the core is no_std without alloc"),
    ("alloc::", "the core allocates nothing"),
    (".unwrap(", "the core cannot panic"),
    (".expect(", "the core cannot panic"),
    ("panic!", "the core cannot panic"),
    ("unreachable!", "the core cannot panic"),
    ("todo!", "the core cannot panic"),
    ("unimplemented!", "the core cannot panic"),
    ("HashMap", "its order is random"),
];

/// The one place that may name libm.
const LIBM_DOOR: &str = "real";

/// All the banned words under a folder, as `file:line: word: reason`.
pub(crate) fn scan(folder: &Path) -> Result<Vec<String>, String> {
    let mut found = Vec::new();
    for file in rust_files(folder)? {
        let text =
            std::fs::read_to_string(&file).map_err(|e| format!("{}: {e}", file.display()))?;
        let inside = file.strip_prefix(folder).unwrap_or(&file);
        found.extend(faults(inside, &text).into_iter().map(|f| format!("{}:{f}", file.display())));
    }
    Ok(found)
}

fn rust_files(folder: &Path) -> Result<Vec<std::path::PathBuf>, String> {
    let fail = |e: std::io::Error| format!("{}: {e}", folder.display());
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(fail)? {
        let path = entry.map_err(fail)?.path();
        if path.is_dir() {
            files.extend(rust_files(&path)?);
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

fn faults(file: &Path, text: &str) -> Vec<String> {
    if is_test(file) {
        return Vec::new();
    }
    let door = file
        .components()
        .next()
        .is_some_and(|c| Path::new(c.as_os_str()).file_stem().is_some_and(|s| s == LIBM_DOOR));
    let libm = (!door).then_some(("libm::", "only `real` is the door to libm"));
    let mut found = Vec::new();
    for (i, line) in code_only(text).lines().enumerate() {
        for (word, why) in BANNED.iter().copied().chain(libm) {
            if has(line, word) {
                found.push(format!("{}: {word}: {why}", i + 1));
            }
        }
    }
    found
}

/// A module file that its parent includes under `cfg(test)`, by this repository's naming.
fn is_test(file: &Path) -> bool {
    file.file_stem().is_some_and(|s| s == "tests")
        || file.components().any(|c| c.as_os_str() == "tests")
}

fn has(line: &str, word: &str) -> bool {
    let starts_word = word.starts_with(|c: char| c.is_alphanumeric());
    line.match_indices(word).any(|(at, _)| {
        let before = line[..at].chars().next_back();
        !(starts_word && before.is_some_and(|c| c.is_alphanumeric() || c == '_'))
    })
}

#[cfg(test)]
mod check {
    use std::path::Path;

    use super::faults;

    fn count(file: &str, text: &str) -> usize {
        faults(Path::new(file), text).len()
    }

    #[test]
    fn a_planted_word_is_caught() {
        for line in [
            "x.unwrap();",
            "use std::fmt;",
            "a.mul_add(b, c)",
            "panic!(\"no\")",
            "x.powi(2)",
            "extern crate alloc;",
        ] {
            assert_eq!(count("step/newton.rs", line), 1, "{line}");
        }
    }

    #[test]
    fn its_neighbours_are_not() {
        for line in ["x.unwrap_or(0);", "// x.unwrap()", "nostd::x", "\"panic!\"", "use core::fmt;"]
        {
            assert_eq!(count("step/newton.rs", line), 0, "{line}");
        }
    }

    #[test]
    fn one_door_to_libm() {
        assert_eq!(count("real/mod.rs", "libm::sqrtf(x)"), 0);
        assert_eq!(count("real.rs", "libm::sqrtf(x)"), 0);
        assert_eq!(count("mesh/leaf.rs", "libm::sqrtf(x)"), 1);
        assert_eq!(count("mesh/tests.rs", "libm::sqrtf(x)"), 0);
    }
}
