//! `fmt`, `lint`, `doc`: what can be said about the source without running it.

use std::process::Command;

use crate::hashes::BOARD;
use crate::shell::{cargo, run_each};
use crate::tally::Tally;
use crate::tools;
use crate::tree::core_features;
use crate::words::{Result, flag, no_args};

/// The peers stand outside of the workspace (they need a C++ library), but not outside of the style.
const PEERS: &str = "ci/peers/Cargo.toml";
/// So do the fuzz targets, which are built in a way of their own.
const FUZZ: &str = "tests/fuzz/Cargo.toml";
/// The generator of bindings.
const BINDGEN: &str = crate::bindings::MANIFEST;
/// And what is built for many targets.
const PROBE: &str = "tests/probe/Cargo.toml";
const FIRMWARE: &str = "shells/eink/firmware/Cargo.toml";
/// The web shell, and what writes its JavaScript.
const WEB: &str = crate::web::MANIFEST;
const JSBIND: &str = crate::web::JSBIND;

/// `cargo ci fmt [--check]`.
pub(crate) fn fmt(args: &[String]) -> Result {
    let check = flag(args, "--check")?;
    let with = |list: &[&str]| {
        let mut c = cargo(["fmt"]);
        c.args(list);
        if check {
            c.args(["--", "--check"]);
        }
        c
    };
    let apart = |manifest| with(&["--manifest-path", manifest]);
    let outside = [PEERS, FUZZ, PROBE, FIRMWARE, BINDGEN, WEB, JSBIND].map(apart);
    run_each([with(&["--all"])].into_iter().chain(outside))?;
    Ok(Tally::default())
}

/// `cargo ci lint`: the workspace, then the core alone with each feature, because in the workspace
/// another member may switch a feature on and hide what breaks without it.
pub(crate) fn lint(args: &[String]) -> Result {
    no_args(args)?;
    let core = |features: &[&str]| clippy(["-p", "dogleaf-core"].iter().chain(features));
    let mut list = vec![clippy(&["--workspace", "--all-targets"]), core(&[])];
    for feature in core_features()? {
        // Only `seed` has tests of its own that link on a host; a defmt binary wants a logger.
        let targets: &[&str] = if feature == "seed" { &["--all-targets"] } else { &[] };
        list.push(core(&[&["--features", feature.as_str()], targets].concat()));
    }
    list.push(clippy(&["--manifest-path", PROBE, "--all-targets", "--all-features"]));
    list.push(clippy(&["--manifest-path", WEB, "--all-targets", "--all-features"]));
    // Without the target `hashes` says that it is missing.
    if tools::target(BOARD).is_ok() {
        list.push(clippy(&[
            "--manifest-path",
            FIRMWARE,
            "--bins",
            "--features",
            "reader",
            "--target",
            BOARD,
        ]));
    }
    run_each(list)?;
    Ok(Tally::default())
}

fn clippy<'a>(args: impl IntoIterator<Item = &'a &'a str>) -> Command {
    let mut c = cargo(["clippy"]);
    c.args(args).args(["--", "-D", "warnings"]);
    c
}

/// `cargo ci doc`: as the workspace sees it, and the core as a firmware sees it.
pub(crate) fn doc(args: &[String]) -> Result {
    no_args(args)?;
    let doc = |what: &str| {
        let mut c = cargo(["doc", "--no-deps"]);
        c.args(what.split(' ')).env("RUSTDOCFLAGS", "-D warnings");
        c
    };
    run_each([doc("--workspace"), doc("-p dogleaf-core"), doc("-p dogleaf-core --all-features")])?;
    Ok(Tally::default())
}
