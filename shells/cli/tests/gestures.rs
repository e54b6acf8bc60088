//! The gestures of `fixtures/` are what the program makes; with `DOGLEAF_BLESS=1` they are made anew.

mod common;

use common::{fixture, folder, told};

#[test]
fn fixtures_are_as_made() {
    let bless = std::env::var_os("DOGLEAF_BLESS").is_some_and(|v| v == "1");
    let made = folder("gestures");
    told(&["gestures", made.to_str().expect("a path")]);
    let mut seen = 0;
    for entry in std::fs::read_dir(&made).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().and_then(|n| n.to_str()).expect("a name").to_owned();
        let kept = fixture(&format!("gestures/{name}"));
        let made = std::fs::read_to_string(&path).expect("text");
        if bless {
            std::fs::write(&kept, &made).expect("written");
        }
        let kept = std::fs::read_to_string(&kept).unwrap_or_default();
        assert!(kept == made, "{name} differs: run this test with DOGLEAF_BLESS=1");
        seen += 1;
    }
    assert_eq!(seen, 8, "gestures");
}
