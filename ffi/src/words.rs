//! The frame loop without an object or a copy: words that both sides read, and two calls by JNI's naming rule.
//!
//! uniffi's Kotlin makes garbage with a native part at every call, which one thread of JNA's frees; sixty frames a second
//! are better off without. The words are atomics in memory of ours, so nothing here needs `unsafe` but the names.
//!
//! ```text
//! word  0       1 draw, 2 needs_frame          8..   what a step answers is above
//!       1 2     generation, pieces_generation  16..  64 samples of 4: time; id, phase, leaves (8, 8, 16 bits); x; y
//!       3       notices that follow            272.. 64 notices of 2: kind and first value (32, 32 bits); second value
//!       4 5 6   stretch, through, flying_through: the bits of an f32
//!       7       status
//!       8       electronic paper: x, y, width, height of the picture it is to show (16 bits each); nought if none
//!       9       its waveform, 256 full, 512 settled; microseconds it is busy (32, 32 bits)
//! ```

use crate::book::Book;
use crate::eink::PanelUpdate;
use crate::frame::FrameInfo;
use crate::notice::{Notice, Tick};
use crate::pointer::{Phase, PointerSample};
use std::collections::BTreeMap;
use std::ffi::c_void;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::{Arc, Mutex, PoisonError, Weak};

/// Where the samples begin, and how many fit.
const SAMPLES: (usize, usize) = (16, 64);
/// Where the notices begin, and how many fit.
pub(crate) const NOTICES: (usize, usize) = (272, 64);
/// All of them.
const WORDS: usize = 400;

/// Words that both sides read and write.
#[derive(Debug)]
pub(crate) struct Words(Box<[AtomicU64]>);

/// Where the words of a book lie. The memory stays for as long as the program runs; a freed book's goes to another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, uniffi::Record)]
pub struct FrameWords {
    /// First byte.
    pub address: u64,
    /// Bytes.
    pub byte_len: u64,
    /// What the calls are told the book by.
    pub ticket: u64,
}

/// The books that were asked for their words, and words nobody uses.
struct Shelf {
    books: BTreeMap<u64, Weak<Book>>,
    free: Vec<Arc<Words>>,
    next: u64,
}

static SHELF: Mutex<Shelf> =
    Mutex::new(Shelf { books: BTreeMap::new(), free: Vec::new(), next: 1 });

fn shelf<T>(work: impl FnOnce(&mut Shelf) -> T) -> T {
    work(&mut SHELF.lock().unwrap_or_else(PoisonError::into_inner))
}

impl Words {
    /// Words for a book, and its ticket.
    pub(crate) fn lend(book: &Arc<Book>) -> (Arc<Self>, u64) {
        shelf(|s| {
            let ticket = s.next;
            s.next += 1;
            s.books.insert(ticket, Arc::downgrade(book));
            let new = || Arc::new(Self((0..WORDS).map(|_| AtomicU64::new(0)).collect()));
            (s.free.pop().unwrap_or_else(new), ticket)
        })
    }

    /// The book is freed.
    pub(crate) fn give_back(words: Arc<Self>, ticket: u64) {
        shelf(|s| {
            s.books.remove(&ticket);
            s.free.push(words);
        });
    }

    pub(crate) fn view(&self, ticket: u64) -> FrameWords {
        let byte_len = size_of_val(&*self.0) as u64;
        FrameWords { address: self.0.as_ptr() as u64, byte_len, ticket }
    }

    fn word(&self, at: usize) -> u64 {
        self.0.get(at).map_or(0, |w| w.load(Relaxed))
    }

    fn set(&self, at: usize, value: u64) {
        if let Some(word) = self.0.get(at) {
            word.store(value, Relaxed);
        }
    }

    /// One of the samples the app has put down; nothing if its phase means nothing.
    pub(crate) fn sample(&self, n: usize) -> Option<PointerSample> {
        let (first, most) = SAMPLES;
        let at = first + 4 * n;
        let who = self.word(at + 1);
        let phase = [Phase::Down, Phase::Move, Phase::Up, Phase::Cancel];
        let phase = phase.get((who >> 8 & 0xff) as usize).copied().filter(|_| n < most)?;
        Some(PointerSample {
            time_us: self.word(at),
            id: who as u8,
            phase,
            x: f32::from_bits(self.word(at + 2) as u32),
            y: f32::from_bits(self.word(at + 3) as u32),
            leaves: (who >> 16) as u16,
        })
    }

    /// Puts down what a step answered.
    pub(crate) fn answer(&self, info: &FrameInfo, notices: &[Notice]) {
        self.set(0, u64::from(info.draw) | u64::from(info.needs_frame) << 1);
        self.set(1, info.generation);
        self.set(2, info.pieces_generation);
        self.set(3, notices.len() as u64);
        for (n, value) in [info.stretch, info.through, info.flying_through].iter().enumerate() {
            self.set(4 + n, u64::from(value.to_bits()));
        }
        self.set(7, info.status as u64);
        let [place, how] = info.panel.map_or([0; 2], |panel| panelled(&panel));
        self.set(8, place);
        self.set(9, how);
        for (n, notice) in notices.iter().enumerate() {
            let (kind, first, second) = coded(*notice);
            self.set(NOTICES.0 + 2 * n, u64::from(kind) | u64::from(first) << 32);
            self.set(NOTICES.0 + 2 * n + 1, u64::from(second));
        }
    }
}

/// Two words of a picture for a panel. A view has at most 16,384 pixels a side.
fn panelled(panel: &PanelUpdate) -> [u64; 2] {
    let sides = [panel.x, panel.y, panel.width, panel.height];
    let place = sides.iter().rev().fold(0, |word, &side| word << 16 | u64::from(side & 0xffff));
    let how = panel.waveform as u64 | u64::from(panel.full) << 8 | u64::from(panel.settled) << 9;
    [place, how | u64::from(panel.busy_us) << 32]
}

fn coded(notice: Notice) -> (u32, u32, u32) {
    match notice {
        Notice::Lifted { from_right, leaves } => (0, leaves, u32::from(from_right)),
        Notice::Held { leaves } => (1, leaves, 0),
        Notice::Committed { page } => (2, page, 0),
        Notice::Cancelled => (3, 0, 0),
        Notice::Announce { page, pages } => (4, page, pages),
        Notice::Haptic { tick } => {
            let tick = match tick {
                Tick::Lift => 0,
                Tick::Over => 1,
                Tick::Land => 2,
                Tick::Flip => 3,
            };
            (5, tick, 0)
        }
        Notice::Asleep => (6, 0, 0),
    }
}

/// Answers of the calls.
pub(crate) const DONE: i32 = 0;
/// The book is closed or freed.
pub(crate) const CLOSED: i32 = 1;
/// A sample was refused; everything else was done.
pub(crate) const REFUSED: i32 = 2;
/// Something broke; the book was put back to rest.
pub(crate) const BROKEN: i32 = 3;

fn with(ticket: i64, work: impl FnOnce(&Book) -> i32) -> i32 {
    let book = shelf(|s| s.books.get(&ticket.cast_unsigned()).and_then(Weak::upgrade));
    book.map_or(CLOSED, |book| work(&book))
}

/// `FastCalls.step` of the Kotlin shell: takes the samples put down, and steps. 0 done, 1 closed, 2 a sample was refused, 3 broken.
#[unsafe(no_mangle)]
extern "system" fn Java_org_dogleaf_FastCalls_step(
    _env: *mut c_void,
    _class: *mut c_void,
    ticket: i64,
    now_us: i64,
    samples: i32,
) -> i32 {
    with(ticket, |book| {
        book.fast(samples.max(0).cast_unsigned() as usize, Some(now_us.cast_unsigned()))
    })
}

/// `FastCalls.feed` of the Kotlin shell: takes the samples put down, without a step. Answers as `step`.
#[unsafe(no_mangle)]
extern "system" fn Java_org_dogleaf_FastCalls_feed(
    _env: *mut c_void,
    _class: *mut c_void,
    ticket: i64,
    samples: i32,
) -> i32 {
    with(ticket, |book| book.fast(samples.max(0).cast_unsigned() as usize, None))
}

#[cfg(test)]
mod check {
    use super::{CLOSED, DONE, Java_org_dogleaf_FastCalls_step as step, SAMPLES, SHELF};
    use crate::book::Book;
    use crate::options::book_options;
    use std::ptr::null_mut;
    use std::sync::Arc;

    #[test]
    fn the_words_say_what_a_step_says() {
        let options = book_options(320, 960, 720);
        let (book, other) =
            (Book::open(&options).expect("sound"), Book::open(&options).expect("sound"));
        let view = Arc::clone(&book).frame_words().expect("open");
        let ticket = view.ticket.cast_signed();
        assert_eq!(Arc::clone(&book).frame_words(), Ok(view), "only once");
        book.turn(true, 1).expect("a page");
        other.turn(true, 1).expect("a page");
        let words = book.words().expect("asked for");
        for frame in 1..200 {
            assert_eq!(step(null_mut(), null_mut(), ticket, frame * 16_667, 0), DONE);
            let info = other.step(frame.cast_unsigned() * 16_667).expect("open");
            assert_eq!(words.word(0), u64::from(info.draw) | u64::from(info.needs_frame) << 1);
            assert_eq!(words.word(1), info.generation);
            assert_eq!(words.word(3), u64::from(info.notices));
            assert_eq!(words.word(5) as u32, info.through.to_bits());
            other.notices().expect("open");
        }
        assert_eq!(book.state_hash(), other.state_hash());
        words.set(SAMPLES.0 + 1, 9 << 8);
        assert_eq!(words.sample(0), None, "no such phase");
        book.shut();
        assert_eq!(step(null_mut(), null_mut(), ticket, 1, 0), CLOSED);
        drop((book, words));
        assert_eq!(step(null_mut(), null_mut(), ticket, 1, 0), CLOSED, "freed");
        assert!(!SHELF.lock().expect("sound").free.is_empty(), "the words wait for another book");
    }
}
