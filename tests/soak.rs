//! Promise: what the soak counts is what happened. A short soak has figures pinned to the digit; its cases are the same
//! whoever shares the work; in readers' worlds no number is lost, nothing panics and no leaf is; and what once
//! failed is kept and played again.

use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;
use dogleaf_core::record::{Reader, Tier};
use dogleaf_tests::soak::case::{Nobody, Scribe};
use dogleaf_tests::soak::draw::World;
use dogleaf_tests::soak::{Ask, Case, Outcome, Sum, kept, soak};
use std::path::Path;

fn short(steps: u64, threads: usize) -> Sum {
    soak::<f32>(&Ask { steps, seed: 1, threads }, |_| ())
}

/// Nothing may go wrong in any world that must not go wrong in any.
fn sound(sum: &Sum) {
    assert_eq!(sum.nans, 0, "{sum}");
    for failure in &sum.failures {
        let grave = |what: &&String| {
            ["panicked", "not finite", "more work", "leaves of"].iter().any(|w| what.contains(w))
        };
        assert_eq!(failure.faults.iter().find(grave), None, "case {}", failure.case);
    }
    for (kind, (name, _)) in sum.kinds.iter().zip(World::ALL).take(2) {
        assert_eq!(kind.collapses, 0, "{name}: {sum}");
    }
}

#[cfg(not(debug_assertions))]
#[test]
fn two_hundred_thousand_steps() {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let sum = short(200_000, threads);
    sound(&sum);
    let table = format!("{sum}\n");
    if let Err(why) = dogleaf_tests::golden::compare("soak.txt", &table) {
        panic!("{why}");
    }
}

#[cfg(debug_assertions)]
#[test]
fn ten_thousand_steps() {
    sound(&short(10_000, 2));
}

#[test]
fn threads_change_nothing() {
    let [one, three] = [1, 3].map(|threads| short(2_500, threads));
    assert_eq!(one.json(), three.json(), "one thread, three threads");
    assert_eq!(one.to_string(), three.to_string(), "one thread, three threads");
}

/// Plays every kept recording: the book stays a book, whatever its hashes are by now.
#[test]
fn kept_cases() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/gestures/hard");
    let mut played = 0;
    for entry in std::fs::read_dir(&folder).into_iter().flatten() {
        let file = entry.expect("a folder can be read").path();
        if file.extension().is_none_or(|e| e != "dlr") {
            continue;
        }
        let bytes = std::fs::read(&file).expect("a kept case can be read");
        let reader = Reader::open(&bytes).expect("a kept case is a recording");
        let name = file.display();
        let finite = match reader.header().tier {
            Tier::F32 => numbers::<f32>(&reader),
            Tier::F64 => numbers::<f64>(&reader),
        };
        assert!(finite, "{name}");
        played += 1;
    }
    println!("{played} kept cases");
}

fn numbers<R: dogleaf_core::real::Real>(reader: &Reader<'_>) -> bool {
    let (book, seen) = kept::play::<R>(reader).expect("it opens as it was opened");
    println!("{:?} {:?}", seen.turns(), seen.complaint);
    let lost =
        seen.complaint.is_some_and(|what| what.contains("finite") || what.contains("leaves"));
    !lost && book.leaf().is_none_or(|leaf| leaf.x.finite())
}

/// A kept case is the case: the recording ends where the case ends.
#[test]
fn a_case_and_its_recording_agree() {
    struct Last(u64, u64);
    impl Scribe<f32> for Last {
        fn step(&mut self, book: &mut Book<f32, G11x8>) {
            (self.0, self.1) = (book.state_hash(), self.1 + 1);
        }
    }
    let case = Case::new(1, 3);
    let mut last = Last(0, 0);
    let _ = case.run::<f32>(&mut last);
    let bytes = kept::record::<f32>(&case).expect("a sound case");
    let reader = Reader::open(&bytes).expect("a sound recording");
    let (book, _) = kept::play::<f32>(&reader).expect("it opens");
    assert_eq!((book.state_hash(), u64::from(reader.steps())), (last.0, last.1), "the same end");
}

/// What the figures are worth: a leaf that is lost, a NaN and a stretched gesture are counted.
#[test]
fn the_check_can_fail() {
    let outcome = Case::new(1, 3).run::<f32>(&mut Nobody);
    let mut sum = Sum::of::<f32>(1);
    sum.take(0, outcome.clone());
    let before = sum.complaints();
    let bad = Outcome {
        nans: 2,
        collapsed: true,
        stretches: vec![0.2; 50],
        faults: vec!["collapsed for good".into()],
        world: World::Readers,
        ..outcome
    };
    sum.take(1, bad);
    assert_eq!((sum.nans, sum.kinds[0].collapses, sum.failures.len()), (2, 1, 1), "{sum}");
    assert!(sum.kinds[0].share() < 0.99 && sum.complaints().len() == before.len() + 2, "{sum}");
    assert!(sum.to_string().contains("FAILED case 1: collapsed for good"), "{sum}");
    assert!(std::panic::catch_unwind(|| sound(&sum)).is_err(), "the promise sees it");
}
