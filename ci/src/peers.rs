//! `peers`: builds and runs the comparison with Eigen, for the same processor level as our own code; then the sheets of
//! MuJoCo and pyPBD, from their wheels. Writes `peers.json`, which `dogleaf cost --peers` draws.

use std::path::{Path, PathBuf};

use crate::shell::{apt_install, command, run, succeeds, target_dir};
use crate::tally::Tally;
use crate::words::{Result, Stop};

const MANIFEST: &str = "ci/peers/Cargo.toml";
/// Peers with wheels, at the versions that were measured.
const WHEELS: [&str; 3] = ["mujoco==4.0.0", "pyPBD==2.2.2", "numpy"];

/// `cargo ci peers [ARG..]`.
pub(crate) fn peers(args: &[String]) -> Result {
    ready()?;
    run(eigen_run().args(args))?;
    if !args.is_empty() {
        return Ok(Tally::default());
    }
    let absolute = |p: &Path| std::path::absolute(p).map_err(|e| Stop::from(e.to_string()));
    let folder = absolute(&target_dir().join("peers"))?;
    let linear = folder.join("eigen.json");
    let json = eigen_run().args(["--json", "--repeats", "3"]).output();
    let text = json.map_err(|e| Stop::from(e.to_string()))?.stdout;
    std::fs::write(&linear, text).map_err(|e| Stop::from(e.to_string()))?;
    let python = wheels(&folder.join("python"))?;
    let out = folder.join("peers.json");
    // MuJoCo leaves its log where it runs.
    let script = absolute(Path::new("ci/peers/sheets.py"))?;
    run(command(python, [script]).args([&out, &linear]).current_dir(&folder))?;
    println!("{}\nTo draw them: dogleaf cost --peers {}", out.display(), out.display());
    Ok(Tally::default())
}

fn eigen_run() -> std::process::Command {
    let mut c = command(
        "cargo",
        ["run", "--quiet", "--release", "--locked", "--manifest-path", MANIFEST, "--target-dir"],
    );
    c.arg(target_dir().join("peers")).arg("--");
    if cfg!(target_arch = "x86_64") {
        c.env("RUSTFLAGS", "-C target-cpu=x86-64-v3");
    }
    c
}

/// A Python of its own with the peers' wheels in it.
fn wheels(folder: &Path) -> std::result::Result<PathBuf, Stop> {
    let python = folder.join("bin/python");
    if succeeds(command(&python, ["-c", "import mujoco, pypbd"]).env("PYTHONWARNINGS", "ignore")) {
        return Ok(python);
    }
    let lacks = |what: &str| Stop::Skipped(format!("MuJoCo and pyPBD: {what}"));
    if !succeeds(command("python3", ["-m", "venv"]).arg(folder)) {
        return Err(lacks("no Python with venv: install python3-venv"));
    }
    let mut pip = command(&python, ["-m", "pip", "install", "--quiet"]);
    if succeeds(pip.args(WHEELS)) { Ok(python) } else { Err(lacks("their wheels cannot be had")) }
}

/// Eigen's headers, a C++ compiler, and a processor that can run what they make.
fn ready() -> std::result::Result<(), Stop> {
    if !eigen() && !apt_install(&["libeigen3-dev"]) {
        return Err(Stop::Skipped("Eigen's headers are missing: install libeigen3-dev, or set EIGEN3_INCLUDE to their folder".into()));
    }
    if !compiler() && !apt_install(&["g++"]) {
        return Err(Stop::Skipped("no C++ compiler: install g++, or set CXX".into()));
    }
    if level_3() {
        Ok(())
    } else {
        Err(Stop::Skipped("this processor is below x86-64-v3 (AVX2, FMA, BMI)".into()))
    }
}

fn eigen() -> bool {
    let folder = std::env::var_os("EIGEN3_INCLUDE").unwrap_or_else(|| "/usr/include/eigen3".into());
    Path::new(&folder).join("Eigen/SparseLU").exists()
}

fn compiler() -> bool {
    let named = std::env::var_os("CXX").unwrap_or_else(|| "c++".into());
    succeeds(&mut command(named, ["--version"]))
}

#[cfg(target_arch = "x86_64")]
fn level_3() -> bool {
    use std::arch::is_x86_feature_detected as has;
    has!("avx2")
        && has!("fma")
        && has!("bmi1")
        && has!("bmi2")
        && has!("f16c")
        && has!("lzcnt")
        && has!("movbe")
}

#[cfg(not(target_arch = "x86_64"))]
fn level_3() -> bool {
    true
}
