//! The soak: books, papers, worlds and hands at random, by the million steps.
//!
//! A case is one book and a handful of gestures, all of it decided by the seed and the case's number. Cases
//! are taken in order of their numbers until enough steps were taken, so the figures depend on the seed and the
//! number of steps alone, not on how many threads shared the work.

pub mod case;
pub mod draw;
pub mod hands;
pub mod kept;
pub mod sum;

pub use case::{Case, Outcome};
pub use sum::Sum;

use dogleaf_core::real::Real;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};

/// What a soak is asked.
#[derive(Debug, Clone, Copy)]
pub struct Ask {
    /// World steps at least.
    pub steps: u64,
    /// Seed of everything.
    pub seed: u64,
    /// Threads that share the work; nothing else depends on it.
    pub threads: usize,
}

/// What workers hand over: outcomes by the number of their case.
#[derive(Default)]
struct Desk {
    done: Mutex<BTreeMap<u64, Outcome>>,
    news: Condvar,
    next: AtomicU64,
    enough: AtomicBool,
}

impl Desk {
    fn work<R: Real>(&self, seed: u64) {
        while !self.enough.load(Ordering::Relaxed) {
            let number = self.next.fetch_add(1, Ordering::Relaxed);
            let outcome = Case::new(seed, number).run_safely::<R>();
            let mut done = self.done.lock().unwrap_or_else(PoisonError::into_inner);
            done.insert(number, outcome);
            self.news.notify_one();
        }
    }
    /// The outcome of a case, as soon as there is one.
    fn take(&self, number: u64) -> Outcome {
        let mut done = self.done.lock().unwrap_or_else(PoisonError::into_inner);
        loop {
            if let Some(outcome) = done.remove(&number) {
                return outcome;
            }
            done = self.news.wait(done).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

/// Soaks; `watch` sees the sum after every case.
pub fn soak<R: Real>(ask: &Ask, mut watch: impl FnMut(&Sum)) -> Sum {
    let desk = Desk::default();
    let mut sum = Sum::of::<R>(ask.seed);
    std::thread::scope(|scope| {
        for _ in 0..ask.threads.max(1) {
            scope.spawn(|| desk.work::<R>(ask.seed));
        }
        for number in 0.. {
            sum.take(number, desk.take(number));
            watch(&sum);
            if sum.steps >= ask.steps {
                break;
            }
        }
        desk.enough.store(true, Ordering::Relaxed);
    });
    sum
}
