//! `bindings`: what uniffi makes of `ffi/` for Kotlin and Swift. It is committed, so that nobody who reads or builds a
//! shell needs the generator; `--check` sees that it is what the generator makes today.

use std::path::{Path, PathBuf};

use crate::shell::{cargo, run, target_dir};
use crate::tally::Tally;
use crate::words::{Result, flag};

/// The generator's own workspace.
pub(crate) const MANIFEST: &str = "ci/bindgen/Cargo.toml";

/// A language, what is generated for it, and where that is kept.
const FILES: [(&str, &str, &str); 4] = [
    (
        "kotlin",
        "org/dogleaf/dogleaf_ffi.kt",
        "shells/android/dogleaf/src/generated/kotlin/org/dogleaf/dogleaf_ffi.kt",
    ),
    ("swift", "Dogleaf.swift", "shells/ios/Sources/Dogleaf/Generated.swift"),
    ("swift", "DogleafFFI.h", "shells/ios/Sources/DogleafFFI/include/DogleafFFI.h"),
    // A package looks for it under this name.
    ("swift", "DogleafFFI.modulemap", "shells/ios/Sources/DogleafFFI/include/module.modulemap"),
];

/// `cargo ci bindings [--check]`.
pub(crate) fn bindings(args: &[String]) -> Result {
    let check = flag(args, "--check")?;
    let library = library()?;
    let out = target_dir().join("bindings");
    for language in ["kotlin", "swift"] {
        let mut c = cargo(["run", "--quiet", "--locked", "--manifest-path", MANIFEST]);
        // Another workspace's files stay apart, else both rebuild at every turn.
        c.arg("--target-dir").arg(target_dir().join("bindgen"));
        c.arg("--").arg("generate").arg(&library);
        c.args(["--language", language, "--no-format", "--out-dir"]).arg(out.join(language));
        run(&mut c)?;
    }
    let mut stale = Vec::new();
    for (language, made, kept) in FILES {
        let fresh = read(&out.join(language).join(made))?;
        if check {
            if read(Path::new(kept)).unwrap_or_default() != fresh {
                stale.push(kept);
            }
        } else {
            write(Path::new(kept), &fresh)?;
        }
    }
    if stale.is_empty() {
        Ok(Tally::default())
    } else {
        Err(format!("not what uniffi makes today: {}; run cargo ci bindings", stale.join(", "))
            .into())
    }
}

/// Builds the library that Kotlin loads, and says where it is.
pub(crate) fn library() -> std::result::Result<PathBuf, String> {
    run(&mut cargo(["build", "--release", "-p", "dogleaf-ffi"]))?;
    let name =
        format!("{}dogleaf_ffi{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    Ok(target_dir().join("release").join(name))
}

fn read(path: &Path) -> std::result::Result<String, String> {
    let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
    // Generated code ends its lines as it likes; a diff should not.
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    Ok(lines.join("\n").trim_end().to_owned() + "\n")
}

fn write(path: &Path, text: &str) -> std::result::Result<(), String> {
    let fail = |e: std::io::Error| format!("{}: {e}", path.display());
    std::fs::create_dir_all(path.parent().unwrap_or(Path::new("."))).map_err(fail)?;
    std::fs::write(path, text).map_err(fail)
}
