//! `peers`: builds and runs the comparison with Eigen, for the same processor level as our own code.

use std::path::Path;

use crate::shell::{apt_install, command, run, succeeds, target_dir};
use crate::tally::Tally;
use crate::words::{Result, Stop};

const MANIFEST: &str = "ci/peers/Cargo.toml";

/// `cargo ci peers [ARG..]`.
pub(crate) fn peers(args: &[String]) -> Result {
    ready()?;
    let mut c = command(
        "cargo",
        ["run", "--quiet", "--release", "--locked", "--manifest-path", MANIFEST, "--target-dir"],
    );
    c.arg(target_dir().join("peers")).arg("--").args(args);
    if cfg!(target_arch = "x86_64") {
        c.env("RUSTFLAGS", "-C target-cpu=x86-64-v3");
    }
    run(&mut c)?;
    Ok(Tally::default())
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
