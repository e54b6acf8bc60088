//! Promise: under `MotionPolicy::EInk` a frame asks to draw exactly when the panel is to show something, and says where and
//! how; what becomes of the turn is what becomes of it under any policy.

use dogleaf_ffi::{
    Book, BookOptions, FrameInfo, Motion, MotionPolicy, PanelUpdate, Phase, PointerSample,
    Waveform, book_options, panel_options,
};
use std::sync::Arc;

const FRAME_US: u64 = 16_667;

fn options() -> BookOptions {
    BookOptions { open_at: 120, ..book_options(320, 960, 720) }
}

fn motion(policy: MotionPolicy) -> Motion {
    Motion { policy, cap_us: None }
}

fn open(policy: MotionPolicy) -> Arc<Book> {
    let book = Book::open(&options()).expect("sound");
    book.set_motion(motion(policy)).expect("open");
    book
}

/// Steps until nothing is owed; every frame.
fn rest(book: &Book, from: u64) -> Vec<(u64, FrameInfo)> {
    let mut frames = Vec::new();
    for n in from.. {
        let now = n * FRAME_US;
        let info = book.step(now).expect("open");
        frames.push((now, info));
        if !info.needs_frame {
            return frames;
        }
        assert!(n < from + 2_000, "it comes to rest");
    }
    frames
}

fn shown(frames: &[(u64, FrameInfo)]) -> Vec<(u64, PanelUpdate)> {
    frames.iter().filter_map(|&(at, info)| Some((at, info.panel?))).collect()
}

#[test]
fn a_turn_has_a_few_pictures_and_the_page_after() {
    let book = open(MotionPolicy::EInk);
    let first = rest(&book, 1);
    let [(_, whole)] = shown(&first)[..] else { panic!("the page at rest, once: {first:?}") };
    assert!(whole.full && whole.settled && whole.waveform == Waveform::Gc16, "{whole:?}");
    assert_eq!([whole.x, whole.y, whole.width, whole.height], [0, 0, 960, 720]);
    book.turn(true, 1).expect("a page");
    let frames = rest(&book, 100);
    let pictures = shown(&frames);
    let (_, last) = pictures.last().expect("some");
    assert!(last.settled && !last.full, "{last:?}");
    let moving = pictures.len() - 1;
    assert!((2..=4).contains(&moving), "{pictures:?}");
    assert!(pictures[..moving].iter().all(|(_, p)| !p.settled), "{pictures:?}");
    assert_eq!(pictures[0].1.waveform, Waveform::Du, "from greys");
    assert!(pictures[1..moving].iter().all(|(_, p)| p.waveform == Waveform::A2), "{pictures:?}");
    let gaps = pictures.windows(2).all(|w| w[1].0 - w[0].0 >= u64::from(w[0].1.busy_us));
    assert!(gaps, "none while the panel is busy: {pictures:?}");
    for (_, p) in &pictures {
        assert!(p.x.is_multiple_of(8) && (p.x + p.width).is_multiple_of(8), "whole bytes: {p:?}");
        assert!(p.x + p.width <= 960 && p.y + p.height <= 720, "inside: {p:?}");
    }
    let drawn: Vec<u64> = frames.iter().filter(|(_, i)| i.draw).map(|&(at, _)| at).collect();
    assert_eq!(
        drawn,
        pictures.iter().map(|&(at, _)| at).collect::<Vec<_>>(),
        "draws what is shown"
    );
    assert_eq!(book.needs_frame(), Ok(false));
}

#[test]
fn nothing_is_shown_at_rest_and_a_lost_picture_is_shown_whole() {
    let book = open(MotionPolicy::EInk);
    rest(&book, 1);
    for n in 100..700 {
        let info = book.step(n * FRAME_US).expect("open");
        assert_eq!((info.panel, info.draw, info.needs_frame), (None, false, false));
    }
    book.redraw().expect("open");
    let again = shown(&rest(&book, 700));
    assert!(matches!(again[..], [(_, p)] if p.full), "{again:?}");
}

#[test]
fn a_turn_ends_as_under_every_other_policy() {
    let end = |policy| {
        let book = open(policy);
        rest(&book, 1);
        book.turn(true, 1).expect("a page");
        let frames = rest(&book, 100);
        if policy != MotionPolicy::EInk {
            assert!(shown(&frames).is_empty(), "no panel, no pictures for one");
        }
        (book.page().expect("open"), book.state_hash().expect("open"))
    };
    assert_eq!(end(MotionPolicy::EInk), end(MotionPolicy::Full));
}

#[test]
fn a_leaf_that_is_held_is_followed_both_ways() {
    let book = open(MotionPolicy::EInk);
    rest(&book, 1);
    let finger = |n: u64, phase, x: f32| PointerSample {
        time_us: n * FRAME_US,
        id: 0,
        phase,
        x,
        y: 470.0,
        leaves: 0,
    };
    let mut pictures = Vec::new();
    book.pointer(&finger(100, Phase::Down, 800.0)).expect("in order");
    for n in 101..340 {
        // Over, and back.
        let way = ((n - 101) as f32 / 40.0).cos();
        book.pointer(&finger(n, Phase::Move, 500.0 + 300.0 * way)).expect("in order");
        pictures.extend(book.step(n * FRAME_US).expect("open").panel);
    }
    assert!(pictures.len() >= 5, "{} pictures", pictures.len());
    assert!(pictures.iter().all(|p| !p.settled), "{pictures:?}");
    book.pointer(&finger(340, Phase::Up, 800.0)).expect("in order");
    let after = shown(&rest(&book, 341));
    assert!(after.last().is_some_and(|(_, p)| p.settled), "{after:?}");
}

#[test]
fn a_slow_panel_gets_fewer_and_many_end_in_a_full_refresh() {
    let book = open(MotionPolicy::EInk);
    let slow =
        dogleaf_ffi::PanelOptions { a2_us: None, du_us: 600_000, full_after: 4, ..panel_options() };
    book.set_panel(slow).expect("open");
    let mut at = 1;
    rest(&book, at);
    let mut full = 0;
    for turn in 0..6 {
        at += 1_000;
        book.turn(turn % 2 == 0, 1).expect("a page");
        let pictures = shown(&rest(&book, at));
        assert!(pictures.len() <= 3, "{pictures:?}");
        assert!(pictures.iter().all(|(_, p)| p.waveform != Waveform::A2), "{pictures:?}");
        full += pictures.iter().filter(|(_, p)| p.full).count();
    }
    assert!((1..=3).contains(&full), "{full} full refreshes");
}

#[test]
fn what_no_panel_takes_is_refused_in_a_line() {
    let book = open(MotionPolicy::EInk);
    let sound = panel_options();
    for (options, said) in [
        (dogleaf_ffi::PanelOptions { du_us: 0, ..sound }, "waveform"),
        (dogleaf_ffi::PanelOptions { glr16_us: Some(20_000_000), ..sound }, "waveform"),
        (dogleaf_ffi::PanelOptions { key_frames: 0, ..sound }, "key frames"),
        (dogleaf_ffi::PanelOptions { full_after: 0, ..sound }, "full refresh"),
    ] {
        let why = book.set_panel(options).expect_err("refused").to_string();
        assert!(why.contains(said) && why.lines().count() == 1, "{why}");
    }
}

#[test]
fn a_panel_that_does_not_drive_white_is_not_asked_to() {
    let book = open(MotionPolicy::EInk);
    book.set_panel(dogleaf_ffi::PanelOptions { glr16_us: None, ..panel_options() }).expect("sound");
    rest(&book, 1);
    book.turn(true, 1).expect("a page");
    let pictures = shown(&rest(&book, 2_000));
    let last = pictures.last().expect("the page after").1;
    assert_eq!(last.waveform, Waveform::Gl16, "{pictures:?}");
}
