//! The emulated boards the firmware runs on: how an image is built for each, and what it says when it runs.

use std::path::{Path, PathBuf};
use std::process::Stdio;

use crate::hashes::{BOARD, SOFT, board};
use crate::shell::{cargo, run, target_dir};
use crate::tools;

/// A processor and the board QEMU has for it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Processor {
    pub(crate) name: &'static str,
    triple: &'static str,
    /// As `shells/eink/firmware/.cargo/config.toml` and the files laid over it have them.
    flags: &'static str,
    cpu: &'static str,
    machine: &'static str,
}

/// With a unit for both kinds of number.
pub(crate) const M7: Processor = Processor {
    name: "Cortex-M7",
    triple: BOARD,
    flags: "-Ctarget-cpu=cortex-m7 -Cllvm-args=-inline-threshold=5",
    cpu: "cortex-m7",
    machine: "mps2-an500",
};
/// With a unit for single floats.
pub(crate) const M4F: Processor = Processor {
    name: "Cortex-M4F",
    triple: BOARD,
    flags: "-Ctarget-cpu=cortex-m4 -Cllvm-args=-inline-threshold=5",
    cpu: "cortex-m4",
    machine: "mps2-an386",
};
/// With none: the code is ARMv6-M's, run by a Cortex-M3 for want of a board with a Cortex-M0.
pub(crate) const M0: Processor = Processor {
    name: "Cortex-M0 soft",
    triple: SOFT,
    flags: "-Cllvm-args=-inline-threshold=5",
    cpu: "cortex-m3",
    machine: "mps2-an385",
};

impl Processor {
    /// What is missing here to build and run for it.
    pub(crate) fn ready(&self) -> Result<(), String> {
        tools::target(self.triple)?;
        tools::program("qemu-system-arm", "qemu-system-arm")
    }

    /// Builds an image of the firmware, with features of it or of the core.
    pub(crate) fn build(&self, bin: &str, features: &str) -> Result<PathBuf, String> {
        let folder = target_dir().join("hashes");
        let mut c = cargo(["build", "--quiet", "--locked", "--release", "--bin", bin]);
        c.args(["--manifest-path", "shells/eink/firmware/Cargo.toml", "--target", self.triple]);
        c.arg("--target-dir").arg(&folder).args(["--features", features]);
        c.env("RUSTFLAGS", self.flags).env_remove("CARGO_ENCODED_RUSTFLAGS");
        run(&mut c)?;
        Ok(folder.join(self.triple).join("release").join(bin))
    }

    /// Runs an image: whether its status was good, and what it said.
    pub(crate) fn run(&self, image: &Path) -> Result<(bool, String), String> {
        let mut c = board(self.cpu, self.machine, image);
        // Sixteen nanoseconds an instruction: the firmware's clock counts them.
        c.args(["-icount", "shift=4,align=off,sleep=off"]).stdin(Stdio::null());
        let done = c.output().map_err(|e| format!("qemu-system-arm: {e}"))?;
        Ok((done.status.success(), String::from_utf8_lossy(&done.stderr).into_owned()))
    }
}
