//! Promise: no half erased trail. After a turn the panel was told the pages exactly; what it looks like differs by no more
//! than its waveforms leave, and never by a leaf that was drawn and not taken away.

mod support;

use dogleaf_core::scene::Direction;
use dogleaf_eink::{Layout, Panel, Picture, Policy, Rect, Sheet, Update};
use support::board::Board;

/// What a page looks like at worst on a panel that drives white anew; and on one that does not, of 255.
const CLEAN: u8 = 10;
const WITHOUT: u8 = 33;

fn told(board: &mut Board) -> Vec<u8> {
    board.glass().told().collect()
}

#[test]
fn the_page_after_is_exact() {
    for (layout, direction) in [
        (Layout::Spread, Direction::Ltr),
        (Layout::Spread, Direction::Rtl),
        (Layout::Right, Direction::Ltr),
        (Layout::Left, Direction::Rtl),
    ] {
        for policy in [Policy::READER, Policy::STRIPE] {
            let mut board = Board::new(Panel::SIX_INCH, policy, layout, direction);
            for forward in [true, true, false] {
                board.turn(forward);
                let (ideal, told) = (board.ideal(), told(&mut board));
                let wrong = ideal.iter().zip(&told).filter(|(a, b)| a != b).count();
                assert_eq!(wrong, 0, "{layout:?} {direction:?} {:?}: pixels", policy.style);
            }
        }
    }
}

#[test]
fn what_is_left_is_what_the_waveform_leaves() {
    for (panel, most) in
        [(Panel::SIX_INCH, CLEAN), (Panel { glr16_us: None, ..Panel::SIX_INCH }, WITHOUT)]
    {
        for policy in [Policy::READER, Policy::STRIPE] {
            let mut board = Board::new(panel, policy, Layout::Spread, Direction::Ltr);
            for _ in 0..12 {
                board.turn(true);
                let ghost = board.glass().ghost();
                assert!(ghost.worst <= most, "{:?} {ghost:?}", policy.style);
            }
        }
    }
}

/// While it moves: the leaf before is gone, up to the ghost of a fast picture.
#[test]
fn the_leaf_before_is_taken_away() {
    let mut board = Board::reader();
    for _ in 0..6 {
        board.turn(true);
    }
    for shot in board.shots.iter().filter(|s| s.update.picture == Picture::Moving) {
        assert!(shot.ghost.worst <= WITHOUT + 8, "{:?} {:?}", shot.update, shot.ghost);
    }
}

/// Controls: a planner that forgets what was there, and one that takes the fast waveform from the start, are seen.
#[test]
fn the_measure_sees_trails() {
    let forgets = |update: Update, sheet: Option<&Sheet>| match sheet {
        Some(sheet) => Update { rect: sheet.reach().aligned(800), ..update },
        None => Update { rect: Rect::new(0, 0, 400, 600), ..update },
    };
    let mut board = Board::reader();
    board.spoil = forgets;
    board.turn(true);
    let (ideal, told) = (board.ideal(), told(&mut board));
    let wrong = ideal.iter().zip(&told).filter(|(a, b)| a.abs_diff(**b) > 4).count();
    assert!(wrong > 10_000, "{wrong} pixels of a leaf that was not taken away");

    let hurried = |update: Update, _: Option<&Sheet>| match update.picture {
        Picture::Moving => Update { waveform: dogleaf_eink::Waveform::A2, ..update },
        Picture::Settled => update,
    };
    let mut board = Board::reader();
    board.spoil = hurried;
    board.turn(true);
    let worst = board.shots.iter().map(|s| s.ghost.worst).max().unwrap_or(0);
    assert!(worst > WITHOUT + 8, "{worst}: the fast waveform from greys");
}
