//! Promise: left and right are the same. A turn and its mirror image agree, step by step, and a book read
//! from right to left is the mirror image of one read from left to right.

use dogleaf_core::Book;
use dogleaf_core::event::Event;
use dogleaf_core::grid::{G11x8, Grid};
use dogleaf_core::hand::Sample;
use dogleaf_core::real::Real;
use dogleaf_core::scene::Direction;
use dogleaf_tests::gesture::{FRAME_US, Gesture, Rng, Scene};

/// Largest distance between a leaf and its mirror image, page widths.
const BOUND: f64 = 1e-5;
/// Pictures of a turn and of its coming to rest.
const FRAMES: u32 = 200;

/// Gestures on each pair of books.
fn count() -> u64 {
    if cfg!(debug_assertions) { 4 } else { 16 }
}

/// Two books, the second the mirror image of the first.
struct Pair<R: Real> {
    books: [Box<Book<R, G11x8>>; 2],
    inputs: [Vec<Sample>; 2],
}

/// What came of them.
struct Seen {
    apart: f64,
    moved: f64,
    events: [Vec<Event>; 2],
}

impl<R: Real> Pair<R> {
    fn of(scenes: [&Scene; 2], gesture: &[Sample]) -> Self {
        let books = scenes.map(|s| s.open().expect("a sound scene"));
        let inputs = [gesture.to_vec(), scenes[0].eye().mirror(gesture)];
        Self { books, inputs }
    }

    fn play(mut self) -> Seen {
        let mut seen = Seen { apart: 0.0, moved: 0.0, events: Default::default() };
        let mut done = 0;
        for n in 0..FRAMES {
            let until = u64::from(n + 1) * u64::from(FRAME_US);
            let due = self.inputs[0][done..].iter().take_while(|s| s.t_us <= until).count();
            for (book, samples) in self.books.iter_mut().zip(&self.inputs) {
                samples[done..done + due].iter().for_each(|s| book.input(*s).expect("in order"));
                let _ = book.advance(FRAME_US);
            }
            done += due;
            for (book, events) in self.books.iter_mut().zip(&mut seen.events) {
                events.extend(core::iter::from_fn(|| book.take_event()));
            }
            seen.apart = seen.apart.max(self.apart());
            seen.moved = seen.moved.max(self.books[0].stretch().max().wide());
        }
        seen
    }

    /// Largest distance of a node of one from the mirrored node of the other, page widths; endless where
    /// only one has a leaf in the air.
    fn apart(&self) -> f64 {
        let [a, b] = &self.books;
        let (a, b) = match (a.leaf(), b.leaf()) {
            (Some(a), Some(b)) => (a, b),
            (None, None) => return 0.0,
            _ => return f64::INFINITY,
        };
        let nodes = (0..G11x8::NX).flat_map(|i| (0..G11x8::NZ).map(move |k| (i, k)));
        let far = nodes.map(|(i, k)| {
            let ([x, y, z], [u, v, w]) = (a.x.at(i, k).0, b.x.at(i, k).0);
            let d = [x + u, y - v, z - w].map(Real::wide);
            d.iter().map(|d| d * d).sum::<f64>().sqrt()
        });
        far.fold(0.0, f64::max) / 12.0
    }
}

/// Turns and their mirror images over many gestures; answers the largest distance.
fn apart<R: Real>(name: &str, scenes: [&Scene; 2]) -> f64 {
    let mut worst = 0f64;
    for seed in 0..count() {
        let gesture = Gesture::corner_turn(&scenes[0].eye(), seed);
        let seen = Pair::<R>::of(scenes, &gesture).play();
        assert!(seen.moved > 1e-4, "{name}, gesture {seed}: nothing happened");
        assert!(
            seen.apart <= BOUND,
            "{name} {}, gesture {seed}: {:.2e} page widths apart",
            R::NAME,
            seen.apart
        );
        assert_eq!(mirrored(&seen.events[0]), seen.events[1], "{name}, gesture {seed}");
        worst = worst.max(seen.apart);
    }
    println!("{name:32} {} {worst:.2e} page widths apart", R::NAME);
    worst
}

/// Events of the mirror image, which names the same pages where direction is mirrored too.
fn mirrored(events: &[Event]) -> Vec<Event> {
    let turn = |e: &Event| match *e {
        Event::Lifted { from_right, leaves } => Event::Lifted { from_right: !from_right, leaves },
        other => other,
    };
    events.iter().map(turn).collect()
}

/// The mirror image of a scene: the same pages read the other way.
fn other_way(scene: &Scene) -> Scene {
    let mut other = *scene;
    other.book.direction = Direction::Rtl;
    other
}

fn both(name: &str, scene: &Scene) {
    let other = other_way(scene);
    apart::<f32>(name, [scene, &other]);
    apart::<f64>(name, [scene, &other]);
}

#[test]
fn books_read_the_other_way() {
    both("open in the middle", &Scene::open_at(320, 160));
    both("60 leaves and 100", &Scene::open_at(320, 120));
    both("one leaf read", &Scene::open_at(320, 2));
    both("the last leaf", &Scene::open_at(320, 318));
    both("seed's weights", &Scene::seed());
}

/// The same book, one turn onwards and one back: as many leaves on one side as on the other, then not.
#[test]
fn turns_onwards_and_back() {
    for (a, b) in [(160, 160), (120, 200)] {
        let scenes = [Scene::open_at(320, a), Scene::open_at(320, b)];
        for seed in 0..count() {
            let gesture = Gesture::corner_turn(&scenes[0].eye(), seed);
            let seen = Pair::<f32>::of([&scenes[0], &scenes[1]], &gesture).play();
            assert!(seen.apart <= BOUND, "gesture {seed}: {:.2e} page widths apart", seen.apart);
            let end = |side: usize, page| seen.events[side].contains(&Event::Committed { page });
            assert!(end(0, a + 2) && end(1, b - 2), "gesture {seed}: {:?}", seen.events);
        }
    }
}

/// Scribbles: the hand's clamps are mirrored as well.
#[test]
fn scribbles() {
    let scene = Scene::open_at(320, 140);
    let other = other_way(&scene);
    for seed in 0..count() {
        let mut rng = Rng::new(seed);
        let eye = scene.eye();
        let mut gesture = Gesture::press(eye.page(0.9, rng.within(-0.9, 0.9)));
        for _ in 0..12 {
            let to = eye.above(rng.within(-1.3, 1.3), rng.within(0.0, 0.8), rng.within(-1.2, 1.2));
            gesture = gesture.to(to, (rng.within(30.0, 200.0) * 1e3) as u64);
        }
        let seen = Pair::<f64>::of([&scene, &other], &gesture.up()).play();
        assert!(seen.apart <= BOUND, "gesture {seed}: {:.2e} page widths apart", seen.apart);
        assert_eq!(mirrored(&seen.events[0]), seen.events[1], "gesture {seed}");
    }
}

/// What the check is worth: a hand that goes a pixel further than its mirror image is seen.
#[test]
fn the_check_can_fail() {
    let scene = Scene::open_at(320, 160);
    let gesture = Gesture::corner_turn(&scene.eye(), 0);
    let mut pair = Pair::<f64>::of([&scene, &other_way(&scene)], &gesture);
    // Not the press: a hand leads by how far it goes from there.
    pair.inputs[1].iter_mut().skip(1).for_each(|s| s.x += 256);
    assert!(pair.play().apart > BOUND, "a pixel was not seen");
}
