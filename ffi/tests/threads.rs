//! Promise: eight threads may call at once while one closes the book: each call works or says `Closed`.

mod common;

use common::{FRAME_US, book};
use dogleaf_ffi::{DogleafError, Phase, PointerSample};
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;
use std::time::Duration;

#[test]
fn eight_threads_and_one_that_closes() {
    let book = book();
    let done = AtomicU32::new(0);
    let closed = AtomicU32::new(0);
    let judge = |result: Result<(), DogleafError>| match result {
        Ok(()) => drop(done.fetch_add(1, Ordering::Relaxed)),
        Err(DogleafError::Closed) => drop(closed.fetch_add(1, Ordering::Relaxed)),
        // Two fingers on eight threads come in any order.
        Err(DogleafError::Pointer(_) | DogleafError::Busy | DogleafError::NoSuchPage) => {}
        Err(other) => panic!("{other}"),
    };
    thread::scope(|scope| {
        for own in 0..8_u8 {
            let (book, judge) = (&book, &judge);
            scope.spawn(move || {
                for n in 0..5_000_u64 {
                    let phase = [Phase::Down, Phase::Move, Phase::Up][n as usize % 3];
                    let (x, y) = ((n % 960) as f32, (n % 720) as f32);
                    let sample =
                        PointerSample { time_us: n * 100, id: own, phase, x, y, leaves: 0 };
                    match own % 4 {
                        0 => judge(book.pointer(&sample)),
                        1 => judge(book.step(n * FRAME_US / 8).map(drop)),
                        2 => judge(book.notices().map(drop)),
                        _ => judge(book.turn(n % 2 == 0, 1)),
                    }
                }
            });
        }
        thread::sleep(Duration::from_millis(300));
        book.shut();
    });
    assert!(done.load(Ordering::Relaxed) > 0, "some came before");
    assert_eq!(book.step(1).map(drop), Err(DogleafError::Closed));
}
