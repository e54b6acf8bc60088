//! Promise: the hard scenarios hold. Forty-eight of them at three fidelities in two scalars, every rule checked
//! after every step, and one figure each pinned in a table.
//!
//! In release the whole table is compared with `fixtures/golden/hard_cases.txt`, where a `!` marks a rule that is
//! known to be broken; debug builds play a short version at the standard fidelity, under the same rules.

use dogleaf_tests::scenario::{ALL, At, Found, Run, table};

/// The whole table: a rule that is broken where the table does not show a `!` makes another table.
#[cfg(not(debug_assertions))]
#[test]
fn all_scenarios() {
    use dogleaf_tests::golden::compare;
    let rows = table::rows(true, |_| true);
    table::faults(&rows).iter().for_each(|what| println!("{what}"));
    if let Err(why) = compare("hard_cases.txt", &table::print(&rows)) {
        panic!("{why}");
    }
}

/// The short version may break only rules that the pinned table shows as broken.
#[cfg(debug_assertions)]
#[test]
fn all_scenarios_in_short() {
    let rows = table::rows(false, |run| run % 3 == 1);
    println!("{}", table::print(&rows));
    let pinned = include_str!("../fixtures/golden/hard_cases.txt");
    let marked = |n: u32| {
        let is_row = |line: &&str| line.split_whitespace().next() == Some(n.to_string().as_str());
        pinned.lines().find(is_row).is_some_and(|line| line.contains('!'))
    };
    let fresh: Vec<_> = rows.into_iter().filter(|row| !marked(row.scenario.number)).collect();
    let faults = table::faults(&fresh);
    assert!(faults.is_empty(), "{} rules broken:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn none_is_left_out() {
    for (n, scenario) in ALL.iter().enumerate() {
        assert_eq!(scenario.number as usize, n + 1, "{}", scenario.name);
        if let Run::NotYet(why) = scenario.run {
            assert!(!why.is_empty(), "{} has no reason", scenario.name);
        }
    }
    let open = ALL.iter().filter(|s| matches!(s.run, Run::NotYet(_))).count();
    assert_eq!(open, 1, "only the bookmark is not yet");
}

/// What the table is worth: a figure beyond its bound, one that is no number, and a panic are failures.
#[test]
fn the_check_can_fail() {
    assert!(Found::within(1.0, 1.0).faults.is_empty(), "within");
    assert_eq!(Found::within(1.1, 1.0).faults.len(), 1, "beyond");
    assert_eq!(Found::within(f64::NAN, 1.0).faults.len(), 1, "no number is within nothing");
    let mut rows = table::rows(false, |_| false);
    assert!(rows.iter().all(|row| row.found.iter().all(Option::is_none)), "nothing was asked for");
    rows[0].found[4] = Some(Found::within(2.0, 1.0));
    let text = table::print(&rows);
    assert!(text.contains("2.00!") && text.contains("0 passed, 1 failed, 1 not yet"), "{text}");
    assert!(table::faults(&rows)[0].starts_with("1 rest without input, standard f64"), "named");
    let _ = At { fidelity: table::FIDELITIES[0], full: false };
}
