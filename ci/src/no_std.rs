//! `no-std`: the core builds for a microcontroller, with no feature, with each one, with all.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::shell::{apt_install, command, output, run, run_each, succeeds, target_dir};
use crate::tally::Tally;
use crate::tree::core_features;
use crate::words::{Result, Stop};

const TARGET: &str = "thumbv7em-none-eabihf";

/// How this machine can build for the target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    /// The toolchain in use has the target, or rustup could add it.
    Installed,
    /// A nightly toolchain with rust-src builds `core` itself.
    Nightly,
    /// So does Debian's rustc-web with its sources.
    Debian,
}

impl Way {
    const ALL: [Self; 3] = [Self::Installed, Self::Nightly, Self::Debian];

    fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|w| format!("{w:?}").eq_ignore_ascii_case(name))
    }

    /// Whether it works here, after installing what may be installed.
    fn ready(self) -> bool {
        match self {
            Self::Installed => has_target() || (rustup(["target", "add", TARGET]) && has_target()),
            Self::Nightly => {
                has_source(&rustc("nightly"))
                    || (rustup(["component", "add", "rust-src", "--toolchain", "nightly"])
                        && has_source(&rustc("nightly")))
            }
            Self::Debian => {
                let there = || {
                    Path::new("/usr/bin/cargo").exists() && has_source(&["/usr/bin/rustc".into()])
                };
                there() || (apt_install(&["rustc-web", "cargo-web", "rust-web-src"]) && there())
            }
        }
    }

    /// `cargo build` of the core, this way.
    fn build(self) -> Command {
        let mut c = match self {
            Self::Installed => command("cargo", ["build"]),
            Self::Nightly => {
                command("rustup", ["run", "nightly", "cargo", "build", "-Zbuild-std=core"])
            }
            Self::Debian => {
                let mut c = command("/usr/bin/cargo", ["build", "-Zbuild-std=core"]);
                c.env("RUSTC", "/usr/bin/rustc")
                    .env("RUSTC_BOOTSTRAP", "1")
                    .env_remove("RUSTUP_TOOLCHAIN");
                c
            }
        };
        c.args(["--release", "-p", "dogleaf-core", "--target", TARGET]);
        if self != Self::Installed {
            // Another compiler's files stay apart, else both rebuild everything at every turn.
            c.arg("--target-dir").arg(target_dir().join(format!("{self:?}").to_lowercase()));
        }
        c
    }
}

/// `cargo ci no-std [--via WAY]`.
pub(crate) fn no_std(args: &[String]) -> Result {
    let way = match args {
        [] => Way::ALL.into_iter().find(|w| w.ready()),
        [via, name] if via == "--via" => Some(forced(name)?),
        _ => {
            return Err(Stop::Usage(
                "no-std takes `--via installed|nightly|debian` or nothing".into(),
            ));
        }
    };
    let Some(way) = way else { return Err(Stop::Skipped(missing())) };
    eprintln!("no-std: {TARGET}, way: {way:?}");
    run_each(feature_sets(&core_features()?).into_iter().map(|set| {
        let mut c = way.build();
        c.args(set);
        c
    }))?;
    Ok(Tally::default())
}

fn forced(name: &str) -> std::result::Result<Way, Stop> {
    let way = Way::named(name).ok_or_else(|| Stop::Usage(format!("no way called `{name}`")))?;
    if way.ready() { Ok(way) } else { Err(Stop::Skipped(missing())) }
}

fn missing() -> String {
    format!(
        "no toolchain here builds for {TARGET}: rustup could not add it, nor rust-src to nightly, nor apt rustc-web"
    )
}

/// None, each alone, all of them.
fn feature_sets(features: &[String]) -> Vec<Vec<String>> {
    let mut sets = vec![vec!["--no-default-features".to_owned()]];
    sets.extend(
        features
            .iter()
            .map(|f| vec!["--no-default-features".to_owned(), "--features".to_owned(), f.clone()]),
    );
    sets.push(vec!["--all-features".to_owned()]);
    sets
}

fn has_target() -> bool {
    let dir = output(&mut command("rustc", ["--print", "target-libdir", "--target", TARGET]));
    dir.is_ok_and(|d| Path::new(d.trim()).is_dir())
}

fn rustc(toolchain: &str) -> [String; 4] {
    ["rustup", "run", toolchain, "rustc"].map(str::to_owned)
}

fn has_source(rustc: &[String]) -> bool {
    let mut c = command(&rustc[0], &rustc[1..]);
    if !succeeds(c.arg("--version")) {
        return false;
    }
    let root = output(command(&rustc[0], &rustc[1..]).args(["--print", "sysroot"]));
    root.is_ok_and(|r| PathBuf::from(r.trim()).join("lib/rustlib/src/rust/library/core").is_dir())
}

fn rustup<const N: usize>(args: [&str; N]) -> bool {
    succeeds(&mut command("rustup", ["--version"])) && run(&mut command("rustup", args)).is_ok()
}

#[cfg(test)]
mod check {
    use super::{Way, feature_sets};

    #[test]
    fn none_each_and_all() {
        let sets = feature_sets(&["seed".to_owned(), "defmt".to_owned()]);
        let text: Vec<String> = sets.iter().map(|s| s.join(" ")).collect();
        assert_eq!(text[0], "--no-default-features");
        assert_eq!(text[2], "--no-default-features --features defmt");
        assert_eq!(text[3], "--all-features");
    }

    #[test]
    fn ways_are_found_by_name() {
        assert_eq!(Way::named("debian"), Some(Way::Debian));
        assert_eq!(Way::named("gentoo"), None);
    }
}
