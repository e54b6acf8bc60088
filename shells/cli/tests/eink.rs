//! `eink`: the plan of a turn on electronic paper, and its pictures.

mod common;

use common::{arg, fixture, folder, refused, told};
use serde_json::Value;

fn plan(more: &[&str]) -> Value {
    let book = fixture("books/old-verses.pdf");
    let text = told(&[&["eink", &book, "--json"], more].concat());
    serde_json::from_str(&text).expect("one object")
}

fn pictures(plan: &Value) -> Vec<(String, String)> {
    let text = |v: &Value| v.as_str().expect("a word").to_owned();
    let all = plan["pictures"].as_array().expect("a list").iter();
    all.map(|p| (text(&p["picture"]), text(&p["waveform"]))).collect()
}

#[test]
fn a_turn_is_a_few_pictures_and_then_the_page() {
    let out = arg(&folder("eink"), "strip.png");
    let found = plan(&["-o", &out]);
    let words = pictures(&found);
    let words: Vec<_> = words.iter().map(|(a, b)| (a.as_str(), b.as_str())).collect();
    let wanted = [
        ("page", "GC16"),
        ("turn", "DU"),
        ("turn", "A2"),
        ("turn", "A2"),
        ("turn", "A2"),
        ("page", "GLR16"),
    ];
    assert_eq!(words, wanted, "from the page before to the page after");
    let bytes = std::fs::read(out).expect("a file");
    assert_eq!(&bytes[1..4], b"PNG", "a strip");
    let side = |n: usize| u32::from_be_bytes(bytes[n..n + 4].try_into().expect("four"));
    assert_eq!([side(16), side(20)], [3 * 408 + 8, 2 * 308 + 8], "six pictures in two rows");
    let last = found["pictures"].as_array().and_then(|p| p.last()).expect("a page");
    assert!(last["ghost_worst"].as_u64() <= Some(10), "{last}");
}

#[test]
fn a_module_shows_one_picture_and_a_stripe_is_narrow() {
    let found = plan(&["--panel", "module", "--layout", "single"]);
    assert_eq!(found["pictures"][0]["rect"], serde_json::json!([0, 0, 800, 480]), "its own size");
    assert_eq!(pictures(&found).len(), 4, "{found}");
    let stripes = plan(&["--style", "stripe", "--direction", "rtl"]);
    let driven = |p: &Value| p["driven_px"].as_u64().expect("a number");
    assert!(driven(&stripes) < driven(&plan(&["--direction", "rtl"])), "{stripes}");
}

#[test]
fn bad_calls_are_refused_in_one_line() {
    let book = fixture("books/old-verses.pdf");
    for (args, said) in [
        (["eink", &book, "--size", "20x20"], "write it as 800x600"),
        (["eink", &book, "--key-frames", "0"], "1..=12"),
        (["eink", &book, "--page", "999"], "999"),
        (["eink", "no.pdf", "--style", "leaf"], "no.pdf"),
    ] {
        let (line, code) = refused(&args);
        assert_eq!(code, 2, "{line}");
        assert!(line.contains(said), "{args:?}: {line}");
    }
}
