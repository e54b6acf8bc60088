//! The program as one calls it: help, pictures, a window, and one clear line for what cannot be done.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn fixture(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures").join(name);
    path.display().to_string()
}

fn call(args: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_dogleaf-desktop");
    Command::new(program).args(args).output().expect("the program starts")
}

fn picture(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("dogleaf-desktop-{}-{name}.png", std::process::id()))
}

#[test]
fn help_shows_examples() {
    let out = call(&["--help"]);
    let text = String::from_utf8_lossy(&out.stdout);
    assert!(out.status.success(), "help is no fault");
    assert!(text.contains("Examples:") && text.contains("--screenshot"), "{text}");
}

#[test]
fn what_cannot_be_done_is_one_line() {
    let book = fixture("books/old-verses.pdf");
    let readme = fixture("README.md");
    for (args, wanted) in [
        (vec!["nowhere.pdf"], "nowhere.pdf does not exist"),
        (vec![readme.as_str()], "is not a book"),
        (vec![book.as_str(), "--page", "900", "--screenshot", "x.png"], "there is no page 900"),
        (vec![book.as_str(), "--gesture", readme.as_str()], "README.md:1: "),
        (vec![book.as_str(), "--size", "9"], "wanted WIDTHxHEIGHT"),
        (vec![book.as_str(), "--direction", "up"], "invalid value 'up'"),
        (vec![book.as_str(), "--screenshot", "x.png", "--grip", "1000"], "handling.grip"),
        (vec![book.as_str(), "--screenshot", "x.png", "--at", "-1"], "--at: wanted 0 to 900"),
        (vec![], "required arguments"),
    ] {
        let out = call(&args);
        let text = String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(2), "{args:?}: {text}");
        assert_eq!(text.lines().count(), 1, "{args:?}: {text}");
        assert!(text.starts_with("dogleaf-desktop: ") && text.contains(wanted), "{args:?}: {text}");
    }
}

#[test]
#[ignore = "needs EGL: cargo ci desktop"]
fn a_screenshot_shows_the_gesture() {
    let (book, gesture) = (fixture("books/old-verses.cbz"), fixture("gestures/corner_turn.jsonl"));
    let shots = ["0", "0.5"].map(|at| {
        let path = picture(at);
        let name = path.display().to_string();
        let size = ["--size", "320x240"];
        let out = call(
            &[&[&book, "--screenshot", &name, "--gesture", &gesture, "--at", at], &size[..]]
                .concat(),
        );
        assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
        let shot = image::open(&path).expect("a picture").to_rgb8();
        let _ = std::fs::remove_file(&path);
        assert_eq!(shot.dimensions(), (320, 240), "as large as asked");
        shot
    });
    let moved = shots[0].pixels().zip(shots[1].pixels()).filter(|(a, b)| a != b).count();
    assert!(moved > 5000, "a leaf was lifted: {moved} pixels differ");
}

#[test]
#[ignore = "needs a display: cargo ci desktop"]
fn a_window_plays_a_gesture_and_closes() {
    let (book, gesture) = (fixture("books/old-verses.pdf"), fixture("gestures/flick.jsonl"));
    let out = call(&[&book, "--gesture", &gesture, "--size", "320x240"]);
    let text = String::from_utf8_lossy(&out.stdout);
    println!("{text}{}", String::from_utf8_lossy(&out.stderr));
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let pictures: u32 = text.split(' ').next().and_then(|n| n.parse().ok()).unwrap_or_default();
    assert!(pictures > 3, "{text}");
}
