//! Promise: a finger on the panel is followed as fast as the panel can, both ways; what it lets go is seen to land; and at
//! rest the panel is left alone.

mod support;

use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::scene::Direction;
use dogleaf_eink::{Faces, Layout, Panel, Picture, Policy, Pose};
use support::board::{Board, Shot};

const FRAME_US: u64 = 16_667;

/// Drags from the right page's lower outer corner to `reach` of 800 pixels and, if asked, back again; then lets go.
fn drag(board: &mut Board, reach: i32, back: bool) -> Vec<(u64, Shot)> {
    let (from, down) = (760, 540);
    let steps = 60;
    let mut seen = Vec::new();
    let mut now = 1_000_000;
    let places = (0..=steps).map(|n| from + (reach - from) * n / steps);
    let rests = std::iter::repeat_n(reach, 30);
    let returns =
        (1..=steps).map(|n| reach + (from - reach) * n / steps).take(if back { 60 } else { 0 });
    let way: Vec<i32> = places.chain(rests).chain(returns).collect();
    for (n, x) in way.iter().enumerate() {
        let phase = if n == 0 { Phase::Down } else { Phase::Move };
        touch(board, now, phase, *x, down);
        frame(board, now, true, &mut seen);
        now += FRAME_US;
    }
    touch(board, now, Phase::Up, way[way.len() - 1], down);
    for _ in 0..240 {
        now += FRAME_US;
        frame(board, now, false, &mut seen);
    }
    seen
}

fn touch(board: &mut Board, t_us: u64, phase: Phase, x: i32, y: i32) {
    let sample = Sample { t_us, id: 0, phase, x: x * 256, y: y * 256, leaves: 0 };
    board.reading.pointer(sample, &mut ()).expect("a sample");
}

fn frame(board: &mut Board, now: u64, held: bool, seen: &mut Vec<(u64, Shot)>) {
    board.reading.step(now, &mut ());
    if now < board.planner.busy_until_us() {
        return;
    }
    let shots = board.shots.len();
    board.now_us = Some(now);
    match Pose::of(board.reading.book()) {
        Some(pose) => board.key(&pose, Faces::of(board.reading.book()), held),
        None => board.rest(),
    }
    seen.extend(board.shots[shots..].iter().map(|s| (now, *s)));
}

fn board() -> Board {
    Board::new(Panel::SIX_INCH, Policy::READER, Layout::Spread, Direction::Ltr)
}

#[test]
fn a_drag_turns_the_page() {
    let mut board = board();
    let before = board.reading.page();
    let seen = drag(&mut board, 120, false);
    assert_eq!(board.reading.page(), before + 2, "it was turned");
    let keys = seen.iter().filter(|(_, s)| s.update.picture == Picture::Moving).count();
    assert!((3..=8).contains(&keys), "{keys} key frames");
    let (_, last) = seen.last().expect("pictures");
    assert_eq!(last.update.picture, Picture::Settled, "the page after is the last picture");
    let (ideal, told): (Vec<u8>, Vec<u8>) = (board.ideal(), board.glass().told().collect());
    assert!(ideal == told, "and it is exact");
}

#[test]
fn a_drag_that_goes_back_leaves_the_page() {
    let mut board = board();
    let before = board.reading.page();
    let seen = drag(&mut board, 420, true);
    assert_eq!(board.reading.page(), before, "it was put back");
    let ways: Vec<u16> = seen.iter().filter_map(|(_, s)| s.progress).collect();
    let most = ways.iter().max().copied().unwrap_or(0);
    assert!(most > 250 && *ways.last().expect("one") < most, "followed there and back: {ways:?}");
    let (ideal, told): (Vec<u8>, Vec<u8>) = (board.ideal(), board.glass().told().collect());
    assert!(ideal == told, "the page before, exact");
}

/// Pictures are only started on a panel that is done with the one before, and none while nothing moves.
#[test]
fn the_panel_is_never_hurried_and_rests() {
    let mut board = board();
    let seen = drag(&mut board, 120, false);
    for pair in seen.windows(2) {
        let [(a, first), (b, _)] = [pair[0], pair[1]];
        assert!(b - a >= u64::from(first.update.busy_us), "{a} then {b}");
    }
    let mut more = Vec::new();
    for n in 0..600 {
        frame(&mut board, 20_000_000 + n * FRAME_US, false, &mut more);
    }
    assert!(more.is_empty(), "{} pictures in ten seconds of rest", more.len());
    assert!(!board.reading.needs_frame() || board.reading.book().leaf().is_none(), "at rest");
}

/// A leaf is taken up while the panel is still busy with the page before, and thrown over at once: key frames may be lost,
/// the page after is not.
#[test]
fn a_turn_on_a_busy_panel_still_ends_exact() {
    let mut board = board();
    let _ = drag(&mut board, 120, false);
    let before = board.reading.page();
    let busy = board.planner.busy_until_us();
    let mut seen = Vec::new();
    let mut now = busy.max(6_100_000);
    // A key is pressed in the middle of the full refresh of a panel that lost its picture.
    board.planner.forget();
    frame(&mut board, now, false, &mut seen);
    assert_eq!(seen.len(), 1, "the page again");
    board.reading.turn(true, 1).expect("a page");
    for _ in 0..300 {
        now += FRAME_US;
        frame(&mut board, now, false, &mut seen);
    }
    assert_eq!(board.reading.page(), before + 2, "it was turned");
    assert_eq!(seen.last().map(|(_, s)| s.update.picture), Some(Picture::Settled), "{seen:?}");
    let (ideal, told): (Vec<u8>, Vec<u8>) = (board.ideal(), board.glass().told().collect());
    assert!(ideal == told, "the page after, exact");
}
