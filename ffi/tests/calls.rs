//! Promise: every method does what it says, also on a book that is closed, paused or asked for nonsense.

mod common;

use common::{FRAME_US, book, gesture, options, play};
use dogleaf_ffi::{
    Book, BookOptions, Direction, DogleafError, Gaze, Layout, Motion, MotionPolicy, Notice, Paper,
    Phase, PieceFace, PointerSample, StepStatus, Surface, version,
};

fn ends(told: &[Notice]) -> usize {
    let end = |n: &&Notice| matches!(n, Notice::Committed { .. } | Notice::Cancelled);
    told.iter().filter(end).count()
}

fn refused(options: &BookOptions, word: &str) {
    let why = Book::open(options).expect_err("refused").to_string();
    assert!(why.contains(word), "{why} names {word}");
}

#[test]
fn a_turn_commits_exactly_once() {
    let book = book();
    let (_, told) = play(&book, &gesture("slow_turn"));
    assert_eq!(ends(&told), 1, "{told:?}");
    assert!(told.contains(&Notice::Committed { page: 122 }), "{told:?}");
    assert!(told.contains(&Notice::Announce { page: 122, pages: 320 }), "{told:?}");
    assert_eq!(book.page(), Ok(122));
    assert_eq!(book.pages(), Ok(320));
    assert!((book.progress().expect("open") - 61.0 / 160.0).abs() < 1e-9, "61 of 160 leaves");
    assert_eq!(book.is_sleeping(), Ok(true));
    let still = book.step(900_000_000).expect("open");
    assert!(!still.draw && !still.needs_frame, "asleep is asleep");
    assert_eq!(still.status, StepStatus::Asleep);
}

#[test]
fn what_is_put_back_cancels_exactly_once() {
    let book = book();
    let (_, told) = play(&book, &gesture("peek_and_put_back"));
    assert_eq!(ends(&told), 1, "{told:?}");
    assert!(told.contains(&Notice::Cancelled), "{told:?}");
    assert_eq!(book.page(), Ok(120));
}

#[test]
fn a_key_turns_and_a_busy_book_refuses() {
    let book = book();
    book.turn(true, 1).expect("there are pages");
    book.step(FRAME_US).expect("open");
    assert_eq!(book.turn(true, 1), Err(DogleafError::Busy));
    assert_eq!(book.start_recording(), Err(DogleafError::Busy));
    let (_, told) = play(&book, &[]);
    assert_eq!(ends(&told), 1, "{told:?}");
    assert_eq!(book.page(), Ok(122));
    let first = Book::open(&BookOptions { open_at: 0, ..options() }).expect("sound");
    assert_eq!(first.turn(false, 1), Err(DogleafError::NoSuchPage));
}

#[test]
fn skip_lays_the_leaf_at_once() {
    let book = book();
    let mut now = 0;
    for sample in gesture("slow_turn") {
        book.pointer(&sample).expect("in order");
        while now < sample.time_us {
            now += FRAME_US;
            book.step(now).expect("open");
        }
    }
    assert_eq!(book.is_sleeping(), Ok(false), "just let go");
    book.skip().expect("open");
    assert_eq!(book.is_sleeping(), Ok(true));
    assert_eq!(ends(&book.notices().expect("open")), 1, "one end");
}

#[test]
fn motion_is_kept_and_bad_caps_are_refused() {
    let book = book();
    let motion = Motion { policy: MotionPolicy::Reduced, cap_us: Some(400_000) };
    book.set_motion(motion).expect("a sound cap");
    assert_eq!(book.motion(), Ok(motion));
    let bad = Motion { policy: MotionPolicy::Full, cap_us: Some(1) };
    assert!(matches!(book.set_motion(bad), Err(DogleafError::Refused(_))), "1 µs is no cap");
    assert_eq!(book.motion(), Ok(motion), "unchanged");
}

#[test]
fn bad_options_are_refused_by_name() {
    refused(&BookOptions { pages: 0, ..options() }, "book.pages");
    refused(&BookOptions { width_m: f64::NAN, ..options() }, "book.width_m");
    refused(&BookOptions { width_px: 0, ..options() }, "view");
    refused(&BookOptions { grip: -1.0, ..options() }, "grip");
    refused(&BookOptions { step_us: 1, ..options() }, "step_us");
    let paper =
        Paper::Custom { areal_mass_gsm: 80.0, thickness_mm: 0.1, youngs_gpa: -4.0, poisson: 0.2 };
    refused(&BookOptions { paper, ..options() }, "youngs_gpa");
}

#[test]
fn bad_samples_are_refused_and_the_book_goes_on() {
    let book = book();
    let at = |x| PointerSample { time_us: 1, id: 0, phase: Phase::Down, x, y: 5.0, leaves: 0 };
    for x in [f32::NAN, f32::INFINITY] {
        assert!(matches!(book.pointer(&at(x)), Err(DogleafError::Pointer(_))), "{x}");
    }
    book.pointer(&at(1e30)).expect("far away is somewhere");
    assert!(book.step(FRAME_US).is_ok(), "it goes on");
}

#[test]
fn the_mesh_stays_where_it_is() {
    let book = book();
    let before = book.mesh().expect("open");
    let indices = book.indices().expect("open");
    assert_eq!(before.byte_len, u64::from(before.vertices) * u64::from(before.stride));
    assert_eq!(before.stride, 32);
    assert_eq!(indices.byte_len, 2 * u64::from(indices.indices));
    assert_eq!(before.generation, 1, "there at once");
    play(&book, &gesture("slow_turn"));
    let snapshot = book.snapshot().expect("open");
    book.restore(snapshot).expect("its own");
    let after = book.mesh().expect("open");
    assert!(after.generation > 60, "made anew while the leaf moved: {}", after.generation);
    assert_eq!((before.address, before.byte_len), (after.address, after.byte_len));
    assert_eq!(book.indices(), Ok(indices));
}

#[test]
fn pieces_say_what_they_show_and_change_seldom() {
    let book = book();
    let pieces = book.pieces().expect("open");
    let top = |s| pieces.iter().find(|p| p.surface == s && !p.flying).expect("a top");
    assert_eq!(top(Surface::LeftTop).face, PieceFace::Page { page: 119 });
    assert_eq!(top(Surface::RightTop).face, PieceFace::Page { page: 120 });
    assert_eq!(top(Surface::LeftSides).leaves, 60);
    assert!(!top(Surface::LeafUp).visible, "nothing is in the air");
    let count = book.indices().expect("open").indices;
    assert!(pieces.iter().all(|p| p.first_index + p.index_count <= count), "inside the buffer");
    let first = book.step(FRAME_US).expect("open").pieces_generation;
    book.turn(true, 1).expect("a page");
    let mut changes = 0;
    let mut last = first;
    for frame in 2..400 {
        let info = book.step(frame * FRAME_US).expect("open");
        changes += u32::from(info.pieces_generation != last);
        last = info.pieces_generation;
        let pieces = book.pieces().expect("open");
        if let Some(up) =
            pieces.iter().find(|p| p.surface == Surface::LeafUp && p.visible && !p.flying)
        {
            assert_eq!((up.face, up.reverse), (PieceFace::Page { page: 120 }, Some(121)));
        }
    }
    assert!((2..6).contains(&changes), "taken up and laid: {changes}");
}

#[test]
fn looking_from_elsewhere_draws_anew() {
    let book = book();
    let table = book.stage().expect("open");
    assert_eq!((table.view_projection.len(), table.eye.len()), (16, 3));
    book.step(FRAME_US).expect("open");
    book.look(Gaze::Above, 1000, 700).expect("a sound view");
    let above = book.stage().expect("open");
    assert_ne!(table.view_projection, above.view_projection);
    assert_eq!((above.width_px, above.height_px), (1000, 700));
    assert!(book.step(2 * FRAME_US).expect("open").draw, "from elsewhere it looks otherwise");
    book.resize(500, 900).expect("a sound size");
    assert_eq!(book.stage().expect("open").eye[2], 0.0, "still from above");
    assert!(matches!(book.resize(0, 9), Err(DogleafError::Refused(_))), "no pixels");
    book.redraw().expect("open");
    assert_eq!(book.needs_frame(), Ok(true));
}

#[test]
fn a_paused_book_rests_and_goes_on() {
    let book = book();
    book.turn(true, 1).expect("a page");
    book.step(FRAME_US).expect("open");
    book.pause().expect("open");
    assert_eq!(book.is_sleeping(), Ok(true));
    assert_eq!(book.turn(true, 1), Err(DogleafError::Paused));
    book.step(2 * FRAME_US).expect("open");
    assert_eq!(book.needs_frame(), Ok(false));
    book.resume().expect("open");
    let (_, told) = play(&book, &gesture("slow_turn"));
    assert!(ends(&told) >= 1, "{told:?}");
}

#[test]
fn a_snapshot_opens_the_same_book() {
    let rtl = BookOptions { direction: Direction::Rtl, layout: Layout::Single, ..options() };
    let book = Book::open(&rtl).expect("sound");
    book.turn(true, 1).expect("a page");
    play(&book, &[]);
    let bytes = book.snapshot().expect("open");
    let again = Book::from_snapshot(bytes.clone()).expect("its own");
    assert_eq!(again.page(), book.page());
    assert_eq!(again.stage(), book.stage());
    let hash = again.state_hash();
    book.restore(bytes.clone()).expect("its own");
    assert_eq!(book.state_hash(), hash);
    for cut in 0..bytes.len() {
        let bad = book.restore(bytes[..cut].to_vec());
        assert!(matches!(bad, Err(DogleafError::Recording(_))), "{cut} bytes");
    }
    assert_eq!(book.state_hash(), hash, "nothing was changed");
}

#[test]
fn a_recording_replays() {
    use dogleaf_core::record::{Reader, replay};
    let book = book();
    play(&book, &gesture("flick"));
    book.start_recording().expect("at rest");
    book.turn(true, 1).expect("a page");
    for frame in 1..300 {
        book.step(900_000_000 + frame * FRAME_US).expect("open");
    }
    let hash = book.state_hash().expect("open");
    let bytes = book.stop_recording().expect("a recording");
    assert!(matches!(book.stop_recording(), Err(DogleafError::Recording(_))), "only one");
    let reader = Reader::open(&bytes).expect("a sound recording");
    let mut other = Box::new(dogleaf_core::Book::<f32, dogleaf_core::grid::G11x8>::EMPTY);
    let verdict = replay(&reader, &mut other).expect("it fits");
    assert_eq!(verdict.diverged, None);
    assert_eq!(verdict.final_hash, hash);
    assert!(verdict.steps > 30, "{} steps", verdict.steps);
}

#[test]
fn a_closed_book_refuses_everything() {
    let book = book();
    let mesh = book.mesh().expect("open");
    book.shut();
    book.shut();
    let closed = DogleafError::Closed;
    let sample = PointerSample { time_us: 0, id: 0, phase: Phase::Down, x: 1.0, y: 1.0, leaves: 0 };
    let motion = Motion { policy: MotionPolicy::Full, cap_us: None };
    let calls: [Result<(), DogleafError>; 28] = [
        book.pointer(&sample),
        book.pointers(vec![sample]),
        book.step(1).map(drop),
        book.mesh().map(drop),
        book.indices().map(drop),
        book.pieces().map(drop),
        book.notices().map(drop),
        book.stage().map(drop),
        book.needs_frame().map(drop),
        book.turn(true, 1),
        book.skip(),
        book.motion().map(drop),
        book.set_motion(motion),
        book.look(Gaze::Above, 9, 9),
        book.resize(9, 9),
        book.redraw(),
        book.pause(),
        book.resume(),
        book.snapshot().map(drop),
        book.restore(Vec::new()),
        book.page().map(drop),
        book.pages().map(drop),
        book.progress().map(drop),
        book.state_hash().map(drop),
        book.is_sleeping().map(drop),
        book.start_recording(),
        book.stop_recording().map(drop),
        Err(DogleafError::Closed),
    ];
    for (n, call) in calls.iter().enumerate() {
        assert_eq!(call.as_ref(), Err(&closed), "call {n}");
    }
    assert_ne!(mesh.address, 0, "and its mesh is still there");
    assert_eq!(version(), env!("CARGO_PKG_VERSION"));
}
