//! The one object an app holds.

use crate::desk::Desk;
use crate::eink::PanelOptions;
use crate::error::DogleafError;
use crate::frame::FrameInfo;
use crate::mesh::{IndexView, Mesh, MeshView, Piece};
use crate::notice::Notice;
use crate::options::{BookOptions, Motion};
use crate::pointer::PointerSample;
use crate::stage::{Gaze, Stage};
use crate::words::{self, FrameWords, Words};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

pub(crate) type Result<T> = std::result::Result<T, DogleafError>;

/// A book being read. It may be used from any thread, one call at a time; apps keep it to one.
///
/// It is fed with pointer samples and time, and answers with a mesh and notices. `shut` ends it: then every call is
/// refused with `Closed`, also one that waits on another thread.
#[derive(Debug, uniffi::Object)]
pub struct Book {
    state: Mutex<State>,
    /// The words of the frame loop and their ticket, once they were asked for.
    words: OnceLock<(Arc<Words>, u64)>,
}

impl Drop for Book {
    fn drop(&mut self) {
        if let Some((words, ticket)) = self.words.take() {
            Words::give_back(words, ticket);
        }
    }
}

#[derive(Debug)]
struct State {
    desk: Option<Box<Desk>>,
    /// The mesh of a book that was shut: a renderer may still read it.
    kept: Option<Mesh>,
}

impl Book {
    fn of(desk: Desk) -> Arc<Self> {
        let state = State { desk: Some(Box::new(desk)), kept: None };
        Arc::new(Self { state: Mutex::new(state), words: OnceLock::new() })
    }

    /// Does something with the open book. A panic puts it back to rest and becomes an error.
    pub(crate) fn with<T>(&self, work: impl FnOnce(&mut Desk) -> Result<T>) -> Result<T> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let desk = state.desk.as_mut().ok_or(DogleafError::Closed)?;
        match catch_unwind(AssertUnwindSafe(|| work(desk))) {
            Ok(done) => done,
            Err(panic) => {
                let why = said(&*panic);
                let again = catch_unwind(AssertUnwindSafe(|| desk.recover()));
                if !matches!(again, Ok(Ok(()))) {
                    // Not even the page it was open at can be opened: there is no book any more.
                    state.shut();
                }
                Err(DogleafError::Panicked(why))
            }
        }
    }

    /// A frame by way of the words: the samples put down there, and a step if there is a time for it.
    pub(crate) fn fast(&self, samples: usize, now_us: Option<u64>) -> i32 {
        let Some((words, _)) = self.words.get() else { return words::CLOSED };
        let done = self.with(|desk| {
            let mut code = words::DONE;
            for n in 0..samples.min(64) {
                let taken = words.sample(n).map(|s| desk.pointers(&[s]));
                if !matches!(taken, Some(Ok(()))) {
                    code = words::REFUSED;
                }
            }
            if let Some(now_us) = now_us {
                let info = desk.step(now_us);
                let notices = desk.some_notices(words::NOTICES.1);
                words.answer(&info, &notices);
            }
            Ok(code)
        });
        match done {
            Ok(code) => code,
            Err(DogleafError::Closed) => words::CLOSED,
            Err(_) => words::BROKEN,
        }
    }

    #[cfg(test)]
    pub(crate) fn words(&self) -> Option<Arc<Words>> {
        self.words.get().map(|(words, _)| Arc::clone(words))
    }

    /// The same for what changes the book: takes note of it afterwards.
    pub(crate) fn change<T>(&self, work: impl FnOnce(&mut Desk) -> Result<T>) -> Result<T> {
        self.with(|desk| {
            let done = work(desk);
            desk.keep();
            done
        })
    }
}

impl State {
    fn shut(&mut self) {
        if let Some(desk) = self.desk.take() {
            self.kept = Some(desk.mesh);
        }
    }
}

/// What a panic said.
fn said(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|s| (*s).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_else(|| "no reason".into())
}

#[uniffi::export]
impl Book {
    /// Opens a book, at rest at its page. Its mesh is there at once.
    ///
    /// # Errors
    ///
    /// `Refused`, with the option at fault.
    #[uniffi::constructor]
    pub fn open(options: &BookOptions) -> Result<Arc<Self>> {
        Ok(Self::of(Desk::open(&options.into())?))
    }

    /// Opens the book of a snapshot, at rest at its page.
    ///
    /// # Errors
    ///
    /// `Recording`: these bytes are no snapshot of this version.
    #[uniffi::constructor]
    #[expect(clippy::needless_pass_by_value, reason = "what crosses the boundary is owned")]
    pub fn from_snapshot(bytes: Vec<u8>) -> Result<Arc<Self>> {
        Ok(Self::of(Desk::restore(&bytes)?))
    }

    /// Takes a pointer sample. A paused book takes none and says nothing.
    ///
    /// # Errors
    ///
    /// `Pointer`, `Closed`.
    pub fn pointer(&self, sample: &PointerSample) -> Result<()> {
        self.with(|desk| desk.pointers(std::slice::from_ref(sample)))
    }

    /// Takes a batch of pointer samples, oldest first: what the system collected since the last frame.
    ///
    /// # Errors
    ///
    /// `Pointer` at the first bad one, those before it were taken; `Closed`.
    #[expect(clippy::needless_pass_by_value, reason = "what crosses the boundary is owned")]
    pub fn pointers(&self, samples: Vec<PointerSample>) -> Result<()> {
        self.with(|desk| desk.pointers(&samples))
    }

    /// Lets time pass until `now_us`, the time of the frame to be drawn, and makes the mesh if it changed.
    ///
    /// # Errors
    ///
    /// `Closed`, `Panicked`.
    pub fn step(&self, now_us: u64) -> Result<FrameInfo> {
        self.with(|desk| Ok(desk.step(now_us)))
    }

    /// Where the vertices lie. Once is enough: the address never changes.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn mesh(&self) -> Result<MeshView> {
        self.with(|desk| Ok(desk.mesh.view()))
    }

    /// Where the indices lie, and they never change.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn indices(&self) -> Result<IndexView> {
        self.with(|desk| Ok(desk.mesh.index_view()))
    }

    /// What the mesh is made of. Ask again when `pieces_generation` moved.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn pieces(&self) -> Result<Vec<Piece>> {
        self.with(|desk| Ok(desk.mesh.pieces.clone()))
    }

    /// Where the frame loop's words lie, for a shell that steps without objects: see the Kotlin shell's `Frames`.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn frame_words(self: Arc<Self>) -> Result<FrameWords> {
        self.with(|_| Ok(()))?;
        let (words, ticket) = self.words.get_or_init(|| Words::lend(&self));
        Ok(words.view(*ticket))
    }

    /// All notices waiting, oldest first.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn notices(&self) -> Result<Vec<Notice>> {
        self.with(|desk| {
            desk.keep();
            Ok(desk.notices())
        })
    }

    /// What stands around the book, for the renderer. Ask again after `look` and `resize`.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn stage(&self) -> Result<Stage> {
        self.with(|desk| Ok(desk.stage()))
    }

    /// Whether the app has to call `step` again. False while everything is at rest or paused.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn needs_frame(&self) -> Result<bool> {
        self.with(|desk| Ok(desk.needs_frame()))
    }

    /// Turns leaves on, or back, as a key or a screen reader asks for.
    ///
    /// # Errors
    ///
    /// `Busy` while a leaf is in the air; `NoSuchPage` at either end; `Paused`; `Closed`.
    pub fn turn(&self, forward: bool, leaves: u16) -> Result<()> {
        self.change(|desk| Ok(desk.reading.turn(forward, leaves)?))
    }

    /// Lets the leaf that nobody holds come to lie at once.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn skip(&self) -> Result<()> {
        self.change(|desk| {
            desk.reading.skip(&mut desk.journal);
            Ok(())
        })
    }

    /// What moves, and for how long at most.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn motion(&self) -> Result<Motion> {
        self.with(|desk| Ok(desk.reading.motion().into()))
    }

    /// Changes it, also in the middle of a turn.
    ///
    /// # Errors
    ///
    /// `Refused`: a cap that no turn keeps; `Closed`.
    pub fn set_motion(&self, motion: Motion) -> Result<()> {
        self.change(|desk| {
            desk.reading.set_motion(motion.into())?;
            desk.redraw();
            Ok(())
        })
    }

    /// What the electronic paper can do, under `MotionPolicy::EInk`; [`panel_options`](crate::panel_options) until it is said.
    /// What it shows is drawn anew.
    ///
    /// # Errors
    ///
    /// `Refused`: what no panel takes; `Closed`.
    pub fn set_panel(&self, options: PanelOptions) -> Result<()> {
        crate::eink::check(&options)?;
        self.change(|desk| {
            desk.set_panel(options);
            Ok(())
        })
    }

    /// Looks from elsewhere, in a view of this size.
    ///
    /// # Errors
    ///
    /// `Refused`: a view without pixels, or above 16,384; `Closed`.
    pub fn look(&self, gaze: Gaze, width_px: u32, height_px: u32) -> Result<()> {
        self.change(|desk| desk.look(gaze, width_px, height_px))
    }

    /// The view has another size.
    ///
    /// # Errors
    ///
    /// As `look`.
    pub fn resize(&self, width_px: u32, height_px: u32) -> Result<()> {
        self.change(|desk| desk.look(desk.gaze(), width_px, height_px))
    }

    /// The picture the app has is lost (a GL context, say): the next `step` asks to draw.
    ///
    /// # Errors
    ///
    /// `Closed`.
    pub fn redraw(&self) -> Result<()> {
        self.with(|desk| {
            desk.redraw();
            Ok(())
        })
    }

    /// Ends the book: every later call is refused with `Closed`. The mesh stays readable until the object is freed.
    pub fn shut(&self) {
        self.state.lock().unwrap_or_else(PoisonError::into_inner).shut();
    }
}

#[cfg(test)]
mod check {
    use super::Book;
    use crate::error::DogleafError;
    use crate::options::book_options;

    #[test]
    fn a_panic_becomes_an_error_and_the_book_goes_on() {
        let book = Book::open(&book_options(320, 960, 720)).expect("sound");
        book.turn(true, 1).expect("a page");
        for frame in 1..30 {
            book.step(frame * 16_667).expect("open");
        }
        let mesh = book.mesh().expect("open");
        let broken: Result<(), _> = book.with(|desk| {
            desk.reading.resume();
            panic!("planted")
        });
        assert_eq!(broken, Err(DogleafError::Panicked("planted".to_owned())));
        assert_eq!(book.is_sleeping(), Ok(true), "put back to rest");
        assert_eq!(book.mesh().map(|m| m.address), Ok(mesh.address), "where it was");
        book.turn(true, 1).expect("a page");
        assert!(book.step(700_000).is_ok(), "and it goes on");
    }

    #[test]
    fn a_lock_that_was_poisoned_is_taken_over() {
        let book = Book::open(&book_options(20, 960, 720)).expect("sound");
        let other = std::sync::Arc::clone(&book);
        let dead = std::thread::spawn(move || {
            let _held = other.state.lock();
            panic!("planted while the lock is held")
        });
        assert!(dead.join().is_err(), "it died");
        assert_eq!(book.page(), Ok(0));
    }

    #[test]
    fn the_mesh_is_there_before_the_first_step() {
        let book = Book::open(&book_options(320, 960, 720)).expect("sound");
        let filled = book.with(|desk| {
            let far = desk.mesh.vertices().iter().any(|v| v.position[0] > 0.1);
            Ok(far)
        });
        assert_eq!(filled, Ok(true));
    }
}
