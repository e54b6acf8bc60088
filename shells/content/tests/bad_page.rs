//! One bad page is an error of that page alone; a book of nothing but bad pages is refused.

mod common;

use common::{Scratch, check_line, number_of, numbered, open, pdf_of, refused, stream, zip_of};
use dogleaf_content::{Book, ContentError};
use std::path::Path;

fn check_only_bad(book: &Book, path: &Path, bad: usize) {
    for i in 0..book.page_count() {
        match book.page(i, 30, 30) {
            Ok(_) => assert_ne!(i, bad, "the bad page was drawn"),
            Err(error) => {
                assert_eq!(i, bad, "a sound page was lost: {error}");
                let page = i + 1;
                assert!(
                    matches!(error, ContentError::BadPage { page: p, .. } if p == page),
                    "{error}"
                );
                check_line(&error, path);
            }
        }
    }
}

/// What may go by the name of an image.
fn bad_images() -> Vec<(&'static str, Vec<u8>)> {
    let cut = numbered(2)[..50].to_vec();
    vec![
        ("2.png", b"not an image at all".to_vec()),
        ("2.jpg", Vec::new()),
        ("2.gif", b"GIF89a".to_vec()),
        ("2.webp", b"RIFF\x10\0\0\0WEBPVP8 ".to_vec()),
        ("2.png", cut),
        ("2.avif", b"\0\0\0\x1cftypavif".to_vec()),
        ("2.bmp", b"BM\x3a\0\0\0\0\0\0\0".to_vec()),
    ]
}

#[test]
fn in_a_cbz_and_in_a_folder() {
    for (name, bytes) in bad_images() {
        let scratch = Scratch::new();
        let entries = [("1.png", numbered(1)), (name, bytes.clone()), ("3.png", numbered(3))];
        let cbz = scratch.file("a.cbz", zip_of(&entries));
        for (name, bytes) in &entries {
            scratch.file(&format!("folder/{name}"), bytes);
        }
        for path in [cbz, scratch.path().join("folder")] {
            let book = open(&path);
            assert_eq!(book.page_count(), 3, "a bad page keeps its place");
            check_only_bad(&book, &path, 1);
            let last = book.page(2, 30, 30).expect("page 3 is sound");
            assert_eq!(number_of(&last), 3, "pages after the bad one keep their number");
            let error = book.page(1, 30, 30).expect_err("page 2 is bad");
            assert!(error.to_string().contains(name), "which image was it? {error}");
        }
    }
}

#[test]
fn packed_bytes_that_do_not_match_their_checksum() {
    let scratch = Scratch::new();
    let mut zip = zip_of(&[("1.png", numbered(1)), ("2.png", numbered(2)), ("3.png", numbered(3))]);
    let (local, directory) = common::zip_headers(&zip);
    zip[local[1] + 14] ^= 1;
    zip[directory[1] + 16] ^= 1;
    let path = scratch.file("a.cbz", zip);
    check_only_bad(&open(&path), &path, 1);
}

#[test]
fn in_a_pdf() {
    let scratch = Scratch::new();
    let page = |contents: u32, size: &str| {
        let text = format!(
            "<</Type/Page/Parent 2 0 R/MediaBox[0 0 {size}]/Contents {contents} 0 R/Resources<<>>>>"
        );
        text.into_bytes()
    };
    for (bad, size) in [
        (stream("/Filter/JPXDecode", b"these are no pixels"), "200 300"),
        (b"null".to_vec(), "200 300"),
        (stream("", b"0 0 1 1 re f"), "1 30000"),
    ] {
        let objects = [
            b"<</Type/Catalog/Pages 2 0 R>>".to_vec(),
            b"<</Type/Pages/Kids[3 0 R 4 0 R 3 0 R 5 0 R]/Count 3>>".to_vec(),
            page(6, "200 300"),
            page(7, size),
            page(6, "200 300"),
            stream("", b"0 0 10 10 re f"),
            bad,
        ];
        let path = scratch.file("a.pdf", pdf_of(&objects, ""));
        check_only_bad(&open(&path), &path, 1);
    }
}

#[test]
fn nothing_but_bad_pages() {
    let scratch = Scratch::new();
    let path = scratch.file("a.cbz", zip_of(&[("1.png", "no image"), ("2.png", "nor this")]));
    let error = refused(&path);
    assert!(matches!(error, ContentError::Broken { .. }), "{error}");
    assert!(error.to_string().contains("1.png"), "{error}");
}

#[test]
fn pages_beyond_the_last() {
    let scratch = Scratch::new();
    let path = scratch.file("a.cbz", zip_of(&[("1.png", numbered(1))]));
    let book = open(&path);
    for i in [1, 2, usize::MAX] {
        let error = book.page(i, 10, 10).expect_err("there is one page");
        assert!(matches!(error, ContentError::NoSuchPage { last: 1, .. }), "{error}");
        check_line(&error, &path);
        assert!(book.page_size(i).is_err(), "page {i} has no size");
    }
}
