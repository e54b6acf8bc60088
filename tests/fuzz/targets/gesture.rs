//! The state machine of the hand: samples, pauses and views in any order, on the default book.
#![no_main]

use arbitrary::{Result, Unstructured};
use dogleaf_core::Book;
use dogleaf_core::event::Event;
use dogleaf_core::grid::G6x5;
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_fuzz::{draw, fresh, refused, sound};
use libfuzzer_sys::fuzz_target;
use std::sync::OnceLock;

type Pages = Book<f32, G6x5>;

static MODEL: OnceLock<Box<Pages>> = OnceLock::new();

/// Calls at most.
const CALLS: u32 = 64;
/// Waited for at the end: a sample may be a minute ahead.
const SOON_US: u64 = 500_000;

fuzz_target!(|data: &[u8]| {
    let mut book = fresh(&MODEL);
    let mut tally = Tally::default();
    // Whatever bytes there were: the rest is done with what is left.
    let _ = storm(&mut Unstructured::new(data), &mut book, &mut tally);
    let_go(&mut book, &mut tally);
});

/// Leaves taken up and leaves laid down, and the time that was spoken of.
#[derive(Default)]
struct Tally {
    lifted: u32,
    ended: u32,
    /// Time of the last sample that was taken.
    latest_us: u64,
}

fn storm(u: &mut Unstructured<'_>, book: &mut Pages, tally: &mut Tally) -> Result<()> {
    for _ in 0..CALLS {
        if u.is_empty() {
            break;
        }
        match u.int_in_range(0..=9)? {
            0..=5 => {
                let sample = draw::sample(u, book.now_us())?;
                if refused(book, |b| b.input(sample)).is_ok() {
                    tally.latest_us = sample.t_us;
                }
            }
            6 | 7 => advance(book, 16_667, tally),
            8 => advance(book, u.arbitrary::<u32>()? >> (u.arbitrary::<u8>()? % 18), tally),
            _ => {
                let view = draw::view(u)?;
                let hash = book.state_hash();
                let _ = refused(book, |b| b.look(&view));
                assert_eq!(book.state_hash(), hash, "looking never changes the physics");
            }
        }
    }
    Ok(())
}

fn advance(book: &mut Pages, dt_us: u32, tally: &mut Tally) {
    let report = book.advance(dt_us);
    // A step that is taken again is taken in four parts.
    assert!(report.steps <= 8 && report.newton_steps <= 5 * 8, "bounded: {report:?}");
    sound(book);
    assert!(book.needs_frame() || book.held().is_none(), "asleep in a hand");
    while let Some(event) = book.take_event() {
        match event {
            Event::Lifted { .. } => tally.lifted += 1,
            Event::Committed { .. } | Event::Cancelled => tally.ended += 1,
            Event::Held { .. } | Event::Asleep => {}
        }
        let in_air = u32::from(book.leaf().is_some());
        assert!(tally.ended <= tally.lifted && in_air <= 1, "a leaf came from nowhere");
    }
    assert_eq!(
        tally.lifted,
        tally.ended + u32::from(book.leaf().is_some()),
        "each leaf taken up is in the air or has come to lie once"
    );
}

/// After all pointers were taken away nobody holds anything: the machine is never stuck.
fn let_go(book: &mut Pages, tally: &mut Tally) {
    let t_us = tally.latest_us.max(book.now_us());
    if t_us > book.now_us() + SOON_US {
        return;
    }
    while book.now_us() < t_us {
        advance(book, 16_667, tally);
    }
    for id in [0, 1, 255] {
        let cancel =
            Sample { t_us: book.now_us(), id, phase: Phase::Cancel, x: 0, y: 0, leaves: 0 };
        assert_eq!(book.input(cancel), Ok(()), "there is room, and now is never too late");
    }
    // A hand that follows through lets go within a second.
    for _ in 0..8 {
        advance(book, 8 * 16_667, tally);
    }
    assert!(book.held().is_none(), "somebody holds on");
}
