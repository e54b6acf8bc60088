//! What the view feels is what the core alone computes: the same hash after a recorded gesture, live and replayed.

mod support;

use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;
use dogleaf_core::reading::Notice;
use dogleaf_core::record::{Reader, replay};
use dogleaf_desktop::BookView;
use support::{book, options, play, samples};

/// Long enough for the gesture and the fall.
const UNTIL_US: u64 = 6_000_000;
const GESTURE: &str = "corner_turn.jsonl";

fn opened() -> BookView {
    BookView::open(book(), &options(), || ()).expect("a sound book")
}

#[test]
fn a_recorded_gesture_ends_in_the_cores_own_state() {
    let path = std::env::temp_dir().join(format!("dogleaf-desktop-{}.dlr", std::process::id()));
    let mut view = opened();
    view.record(&path).expect("a place for the recording");
    play(&mut view, &samples(GESTURE), UNTIL_US);
    let live = view.reading().book().state_hash();
    view.close().expect("the recording is whole");

    let bytes = std::fs::read(&path).expect("the recording");
    let _ = std::fs::remove_file(&path);
    let reader = Reader::open(&bytes).expect("a sound recording");
    let mut again = Box::new(Book::<f32, G11x8>::EMPTY);
    let verdict = replay(&reader, &mut again).expect("the same grid and scalar");
    assert_eq!(verdict.diverged, None, "the core takes every step as the view did");
    assert_eq!(verdict.final_hash, live, "and ends where it ended");
    assert!(verdict.steps > 60, "the turn was in it: {} steps", verdict.steps);
}

#[test]
fn the_page_that_was_turned_is_the_cores() {
    let mut view = opened();
    let page = view.reading().page();
    play(&mut view, &samples(GESTURE), UNTIL_US);
    let mut committed = Vec::new();
    while let Some(notice) = view.take_notice() {
        if let Notice::Committed { page } = notice {
            committed.push(page);
        }
    }
    assert_eq!(committed, [page + 2], "told once");
}

#[test]
fn nothing_is_drawn_while_the_book_lies_still() {
    let mut view = opened();
    play(&mut view, &samples(GESTURE), UNTIL_US);
    assert!(!view.needs_frame(), "six seconds are enough to come to rest");
    let hash = view.reading().book().state_hash();
    let drawn = (0..100_u64).filter(|n| view.step(UNTIL_US + n * 16_667)).count();
    assert_eq!(drawn, 0, "no picture of what did not change");
    assert_eq!(view.reading().book().state_hash(), hash, "and no work");
}

#[test]
fn a_second_finger_takes_more_leaves() {
    let mut view = opened();
    let held = |view: &BookView| view.reading().book().binding().held;
    play(&mut view, &samples(GESTURE), 700_000);
    assert_eq!(held(&view), 1, "one leaf in hand");
    view.bookmark(true, 700_000);
    view.bookmark(true, 700_000);
    view.step(720_000);
    view.step(740_000);
    assert_eq!(held(&view), 3, "two more");
    view.bookmark(false, 750_000);
    view.step(770_000);
    view.step(790_000);
    assert_eq!(held(&view), 2, "one less");
    assert!(view.put_back(800_000), "the mouse held it");
}

#[test]
fn keys_turn_to_the_ends_of_the_book() {
    let mut view = opened();
    view.turn_all(true);
    play(&mut view, &[], UNTIL_US);
    assert_eq!(view.reading().page(), view.reading().pages(), "after the last leaf");
    view.turn_all(false);
    (0..400_u64).for_each(|n| _ = view.step(UNTIL_US + n * 16_667));
    assert_eq!(view.reading().page(), 0, "before the first");
}
