//! Promise: of a turn a panel is shown a few pictures that tell its direction, each in whole bytes of pixels, in two tones
//! while it moves, in greys when it rests; and none at rest.

mod support;

use dogleaf_core::scene::Direction;
use dogleaf_eink::plan::Aloft;
use dogleaf_eink::{Faces, Layout, Panel, Picture, Planner, Policy, Rect, Style, Waveform};
use support::board::Board;

const LAYOUTS: [(Layout, Direction); 4] = [
    (Layout::Spread, Direction::Ltr),
    (Layout::Spread, Direction::Rtl),
    (Layout::Right, Direction::Ltr),
    (Layout::Left, Direction::Rtl),
];

fn boards() -> impl Iterator<Item = (String, Board)> {
    let panels = [("reader", Panel::SIX_INCH), ("module", Panel::MODULE)];
    let styles = [Policy::READER, Policy::STRIPE];
    panels.into_iter().flat_map(move |(name, panel)| {
        LAYOUTS.into_iter().flat_map(move |(layout, direction)| {
            styles.into_iter().map(move |policy| {
                let said = format!("{name} {layout:?} {direction:?} {:?}", policy.style);
                let mut board = Board::new(panel, policy, layout, direction);
                board.blind = true;
                (said, board)
            })
        })
    })
}

#[test]
fn every_rectangle_is_whole_bytes_on_the_panel() {
    for (said, mut board) in boards() {
        board.turn(true);
        board.turn(false);
        for shot in &board.shots {
            let rect = shot.update.rect;
            let whole = rect.x0 % 8 == 0 && (rect.x1 % 8 == 0 || rect.x1 == board.panel.width);
            assert!(whole && !rect.is_empty(), "{said}: {rect:?}");
            assert!(board.panel.whole().holds(&rect), "{said}: {rect:?}");
        }
    }
}

#[test]
fn two_tones_while_it_moves_and_greys_at_rest() {
    for (said, mut board) in boards() {
        board.turn(true);
        let grey = board.panel.grey;
        for shot in &board.shots {
            let two = shot.update.waveform.is_two_tone();
            let wanted = shot.update.picture == Picture::Moving || !grey;
            let first = shot.update.waveform == Waveform::Gc16;
            assert!(two == wanted || first, "{said}: {:?}", shot.update);
        }
        assert!(!board.keys().is_empty(), "{said}: a turn is seen");
    }
}

/// The mean of the fore-edge goes the turn's way from each key frame to the next, and neither side is left out.
#[test]
fn key_frames_tell_the_direction() {
    for (layout, direction) in LAYOUTS {
        for key_frames in 1..=8 {
            for forward in [true, false] {
                let policy = Policy { key_frames, turn_us: 5_000_000, ..Policy::READER };
                let mut board = Board::new(Panel::SIX_INCH, policy, layout, direction);
                board.blind = true;
                board.turn(forward);
                let keys = board.keys();
                let said = format!("{layout:?} {direction:?} {key_frames} {forward}");
                assert_eq!(keys.len(), usize::from(key_frames), "{said}");
                let leftwards = forward == (direction == Direction::Ltr);
                let edges: Vec<i32> = keys.iter().map(|k| i32::from(k.edge_x)).collect();
                let inside = |x: &i32| *x > 4 && *x < i32::from(board.panel.width) - 4;
                for pair in edges.windows(2).filter(|p| p.iter().all(inside)) {
                    let way = if leftwards { pair[0] - pair[1] } else { pair[1] - pair[0] };
                    assert!(way >= 8, "{said}: {edges:?}");
                }
                let over = |p: Option<u16>| p.is_some_and(|p| p > 512);
                let passed = keys.iter().any(|k| over(k.progress));
                assert_eq!(passed, key_frames >= 2, "{said}: both sides, unless there is one");
                assert!(keys.iter().any(|k| !over(k.progress)), "{said}: the near side");
            }
        }
    }
}

#[test]
fn a_slow_panel_gets_fewer_key_frames() {
    let keys = |frame_us: u32| {
        let panel = Panel { a2_us: None, du_us: frame_us, ..Panel::SIX_INCH };
        Policy { key_frames: 12, ..Policy::READER }.keys(&panel)
    };
    let found = [50_000, 120_000, 260_000, 600_000, 2_000_000].map(keys);
    assert_eq!(found, [12, 5, 2, 1, 1], "from fast to slow");
}

#[test]
fn at_rest_nothing_is_shown() {
    let mut board = Board::reader();
    let faces = Faces::of(board.reading.book());
    for t in 0..1_000 {
        let update = board.planner.look(10_000_000 + t * 16_667, &faces, None);
        assert_eq!(update, None, "at rest");
    }
    assert!(!board.planner.owes(&faces), "nothing is owed");
    board.turn(true);
    let faces = Faces::of(board.reading.book());
    assert_eq!(board.planner.look(u64::MAX / 2, &faces, None), None, "after a turn");
}

#[test]
fn a_busy_panel_is_left_alone() {
    let mut planner = Planner::new(Panel::SIX_INCH, Policy::READER, [Rect::NONE, Rect::NONE]);
    let faces = Faces::default();
    let first = planner.look(0, &faces, None).expect("the first picture");
    assert_eq!(first.waveform, Waveform::Gc16, "nobody knows what the panel shows");
    let leaf =
        |progress| Aloft { progress, reach: Rect::new(400, 0, 800, 600), edge_x: 700, held: true };
    for t in 0..u64::from(first.busy_us) {
        if t % 10_000 == 0 {
            assert_eq!(planner.look(t, &faces, Some(&leaf(400))), None, "busy at {t}");
        }
    }
    assert!(planner.look(u64::from(first.busy_us), &faces, Some(&leaf(400))).is_some(), "free");
}

/// A finger that rests is no reason for pictures; one that goes back is followed back.
#[test]
fn a_held_leaf_is_followed_both_ways() {
    let panel = Panel::SIX_INCH;
    let pages = [Rect::new(0, 0, 400, 600), Rect::new(400, 0, 800, 600)];
    let mut planner = Planner::new(panel, Policy::READER, pages);
    let faces = Faces::default();
    let _ = planner.look(0, &faces, None);
    let mut shown = Vec::new();
    let way = (0..100).chain(std::iter::repeat_n(100, 200)).chain((0..100).rev());
    for (n, percent) in way.enumerate() {
        let progress = percent * 8;
        let edge_x = 800 - percent * 6;
        let leaf = Aloft { progress, reach: Rect::new(edge_x, 0, 800, 600), edge_x, held: true };
        if planner.look(1_000_000 + n as u64 * 16_667, &faces, Some(&leaf)).is_some() {
            shown.push((n, progress));
        }
    }
    let resting = shown.iter().filter(|(n, _)| (120..300).contains(n)).count();
    assert_eq!(resting, 0, "while the finger rests: {shown:?}");
    let [out, back] =
        [0..120, 300..400].map(|r| shown.iter().filter(|(n, _)| r.contains(n)).count());
    assert!(out >= 2 && back >= 2, "there {out}, back {back}: {shown:?}");
    let settled = planner.look(20_000_000, &faces, None).expect("the page again");
    assert!(settled.rect.holds(&Rect::new(200, 0, 800, 600)), "all that was touched: {settled:?}");
}

#[test]
fn the_panel_is_cleaned_after_so_many_pictures() {
    let mut board = Board::reader();
    board.blind = true;
    let mut since = 0;
    let mut full = 0;
    for _ in 0..20 {
        board.shots.truncate(1);
        board.turn(true);
        for shot in &board.shots[1..] {
            since += 1;
            if shot.update.waveform == Waveform::Gc16 {
                assert!(shot.update.rect == board.panel.whole(), "the whole panel");
                assert!(shot.update.picture == Picture::Settled, "never in the middle of a turn");
                (since, full) = (0, full + 1);
            }
            assert!(since <= board.policy.full_after + 12, "{since} pictures without one");
        }
    }
    assert!(full >= 3, "{full} in twenty turns");
}

/// A stripe is what the edge passed, and no more: a turn drives each pixel of the pages about once.
#[test]
fn a_stripe_changes_each_column_once() {
    let mut board = Board::new(Panel::SIX_INCH, Policy::STRIPE, Layout::Spread, Direction::Ltr);
    board.turn(true);
    let keys = board.keys();
    let area: u32 = keys.iter().map(|k| k.update.rect.area()).sum();
    let pages: u32 = board.stage.pages().iter().map(Rect::area).sum();
    assert!(area <= pages + 8 * 600 * keys.len() as u32, "{area} of {pages}");
    assert_eq!(board.policy.style, Style::Stripe, "it was asked for");
    for pair in keys.windows(2) {
        let [a, b] = [pair[0].update.rect, pair[1].update.rect];
        assert!(b.x0 < a.x0 && b.x1 <= a.x0 + 8, "{a:?} then {b:?}: onwards, no gap");
        assert!(b.x1 >= a.x0, "{a:?} then {b:?}: no column is left out");
    }
}
