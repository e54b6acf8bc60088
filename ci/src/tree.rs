//! `tree`: what must never enter the core, neither as a crate, nor as a feature, nor as a word.
//!
//! Cargo unifies features: one member that asks for `nalgebra/std` would change the core's bits
//! without a change in the core. So the tree is looked at as a firmware gets it, and as the shells do.

use crate::bans;
use crate::shell::{cargo, output};
use crate::tally::Tally;
use crate::words::{Result, no_args};

const MANIFEST: &str = "core/Cargo.toml";

/// A firmware's core, and the one that the shells share.
const LOOKS: [&str; 3] = [
    "-p dogleaf-core --target thumbv7em-none-eabihf --no-default-features",
    "-p dogleaf-core --target thumbv7em-none-eabihf --all-features",
    "--workspace",
];

/// Beginnings of lines of `cargo tree -e features`, and what is wrong with them.
const BANNED: [(&str, &str); 6] = [
    ("nalgebra feature \"std\"", "replaces libm by the host's own functions"),
    ("nalgebra feature \"default\"", "brings std and matrixmultiply"),
    ("nalgebra feature \"alloc\"", "the core allocates nothing"),
    ("matrixmultiply ", "chooses FMA by the processor it runs on"),
    ("simba feature \"std\"", "replaces libm by the host's own functions"),
    ("heapless feature \"alloc\"", "the core allocates nothing"),
];

/// `cargo ci tree`.
pub(crate) fn tree(args: &[String]) -> Result {
    no_args(args)?;
    let mut faults = Vec::new();
    for what in LOOKS {
        let list = output(
            cargo(["tree", "-e", "no-dev,features", "--prefix", "none"]).args(what.split(' ')),
        )?;
        eprintln!("> cargo tree {what}");
        faults.extend(banned(&list).into_iter().map(|f| format!("{what}: {f}")));
    }
    eprintln!("> bans in core/src");
    faults.extend(bans::scan("core/src".as_ref())?);
    for f in &faults {
        eprintln!("  {f}");
    }
    if faults.is_empty() {
        Ok(Tally::default())
    } else {
        Err(format!("{} faults in the core", faults.len()).into())
    }
}

fn banned(tree: &str) -> Vec<String> {
    let fault = |line: &str| {
        let (what, why) = BANNED.iter().find(|(what, _)| line.starts_with(what))?;
        Some(format!("{}: {why}", what.trim_end()))
    };
    let mut found: Vec<String> = tree.lines().filter_map(fault).collect();
    found.sort();
    found.dedup();
    found
}

/// The names of the core's features but `default`, read from its manifest.
pub(crate) fn core_features() -> std::result::Result<Vec<String>, String> {
    let text = std::fs::read_to_string(MANIFEST).map_err(|e| format!("{MANIFEST}: {e}"))?;
    Ok(features(&text))
}

fn features(manifest: &str) -> Vec<String> {
    let section = manifest
        .lines()
        .skip_while(|l| l.trim() != "[features]")
        .skip(1)
        .take_while(|l| !l.starts_with('['));
    let name = |line: &str| {
        let (name, _) = line.split_once('=')?;
        let name = name.trim();
        let word =
            !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || c == '-' || c == '_');
        (word && name != "default").then(|| name.to_owned())
    };
    section.filter_map(name).collect()
}

#[cfg(test)]
mod check {
    use super::{banned, features};

    #[test]
    fn features_are_read_from_the_manifest() {
        let text = "[package]\nname = \"x\"\n\n[features]\ndefault = []\n# why\nseed = []\ndefmt = [\n  \"dep:defmt\",\n]\n\n[dependencies]\nlibm = \"1\"\n";
        assert_eq!(features(text), ["seed", "defmt"]);
    }

    #[test]
    fn a_planted_feature_is_caught() {
        assert!(
            banned("nalgebra v0.35.0\nnalgebra feature \"libm-force\"\n").is_empty(),
            "what we want"
        );
        let bad = banned(
            "nalgebra feature \"std\"\nmatrixmultiply v0.3.10\nnalgebra feature \"std\" (*)\n",
        );
        assert_eq!(bad.len(), 2, "{bad:?}");
    }
}
