//! Promise: one recorded gesture gives one state hash, through whatever language it was played. The table written here
//! is what the other languages' tests compare with.

mod common;

use common::{book, gesture, play};
use dogleaf_ffi::Notice;
use std::fmt::Write as _;
use std::path::Path;

const GESTURES: [&str; 5] = ["slow_turn", "corner_turn", "flick", "peek_and_put_back", "stack"];

#[test]
fn the_same_hashes_as_in_every_language() {
    let mut table = String::from("gesture frames page commits hash\n");
    for name in GESTURES {
        let book = book();
        let (frames, told) = play(&book, &gesture(name));
        let commits = told.iter().filter(|n| matches!(n, Notice::Committed { .. })).count();
        let page = book.page().expect("open");
        let hash = book.state_hash().expect("open");
        let _ = writeln!(table, "{name} {frames} {page} {commits} {hash:016x}");
    }
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/golden/bindings.txt");
    if std::env::var_os("DOGLEAF_BLESS").is_some() {
        std::fs::write(&file, &table).expect("the table can be written");
    }
    let golden = std::fs::read_to_string(&file).unwrap_or_default();
    assert_eq!(table, golden, "the table moved; see fixtures/README.md");
}
