//! Promise: the pictures of a session with the built-in book change only when somebody says so. The firmware says the
//! same lines on every board (`cargo ci eink`). A reader at rest draws nothing.

use dogleaf_eink::simulated::Cell;
use dogleaf_eink::{Print, Simulated};
use dogleaf_eink_reader::desk::{Desk, Part, Shot, Watch};
use dogleaf_eink_reader::line::{Text, told};
use dogleaf_eink_reader::{Built, Room, scene};
use dogleaf_tests::golden::compare;
use std::fmt::Write as _;

/// Notes every picture.
#[derive(Default)]
struct Notes {
    lines: String,
    pictures: Vec<(u64, Vec<u8>)>,
    slept_us: u64,
}

impl Watch for Notes {
    fn part(&mut self, _: Part) {}
    fn shot(&mut self, shot: &Shot, glass: &Simulated<'_>) {
        let mut text = Text::EMPTY;
        told(&mut text, shot, glass);
        writeln!(self.lines, "{}", text.as_str()).expect("a text takes every line");
        self.pictures.push((shot.at_us, glass.looks().collect()));
    }
    fn sleep(&mut self, us: u64) {
        self.slept_us += us;
    }
}

/// Plays the session; its end, and the ten seconds after it.
fn session() -> (Notes, Notes, u32) {
    let stage = scene::stage().expect("the scene's own stage");
    let print = Built::open(scene::PAGES).expect("the scene's own pages");
    let mut cells = vec![Cell::NEW; 800 * 600];
    let glass = Simulated::new(scene::PANEL, &mut cells).expect("as many pixels as it has");
    let mut room = Box::new(Room::EMPTY);
    let setup = scene::setup(&stage);
    let mut desk = Desk::open(&mut room, glass, print, stage, &setup).expect("a sound scene");
    let (mut moving, mut resting) = (Notes::default(), Notes::default());
    let mut touches = scene::touches();
    desk.run(&mut touches, scene::END_US, &mut moving);
    desk.run(&mut touches, scene::END_US + scene::REST_US, &mut resting);
    let page = desk.room().reading.page();
    (moving, resting, page)
}

#[test]
fn pictures_are_golden_and_none_is_drawn_at_rest() {
    let (moving, resting, page) = session();
    if let Some(folder) = std::env::var_os("DOGLEAF_EINK_OUT") {
        show(folder.as_ref(), &moving.pictures);
    }
    assert_eq!(resting.lines, "", "at rest nothing is drawn");
    assert!(resting.slept_us >= scene::REST_US, "it slept for the ten seconds");
    assert_eq!(page, scene::book().open_at, "there, back, and not turned");
    if let Err(difference) = compare("eink.txt", &moving.lines) {
        panic!("{difference}");
    }
}

#[test]
fn the_built_in_pages_are_as_large_as_the_stage_wants_and_hold_print() {
    let print = Built::open(scene::PAGES).expect("the scene's own pages");
    let size = scene::stage().expect("the scene's own stage").page();
    assert_eq!(print.size(), size);
    let ink = |page| {
        let cells = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y)));
        cells.filter(|&(x, y)| print.luma(page, x, y) < 128).count()
    };
    assert!((13..17).all(|page| ink(page) > 2_000), "verse on every page");
    assert_eq!([ink(12), ink(17)], [0, 0], "no other pages");
    assert!(scene::PAGES.len() <= 100_000, "{} bytes", scene::PAGES.len());
}

#[test]
fn pages_cut_short_are_blank_and_nothing_worse() {
    for end in (0..scene::PAGES.len()).step_by(997) {
        let Some(print) = Built::open(&scene::PAGES[..end]) else { continue };
        for (x, y) in [(0, 0), (200, 300), (399, 599), (u16::MAX, u16::MAX)] {
            for page in 12..18 {
                let _ = print.luma(page, x, y);
            }
        }
    }
    assert!(Built::open(b"DLP2aaaaaaaaaaaaaaa").is_none(), "another layout");
}

/// Every picture as a file, for the eye.
fn show(folder: &std::path::Path, pictures: &[(u64, Vec<u8>)]) {
    std::fs::create_dir_all(folder).expect("a folder");
    for (n, (at_us, looks)) in pictures.iter().enumerate() {
        let mut file = b"P5 800 600 255\n".to_vec();
        file.extend(looks);
        let name = folder.join(format!("{n:02}-{}ms.pgm", at_us / 1_000));
        std::fs::write(name, file).expect("a picture");
    }
}
