//! The figures of a soak.

use super::case::{Outcome, REST_S, STRETCHED};
use super::draw::World;
use dogleaf_core::real::Real;
use dogleaf_core::step::{StepReport, StepStatus};
use std::fmt::{self, Write as _};

/// Every status, in the order of its number.
const STATUSES: [StepStatus; 6] = [
    StepStatus::Asleep,
    StepStatus::Converged,
    StepStatus::Reduced,
    StepStatus::Stalled,
    StepStatus::Held,
    StepStatus::Recovered,
];
/// Share of the gestures that must stay under the stretch.
pub const SHARE: f64 = 0.99;

/// A case that failed, and why.
#[derive(Debug, Clone)]
pub struct Failure {
    /// Its number.
    pub case: u64,
    /// What was wrong.
    pub faults: Vec<String>,
}

/// Gestures of one kind of world.
#[derive(Debug, Clone, Copy, Default)]
pub struct Kind {
    /// Cases.
    pub cases: u64,
    /// Gestures.
    pub gestures: u64,
    /// Gestures that stayed under fifteen per cent.
    pub under: u64,
    /// Leaves that stayed out of shape.
    pub collapses: u64,
    /// Largest stretch of all, and whose it was.
    pub worst: (f64, u64),
    /// Longest from the last sample to rest, seconds, and whose.
    pub slowest: (f64, u64),
}

impl Kind {
    fn take(&mut self, number: u64, outcome: &Outcome) {
        self.cases += 1;
        self.collapses += u64::from(outcome.collapsed);
        self.gestures += outcome.stretches.len() as u64;
        self.under += outcome.stretches.iter().filter(|s| **s < STRETCHED).count() as u64;
        let most = outcome.stretches.iter().fold(0.0, |m: f64, s| m.max(*s));
        if most > self.worst.0 {
            self.worst = (most, number);
        }
        if outcome.rest_s > self.slowest.0 {
            self.slowest = (outcome.rest_s, number);
        }
    }
    /// Share of the gestures that stayed under fifteen per cent.
    pub fn share(&self) -> f64 {
        self.under as f64 / self.gestures.max(1) as f64
    }
}

/// What a soak has found.
#[derive(Debug, Clone)]
pub struct Sum {
    /// The seed.
    pub seed: u64,
    /// Its numbers.
    pub real: &'static str,
    /// World steps.
    pub steps: u64,
    /// In the order of [`World::ALL`].
    pub kinds: [Kind; 3],
    /// Steps with a number that is none.
    pub nans: u64,
    /// Steps by status.
    pub statuses: [u64; 6],
    /// Newton steps, cuts, clamps and the rest.
    pub work: [u64; 8],
    /// Cases that failed.
    pub failures: Vec<Failure>,
}

/// Names of [`Sum::work`].
const WORK: [&str; 8] =
    ["newton", "cuts", "regularised", "passes", "clamped", "forced rests", "nudged", "refused"];

fn work(r: &StepReport) -> [u64; 8] {
    let all = [
        r.newton_steps,
        r.cuts,
        r.regularised,
        r.passes,
        r.clamped,
        r.forced_rests,
        r.nudged,
        r.refused,
    ];
    all.map(u64::from)
}

impl Sum {
    /// Nothing yet.
    pub fn of<R: Real>(seed: u64) -> Self {
        Self {
            seed,
            real: R::NAME,
            steps: 0,
            kinds: [Kind::default(); 3],
            nans: 0,
            statuses: [0; 6],
            work: [0; 8],
            failures: Vec::new(),
        }
    }

    /// Adds a case.
    pub fn take(&mut self, number: u64, outcome: Outcome) {
        self.steps += outcome.steps;
        self.kinds[outcome.world as usize].take(number, &outcome);
        self.nans += outcome.nans;
        for (sum, n) in self.statuses.iter_mut().zip(outcome.statuses) {
            *sum += n;
        }
        for (sum, n) in self.work.iter_mut().zip(work(&outcome.work)) {
            *sum += n;
        }
        if !outcome.faults.is_empty() {
            self.failures.push(Failure { case: number, faults: outcome.faults });
        }
    }

    /// What was promised and is not so.
    pub fn complaints(&self) -> Vec<String> {
        let mut all = Vec::new();
        let share = self.kinds[0].share();
        if share < SHARE {
            let found = 100.0 * share;
            all.push(format!("{found:.2} % of the readers' gestures under 15 % stretch, not 99 %"));
        }
        if !self.failures.is_empty() {
            all.push(format!("{} cases failed", self.failures.len()));
        }
        all
    }

    /// The same as JSON.
    pub fn json(&self) -> String {
        let named = |names: Vec<&str>, numbers: &[u64]| {
            let pairs = names.iter().zip(numbers).map(|(n, v)| format!("\"{n}\":{v}"));
            format!("{{{}}}", pairs.collect::<Vec<_>>().join(","))
        };
        let kind = |k: &Kind| {
            let slowest = if k.slowest.0.is_finite() { k.slowest.0 } else { -1.0 };
            format!(
                "{{\"cases\":{},\"collapses\":{},\"gestures\":{},\"under_15_percent\":{},\"worst_stretch\":{:.6},\
                 \"worst_case\":{},\"slowest_rest_s\":{:.3},\"slowest_case\":{}}}",
                k.cases,
                k.collapses,
                k.gestures,
                k.under,
                k.worst.0,
                k.worst.1,
                slowest,
                k.slowest.1
            )
        };
        let failed = self.failures.iter().map(|f| f.case.to_string()).collect::<Vec<_>>();
        format!(
            "{{\"seed\":{},\"real\":\"{}\",\"steps\":{},\"nans\":{},\"readers\":{},\"seeds\":{},\
             \"wild\":{},\"statuses\":{},\"work\":{},\"failed_cases\":[{}]}}",
            self.seed,
            self.real,
            self.steps,
            self.nans,
            kind(&self.kinds[0]),
            kind(&self.kinds[1]),
            kind(&self.kinds[2]),
            named(STATUSES.map(StepStatus::name).to_vec(), &self.statuses),
            named(WORK.to_vec(), &self.work),
            failed.join(",")
        )
    }
}

impl fmt::Display for Sum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "soak: seed {}, {}, {} world steps", self.seed, self.real, self.steps)?;
        writeln!(f, "  not a number         {:>10} steps", self.nans)?;
        for ((name, _), k) in World::ALL.iter().zip(&self.kinds) {
            writeln!(f, "  {name}: {} cases, {} gestures", k.cases, k.gestures)?;
            writeln!(f, "    collapsed for good {:>10} cases", k.collapses)?;
            writeln!(f, "    under 15 % stretch {:>10.3} %", 100.0 * k.share())?;
            writeln!(
                f,
                "    worst stretch      {:>10.2} %  case {}",
                100.0 * k.worst.0,
                k.worst.1
            )?;
            writeln!(f, "    slowest to rest    {:>10.2} s  case {}", k.slowest.0, k.slowest.1)?;
        }
        writeln!(f, "  (books that are not wild must be at rest within {REST_S} s)")?;
        let mut line = String::new();
        for (status, n) in STATUSES.iter().zip(self.statuses) {
            write!(line, "  {} {n}", status.name())?;
        }
        writeln!(f, "  statuses:{line}")?;
        line.clear();
        for (name, n) in WORK.iter().zip(self.work) {
            write!(line, "  {name} {n}")?;
        }
        write!(f, "  work:{line}")?;
        for failure in &self.failures {
            write!(f, "\n  FAILED case {}: {}", failure.case, failure.faults.join("; "))?;
        }
        Ok(())
    }
}
