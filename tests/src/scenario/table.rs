//! The table: every scenario at three fidelities in two scalars, side by side.

use super::{ALL, At, Found, Run, Scenario};
use dogleaf_core::scene::Fidelity;
use std::fmt::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// Fidelities of the table; the reference is for references.
pub const FIDELITIES: [Fidelity; 3] = [Fidelity::Draft, Fidelity::Standard, Fidelity::Fine];

/// One scenario at each fidelity in `f32`, then in `f64`.
#[derive(Debug, Clone)]
pub struct Row {
    /// Which.
    pub scenario: Scenario,
    /// What came of it; nothing where it cannot be played, or was not asked for.
    pub found: [Option<Found>; 6],
}

/// One cell: a row, and which of its six runs.
fn cell(n: usize, full: bool, wanted: impl Fn(usize) -> bool) -> Option<Found> {
    let (row, run) = (n / 6, n % 6);
    let Run::Plays(plays) = ALL[row].run else { return None };
    if !wanted(run) {
        return None;
    }
    let at = At { fidelity: FIDELITIES[run % 3], full };
    let play = AssertUnwindSafe(|| plays[run / 3](at));
    let panicked = |_| Found { figure: f64::NAN, faults: vec!["it panicked".into()] };
    Some(catch_unwind(play).unwrap_or_else(panicked))
}

/// Plays all scenarios on all processors; of their six runs, those that are wanted.
pub fn rows(full: bool, wanted: impl Fn(usize) -> bool + Sync) -> Vec<Row> {
    let next = AtomicUsize::new(0);
    let empty = |scenario| Row { scenario, found: [const { None }; 6] };
    let rows = Mutex::new(ALL.map(empty).to_vec());
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            let work = || {
                loop {
                    let n = next.fetch_add(1, Ordering::Relaxed);
                    if n >= 6 * ALL.len() {
                        break;
                    }
                    let found = cell(n, full, &wanted);
                    let mut rows = rows.lock().unwrap_or_else(PoisonError::into_inner);
                    rows[n / 6].found[n % 6] = found;
                }
            };
            let big = std::thread::Builder::new().stack_size(64 << 20);
            big.spawn_scoped(scope, work).expect("a thread can be started");
        }
    });
    rows.into_inner().unwrap_or_else(PoisonError::into_inner)
}

/// Everything that is wrong, one line each.
pub fn faults(rows: &[Row]) -> Vec<String> {
    let mut all = Vec::new();
    for row in rows {
        for (n, found) in row.found.iter().enumerate() {
            let Some(found) = found else { continue };
            let real = ["f32", "f64"][n / 3];
            let fidelity = Fidelity::ALL[n % 3].0;
            let (number, name) = (row.scenario.number, row.scenario.name);
            let line = |what: &String| format!("{number} {name}, {fidelity} {real}: {what}");
            all.extend(found.faults.iter().map(line));
        }
    }
    all
}

/// The whole table, as it is pinned.
pub fn print(rows: &[Row]) -> String {
    let mut text = String::from(
        "The hard scenarios: one figure each at draft, standard, fine; `!` where a rule is broken.\n\
         #   kind         scenario                            figure                 \
         f32: draft   standard       fine   f64: draft   standard       fine\n",
    );
    let (mut passed, mut failed, mut open) = (0, 0, 0);
    for row in rows {
        let s = &row.scenario;
        let kind = format!("{:?}", s.kind).to_lowercase();
        let _ = write!(text, "{:<3} {kind:12} {:35} ", s.number, s.name);
        if let Run::NotYet(why) = s.run {
            open += 1;
            let _ = writeln!(text, "not yet: {why}");
            continue;
        }
        let _ = write!(text, "{:22}", s.figure);
        for (n, found) in row.found.iter().enumerate() {
            let wide = if n % 3 == 0 { 12 } else { 10 };
            let Some(found) = found else {
                let _ = write!(text, " {:>wide$}", "-");
                continue;
            };
            let fine = found.faults.is_empty();
            *(if fine { &mut passed } else { &mut failed }) += 1;
            let mark = if fine { ' ' } else { '!' };
            let _ = write!(text, " {:>w$}{mark}", figure(found.figure), w = wide - 1);
        }
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    let _ = writeln!(text, "{passed} passed, {failed} failed, {open} not yet");
    text
}

/// Three digits, whatever the size; below a part in 10¹² it is nothing.
fn figure(v: f64) -> String {
    match v.abs() {
        a if a < 1e-12 => "0".into(),
        a if (1e3..1e7).contains(&a) && v.fract() == 0.0 => format!("{v:.0}"),
        a if (1e-2..1e5).contains(&a) => {
            let digits = if a < 1.0 { 4 } else { usize::from(a < 100.0) + usize::from(a < 10.0) };
            format!("{v:.digits$}")
        }
        _ => format!("{v:.2e}"),
    }
}
