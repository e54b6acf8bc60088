//! Promise: asleep is asleep. A book at rest does no work and does not change, and only a press on paper
//! wakes it.

use dogleaf_core::Book;
use dogleaf_core::event::Event;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::step::StepReport;
use dogleaf_tests::gesture::{FRAME_US, Gesture, Scene, play};

/// A sleeping book and how it looks.
struct Sleeper {
    book: Box<Book<f32, G11x8>>,
    hash: u64,
    scene: Scene,
}

impl Sleeper {
    fn of(scene: Scene) -> Self {
        let book = scene.open::<f32, G11x8>().expect("a sound scene");
        Self { hash: book.state_hash(), book, scene }
    }
    fn sample(&self, phase: Phase, at: [f64; 2]) -> Sample {
        let [x, y] = at.map(|p| (p * 256.0) as i32);
        Sample { t_us: self.book.now_us(), id: 0, phase, x, y, leaves: 1 }
    }
    /// Lets so many pictures pass; asserts that nothing whatever is done in them.
    fn nothing_for(&mut self, frames: u32, why: &str) {
        for n in 0..frames {
            assert!(!self.book.needs_frame(), "{why}: awake at picture {n}");
            let report = self.book.advance(FRAME_US);
            assert_eq!(report, StepReport::default(), "{why}: work at picture {n}");
            assert_eq!(self.book.state_hash(), self.hash, "{why}: changed at picture {n}");
        }
        assert_eq!(self.book.take_event(), None, "{why}");
    }
    /// Hands over samples that must be refused, one by one, without waking anything.
    fn refuses(&mut self, samples: &[Sample], why: &str) {
        for sample in samples {
            self.book.input(*sample).expect("in order");
            assert!(self.book.needs_frame(), "{why}: a sample waits");
            let report = self.book.advance(FRAME_US);
            let only = StepReport { refused: 1, ..StepReport::default() };
            assert_eq!(
                report, only,
                "{why}: {:?} is refused, counted, and costs nothing",
                sample.phase
            );
        }
        self.nothing_for(30, why);
    }
}

#[test]
fn a_new_book_sleeps() {
    let mut sleeper = Sleeper::of(Scene::default());
    sleeper.nothing_for(600, "new");
    assert_eq!(sleeper.book.now_us(), 600 * u64::from(FRAME_US), "time goes on in its sleep");
}

#[test]
fn an_unopened_book_sleeps() {
    let book = Box::new(Book::<f32, G11x8>::EMPTY);
    let (hash, scene) = (book.state_hash(), Scene::default());
    Sleeper { book, hash, scene }.nothing_for(60, "never opened");
}

/// Press, turn, settle, sleep; the loop a shell runs, five times over.
#[test]
fn it_wakes_works_and_sleeps_again() {
    let mut sleeper = Sleeper::of(Scene::default());
    for round in 0..5 {
        let gesture = Gesture::corner_turn(&sleeper.scene.eye(), round);
        let (mut worked, mut slept) = (0, None);
        play(&mut sleeper.book, &gesture, 400, &mut |book, report| {
            worked += report.steps;
            if !book.needs_frame() && worked > 0 {
                slept.get_or_insert(worked);
            }
        });
        assert_eq!(
            slept,
            Some(worked),
            "round {round}: it worked until it slept, and then no more"
        );
        let hash = core::mem::replace(&mut sleeper.hash, sleeper.book.state_hash());
        assert_ne!(hash, sleeper.hash, "round {round}: the hash tells one page from the next");
        let events: Vec<_> = core::iter::from_fn(|| sleeper.book.take_event()).collect();
        let page = 122 + 2 * u32::try_from(round).expect("few");
        let (lifted, committed) =
            (Event::Lifted { from_right: true, leaves: 1 }, Event::Committed { page });
        assert_eq!(events, [lifted, committed, Event::Asleep], "round {round}");
        sleeper.nothing_for(600, "after a turn");
    }
}

/// A press wakes in the very step it is due in, and not before.
#[test]
fn only_a_press_wakes() {
    let mut sleeper = Sleeper::of(Scene::default());
    let at = sleeper.scene.eye().page(0.9, 0.8);
    let others = [Phase::Move, Phase::Up, Phase::Cancel];
    for phase in others {
        let sample = sleeper.sample(phase, at);
        sleeper.refuses(&[sample], "a finger that never came down");
    }
    let later = Sample { t_us: sleeper.book.now_us() + 500_000, ..sleeper.sample(Phase::Down, at) };
    sleeper.book.input(later).expect("in order");
    for n in 0..29 {
        let report = sleeper.book.advance(FRAME_US);
        assert_eq!(report, StepReport::default(), "picture {n}: not due yet");
        assert_eq!(sleeper.book.state_hash(), sleeper.hash, "picture {n}: not due yet");
    }
    let report = sleeper.book.advance(2 * FRAME_US);
    assert!(report.steps > 0 && report.newton_steps > 0 && report.refused == 0, "{report:?}");
    assert_eq!(sleeper.book.take_event(), Some(Event::Lifted { from_right: true, leaves: 1 }));
}

/// Where there is no paper a press is refused and counted: an empty side, the table, the sky.
#[test]
fn a_press_on_nothing_is_refused() {
    for (open_at, empty) in [(0, -0.6), (320, 0.6)] {
        let scene = Scene::open_at(320, open_at);
        let mut sleeper = Sleeper::of(scene);
        let eye = scene.eye();
        let at = eye.page(empty, 0.3);
        let press = [sleeper.sample(Phase::Down, at), sleeper.sample(Phase::Up, at)];
        sleeper.refuses(&press, "an empty side");
    }
    let mut sleeper = Sleeper::of(Scene::default());
    let eye = sleeper.scene.eye();
    for at in [eye.page(1.6, 0.0), eye.page(-1.6, 0.0), [480.0, -1e5]] {
        let press = sleeper.sample(Phase::Down, at);
        sleeper.refuses(&[press], "beside the book");
    }
    let above_the_head = sleeper.sample(Phase::Down, eye.page(0.5, -2.5));
    sleeper.refuses(&[above_the_head], "above the head");
}

/// What the check is worth: a book with a leaf in the air, a sample that waits, a hash that is another and an event
/// nobody has read are each seen.
#[test]
fn the_check_can_fail() {
    let wakers: [fn(&mut Sleeper); 4] = [
        |s| assert!(s.book.take_up(true, 1), "there is a leaf"),
        |s| {
            let press = s.sample(Phase::Down, s.scene.eye().page(0.9, 0.8));
            s.book.input(press).expect("in order");
        },
        |s| s.hash ^= 1,
        |s| {
            // Taken up and down again: all that is left of it is an event.
            let other = s.scene.open::<f32, G11x8>().expect("a sound scene");
            let mut book = core::mem::replace(&mut s.book, other);
            let gesture = Gesture::corner_turn(&s.scene.eye(), 1);
            play(&mut book, &gesture, 400, &mut |_, _| ());
            s.hash = book.state_hash();
            s.book = book;
        },
    ];
    for (n, wake) in wakers.into_iter().enumerate() {
        let seen = std::panic::catch_unwind(|| {
            let mut sleeper = Sleeper::of(Scene::default());
            wake(&mut sleeper);
            sleeper.nothing_for(30, "the control");
        });
        assert!(seen.is_err(), "control {n} was not seen");
    }
}
