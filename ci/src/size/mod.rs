//! `size`: the firmware's image on the emulated Cortex-M7 against what it may take, and whether the checks
//! would notice.

mod figures;
mod image;

use std::path::PathBuf;

use crate::hashes::{BOARD, board};
use crate::shell::{cargo, run, target_dir};
use crate::tally::Tally;
use crate::tools;
use crate::words::{Result, Stop, no_args};
use figures::Figures;
use image::Image;

const KIB: u64 = 1024;
/// Code and constants: what we want, and what we have. The second may only fall.
const TEXT: [u64; 2] = [64 * KIB, 83 * KIB];
/// RAM, statics and stack together.
const RAM: [u64; 2] = [96 * KIB, 88 * KIB];
/// Stack.
const STACK: [u64; 2] = [4 * KIB, 3_900];
/// Instructions of the median step, and how many times as many the worst may take.
const INSTRUCTIONS: [u64; 2] = [1_200_000, 1_200_000];
const WORST: u64 = 2;

/// Features of the core, and how the firmware asks for them.
const FEATURES: [(&str, &str); 3] =
    [("none", ""), ("seed, unused", "dogleaf-core/seed"), ("defmt, logged", "defmt")];

/// As `shells/eink/firmware/.cargo/config.toml` has them.
const FLAGS: &str = "-Ctarget-cpu=cortex-m7 -Cllvm-args=-inline-threshold=5";

/// One thing that is looked at: its name, its figure, what is wanted and what is allowed.
struct Check {
    name: &'static str,
    found: u64,
    goal: u64,
    most: u64,
}

/// `cargo ci size`.
pub(crate) fn size(args: &[String]) -> Result {
    no_args(args)?;
    tools::target(BOARD).map_err(Stop::Skipped)?;
    tools::program("qemu-system-arm", "qemu-system-arm").map_err(Stop::Skipped)?;
    let mut faults = product()?;
    faults.extend(control()?);
    features()?;
    for fault in &faults {
        eprintln!("  {fault}");
    }
    if faults.is_empty() {
        Ok(Tally::default())
    } else {
        Err(format!("{} of the firmware's bounds do not hold", faults.len()).into())
    }
}

/// The image as it is: nothing may be over.
fn product() -> std::result::Result<Vec<String>, String> {
    let (checks, image, said) = looked_at("")?;
    println!("| firmware on Cortex-M7 | found | at most | goal |\n|---|---|---|---|");
    for Check { name, found, goal, most } in &checks {
        let missed = if found > goal { ", missed" } else { "" };
        println!("| {name} | {found} | {most} | {goal}{missed} |");
    }
    for line in said.lines() {
        println!("    {line}");
    }
    for name in image.panics.iter().chain(&image.allocators).chain(&image.unasked) {
        println!("    forbidden: {name}");
    }
    let over = checks.iter().filter(|c| c.found > c.most);
    Ok(over.map(|c| format!("{}: {} is more than {}", c.name, c.found, c.most)).collect())
}

/// The image with everything planted that must not be in it: every check must fail.
fn control() -> std::result::Result<Vec<String>, String> {
    let (checks, ..) = looked_at("planted")?;
    let blind = checks.iter().filter(|c| c.found <= c.most);
    Ok(blind.map(|c| format!("control: `{}` did not notice what was planted", c.name)).collect())
}

fn looked_at(features: &str) -> std::result::Result<(Vec<Check>, Image, String), String> {
    let path = build(features)?;
    let image = Image::read(&path)?;
    let said = play(&path)?;
    let figures = Figures::read(&said);
    let stack = figures.get("stack high water")?;
    let median = figures.get("instructions median")?;
    let check = |name, found, [goal, most]: [u64; 2]| Check { name, found, goal, most };
    let checks = vec![
        check("text and constants, bytes", image.text, TEXT),
        check("static RAM and stack, bytes", image.statics() + stack, RAM),
        check("stack high water, bytes", stack, STACK),
        check("instructions a step, median", median, INSTRUCTIONS),
        check(
            "instructions a step, worst",
            figures.get("instructions most")?,
            INSTRUCTIONS.map(|n| WORST * n),
        ),
        check("functions that panic", image.panics.len() as u64, [0, 0]),
        check("functions that allocate", image.allocators.len() as u64, [0, 0]),
        check("functions nobody asked for", image.unasked.len() as u64, [0, 0]),
    ];
    Ok((checks, image, said))
}

/// Builds the image, with features of it or of the core.
fn build(features: &str) -> std::result::Result<PathBuf, String> {
    let folder = target_dir().join("hashes");
    let mut c = cargo(["build", "--quiet", "--locked", "--bin", "play", "--release"]);
    c.args([
        "--manifest-path",
        "shells/eink/firmware/Cargo.toml",
        "--target",
        BOARD,
        "--target-dir",
    ]);
    c.arg(&folder).args(["--features", features]);
    c.env("RUSTFLAGS", FLAGS).env_remove("CARGO_ENCODED_RUSTFLAGS");
    run(&mut c)?;
    Ok(folder.join(BOARD).join("release/play"))
}

/// What it says when it runs; its status is a figure of another word.
fn play(image: &std::path::Path) -> std::result::Result<String, String> {
    let mut c = board("cortex-m7", "mps2-an500", image);
    // Sixteen nanoseconds an instruction: the firmware's clock counts them.
    c.args(["-icount", "shift=4,align=off,sleep=off"]).stdin(std::process::Stdio::null());
    let done = c.output().map_err(|e| format!("qemu-system-arm: {e}"))?;
    Ok(String::from_utf8_lossy(&done.stderr).into_owned())
}

/// Bytes that each feature of the core costs.
fn features() -> std::result::Result<(), String> {
    println!("| feature of the core | text | statics |\n|---|---|---|");
    for (name, features) in FEATURES {
        let image = Image::read(&build(features)?)?;
        println!("| {name} | {} | {} |", image.text, image.statics());
    }
    Ok(())
}
