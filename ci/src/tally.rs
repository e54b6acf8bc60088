//! How many tests passed: read from the lines that cargo's test binaries print.

use std::ops::AddAssign;

/// Counts of one or more test binaries.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Tally {
    pub(crate) passed: u64,
    pub(crate) failed: u64,
    pub(crate) ignored: u64,
}

impl Tally {
    /// Adds what a `test result:` line says; every other line says nothing.
    pub(crate) fn read(&mut self, line: &str) {
        let Some((_, counts)) = line.split_once("test result:") else { return };
        for part in counts.split([';', '.']) {
            let mut words = part.split_whitespace();
            let Some(Ok(n)) = words.next().map(str::parse::<u64>) else { continue };
            match words.next() {
                Some("passed") => self.passed += n,
                Some("failed") => self.failed += n,
                Some("ignored") => self.ignored += n,
                _ => {}
            }
        }
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.ignored += other.ignored;
    }
}

#[cfg(test)]
mod check {
    use super::Tally;

    #[test]
    fn reads_good_and_bad_results() {
        let mut t = Tally::default();
        t.read("running 7 tests");
        t.read("test result: ok. 5 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.12s");
        t.read("test result: FAILED. 2 passed; 3 failed; 0 ignored; 0 measured; 4 filtered out; finished in 1.00s");
        assert_eq!(t, Tally { passed: 7, failed: 3, ignored: 1 });
    }

    #[test]
    fn colours_do_not_hide_a_count() {
        let mut t = Tally::default();
        t.read("test result: \u{1b}[32mok\u{1b}(B\u{1b}[m. 12 passed; 0 failed; 0 ignored");
        assert_eq!(t.passed, 12);
    }

    #[test]
    fn a_line_of_prose_counts_nothing() {
        let mut t = Tally::default();
        t.read("5 passed; 6 failed");
        t.read("test result: none");
        assert_eq!(t, Tally::default());
    }
}
