//! The static library for the iPhone. An archive needs no linker of Apple's.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

use object::read::archive::ArchiveFile;
use object::{Object, ObjectSymbol};

use crate::shell::{command, run, succeeds, target_dir};
use crate::tools;
use crate::words::Stop;

const TARGET: &str = "aarch64-apple-ios";
const HEADER: &str = "shells/ios/Sources/DogleafFFI/include/DogleafFFI.h";

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
    let bytes = std::fs::read(&file).map_err(|e| format!("{}: {e}", file.display()))?;
    let header = std::fs::read_to_string(HEADER).map_err(|e| format!("{HEADER}: {e}"))?;
    let (declared, defined) = (declared(&header), defined(&bytes, &file)?);
    let lost: Vec<&str> = declared.difference(&defined).map(String::as_str).collect();
    if declared.is_empty() || !lost.is_empty() {
        return Err(format!("{HEADER} declares what {TARGET} lacks: {}", lost.join(", ")).into());
    }
    println!(
        "{TARGET}: libdogleaf_ffi.a has {:.1} MB, before an app's linker drops what it does not call; it defines all {} \
         functions of its header",
        bytes.len() as f64 / 1e6,
        declared.len()
    );
    Ok(())
}

/// Functions that the header declares for Swift to call.
fn declared(header: &str) -> BTreeSet<String> {
    let calls = header.split('(').filter_map(|part| part.rsplit([' ', '\n', '*']).next());
    calls.filter(|n| n.contains("ffi_dogleaf_ffi_")).map(str::to_owned).collect()
}

/// Symbols that the archive's objects define, without the underscore that Apple's tools put before.
fn defined(archive: &[u8], file: &Path) -> Result<BTreeSet<String>, String> {
    let fail = |e: object::Error| format!("{}: {e}", file.display());
    let mut names = BTreeSet::new();
    for member in ArchiveFile::parse(archive).map_err(fail)?.members() {
        let data = member.map_err(fail)?.data(archive).map_err(fail)?;
        let Ok(object) = object::File::parse(data) else { continue };
        let symbols = object.symbols().filter(|s| s.is_definition() && s.is_global());
        names.extend(symbols.filter_map(|s| Some(s.name().ok()?.strip_prefix('_')?.to_owned())));
    }
    Ok(names)
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

#[cfg(test)]
mod check {
    use super::declared;

    #[test]
    fn functions_of_the_header() {
        let header = "typedef void (*Back)(uint64_t);\nuint64_t uniffi_dogleaf_ffi_fn_clone_book(uint64_t h);\n\
            void *ffi_dogleaf_ffi_alloc(void\n);\n";
        let names: Vec<_> = declared(header).into_iter().collect();
        assert_eq!(names, ["ffi_dogleaf_ffi_alloc", "uniffi_dogleaf_ffi_fn_clone_book"]);
    }
}
