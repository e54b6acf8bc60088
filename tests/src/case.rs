//! A hard case: a scene, what is done to it, and what must come of it. Cases run side by side and answer
//! with one row of a table each.

use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::Sample;
use dogleaf_core::real::Real;
use dogleaf_core::step::StepStatus;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use crate::gesture::{FRAME_US, Scene, play};
use crate::watch::Watch;

/// How a case must end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// What is taken up comes to lie on the other side, once.
    Turned,
    /// It comes back, once.
    Back,
    /// One or the other, once.
    Either,
    /// Nothing is taken up.
    Nothing,
    /// As often as leaves are taken up, they come to lie somewhere.
    Balanced,
    /// It may stay in the air, asleep: nothing draws it down.
    Hangs,
    /// A leaf may be taken up or not.
    Unlikely,
}

/// One hard case.
#[derive(Debug, Clone)]
pub struct Case {
    /// Its name in the table.
    pub name: String,
    /// The book.
    pub scene: Scene,
    /// What fingers do.
    pub samples: Vec<Sample>,
    /// What must come of it.
    pub ends: Ends,
    /// Seconds it may take to rest after the last sample.
    pub rest_s: f64,
    /// The blocks fold over themselves: how deep a leaf is in them has no answer.
    pub folded: bool,
}

/// Seconds a leaf may take to rest.
pub const REST_S: f64 = 4.0;
/// Pictures a case is watched beyond the time it is given.
const BEYOND: u32 = 60;

impl Case {
    /// A case that ends as said, in four seconds.
    pub fn new(name: impl Into<String>, scene: &Scene, samples: Vec<Sample>, ends: Ends) -> Self {
        Self { name: name.into(), scene: *scene, samples, ends, rest_s: REST_S, folded: false }
    }
    /// With more time to come to rest.
    #[must_use]
    pub fn within(mut self, rest_s: f64) -> Self {
        self.rest_s = rest_s;
        self
    }

    /// Plays the case and judges it.
    pub fn run<R: Real>(&self) -> Row {
        let name = self.name.clone();
        let mut seen = Watch { folded: self.folded, ..Watch::default() };
        let mut faults = Vec::new();
        let last_us = self.samples.last().map_or(0, |s| s.t_us);
        let drag = u32::try_from(last_us / u64::from(FRAME_US)).unwrap_or(u32::MAX / 2) + 1;
        let given = (self.rest_s * 60.0) as u32;
        match self.scene.open::<R, G11x8>() {
            Ok(mut book) => {
                let frames = drag + given + BEYOND;
                play(&mut book, &self.samples, frames, &mut |b, r| seen.see(b, r));
                faults = self.faults(&seen, drag + given);
            }
            Err(error) => faults.push(error.to_string()),
        }
        let rest_s = seen.rest.map(|n| f64::from(n.saturating_sub(drag)) / 60.0);
        Row { name, real: R::NAME, seen, rest_s, faults }
    }

    fn faults(&self, seen: &Watch, limit: u32) -> Vec<String> {
        let mut all: Vec<_> = seen.complaint.iter().cloned().collect();
        let [lifted, committed, cancelled] = seen.turns();
        let once = |turned: usize, back: usize| [lifted, committed, cancelled] == [1, turned, back];
        let right = match self.ends {
            Ends::Turned => once(1, 0),
            Ends::Back => once(0, 1),
            Ends::Either => once(1, 0) || once(0, 1),
            Ends::Nothing => [lifted, committed, cancelled] == [0; 3],
            Ends::Balanced => lifted == committed + cancelled && lifted > 0,
            Ends::Hangs => lifted == 1 && committed + cancelled <= 1,
            Ends::Unlikely => committed + cancelled <= lifted && lifted <= 1,
        };
        if !right {
            let [l, c, b] = [lifted, committed, cancelled];
            all.push(format!(
                "{:?} was due, but {l} lifted, {c} committed, {b} cancelled",
                self.ends
            ));
        }
        match seen.rest {
            None => all.push("never at rest".into()),
            Some(n) if n > limit => all.push(format!("not at rest after {} s", self.rest_s)),
            Some(_) => {}
        }
        all
    }
}

/// What came of a case.
#[derive(Debug, Clone)]
pub struct Row {
    name: String,
    real: &'static str,
    seen: Watch,
    rest_s: Option<f64>,
    /// What is wrong; nothing where the case is passed.
    pub faults: Vec<String>,
}

impl Row {
    /// Headings over [`Row`]'s columns.
    pub const HEAD: &'static str = "case                                     real  end              rest s  mean max   worst   gap  sunk  worst status   kept  cuts clamp refus forced";

    fn end(&self) -> String {
        let page = |p: u32| format!("page {p}");
        match self.seen.turns() {
            [0, 0, 0] => "nothing".into(),
            [1, 1, 0] => self.seen.page().map_or_else(String::new, page),
            [1, 0, 1] => "back".into(),
            [1, 0, 0] => "in the air".into(),
            [l, c, b] => format!("{l} = {c} + {b}"),
        }
    }
    fn worst_status(&self) -> StepStatus {
        self.seen.work.status
    }
}

impl core::fmt::Display for Row {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let (s, w) = (&self.seen, &self.seen.work);
        let rest = self.rest_s.map_or_else(|| "-".into(), |s| format!("{s:.2}"));
        let [mean, worst] = [s.air.mean_max(), s.air.worst].map(|v| 100.0 * v);
        let [gap, sunk] = [s.gap, s.sunk].map(|v| 100.0 * v);
        write!(f, "{:40} {:4}  {:15} {rest:>7}", self.name, self.real, self.end())?;
        write!(
            f,
            "  {mean:6.2} % {worst:5.1} % {gap:5.1} {sunk:5.2}  {:12}",
            self.worst_status().name()
        )?;
        write!(f, " {:4} {:5} {:5} {:5}", s.kept(), w.cuts, w.clamped, w.refused)?;
        write!(f, " {:6}", w.forced_rests)?;
        self.faults.iter().try_for_each(|what| write!(f, "  <- {what}"))
    }
}

/// Runs cases in both scalars on all processors; rows come in the order of the cases.
pub fn run_all(cases: &[Case]) -> Vec<Row> {
    let next = AtomicUsize::new(0);
    let rows = Mutex::new(Vec::with_capacity(2 * cases.len()));
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some((n, case)) = take(cases, &next) {
                    let two = [case.run::<f32>(), case.run::<f64>()];
                    let mut rows = rows.lock().unwrap_or_else(PoisonError::into_inner);
                    rows.extend(two.into_iter().map(|row| (n, row)));
                }
            });
        }
    });
    let mut rows = rows.into_inner().unwrap_or_else(PoisonError::into_inner);
    rows.sort_by_key(|(n, row)| (*n, row.real));
    rows.into_iter().map(|(_, row)| row).collect()
}

fn take<'a>(cases: &'a [Case], next: &AtomicUsize) -> Option<(usize, &'a Case)> {
    let n = next.fetch_add(1, Ordering::Relaxed);
    cases.get(n).map(|case| (n, case))
}

/// Runs cases, prints their table, and answers the rows that failed.
pub fn judge(cases: &[Case]) -> Vec<Row> {
    let rows = run_all(cases);
    println!("{}", Row::HEAD);
    rows.iter().for_each(|row| println!("{row}"));
    let failed: Vec<_> = rows.into_iter().filter(|row| !row.faults.is_empty()).collect();
    println!("{} cases, {} failed", 2 * cases.len(), failed.len());
    failed
}
