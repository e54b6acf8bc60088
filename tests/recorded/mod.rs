//! For the recording tests: a hand that turns a leaf, and a book it is recorded beside.
#![allow(dead_code, reason = "each test uses its share")]

use dogleaf_core::Book;
use dogleaf_core::grid::Grid;
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::real::{Real, V3};
use dogleaf_core::record::{RecordError, Recorder, Setup, Sink};
use dogleaf_core::scene::{BookSpec, Units};

/// Bytes of the checksum, and of the end with it.
pub(crate) const CRC: usize = 4;
pub(crate) const END: usize = 1 + 3 * 4 + CRC;

/// A sink as a shell has it.
#[derive(Debug, Default)]
pub(crate) struct Bytes(pub(crate) Vec<u8>);

impl Sink for Bytes {
    fn put(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        self.0.extend_from_slice(bytes);
        Ok(())
    }
}

/// The default book at a table.
pub(crate) fn setup() -> Setup {
    Setup::reading(BookSpec::default(), 960, 720)
}

/// A drag of the outer corner over the spine in `drag_us`, a sample every 8333 µs, let go at the end.
pub(crate) fn turn(setup: &Setup, drag_us: u64) -> Vec<Sample> {
    let book = &setup.book;
    let units = Units::of_leaf(book.width_m, book.height_m, setup.paper.areal_mass_gsm);
    let camera = setup.view.camera::<f64>(&units);
    let z = 0.4 * units.length(book.height_m);
    let see = |x: f64| camera.project(V3([x, 1.5, z])).expect("in front of the eye");
    let (from, to) = (see(11.0), see(-11.0));
    let count = drag_us / 8333;
    let sample = |n: u64| {
        let t = n as f64 / count as f64;
        let lift = 40.0 * 4.0 * t * (1.0 - t);
        let place = [from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t - lift];
        let phase = match n {
            0 => Phase::Down,
            n if n == count => Phase::Up,
            _ => Phase::Move,
        };
        let [x, y] = place.map(|p| (p * 256.0) as i32);
        Sample { t_us: 20_000 + 8333 * n, id: 0, phase, x, y, leaves: 1 }
    };
    (0..=count).map(sample).collect()
}

/// An opened book, on the heap: it is too big for a stack.
pub(crate) fn open<R: Real, G: Grid>(setup: &Setup) -> Box<Book<R, G>> {
    let mut book = Box::new(Book::<R, G>::EMPTY);
    setup.open(&mut book).expect("the setup is sound");
    book
}

/// Takes a book through a gesture for so many steps, each sample handed over just before it is due.
pub(crate) fn play<R: Real, G: Grid>(
    setup: &Setup,
    samples: &[Sample],
    steps: u32,
    recorder: &mut Recorder<Bytes>,
) -> Box<Book<R, G>> {
    let mut book = open::<R, G>(setup);
    let mut next = samples.iter().copied().peekable();
    for _ in 0..steps {
        let until = book.now_us() + u64::from(setup.world.step_us);
        while let Some(sample) = next.next_if(|s| s.t_us <= until) {
            let _ = book.input(sample);
            recorder.input(&sample).expect("there is room");
        }
        let _ = book.step();
        recorder.step(book.state_hash()).expect("there is room");
    }
    book
}

/// The recording of a gesture.
pub(crate) fn record<R: Real, G: Grid>(setup: &Setup, samples: &[Sample], steps: u32) -> Vec<u8> {
    let mut recorder = recorder::<R, G>(setup);
    let _ = play::<R, G>(setup, samples, steps, &mut recorder);
    recorder.finish().expect("there is room").0
}

/// A recorder into memory.
pub(crate) fn recorder<R: Real, G: Grid>(setup: &Setup) -> Recorder<Bytes> {
    Recorder::start::<R, G>(Bytes::default(), setup).expect("the setup is sound")
}

/// CRC-32 by its definition, bit by bit: an oracle for the one in the core.
pub(crate) fn crc32(bytes: &[u8]) -> u32 {
    let mut crc = u32::MAX;
    for &byte in bytes {
        crc ^= u32::from(byte);
        for _ in 0..8 {
            crc = (crc >> 1) ^ (0xedb8_8320 & (crc & 1).wrapping_neg());
        }
    }
    !crc
}

/// The bytes before the checksum of a recording, after a change, with a checksum that fits.
pub(crate) fn seal(mut body: Vec<u8>) -> Vec<u8> {
    let crc = crc32(&body);
    body.extend(crc.to_le_bytes());
    body
}

/// Whether every number of a book is one.
pub(crate) fn finite<R: Real, G: Grid>(book: &Book<R, G>) -> bool {
    let leaf = book.leaf().is_none_or(|l| l.x.finite() && l.v.finite());
    let nodes = book.blocks().iter().flat_map(|b| b.x.iter().chain(&b.v));
    leaf && nodes.flat_map(|v| v.0).all(|c| c.finite())
}
