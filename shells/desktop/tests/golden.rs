//! Promise: the reference picture that other languages' renderers are held to is what the software renderer draws.
//! `DOGLEAF_BLESS=1` writes `fixtures/pictures` anew.

mod reference;
mod support;

use dogleaf_content::Picture;
use dogleaf_desktop::BookView;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use reference::{Apart, Sheets, apart, keep, picture, sheets};
use std::fs;
use std::path::{Path, PathBuf};
use support::{FRAME_US, book, fixture, options, play, samples};

/// How far what is kept may be from what is drawn now, in 1/255, on the mean and for 99 of 100 bytes: what another
/// machine's arithmetic may change. Reached: 0 and 0.
const MEAN: f64 = 0.5;
const MOST: u8 = 4;
/// The gesture, and the moment of it: a leaf upright, light behind it.
const GESTURE: &str = "corner_turn";
const UNTIL_US: u64 = 750_000;
/// Size of the picture, pixels: of the view's shape.
const SIZE: [u32; 2] = [640, 480];
/// Most pixels a page picture has across and down.
const TEXELS: [u32; 2] = [512, 512];
/// Bytes of the folder at most.
const ROOM: u64 = 600_000;

fn folder() -> PathBuf {
    fixture("pictures/upright")
}

fn sheet(page: u32) -> PathBuf {
    folder().join(format!("page-{page}.png"))
}

fn at(until_us: u64) -> BookView {
    let mut view = BookView::open(book(), &options(), || ()).expect("a sound book");
    play(&mut view, &samples(&format!("{GESTURE}.jsonl")), until_us);
    view
}

/// What another language needs to come to the same moment.
fn scene(view: &BookView, sheets: &Sheets) -> String {
    let setup = view.setup();
    let word = |name: &dyn std::fmt::Debug| format!("{name:?}").to_lowercase();
    let pages: Vec<String> = sheets.keys().map(ToString::to_string).collect();
    let lines = [
        ("pages", setup.book.pages.to_string()),
        ("open_at", setup.book.open_at.to_string()),
        ("width_m", setup.book.width_m.to_string()),
        ("height_m", setup.book.height_m.to_string()),
        ("cover", word(&setup.book.cover)),
        ("direction", word(&setup.book.direction)),
        ("paper", "book".to_owned()),
        ("thickness_mm", setup.paper.thickness_mm.to_string()),
        ("layout", word(&setup.handling.pages)),
        ("fidelity", word(&setup.fidelity)),
        ("grip", setup.handling.grip.to_string()),
        ("step_us", setup.world.step_us.to_string()),
        ("view_px", format!("{} {}", setup.view.width_px, setup.view.height_px)),
        ("gesture", GESTURE.to_owned()),
        ("frame_us", FRAME_US.to_string()),
        ("until_us", UNTIL_US.to_string()),
        ("state", format!("{:016x}", view.reading().book().state_hash())),
        ("picture_px", format!("{} {}", SIZE[0], SIZE[1])),
        ("page_pngs", pages.join(" ")),
    ];
    lines.iter().map(|(key, value)| format!("{key} = {value}\n")).collect()
}

fn write(path: &Path, bytes: &[u8], [width, height]: [u32; 2]) {
    let file = fs::File::create(path).expect("a place for the picture");
    let encoder = PngEncoder::new_with_quality(file, CompressionType::Best, FilterType::Adaptive);
    encoder.write_image(bytes, width, height, ExtendedColorType::Rgb8).expect("a picture");
}

fn read(path: &Path) -> Picture {
    let image = image::open(path).expect("a picture that is kept").into_rgba8();
    let (width, height) = image.dimensions();
    Picture { width, height, rgba: image.into_raw() }
}

fn rgb(picture: &Picture) -> Vec<u8> {
    picture.rgba.chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect()
}

fn fresh(found: Apart) -> bool {
    found.mean <= MEAN && found.most <= MOST
}

fn bless() {
    let _ = fs::remove_dir_all(folder());
    fs::create_dir_all(folder()).expect("a place for the pictures");
    let mut view = at(UNTIL_US);
    let sheets = sheets(&mut view, &book(), TEXELS);
    for (page, made) in &sheets {
        write(&sheet(*page), &rgb(made), [made.width, made.height]);
    }
    write(&folder().join("reference.png"), &picture(&mut view, &sheets, SIZE), SIZE);
    fs::write(folder().join("scene.txt"), scene(&view, &sheets)).expect("a place for the scene");
}

#[test]
fn the_reference_that_is_kept_is_drawn_now() {
    if std::env::var_os("DOGLEAF_BLESS").is_some() {
        bless();
    }
    let mut view = at(UNTIL_US);
    let made = sheets(&mut view, &book(), TEXELS);
    let scene_kept = fs::read_to_string(folder().join("scene.txt")).unwrap_or_default();
    assert_eq!(scene(&view, &made), scene_kept, "the moment moved; see fixtures/README.md");
    let kept: Sheets = made.keys().map(|page| (*page, read(&sheet(*page)))).collect();
    for (page, now) in &made {
        let found = apart(&rgb(now), &kept[page].rgba);
        assert!(fresh(found), "page {page} moved: {found:?}");
    }
    let wanted = read(&folder().join("reference.png"));
    let now = picture(&mut view, &kept, SIZE);
    keep("kept.png", SIZE, &wanted.rgba);
    let found = apart(&now, &wanted.rgba);
    println!("reference: {found:?}");
    assert!(fresh(found), "the picture moved: {found:?}; see fixtures/README.md");
    // The measure would notice: three frames later it is another picture.
    let later = apart(&picture(&mut at(UNTIL_US + 3 * FRAME_US), &kept, SIZE), &wanted.rgba);
    println!("three frames later: {later:?}");
    assert!(!fresh(later), "three frames later and still {later:?}");
    let files = fs::read_dir(folder()).expect("the pictures").flatten();
    let bytes: u64 = files.filter_map(|f| f.metadata().ok()).map(|m| m.len()).sum();
    assert!(bytes <= ROOM, "{bytes} bytes of pictures");
}
