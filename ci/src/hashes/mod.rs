//! `hashes`: the same bits everywhere; and `wasm`: how long a step takes in node.

mod lines;
mod target;

use std::path::PathBuf;
use std::process::Child;
use std::thread::JoinHandle;

use crate::shell::{command, run};
use crate::tally::Tally;
use crate::words::{Result, Stop, flag, no_args};
use lines::Line;
pub(crate) use target::{BOARD, SOFT, board};
use target::{On, TARGETS, Target};

const GOLDEN: &str = "fixtures/golden/hashes.txt";
/// Microseconds a step may take in node with vectors: a goal, not a gate.
const GOAL_US: &str = "75";

/// What became of one target at one level.
struct Row {
    target: Target,
    level: &'static str,
    found: std::result::Result<Vec<Line>, String>,
}

/// `cargo ci hashes [--bless]`.
pub(crate) fn hashes(args: &[String]) -> Result {
    let bless = flag(args, "--bless")?;
    let (rows, skipped) = everywhere();
    let golden = if bless { first(&rows)? } else { golden()? };
    let faults = compare(&rows, &golden);
    table(&rows, &golden);
    for why in skipped.iter().chain(&faults) {
        eprintln!("  {why}");
    }
    if !faults.is_empty() {
        return Err(format!("{} of {} builds differ", faults.len(), rows.len()).into());
    }
    if !skipped.is_empty() {
        return Err(Stop::Skipped(format!("{} targets did not run", skipped.len())));
    }
    if bless {
        std::fs::write(GOLDEN, lines::write(&golden)).map_err(|e| format!("{GOLDEN}: {e}"))?;
        println!("Blessed. Say in CHANGELOG.md why the bits moved.");
    }
    println!("{} builds, {} hashes, all equal", rows.len(), counted(&rows));
    Ok(Tally { passed: counted(&rows), ..Tally::default() })
}

/// Builds one after the other; what is built runs while the next one builds.
fn everywhere() -> (Vec<Row>, Vec<String>) {
    let (mut running, mut skipped) = (Vec::new(), Vec::new());
    for target in TARGETS {
        if let Err(why) = target.ready() {
            skipped.push(format!("{} did not run: {why}", target.name));
            continue;
        }
        // Unoptimised first: it is built in half the time and runs longest.
        for &level in target.levels {
            running.push((target, level, target.build(level).map(|built| start(target, built))));
        }
    }
    let rows = running.into_iter().map(|(target, level, run)| Row {
        target,
        level,
        found: run.and_then(finish),
    });
    (rows.collect(), skipped)
}

type Running = JoinHandle<std::result::Result<Vec<Line>, String>>;

fn start(target: Target, built: PathBuf) -> Running {
    std::thread::spawn(move || {
        let mut c = target.command(&built);
        c.stdin(std::process::Stdio::null());
        // A board speaks on stderr: semihosting keeps stdout for defmt.
        let child = c.stdout(std::process::Stdio::piped()).stderr(std::process::Stdio::piped());
        let done = child.spawn().and_then(Child::wait_with_output).map_err(|e| e.to_string())?;
        let said = [done.stdout, done.stderr].concat();
        let said = String::from_utf8_lossy(&said);
        if done.status.success() {
            Ok(lines::read(&said))
        } else {
            Err(format!("{}: {}", done.status, said.lines().next_back().unwrap_or("no word")))
        }
    })
}

fn finish(running: Running) -> std::result::Result<Vec<Line>, String> {
    running.join().unwrap_or_else(|_| Err("the runner panicked".into()))
}

/// What is blessed: the first target's, which all others must have too.
fn first(rows: &[Row]) -> std::result::Result<Vec<Line>, String> {
    rows.first().map_or_else(|| Err("nothing ran".into()), |row| row.found.clone())
}

fn golden() -> std::result::Result<Vec<Line>, String> {
    let text = std::fs::read_to_string(GOLDEN).map_err(|e| format!("{GOLDEN}: {e}"))?;
    Ok(lines::read(&text))
}

fn compare(rows: &[Row], golden: &[Line]) -> Vec<String> {
    let fault = |row: &Row| {
        let tiers = row.target.tiers(row.level);
        let why = match &row.found {
            Ok(found) => lines::difference(golden, found, tiers)?,
            Err(why) => why.clone(),
        };
        Some(format!("{} {}: {why}", row.target.name, row.level.to_uppercase()))
    };
    rows.iter().filter_map(fault).collect()
}

fn counted(rows: &[Row]) -> u64 {
    rows.iter().flat_map(|r| &r.found).map(|f| f.len() as u64).sum()
}

/// Target, level and number by scene; and how many operations agree.
fn table(rows: &[Row], golden: &[Line]) {
    let scenes = |tier: &str| -> Vec<&Line> {
        golden.iter().filter(|l| l.kind == "scene" && l.tier == tier).collect()
    };
    let names: Vec<String> = scenes("f32").iter().map(|l| format!("{:<16}", l.name)).collect();
    println!("| {:<15} | O  | real | {} | operations |", "target", names.join(" | "));
    println!("|{}|", vec!["---"; names.len() + 4].join("|"));
    for row in rows {
        for tier in row.target.tiers(row.level) {
            let found = row.found.as_deref().unwrap_or(&[]);
            let cell = |want: &&Line| {
                let same = |f: &&Line| f.kind == "scene" && f.tier == **tier && f.name == want.name;
                found.iter().find(same).map_or("did not run     ", |f| f.hash.as_str()).to_owned()
            };
            let cells: Vec<String> = scenes(tier).iter().map(cell).collect();
            let (name, level) = (row.target.name, row.level.to_uppercase());
            let [same, all] = agreeing(found, golden, tier);
            println!(
                "| {name:<15} | {level} | {tier}  | {} | {same} of {all}   |",
                cells.join(" | ")
            );
        }
    }
}

fn agreeing(found: &[Line], golden: &[Line], tier: &str) -> [usize; 2] {
    let of: Vec<&Line> =
        golden.iter().filter(|l| l.kind == "operation" && l.tier == tier).collect();
    [of.iter().filter(|l| found.contains(l)).count(), of.len()]
}

/// `cargo ci wasm`: the recorded turn in node, with vectors and without.
pub(crate) fn wasm(args: &[String]) -> Result {
    no_args(args)?;
    println!(
        "µs a step: median, median of the best of ten, its p99 (goal with simd128: {GOAL_US})"
    );
    for target in TARGETS.iter().filter(|t| t.on == On::Node) {
        target.ready().map_err(Stop::Skipped)?;
        let built = target.build("o3")?;
        let mut c = command("node", ["tests/probe/web.mjs"]);
        println!("{}:", target.name);
        // Its status says whether every step had the recorded hash.
        run(c.arg(built).arg("--time"))?;
    }
    Ok(Tally::default())
}
