//! Programs and toolchain targets that a word needs, installed where that is allowed.

use std::path::Path;

use crate::shell::{apt_install, command, output, run, succeeds};

/// Whether the toolchain in use builds for `triple`, after asking rustup to add it.
pub(crate) fn target(triple: &str) -> Result<(), String> {
    let added = || succeeds(&mut command("rustup", ["--version"])) && add(triple);
    if has_target(triple) || (added() && has_target(triple)) {
        Ok(())
    } else {
        Err(format!("the toolchain lacks {triple}: rustup target add {triple}"))
    }
}

/// Whether a program answers, after asking apt for its package.
pub(crate) fn program(name: &str, package: &str) -> Result<(), String> {
    let there = || succeeds(&mut command(name, ["--version"]));
    if there() || (apt_install(&[package]) && there()) {
        Ok(())
    } else {
        Err(format!("{name} is missing: install {package}"))
    }
}

fn has_target(triple: &str) -> bool {
    let dir = output(&mut command("rustc", ["--print", "target-libdir", "--target", triple]));
    dir.is_ok_and(|d| Path::new(d.trim()).is_dir())
}

fn add(triple: &str) -> bool {
    run(&mut command("rustup", ["target", "add", triple])).is_ok()
}

#[cfg(test)]
mod check {
    use super::program;

    #[test]
    fn what_is_missing_is_named() {
        let why = program("no-such-program-here", "no-such-package-here");
        assert!(why.is_err_and(|w| w.contains("no-such-package-here")), "the package is named");
    }
}
