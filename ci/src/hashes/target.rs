//! The targets: how the probes are built for each, and what runs them there.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::shell::{cargo, command, run, target_dir};
use crate::tools;

/// Firmware for the emulated boards.
pub(crate) const BOARD: &str = "thumbv7em-none-eabihf";
/// The same for processors without a floating-point unit.
pub(crate) const SOFT: &str = "thumbv6m-none-eabi";
/// What node runs.
pub(crate) const WEB: &str = "wasm32-unknown-unknown";
const HOST: &str = "x86_64-unknown-linux-gnu";
const ARM: &str = "aarch64-unknown-linux-musl";

/// What a target runs on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum On {
    /// This machine.
    Host,
    /// Another processor, emulated for one program.
    User(&'static str),
    /// A whole emulated board: processor, machine.
    Board(&'static str, &'static str),
    /// WebAssembly in node.
    Node,
}

/// One row of the table, at two levels.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Target {
    pub(crate) name: &'static str,
    triple: &'static str,
    flags: &'static str,
    pub(crate) on: On,
    /// Levels it is built at.
    pub(crate) levels: &'static [&'static str],
    /// Levels at which `f64` runs too: a board without a unit for it, or unoptimised, would take minutes.
    double: &'static [&'static str],
}

/// Levels of optimisation: profiles of the probe's own workspace.
const LEVELS: [&str; 2] = ["o0", "o3"];

/// Every target.
pub(crate) const TARGETS: [Target; 8] = [
    Target {
        name: "x86-64",
        triple: HOST,
        flags: "",
        on: On::Host,
        levels: &LEVELS,
        double: &LEVELS,
    },
    Target {
        name: "x86-64 native",
        triple: HOST,
        flags: "-Ctarget-cpu=native",
        on: On::Host,
        // What it could fuse or widen, only the optimiser would.
        levels: &["o3"],
        double: &LEVELS,
    },
    Target {
        name: "aarch64",
        triple: ARM,
        flags: "",
        on: On::User("qemu-aarch64"),
        levels: &LEVELS,
        double: &LEVELS,
    },
    Target {
        name: "Cortex-M4F",
        triple: BOARD,
        flags: "-Ctarget-cpu=cortex-m4",
        on: On::Board("cortex-m4", "mps2-an386"),
        levels: &LEVELS,
        double: &[],
    },
    Target {
        name: "Cortex-M7",
        triple: BOARD,
        flags: "-Ctarget-cpu=cortex-m7",
        on: On::Board("cortex-m7", "mps2-an500"),
        levels: &LEVELS,
        double: &["o3"],
    },
    Target {
        // QEMU has no such board with a Cortex-M0; a Cortex-M3 executes the same instructions.
        name: "Cortex-M0 soft",
        triple: SOFT,
        flags: "",
        on: On::Board("cortex-m3", "mps2-an385"),
        // In software, and unoptimised, it would take minutes.
        levels: &["o3"],
        double: &[],
    },
    Target {
        name: "wasm32",
        triple: WEB,
        flags: "",
        on: On::Node,
        levels: &LEVELS,
        double: &LEVELS,
    },
    Target {
        name: "wasm32 simd128",
        triple: WEB,
        flags: "-Ctarget-feature=+simd128",
        on: On::Node,
        levels: &LEVELS,
        double: &LEVELS,
    },
];

impl Target {
    /// What is missing here to build and run it.
    pub(crate) fn ready(&self) -> Result<(), String> {
        tools::target(self.triple)?;
        match self.on {
            On::Host => Ok(()),
            On::User(emulator) => tools::program(emulator, "qemu-user"),
            On::Board(..) => tools::program("qemu-system-arm", "qemu-system-arm"),
            On::Node => tools::program("node", "nodejs"),
        }
    }

    /// The kinds of number that run at a level.
    pub(crate) fn tiers(&self, level: &str) -> &'static [&'static str] {
        if self.double.contains(&level) { &["f32", "f64"] } else { &["f32"] }
    }

    /// Builds the probes; a copy of them that the next build leaves alone.
    pub(crate) fn build(&self, level: &str) -> Result<PathBuf, String> {
        let folder = target_dir().join("hashes");
        run(&mut self.cargo(level, &folder))?;
        let file = if self.on == On::Node { "dogleaf_probe.wasm" } else { "probe" };
        let from = folder.join(self.triple).join(level).join(file);
        let to = folder.join(format!("{}-{level}", self.name.replace(' ', "-")));
        std::fs::copy(&from, &to).map_err(|e| format!("{}: {e}", from.display()))?;
        Ok(to)
    }

    fn cargo(&self, level: &str, folder: &Path) -> Command {
        let what = match self.on {
            On::Node => "rustc --lib --crate-type cdylib --manifest-path tests/probe/Cargo.toml",
            On::Board(..) => "build --bin probe --manifest-path shells/eink/firmware/Cargo.toml",
            _ => "build --bin probe --manifest-path tests/probe/Cargo.toml",
        };
        let mut c = cargo(what.split(' '));
        c.args(["--quiet", "--locked", "--profile", level, "--target", self.triple]);
        c.arg("--target-dir").arg(folder);
        c.args(["--features", "ribbon"]);
        if matches!(self.on, On::Board(..)) && self.tiers(level).contains(&"f64") {
            c.args(["--features", "double"]);
        }
        // With a target named these do not reach build scripts, so that all targets share those.
        c.env("RUSTFLAGS", self.flags).env_remove("CARGO_ENCODED_RUSTFLAGS");
        c.env("CARGO_TARGET_AARCH64_UNKNOWN_LINUX_MUSL_LINKER", "rust-lld");
        c
    }

    /// Runs what was built.
    pub(crate) fn command(&self, built: &Path) -> Command {
        match self.on {
            On::Host => command(built, [""; 0]),
            On::User(emulator) => command(emulator, [built]),
            On::Board(cpu, machine) => board(cpu, machine, built),
            On::Node => command("node", [Path::new("tests/probe/web.mjs"), built]),
        }
    }
}

/// An emulated board, without a clock: as fast as it goes.
pub(crate) fn board(cpu: &str, machine: &str, image: &Path) -> Command {
    let mut c = command("qemu-system-arm", ["-cpu", cpu, "-machine", machine, "-nographic"]);
    c.args(["-semihosting-config", "enable=on,target=native", "-kernel"]).arg(image);
    c
}

#[cfg(test)]
mod check {
    use super::{On, TARGETS};

    #[test]
    fn names_tell_targets_apart_and_all_run_f32() {
        for (n, t) in TARGETS.iter().enumerate() {
            assert!(TARGETS[..n].iter().all(|o| o.name != t.name), "{} is there twice", t.name);
            assert!(t.levels.iter().all(|l| t.tiers(l).contains(&"f32")), "{} runs f32", t.name);
            assert!(t.levels.contains(&"o3"), "{} runs optimised", t.name);
        }
    }

    #[test]
    fn every_processor_that_is_promised() {
        let on = |what: fn(&On) -> bool| TARGETS.iter().filter(|t| what(&t.on)).count();
        assert_eq!(on(|o| *o == On::Host), 2, "x86-64, plain and native");
        assert_eq!(on(|o| matches!(o, On::User(_))), 1, "aarch64");
        assert_eq!(on(|o| matches!(o, On::Board(..))), 3, "M0, M4F and M7");
        assert_eq!(on(|o| *o == On::Node), 2, "wasm32 without and with vectors");
    }
}
