//! The parser of recordings, and what a recording is replayed on.
//!
//! Any bytes; half of them with the magic in front and a checksum that fits, so that what lies behind is
//! reached.
#![no_main]

use dogleaf_core::Book;
use dogleaf_core::grid::{G6x5, G11x8, Grid};
use dogleaf_core::real::Real;
use dogleaf_core::record::{MAGIC, Reader, Record, replay_with};
use dogleaf_fuzz::{fresh, refused, sound};
use dogleaf_tests::crc::crc32;
use libfuzzer_sys::fuzz_target;
use std::ops::ControlFlow;
use std::sync::OnceLock;

static COARSE: OnceLock<Box<Book<f32, G6x5>>> = OnceLock::new();
static USUAL: OnceLock<Box<Book<f32, G11x8>>> = OnceLock::new();

/// World steps replayed at most.
const STEPS: u32 = 24;

fuzz_target!(|data: &[u8]| {
    let Some((&kind, rest)) = data.split_first() else { return };
    let sealed = kind % 2 == 1;
    let mut bytes = Vec::new();
    if sealed {
        bytes.extend(MAGIC);
    }
    bytes.extend(rest);
    if sealed {
        let crc = crc32(&bytes);
        bytes.extend(crc.to_le_bytes());
    }
    if let Ok(reader) = Reader::open(&bytes) {
        holds_what_it_says(&reader);
        replays(&reader, &mut fresh(&COARSE));
        replays(&reader, &mut fresh(&USUAL));
    }
});

fn holds_what_it_says(reader: &Reader<'_>) {
    let (mut steps, mut inputs) = (0u32, 0u32);
    for record in reader.records() {
        match record.expect("a recording that was believed has no fault") {
            Record::Step { .. } => steps += 1,
            Record::Input(_) => inputs += 1,
            Record::Look(view) => assert_eq!(view.check(), Ok(()), "a view was believed"),
        }
    }
    assert_eq!((steps, inputs), (reader.steps(), reader.inputs()), "the counts were believed");
}

fn replays<R: Real, G: Grid>(reader: &Reader<'_>, book: &mut Book<R, G>) {
    let mut left = STEPS;
    let _ = refused(book, |book| {
        replay_with(reader, book, |seen| {
            sound(seen.book);
            left = left.saturating_sub(1);
            if left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })
    });
}
