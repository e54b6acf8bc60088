//! A book in the middle of a recorded gesture.

use dogleaf_content::Book;
use dogleaf_core::hand::Sample;
use dogleaf_core::scene::Handling;
use dogleaf_desktop::{BookView, Options, gesture};
use std::path::{Path, PathBuf};

/// Time between two frames, microseconds.
pub(crate) const FRAME_US: u64 = 16_667;

/// A file of the fixtures.
pub(crate) fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures").join(name)
}

/// The small book.
pub(crate) fn book() -> Book {
    Book::open(&fixture("books/old-verses.pdf")).expect("the fixture book is sound")
}

/// How the recorded gestures were made.
pub(crate) fn options() -> Options {
    Options { handling: Handling::SPRING, ..Options::default() }
}

/// A recorded gesture.
pub(crate) fn samples(name: &str) -> Vec<Sample> {
    gesture::load(&fixture("gestures").join(name)).expect("the gesture is sound")
}

/// Plays a gesture until a moment, microseconds.
pub(crate) fn play(view: &mut BookView, samples: &[Sample], until_us: u64) {
    let mut left = samples.iter().peekable();
    for now_us in (0..=until_us / FRAME_US).map(|n| n * FRAME_US) {
        while let Some(sample) = left.next_if(|s| s.t_us <= now_us) {
            view.pointer(*sample);
        }
        view.step(now_us);
    }
}
