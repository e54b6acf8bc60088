//! Promise: a bookmark sewn to a book comes to lie, stays out of what is solid, goes with the leaves, comes when a finger
//! pulls, and sleeps with the book. The book does not notice it.

use crate::tally::asked;
use dogleaf_core::Book;
use dogleaf_core::effect::ribbon::Status;
use dogleaf_core::effect::ribbon::bookmark::{Bookmark, BookmarkSpec, Layer};
use dogleaf_core::effect::ribbon::contact::Surface;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::real::{Real, V3};
use dogleaf_core::scene::{BookSpec, Cover, SpecError};
use dogleaf_tests::gesture::{FRAME_US, Gesture, Scene};
use dogleaf_tests::ribbons::stretch;
use std::time::Instant;

pub(crate) type Sewn<R> = Box<Bookmark<R, G11x8>>;
pub(crate) type Read<R> = Box<Book<R, G11x8>>;

/// Steps until a bookmark that was put somewhere must lie.
const LAYING: u32 = 300;
/// It may be so far behind a leaf that pushes it, metres.
const LAG: f64 = 1e-3;
/// It may be so deep in something solid where it lies, metres.
pub(crate) const DEEP: f64 = 3e-4;

pub(crate) fn sew<R: Real>(scene: &Scene, place: u32) -> (Read<R>, Sewn<R>) {
    let book = scene.open::<R, G11x8>().expect("a sound book");
    let mut mark: Sewn<R> = Box::new(Bookmark::EMPTY);
    mark.open(&BookmarkSpec { place, ..BookmarkSpec::default() }, &book).expect("a sound ribbon");
    (book, mark)
}

/// Lets it come to lie; answers the steps it took.
pub(crate) fn lie<R: Real>(book: &Read<R>, mark: &mut Sewn<R>) -> u32 {
    for step in 0..LAYING {
        if !mark.needs_frame() {
            return step;
        }
        let report = mark.follow(book, FRAME_US);
        assert_ne!(report.status, Status::Held, "step {step}");
    }
    panic!("it does not come to lie: {} m/s", fastest(mark));
}

fn fastest<R: Real>(mark: &Sewn<R>) -> f64 {
    let speeds = mark.ribbon().velocities_now().flatten().map(|v| v.norm_sq().wide());
    speeds.fold(0.0, f64::max).sqrt()
}

/// How deep its deepest vertex is in anything, metres.
pub(crate) fn depth<R: Real>(mark: &Sewn<R>) -> f64 {
    let seen =
        mark.pairs().enumerate().filter(|(j, _)| !mark.hidden(*j)).flat_map(|(_, pair)| pair);
    seen.fold(0.0, |deepest, p| deepest.max(-mark.ground().above(p).0.wide()))
}

pub(crate) fn places<R: Real>(mark: &Sewn<R>) -> Vec<V3<f64>> {
    mark.pairs().flatten().map(|p| V3(p.0.map(Real::wide))).collect()
}

fn comes_to_lie<R: Real>(name: &str, scene: &Scene, place: u32) {
    let (book, mut mark) = sew::<R>(scene, place);
    let steps = lie(&book, &mut mark);
    let (deep, stretch) = (depth(&mark), stretch(mark.ribbon()));
    println!(
        "{name} {}: lies after {steps} steps, {deep:.1e} m deep, stretch {stretch:.1e}",
        R::NAME
    );
    assert!(deep <= DEEP, "{name}: {deep} m inside something");
    let tail = places(&mark).iter().fold(f64::MIN, |z, p| z.max(p.0[2]));
    assert!(tail > 0.5 * scene.book.height_m, "{name}: its end hangs out at the tail, {tail}");
}

#[test]
fn it_comes_to_lie() {
    let soft = BookSpec { cover: Cover::Soft, ..BookSpec::default() };
    let thin = BookSpec { pages: 40, open_at: 20, ..soft };
    for (name, book) in [("hard", BookSpec::default()), ("soft", soft), ("thin", thin)] {
        let scene = Scene::of(book);
        comes_to_lie::<f32>(name, &scene, book.read());
        comes_to_lie::<f64>(name, &scene, book.read());
    }
    let book = BookSpec::default();
    comes_to_lie::<f32>("between, left", &Scene::of(book), book.read() / 2);
    comes_to_lie::<f32>("between, right", &Scene::of(book), (book.read() + book.leaves()) / 2);
}

/// Plays a gesture; answers the book's hashes, and the most the bookmark was inside anything.
fn play<R: Real>(
    book: &mut Read<R>,
    mut mark: Option<&mut Sewn<R>>,
    gesture: &[Sample],
) -> (Vec<u64>, f64) {
    let (mut hashes, mut deepest, mut left) = (Vec::new(), 0.0_f64, gesture.iter().peekable());
    let (mut micros, mut iterations) = (Vec::new(), 0);
    for _ in 0..600 {
        while let Some(sample) = left.next_if(|s| s.t_us <= book.now_us() + u64::from(FRAME_US)) {
            book.input(*sample).expect("a sound sample");
        }
        let _ = book.step();
        hashes.push(book.state_hash());
        if let Some(mark) = &mut mark {
            let start = Instant::now();
            let report = mark.follow(book, FRAME_US);
            micros.push(1e6 * start.elapsed().as_secs_f64());
            iterations += report.iterations;
            assert_ne!(report.status, Status::Held, "step {}", hashes.len());
            assert!(places(mark).iter().all(|p| p.0.iter().all(|x| x.is_finite())), "numbers");
            deepest = deepest.max(depth(mark));
        }
        let rest = left.peek().is_none() && !book.needs_frame();
        if rest && mark.as_ref().is_none_or(|m| !m.needs_frame()) {
            break;
        }
    }
    if !micros.is_empty() {
        micros.sort_by(f64::total_cmp);
        let n = micros.len();
        let mean = f64::from(iterations) / n as f64;
        println!(
            "{n} steps, {:.0} us median, {:.0} us p99, {mean:.1} iterations",
            micros[n / 2],
            micros[n * 99 / 100]
        );
    }
    (hashes, deepest)
}

fn goes_with_the_leaves<R: Real>(seed: u64) {
    let scene = Scene::default();
    let gesture = Gesture::corner_turn(&scene.eye(), seed);
    let place = scene.book.read();
    let (mut book, mut mark) = sew::<R>(&scene, place);
    lie(&book, &mut mark);
    let (hashes, deepest) = play(&mut book, Some(&mut mark), &gesture);
    println!("{}: at most {deepest:.1e} m inside something on the way", R::NAME);
    assert!(deepest <= LAG, "{}: {deepest} m inside something", R::NAME);
    assert_eq!(Layer::of(&book, place), Layer::Block(0), "the leaf came to lie on it");
    assert!((0..40).filter(|&j| mark.hidden(j)).count() > 20, "most of it is between leaves");
    assert!(!mark.needs_frame(), "it sleeps with the book");
    let mut alone = scene.open::<R, G11x8>().expect("a sound book");
    let (without, _) = play(&mut alone, None, &gesture);
    assert_eq!(hashes[..without.len()], without[..], "the book does not notice it");
}

#[test]
fn it_goes_with_the_leaves() {
    for seed in 1..=3 {
        goes_with_the_leaves::<f32>(seed);
        goes_with_the_leaves::<f64>(seed);
    }
}

/// Where a place of the book is seen, 1/256 pixel.
pub(crate) fn seen<R: Real>(book: &Read<R>, at: V3<f64>) -> [i32; 2] {
    let units = book.units();
    let p = V3(at.0.map(|c| R::of(units.length(c))));
    let [x, y] = book.camera().project(p).expect("before the eye");
    [x, y].map(|c| (c.wide() * 256.0) as i32)
}

fn comes_to_a_finger<R: Real>() {
    let scene = Scene::default();
    let (book, mut mark) = sew::<R>(&scene, scene.book.read());
    lie(&book, &mut mark);
    let middle = |mark: &Sewn<R>, j: usize| {
        let [a, b] = mark.pairs().nth(j).expect("a crease").map(|p| V3(p.0.map(Real::wide)));
        (a + b) * 0.5
    };
    let held = 24;
    let from = middle(&mark, held);
    let to = from + V3([-0.03, 0.02, -0.01]);
    let sample = |id, phase, at: V3<f64>| {
        let [x, y] = seen(&book, at);
        Sample { t_us: 0, id, phase, x, y, leaves: 1 }
    };
    let page = V3([0.08, 0.02, 0.0]);
    assert!(!mark.touch(&book, &sample(0, Phase::Down, page)), "the page is not its");
    assert!(mark.touch(&book, &sample(1, Phase::Down, from)), "it is taken");
    assert!(!mark.touch(&book, &sample(2, Phase::Move, to)), "another finger is not its");
    for _ in 0..40 {
        assert!(mark.touch(&book, &sample(1, Phase::Move, to)), "it follows");
        assert_ne!(mark.follow(&book, FRAME_US).status, Status::Held, "numbers");
    }
    let (near, wanted) = (seen(&book, middle(&mark, held)), seen(&book, to));
    let off = (0..2).map(|i| f64::from(near[i] - wanted[i]) / 256.0);
    let off = off.map(|d| d * d).sum::<f64>().sqrt();
    println!("{}: {off:.1} pixels from the finger", R::NAME);
    assert!(off < 12.0, "it is under the finger: {off} pixels off");
    assert!(mark.touch(&book, &sample(1, Phase::Up, to)), "it is let go");
    lie(&book, &mut mark);
    assert!(depth(&mark) <= DEEP, "it lies again");
}

#[test]
fn it_comes_to_a_finger() {
    comes_to_a_finger::<f32>();
    comes_to_a_finger::<f64>();
}

#[test]
fn asleep_it_costs_nothing_and_awake_no_memory() {
    let scene = Scene::default();
    let (mut book, mut mark) = sew::<f32>(&scene, scene.book.read());
    lie(&book, &mut mark);
    let before = mark.state_hash();
    let report = mark.follow(&book, FRAME_US);
    assert_eq!((report.iterations, report.trials, mark.state_hash()), (0, 0, before), "asleep");
    let _ = book.take_up(true, 1);
    let spent = asked(|| {
        for _ in 0..120 {
            let _ = book.step();
            let _ = mark.follow(&book, FRAME_US);
        }
    });
    assert_eq!(spent, 0, "nothing is allocated");
    assert_ne!(mark.state_hash(), before, "awake");
}

#[test]
fn bad_bookmarks_are_refused() {
    let scene = Scene::default();
    let book = scene.open::<f32, G11x8>().expect("a sound book");
    let mut mark: Sewn<f32> = Box::new(Bookmark::EMPTY);
    let mut refused = |spec: BookmarkSpec| mark.open(&spec, &book).err();
    let sound = BookmarkSpec::default();
    let beyond = BookmarkSpec { place: scene.book.leaves() + 1, ..sound };
    assert_eq!(refused(beyond), Some(SpecError::OutOfRange("bookmark.place")), "no such place");
    let wide = BookmarkSpec { width_m: f64::NAN, ..sound };
    assert_eq!(refused(wide), Some(SpecError::NotFinite("ribbon.width_m")), "no width");
    let short = BookmarkSpec { length_m: -1.0, ..sound };
    assert_eq!(refused(short), Some(SpecError::OutOfRange("ribbon.length_m")), "no length");
    let slippery = BookmarkSpec { friction: -0.1, ..sound };
    assert_eq!(refused(slippery), Some(SpecError::OutOfRange("bookmark.friction")), "no friction");
    assert_eq!(refused(sound), None, "a good one is taken");
}
