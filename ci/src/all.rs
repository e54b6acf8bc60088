//! `all`: everything in one go, also after a failure, and the closing line that counts it.

use std::time::Instant;

use crate::tally::Tally;
use crate::words::{self, Result, Stop, no_args};

/// Cheap words first; then in the order in which they can use each other's builds. The golden tables are tests among the tests.
const ORDER: &[&[&str]] = &[
    &["fmt", "--check"],
    &["tree"],
    &["slots", "--check"],
    &["lint"],
    &["doc"],
    &["no-std"],
    &["test", "--debug"],
    &["test", "--release"],
    &["hashes"],
    &["size"],
    &["eink"],
    &["wasm"],
    &["bindings", "--check"],
    &["android"],
    &["android-size"],
    &["swift"],
    &["fuzz"],
    &["desktop"],
    &["web"],
];

/// `cargo ci all`. A word counts as one, and each test that it ran as one more.
pub(crate) fn all(args: &[String]) -> Result {
    no_args(args)?;
    let mut sum = Tally::default();
    let mut lines = Vec::new();
    for call in ORDER {
        let text = call.join(" ");
        eprintln!("\n=== {text}");
        let start = Instant::now();
        let (counts, said) = counted(run(call), crate::shell::is_ci());
        sum += counts;
        lines.push(format!("{text:<16} {:>6.0} s  {said}", start.elapsed().as_secs_f64()));
    }
    println!("\n=== sum\n{}", lines.join("\n"));
    // The last line: `main` has nothing to add to it.
    println!("{} passed, {} failed", sum.passed, sum.failed);
    if sum.failed == 0 { Ok(sum) } else { Err(Stop::Failed(String::new(), sum)) }
}

fn run(call: &[&str]) -> Result {
    let args: Vec<String> = call[1..].iter().map(ToString::to_string).collect();
    match words::find(call[0]) {
        Some(word) => (word.run)(&args),
        None => Err(Stop::Usage(format!("unknown word `{}`", call[0]))),
    }
}

/// What a word adds to the sum, and what is said of it.
fn counted(result: Result, strict: bool) -> (Tally, String) {
    match result {
        Ok(t) => (Tally { passed: t.passed + 1, ..t }, format!("ok{}", tests(t))),
        Err(Stop::Skipped(why)) if !strict => (Tally::default(), format!("SKIPPED: {why}")),
        Err(Stop::Skipped(why)) => {
            (Tally { failed: 1, ..Tally::default() }, format!("FAILED, because skipped: {why}"))
        }
        Err(Stop::Usage(why)) => {
            (Tally { failed: 1, ..Tally::default() }, format!("FAILED: {why}"))
        }
        Err(Stop::Failed(why, t)) => {
            (Tally { failed: t.failed + 1, ..t }, format!("FAILED{}: {why}", tests(t)))
        }
    }
}

fn tests(t: Tally) -> String {
    if t == Tally::default() {
        return String::new();
    }
    format!(" ({} tests passed, {} failed, {} ignored)", t.passed, t.failed, t.ignored)
}

#[cfg(test)]
mod check {
    use super::{ORDER, counted};
    use crate::tally::Tally;
    use crate::words::{Stop, find};

    #[test]
    fn every_call_is_a_word() {
        assert!(
            ORDER.iter().all(|call| find(call[0]).is_some()),
            "`all` runs only words that exist"
        );
    }

    #[test]
    fn a_word_counts_as_one_and_its_tests_too() {
        let t = Tally { passed: 4, failed: 0, ignored: 1 };
        assert_eq!(counted(Ok(t), true).0.passed, 5);
        let t = Tally { passed: 4, failed: 2, ignored: 0 };
        let (sum, said) = counted(Err(Stop::Failed("two tests".into(), t)), true);
        assert_eq!((sum.passed, sum.failed), (4, 3));
        assert!(said.contains("2 failed"), "{said}");
    }

    #[test]
    fn a_skip_fails_only_where_nothing_may_be_skipped() {
        let skip = || Err(Stop::Skipped("no target".into()));
        assert_eq!(counted(skip(), false).0, Tally::default());
        assert_eq!(counted(skip(), true).0.failed, 1);
    }
}
