//! Promise: what accuracy costs moves only when somebody says so. Errors are compared to the digit, instructions to two
//! in a hundred and only where valgrind is installed, times never; and the fidelities keep their order on the front.

use dogleaf_cost::axes::{Config, GridName, RealName};
use dogleaf_cost::cost::{Counts, Probe, available, count};
use dogleaf_cost::errors::{Errors, Eye};
use dogleaf_cost::pareto::front;
use dogleaf_cost::reference::reference;
use dogleaf_cost::run::{Trajectory, Watch, play};
use dogleaf_cost::scene::{Kind, Stage, open};
use std::fmt::Write;
use std::process::Command;

// One mechanism for all golden tables; only the comparison of lines is of use here.
#[allow(dead_code, unreachable_pub)]
#[path = "../../../tests/src/golden.rs"]
mod house;

/// What instructions may differ by: another linker, another host's start of the program.
const SHARE: f64 = 0.02;
/// Where the probe finds its words.
const WORDS: &str = "DOGLEAF_COST_PROBE";
const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/golden/cost.txt");
const HOW: &str = "If every change is meant: `cargo ci golden --bless`, read `git diff fixtures/golden`, and say why in CHANGELOG.md.";

fn on_a_big_stack(work: impl FnOnce() + Send + 'static) {
    let worker = std::thread::Builder::new().stack_size(256 << 20).spawn(work);
    let done = worker.expect("a thread").join();
    if let Err(why) = done {
        std::panic::resume_unwind(why);
    }
}

/// The steps that valgrind counts; run by the other test.
#[test]
#[ignore = "run by the golden test under valgrind"]
fn probe() {
    let Ok(words) = std::env::var(WORDS) else { return };
    on_a_big_stack(move || Probe::run(&words).expect("words of the golden test"));
}

fn counted(config: &Config) -> Option<Counts> {
    let program = std::env::current_exe().ok()?;
    count(&Probe::of(config), &|c: &mut Command, words: &str| {
        c.env(WORDS, words).arg(&program).args(["--ignored", "--exact", "probe"]);
    })
}

/// Dials of the table.
fn configs() -> Vec<Config> {
    let mut all = Vec::new();
    for (real, refinements) in [(RealName::F32, 0), (RealName::F32, 1), (RealName::F64, 0)] {
        for newton in [1, 2] {
            for rate in [60, 120, 240, 960] {
                let newton = Some(newton);
                all.push(Config { rate, newton, real, refinements, ..Config::STANDARD });
            }
        }
    }
    all
}

struct Line {
    config: Config,
    errors: Errors,
    work: f64,
    instructions: Option<f64>,
}

fn measure() -> Vec<Line> {
    let stage = Stage::new(Kind::Turn, GridName::G11x8);
    let eye = Eye::new(stage.size_m[0], stage.size_m[1], &stage.units());
    let truth =
        reference(&stage, GridName::G11x8, Config::STANDARD.delta, 1920).expect("a reference");
    let counting = available();
    let mut known: Vec<(Probe, Option<Counts>)> = Vec::new();
    let mut lines = Vec::new();
    for config in configs() {
        let watch =
            Watch { rate: config.rate, seconds: stage.seconds, mesh: false, until_settled: false };
        let run = play(open(&stage, &config).expect("a stage").as_mut(), watch);
        let probe = Probe::of(&config);
        if counting && !known.iter().any(|(p, _)| *p == probe) {
            known.push((probe, counted(&config)));
        }
        let counts = known.iter().find(|(p, _)| *p == probe).and_then(|(_, c)| *c);
        let errors = Errors::beside(&run, &truth.truth, Some(&eye));
        lines.push(Line {
            config,
            errors,
            work: per_picture(&run, 0.0, 1.0),
            instructions: counts.map(|c| per_picture(&run, c.step, c.newton)),
        });
    }
    let smallest = lines.iter().filter_map(|l| l.errors.shape_rms).fold(f64::INFINITY, f64::min);
    assert!(
        truth.floor() <= smallest,
        "references {:.1e} apart, smallest error {smallest:.1e}",
        truth.agreement
    );
    lines
}

fn per_picture(run: &Trajectory, step: f64, newton: f64) -> f64 {
    let steps = run.step_us.len() as f64;
    (steps * step + f64::from(run.work.newton_steps) * newton) * f64::from(run.rate)
        / (60.0 * steps)
}

fn table(lines: &[Line]) -> String {
    let mut t = String::from(
        "A leaf led over by its corner, 11x8; errors beside two references that agree ten times better.\n\
         configuration            fidelity        RMS error  max error  outline px  stretch %  vertical ms  fact.  instructions a picture\n",
    );
    for l in lines {
        let e = &l.errors;
        let number = |v: Option<f64>| v.unwrap_or(f64::NAN);
        let instructions = l.instructions.map_or_else(|| "-".into(), |n| format!("{n:.0}"));
        let name = l.config.to_string();
        let fidelity = l.config.preset(false).join(",");
        writeln!(
            t,
            "{name:23}  {fidelity:14}  {:9.2e}  {:9.2e}  {:10.2}  {:9.3}  {:11.2}  {:5.1}  {instructions:>22}",
            number(e.shape_rms),
            number(e.shape_max),
            number(e.outline_px),
            100.0 * e.stretch[0],
            number(e.vertical_ms),
            l.work,
        )
        .expect("a text takes every line");
    }
    t
}

/// Which fidelities lie on the front, cheapest first; by factorisations where nothing was counted.
fn order(lines: &[Line]) -> String {
    let cost = |l: &Line| l.instructions.unwrap_or(l.work);
    let points: Vec<[f64; 2]> =
        lines.iter().map(|l| [cost(l), l.errors.shape_rms.unwrap_or(f64::INFINITY)]).collect();
    let on = front(&points);
    let mut named: Vec<_> =
        lines.iter().zip(on).filter(|(l, _)| !l.config.preset(false).is_empty()).collect();
    named.sort_by(|a, b| cost(a.0).total_cmp(&cost(b.0)));
    let words = named.iter().map(|(l, on)| {
        format!(
            "{} {}",
            l.config.preset(false).join(", "),
            if *on { "(on the front)" } else { "(BEATEN)" }
        )
    });
    format!("fidelities: {}\n", words.collect::<Vec<_>>().join(" < "))
}

/// The expected table with our instructions where they are close enough, so that what is left to compare is text.
fn with_tolerance(expected: &str, found: &str) -> String {
    let mut lines = expected.lines();
    let merged = found.lines().map(|f| {
        let Some(e) = lines.next() else { return f.to_owned() };
        let (Some((head, ours)), Some((_, theirs))) = (f.rsplit_once(' '), e.rsplit_once(' '))
        else {
            return f.to_owned();
        };
        let close = match (ours.parse::<f64>(), theirs.parse::<f64>()) {
            (Ok(a), Ok(b)) => (a - b).abs() <= SHARE * b,
            (Err(_), Ok(_)) => ours == "-",
            _ => false,
        };
        if close {
            format!("{} {theirs:>22}", head.trim_end().to_owned() + " ")
        } else {
            f.to_owned()
        }
    });
    merged.map(|l| l + "\n").collect()
}

#[cfg_attr(debug_assertions, ignore = "seconds in release, minutes in debug")]
#[test]
fn what_accuracy_costs() {
    on_a_big_stack(|| {
        let lines = measure();
        let found = table(&lines) + &order(&lines);
        println!("{found}");
        if std::env::var_os("DOGLEAF_BLESS").is_some_and(|v| v == "1") {
            assert!(lines.iter().all(|l| l.instructions.is_some()), "blessing needs valgrind");
            std::fs::write(FILE, &found).expect("fixtures/golden/cost.txt can be written");
            return;
        }
        let expected = std::fs::read_to_string(FILE).unwrap_or_default().replace("\r\n", "\n");
        let squeeze = |t: &str| {
            t.lines()
                .map(|l| l.split_whitespace().collect::<Vec<_>>().join(" ") + "\n")
                .collect::<String>()
        };
        let (old, new) = (squeeze(&expected), squeeze(&with_tolerance(&expected, &found)));
        if let Some(both) = house::beside(&old, &new) {
            panic!("fixtures/golden/cost.txt differs.\n{both}\n{HOW}");
        }
    });
}

/// What the comparison is worth: an error's last digit and three in a hundred instructions are seen, one is not.
#[test]
fn the_check_can_fail() {
    let seen = |expected: &str, found: &str| {
        let squeeze = |t: &str| t.split_whitespace().collect::<Vec<_>>().join(" ");
        squeeze(expected) != squeeze(&with_tolerance(expected, found))
    };
    assert!(!seen("a 1.00e-3 1000\n", "a 1.00e-3 1010\n"), "one in a hundred");
    assert!(seen("a 1.00e-3 1000\n", "a 1.00e-3 1030\n"), "three in a hundred");
    assert!(seen("a 1.00e-3 1000\n", "a 1.01e-3 1000\n"), "another error");
    assert!(!seen("a 1.00e-3 1000\n", "a 1.00e-3 -\n"), "nothing was counted");
    assert!(seen("a 1.00e-3 1000\n", "a 1.00e-3 x\n"), "a word is no number");
}
