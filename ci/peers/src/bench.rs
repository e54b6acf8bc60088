//! Everyone factors and solves the same matrices, in turns, so that noise falls on all alike.

use std::time::Instant;

use crate::matrices::Matrices;

/// What one contender did with all the matrices once.
#[derive(Debug, Clone, Default)]
pub(crate) struct Pass {
    /// Nanoseconds of the factorisation, per matrix.
    pub(crate) factor_ns: Vec<u64>,
    /// Nanoseconds of the solve, per matrix.
    pub(crate) solve_ns: Vec<u64>,
    /// Nanoseconds of everything together, from who cannot tell factorisation and solve apart.
    pub(crate) whole_ns: Vec<u64>,
    /// The solutions, one after the other; left empty by who solves another system for the same step.
    pub(crate) x: Vec<f64>,
}

impl Pass {
    /// Makes room for `count` solutions of length `n`.
    pub(crate) fn resize(&mut self, count: usize, n: usize) {
        self.factor_ns.resize(count, 0);
        self.solve_ns.resize(count, 0);
        self.x.resize(count * n, 0.0);
    }

    /// Forgets all, for who gives times one by one.
    pub(crate) fn clear(&mut self) {
        self.factor_ns.clear();
        self.solve_ns.clear();
        self.whole_ns.clear();
        self.x.clear();
    }

    /// The total of each matrix.
    fn totals(&self) -> impl Iterator<Item = u64> {
        let sums = self.factor_ns.iter().zip(&self.solve_ns).map(|(f, s)| f + s);
        sums.chain(self.whole_ns.iter().copied())
    }
}

/// Nanoseconds since `start`.
pub(crate) fn ns(start: Instant) -> u64 {
    start.elapsed().as_nanos() as u64
}

/// Someone who can factor and solve.
pub(crate) trait Contender {
    /// The name in the table.
    fn name(&self) -> &'static str;

    /// Factors and solves every matrix of the set, timing each.
    ///
    /// # Errors
    ///
    /// A matrix could not be factored.
    fn pass(&mut self, set: &Matrices, pass: &mut Pass) -> Result<(), String>;

    /// Stored entries of the factors, if known.
    fn entries(&self) -> Option<u64> {
        None
    }

    /// How many times faster than the baseline it has to be, if that was promised.
    fn wanted(&self) -> Option<f64> {
        None
    }
}

/// One line of the table.
#[derive(Debug, Clone)]
pub(crate) struct Row {
    pub(crate) name: &'static str,
    /// What was measured, or why nothing was.
    pub(crate) figures: Result<Figures, String>,
    /// The least ratio that passes.
    pub(crate) wanted: Option<f64>,
}

/// Medians over matrices and repeats, in microseconds.
#[derive(Debug, Clone)]
pub(crate) struct Figures {
    /// `None` from who cannot tell them apart.
    pub(crate) factor_us: Option<f64>,
    pub(crate) solve_us: Option<f64>,
    /// Of the sums, not the sum of the medians.
    pub(crate) total_us: f64,
    pub(crate) p95_us: f64,
    pub(crate) entries: Option<u64>,
    pub(crate) residual: Option<f64>,
}

/// Above this, a solver does not solve, and its time is worth nothing.
const WORST_RESIDUAL: f64 = 1e-8;

/// What is collected about one contender.
#[derive(Debug, Default)]
struct Lane {
    factor_ns: Vec<u64>,
    solve_ns: Vec<u64>,
    total_ns: Vec<u64>,
    residual: Option<f64>,
    failure: Option<String>,
}

/// Runs everyone once to warm up and then `repeats` times, one after the other within a repeat.
///
/// Who fails, or finds what is no solution, is out of the race; the others go on.
pub(crate) fn race(field: &mut [&mut dyn Contender], set: &Matrices, repeats: usize) -> Vec<Row> {
    let mut lanes: Vec<Lane> = field.iter().map(|_| Lane::default()).collect();
    let mut pass = Pass::default();
    for repeat in 0..=repeats {
        for (contender, lane) in
            field.iter_mut().zip(&mut lanes).filter(|(_, lane)| lane.failure.is_none())
        {
            pass.clear();
            let done = contender.pass(set, &mut pass).and_then(|()| accepted(set, &pass));
            lane.note(repeat == 0, done, &pass);
        }
    }
    field.iter().zip(lanes).map(|(contender, lane)| lane.row(&**contender)).collect()
}

fn accepted(set: &Matrices, pass: &Pass) -> Result<Option<f64>, String> {
    if pass.x.is_empty() {
        return Ok(None);
    }
    let r = set.residual(&pass.x);
    if r < WORST_RESIDUAL { Ok(Some(r)) } else { Err(format!("backward error {r:.1e}")) }
}

impl Lane {
    fn note(&mut self, warm_up: bool, done: Result<Option<f64>, String>, pass: &Pass) {
        match done {
            Err(why) => self.failure = Some(why),
            Ok(residual) => self.residual = residual,
        }
        if !warm_up {
            self.factor_ns.extend_from_slice(&pass.factor_ns);
            self.solve_ns.extend_from_slice(&pass.solve_ns);
            self.total_ns.extend(pass.totals());
        }
    }

    fn row(self, contender: &dyn Contender) -> Row {
        let part = |ns: &[u64]| (!ns.is_empty()).then(|| quantile_us(ns, 0.5));
        let figures = Figures {
            factor_us: part(&self.factor_ns),
            solve_us: part(&self.solve_ns),
            total_us: quantile_us(&self.total_ns, 0.5),
            p95_us: quantile_us(&self.total_ns, 0.95),
            entries: contender.entries(),
            residual: self.residual,
        };
        let figures = self.failure.map_or(Ok(figures), Err);
        Row { name: contender.name(), figures, wanted: contender.wanted() }
    }
}

fn quantile_us(ns: &[u64], q: f64) -> f64 {
    let mut sorted = ns.to_vec();
    sorted.sort_unstable();
    let at = (sorted.len().saturating_sub(1) as f64 * q).round() as usize;
    sorted.get(at).map_or(f64::NAN, |v| *v as f64 / 1000.0)
}

#[cfg(test)]
mod tests {
    use super::{Contender, Pass, quantile_us, race};
    use crate::matrices::Matrices;

    /// Answers `x` after `ns` nanoseconds of its own clock.
    struct Says(f64, u64);

    impl Contender for Says {
        fn name(&self) -> &'static str {
            "says"
        }

        fn pass(&mut self, set: &Matrices, pass: &mut Pass) -> Result<(), String> {
            pass.resize(set.count(), set.n);
            pass.x.fill(self.0);
            pass.factor_ns.fill(self.1);
            pass.solve_ns.fill(1000);
            Ok(())
        }
    }

    #[test]
    fn who_does_not_solve_is_out_and_the_others_go_on() {
        let set = Matrices {
            name: "one",
            n: 1,
            starts: vec![0, 1],
            rows: vec![0],
            values: vec![2.0],
            rhs: vec![4.0],
        };
        let rows =
            race(&mut [&mut Says(3.0, 1), &mut Says(2.0, 5000), &mut Says(f64::NAN, 1)], &set, 3);
        assert!(rows[0].figures.is_err() && rows[2].figures.is_err(), "{rows:?}");
        let good = rows[1].figures.as_ref().expect("2 x 2 = 4");
        assert_eq!((good.factor_us, good.total_us, good.residual), (Some(5.0), 6.0, Some(0.0)));
    }

    #[test]
    fn quantiles() {
        assert_eq!(quantile_us(&[3000, 1000, 2000], 0.5), 2.0);
        assert_eq!(quantile_us(&[3000, 1000, 2000], 1.0), 3.0);
        assert!(quantile_us(&[], 0.5).is_nan(), "nothing has no median");
    }
}
