//! `swift`: what can be known of the Swift shell where there is no Mac.
//!
//! Its sources are parsed, what they call is looked up in the generated bindings, its shaders are made from the GLSL and
//! their types checked as C++, its tests are run where a Swift compiler is, and the library is built for the iPhone.

mod calls;
mod library;
mod metal;
mod names;
mod syntax;

use std::path::{Path, PathBuf};

use crate::shell::{apt_install, command, is_ci, run, run_counting, succeeds, target_dir};
use crate::tally::Tally;
use crate::words::{Result, Stop, flag};

const ROOT: &str = "shells/ios";
const FFI: &str = "ffi";

/// `cargo ci swift [--bless]`.
pub(crate) fn swift(args: &[String]) -> Result {
    let bless = flag(args, "--bless")?;
    shaders(bless)?;
    let files = sources(Path::new(ROOT))?;
    println!("{} Swift files parse; a planted error in each is found", syntax::check(&files)?);
    let uses = calls::check(&files)?;
    println!("{uses} uses of the bindings name what is there; a planted wrong one is found");
    types()?;
    let tally = tests()?;
    if Path::new(FFI).is_dir() {
        library::build()?;
    } else {
        println!("NOT BUILT: the library for iOS, there is no {FFI} in this tree");
    }
    Ok(tally)
}

/// The committed shaders are what the GLSL says.
fn shaders(bless: bool) -> std::result::Result<(), String> {
    let Some(text) = metal::text()? else {
        println!("NOT COMPARED: {}, there is no GLSL in this tree", metal::TO);
        return Ok(());
    };
    if bless {
        return std::fs::write(metal::TO, text).map_err(|e| format!("{}: {e}", metal::TO));
    }
    if std::fs::read_to_string(metal::TO).is_ok_and(|there| there == text) {
        println!("{} is what the GLSL says", metal::TO);
        return Ok(());
    }
    Err(format!("{} is not what the GLSL says: cargo ci swift --bless", metal::TO))
}

/// The shaders' types, checked as C++ with a stand-in for Metal's library; a planted error must be refused.
fn types() -> std::result::Result<(), Stop> {
    let ready = || {
        succeeds(&mut command("g++", ["--version"]))
            && Path::new("/usr/include/glm/glm.hpp").exists()
    };
    let installed = ready() || (apt_install(&["g++", "libglm-dev"]) && ready());
    if !installed {
        return missing("the types of the shaders: g++ and libglm-dev are missing");
    }
    let check = |file: &Path| {
        let flags = "-std=c++17 -fsyntax-only -fsingle-precision-constant -Wno-attributes -x c++";
        let mut c = command("g++", flags.split(' '));
        c.args(["-isystem", "shells/ios/shaders"]).arg(file);
        c
    };
    run(&mut check(Path::new(metal::TO)))?;
    let text = std::fs::read_to_string(metal::TO).map_err(|e| format!("{}: {e}", metal::TO))?;
    let (from, to) = ("s.worldNormal = in.worldNormal;", "s.worldNormal = in.pagePlace;");
    let planted = target_dir().join("planted.metal");
    let write = std::fs::write(&planted, text.replace(from, to));
    write.map_err(|e| format!("{}: {e}", planted.display()))?;
    if !text.contains(from) || succeeds(&mut check(&planted)) {
        return Err(Stop::from("a planted error in the shaders was not found".to_owned()));
    }
    println!("the shaders' types are sound as C++; a planted error is found");
    Ok(())
}

/// `swift test`, against the library built for this machine.
fn tests() -> Result {
    if !succeeds(&mut command("swift", ["--version"])) {
        println!("NOT RUN: swift test, there is no Swift compiler on this machine");
        return Ok(Tally::default());
    }
    if !Path::new(FFI).is_dir() {
        println!("NOT RUN: swift test, there is no {FFI} in this tree");
        return Ok(Tally::default());
    }
    run(&mut command("cargo", ["build", "--release", "--package", "dogleaf-ffi"]))?;
    let built = std::path::absolute(target_dir().join("release")).map_err(|e| e.to_string())?;
    let mut c = command("swift", ["test", "--package-path", ROOT]);
    c.arg("-Xlinker").arg(format!("-L{}", built.display()));
    c.env("LD_LIBRARY_PATH", &built).env("DYLD_LIBRARY_PATH", &built);
    let (result, tally) = run_counting(&mut c);
    result.map(|()| tally).map_err(|why| Stop::Failed(why, tally))
}

/// What this machine lacks is a failure only where nothing may be skipped.
fn missing(what: &str) -> std::result::Result<(), Stop> {
    if is_ci() {
        return Err(Stop::Skipped(what.to_owned()));
    }
    println!("NOT CHECKED: {what}");
    Ok(())
}

/// Every Swift file below a folder that was written by hand.
fn sources(folder: &Path) -> std::result::Result<Vec<PathBuf>, String> {
    let mut found = Vec::new();
    let entries = std::fs::read_dir(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    for entry in entries {
        let path = entry.map_err(|e| e.to_string())?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() && !name.starts_with('.') && name != "build" {
            found.extend(sources(&path)?);
        } else if name.ends_with(".swift") && name != "Generated.swift" {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}
