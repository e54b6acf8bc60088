//! What the tests share: a book on a table, gestures of the fixtures, frames of sixty a second.
#![allow(dead_code, reason = "each test uses its part")]

use dogleaf_ffi::{Book, BookOptions, Notice, Phase, PointerSample, book_options};
use std::path::Path;
use std::sync::Arc;

/// Microseconds of a frame.
pub(crate) const FRAME_US: u64 = 16_667;

/// A paperback of 320 pages, open at 120, in a view of 960 by 720.
pub(crate) fn options() -> BookOptions {
    BookOptions { open_at: 120, ..book_options(320, 960, 720) }
}

/// It, opened.
pub(crate) fn book() -> Arc<Book> {
    Book::open(&options()).expect("a sound book")
}

/// A gesture of the fixtures, in pixels.
pub(crate) fn gesture(name: &str) -> Vec<PointerSample> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/gestures");
    let text = std::fs::read_to_string(root.join(format!("{name}.jsonl"))).expect("a fixture");
    text.lines().filter(|l| !l.trim().is_empty()).map(sample).collect()
}

fn sample(line: &str) -> PointerSample {
    let number = |key: &str| -> i64 {
        let Some((_, rest)) = line.split_once(&format!("\"{key}\":")) else { return 0 };
        let end = rest.find([',', '}']).unwrap_or(rest.len());
        rest[..end].trim().parse().expect("a whole number")
    };
    let phase = [
        ("down", Phase::Down),
        ("move", Phase::Move),
        ("up", Phase::Up),
        ("cancel", Phase::Cancel),
    ];
    let phase = phase.iter().find(|(n, _)| line.contains(&format!("\"phase\":\"{n}\"")));
    PointerSample {
        time_us: number("t_us") as u64,
        id: number("id") as u8,
        phase: phase.expect("a phase").1,
        x: number("x") as f32 / 256.0,
        y: number("y") as f32 / 256.0,
        leaves: number("leaves") as u16,
    }
}

/// Plays a gesture frame by frame until everything is at rest; answers the frames and what was told.
pub(crate) fn play(book: &Book, samples: &[PointerSample]) -> (u32, Vec<Notice>) {
    let mut told = Vec::new();
    let mut next = 0;
    for frame in 1..=3_000 {
        let now = u64::from(frame) * FRAME_US;
        let due = samples[next..].iter().take_while(|s| s.time_us <= now).count();
        if due > 0 {
            book.pointers(samples[next..next + due].to_vec()).expect("samples in order");
            next += due;
        }
        let info = book.step(now).expect("an open book");
        if info.notices > 0 {
            told.extend(book.notices().expect("an open book"));
        }
        if next == samples.len() && !info.needs_frame {
            return (frame, told);
        }
    }
    panic!("it never comes to rest");
}
