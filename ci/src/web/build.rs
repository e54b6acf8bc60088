//! The core as WebAssembly: with vectors and without, and once more with other grids for the page that compares them.

use std::path::{Path, PathBuf};

use super::{MANIFEST, Places, pack};
use crate::shell::{cargo, run, target_dir};
use crate::tools;
use crate::words::Stop;

/// The generator's own workspace.
pub(crate) const JSBIND: &str = "ci/jsbind/Cargo.toml";
const WEB: &str = "wasm32-unknown-unknown";
const VECTORS: &str = "-Ctarget-feature=+simd128";

/// A build: its name, its compiler flags, its feature.
const BUILDS: [(&str, &str, &str); 3] =
    [("simd", VECTORS, ""), ("scalar", "", ""), ("grids", VECTORS, "grids")];

/// Builds all of them; what JavaScript needs goes into the package.
pub(super) fn build(places: &Places) -> std::result::Result<(), Stop> {
    tools::target(WEB).map_err(Stop::Skipped)?;
    let mut glue: Option<String> = None;
    for (name, flags, feature) in BUILDS {
        // Flags for the target alone: build scripts and macros are shared.
        let folder = target_dir().join("web-build");
        let mut c = cargo(["build", "--quiet", "--locked", "--release", "--lib", "--target", WEB]);
        c.args(["--manifest-path", MANIFEST, "--features", feature, "--target-dir"]).arg(&folder);
        c.env("RUSTFLAGS", flags).env_remove("CARGO_ENCODED_RUSTFLAGS");
        run(&mut c)?;
        let made = places.out.join("made").join(name);
        bind(&folder.join(WEB).join("release/dogleaf_web.wasm"), &made)?;
        let text = pack::read(&made.join("dogleaf.js"))?;
        // One module of glue serves all: whoever loads it says which core.
        if glue.get_or_insert_with(|| text.clone()) != &text {
            return Err(format!("the glue of {name} is another one").into());
        }
    }
    Ok(())
}

/// Runs wasm-bindgen.
fn bind(wasm: &Path, to: &Path) -> std::result::Result<(), String> {
    let mut c = cargo(["run", "--quiet", "--locked", "--manifest-path", JSBIND]);
    c.arg("--target-dir").arg(target_dir().join("jsbind")).arg("--").arg(wasm).arg(to);
    run(&mut c)
}

/// The program that does natively what the browser does, for comparing.
pub(super) fn native(places: &Places) -> std::result::Result<PathBuf, Stop> {
    let folder = target_dir().join("web-build");
    let mut c = cargo(["build", "--quiet", "--locked", "--release", "--example", "native"]);
    c.args(["--manifest-path", MANIFEST, "--target-dir"]).arg(&folder);
    run(&mut c)?;
    let to = places.out.join("native");
    pack::copy(&folder.join("release/examples/native"), &to)?;
    Ok(to)
}

/// `dogleaf` itself, which runs again what a page recorded.
pub(super) fn program() -> std::result::Result<PathBuf, Stop> {
    run(&mut cargo(["build", "--quiet", "--profile", "swift", "-p", "dogleaf"]))?;
    Ok(target_dir().join("swift/dogleaf"))
}

/// The tests that need no browser.
pub(super) fn tests() -> std::process::Command {
    let mut c = cargo(["test", "--quiet", "--locked", "--lib", "--features", "grids"]);
    c.args(["--manifest-path", MANIFEST, "--target-dir"]).arg(target_dir().join("web-build"));
    c
}
