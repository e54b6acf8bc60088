//! Pages come in the order a reader means, and the litter of other programs is not among them.

mod common;

use common::{Scratch, numbered, numbers, open, zip_of};

/// Names in the order in which the pages are meant.
const NAMES: [&str; 8] =
    ["1.png", "2.PNG", "9.png", "10.png", "010a.png", "Page 1.png", "page 2.png", "page 10.png"];

const LITTER: [&str; 9] = [
    ".DS_Store",
    "Thumbs.db",
    "desktop.ini",
    "._1.png",
    ".cover.png",
    "ComicInfo.xml",
    "readme.txt",
    "png",
    "0.png.part",
];

fn entries() -> Vec<(String, Vec<u8>)> {
    let pages = NAMES.iter().zip(1..).map(|(name, i)| ((*name).to_owned(), numbered(i)));
    let litter = LITTER.iter().map(|name| ((*name).to_owned(), numbered(99)));
    let mut all: Vec<_> = litter.chain(pages).collect();
    all.reverse();
    all
}

#[test]
fn in_a_cbz() {
    let scratch = Scratch::new();
    let mut all = entries();
    all.push(("__MACOSX/1.png".into(), numbered(99)));
    all.push(("__MACOSX/sub/._2.png".into(), numbered(99)));
    all.push(("folder.png/".into(), Vec::new()));
    let book = open(&scratch.file("a.cbz", zip_of(&all)));
    assert_eq!(numbers(&book), [1, 2, 3, 4, 5, 6, 7, 8], "wrong order or litter");
}

#[test]
fn in_a_folder() {
    let scratch = Scratch::new();
    for (name, bytes) in entries() {
        scratch.file(&format!("folder/{name}"), bytes);
    }
    scratch.file("folder/inner.png/0.png", numbered(99));
    let book = open(&scratch.path().join("folder"));
    assert_eq!(numbers(&book), [1, 2, 3, 4, 5, 6, 7, 8], "wrong order or litter");
}

#[test]
fn chapters_of_a_cbz() {
    let scratch = Scratch::new();
    let names = ["ch 2/1.png", "ch 2/2.png", "ch 10/1.png", "ch 10/10.png", "ch 10 extra/1.png"];
    let mut all: Vec<_> = names.iter().zip(1..).map(|(name, i)| (*name, numbered(i))).collect();
    all.rotate_left(2);
    let book = open(&scratch.file("a.cbz", zip_of(&all)));
    assert_eq!(numbers(&book), [1, 2, 3, 4, 5], "chapters out of order");
}
