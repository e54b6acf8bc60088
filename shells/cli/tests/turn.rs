//! `turn`: books in, animations out, figures as the contract says.

mod common;

use common::{arg, fixture, folder, refused, told};
use serde_json::Value;

/// A turn in a small picture, which is drawn fast.
fn turn(book: &str, out: &str, more: &[&str]) -> Value {
    let args = ["turn", book, "-o", out, "--size", "96x72", "--json"];
    let text = told(&[&args, more].concat());
    assert_eq!(text.lines().count(), 1, "one object");
    serde_json::from_str(&text).expect("JSON")
}

/// A short gesture: few frames to draw.
fn flick() -> String {
    fixture("gestures/flick.jsonl")
}

#[test]
fn a_pdf_turns_into_a_webp_with_its_figures() {
    let out = arg(&folder("turn_pdf"), "out.webp");
    let found = turn(&fixture("books/old-verses.pdf"), &out, &[]);
    let keys: Vec<&String> = found.as_object().expect("an object").keys().collect();
    let wanted = ["committed_page", "out", "simulated", "step_us", "steps", "stretch"];
    assert_eq!(keys, wanted, "exactly these, here by letter");
    assert_eq!(
        (&found["committed_page"], &found["out"]),
        (&10.into(), &out.clone().into()),
        "ends"
    );
    assert!(found["steps"].as_u64() > Some(72), "{found}");
    assert!(found["step_us"]["median"].as_f64() > Some(0.0), "{found}");
    assert!(found["step_us"]["p99"].as_f64() >= found["step_us"]["median"].as_f64(), "{found}");
    let stretch = |name: &str| found["stretch"][name].as_f64().expect("a number");
    let (rms, mean, max) = (stretch("rms"), stretch("avg_max"), stretch("max"));
    assert!(0.0 < rms && rms < mean && mean < max && max < 0.2, "{found}");
    assert!(found["simulated"].as_array().is_some_and(|s| s[0] == "leaf"), "{found}");
    let bytes = std::fs::read(out).expect("a file");
    assert_eq!((&bytes[..4], &bytes[8..12]), (&b"RIFF"[..], &b"WEBP"[..]), "a WebP");
    its_mirror_image(&found);
}

/// Right to left is left to right in a mirror.
fn its_mirror_image(ltr: &Value) {
    let out = arg(&folder("turn_rtl"), "rtl.png");
    let rtl = turn(&fixture("books/old-verses.pdf"), &out, &["--direction", "rtl"]);
    assert_eq!(ltr["steps"], rtl["steps"], "as many steps");
    assert_eq!(ltr["committed_page"], rtl["committed_page"], "the same page");
    for name in ["max", "avg_max", "rms"] {
        let [a, b] = [ltr, &rtl].map(|f| f["stretch"][name].as_f64().expect("a number"));
        assert!((a - b).abs() < 1e-4, "{name}: {a} and {b}");
    }
}

#[test]
fn an_archive_turns_and_then_a_folder() {
    let here = folder("turn_folder");
    let frames = arg(&here, "frames");
    turn(&fixture("books/old-verses.cbz"), &frames, &["--gesture", &flick()]);
    assert!(here.join("frames/frame_0000.png").is_file(), "pictures");
    let gif = arg(&here, "out.gif");
    let found = turn(&frames, &gif, &["--gesture", &flick(), "--page", "1"]);
    assert!(std::fs::read(gif).expect("a file").starts_with(b"GIF89a"), "a GIF");
    assert_eq!(found["committed_page"], 2, "from the first page");
}

#[test]
fn what_is_put_back_commits_nothing() {
    let out = arg(&folder("turn_peek"), "out.webp");
    let peek = fixture("gestures/peek_and_put_back.jsonl");
    let book = fixture("books/old-verses.pdf");
    let found = turn(&book, &out, &["--gesture", &peek, "--fidelity", "fine"]);
    assert!(found["committed_page"].is_null(), "{found}");
}

#[test]
fn a_bookmark_is_sewn_in_only_where_it_is_asked_for() {
    let (book, gesture) = (fixture("books/old-verses.pdf"), flick());
    let out = arg(&folder("turn_ribbon"), "out.png");
    let found = turn(&book, &out, &["--gesture", &gesture, "--ribbon"]);
    let ribbon = found["ribbon"].as_object().expect("what it cost");
    assert!(ribbon["steps"].as_u64() > Some(10), "{found}");
    assert!(ribbon["newton_steps"].as_f64() > Some(0.5), "{found}");
    assert_eq!(ribbon["lies"], "between leaves on the left", "the leaf came to lie on it");
    assert!(found["simulated"].as_array().is_some_and(|s| s.contains(&"ribbon".into())), "{found}");
    let without = turn(&book, &out, &["--gesture", &gesture]);
    assert!(without.get("ribbon").is_none(), "{without}");
    for same in ["steps", "stretch", "committed_page"] {
        assert_eq!(found[same], without[same], "the book does not notice it");
    }
}

#[test]
fn a_bookmark_beyond_the_book_is_refused() {
    let out = arg(&folder("turn_ribbon_beyond"), "out.png");
    let book = fixture("books/old-verses.pdf");
    let (line, code) = refused(&["turn", &book, "-o", &out, "--ribbon=9999"]);
    assert_eq!(code, 2, "bad input");
    assert!(line.contains("--ribbon=9999: the last page is"), "{line}");
}
