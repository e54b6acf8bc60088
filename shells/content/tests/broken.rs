//! Damage never panics and never passes unnoticed: a file cut anywhere is refused.

mod common;

use common::{Scratch, check_line, numbered, open, pdf_pages, png, refused, stored, zip_of};
use dogleaf_content::{Book, ContentError};
use std::path::Path;

fn check_cut(scratch: &Scratch, name: &str, whole: &[u8], lengths: impl Iterator<Item = usize>) {
    for length in lengths {
        let path = scratch.file(name, &whole[..length]);
        let error = refused(&path);
        let expected = matches!(error, ContentError::Broken { .. } | ContentError::NotABook { .. });
        assert!(expected, "{name} cut at {length} of {}: {error}", whole.len());
    }
}

#[test]
fn a_pdf_cut_anywhere() {
    let scratch = Scratch::new();
    let whole = pdf_pages(&[(200, 300), (200, 300), (200, 300)]);
    // The line's end after the end mark may well be missing.
    check_cut(&scratch, "cut.pdf", &whole, 0..whole.len() - 1);
}

#[test]
fn a_zip_cut_anywhere() {
    let scratch = Scratch::new();
    let whole = zip_of(&[("1.png", numbered(1)), ("2.png", numbered(2))]);
    check_cut(&scratch, "cut.cbz", &whole, 0..whole.len());
}

/// Opens, sizes and draws everything; whatever happens must be a fit error or a picture.
fn use_up(path: &Path) {
    let book = match Book::open(path) {
        Ok(book) => book,
        Err(error) => return check_line(&error, path),
    };
    assert!(book.aspect() > 0.0 && book.aspect().is_finite(), "aspect {}", book.aspect());
    for i in 0..book.page_count() {
        if let Err(error) = book.page_size(i) {
            check_line(&error, path);
        }
        match book.page(i, 24, 24) {
            Ok(page) => assert_eq!(page.rgba.len(), 4 * (page.width * page.height) as usize, "{i}"),
            Err(error) => check_line(&error, path),
        }
    }
}

fn use_up_flipped(name: &str, whole: &[u8]) {
    let scratch = Scratch::new();
    for at in 0..whole.len() {
        for flip in [0x01, 0x80, 0xff] {
            let mut bytes = whole.to_vec();
            bytes[at] ^= flip;
            use_up(&scratch.file(name, &bytes));
        }
    }
}

#[test]
fn a_pdf_with_any_byte_changed() {
    use_up_flipped("flipped.pdf", &pdf_pages(&[(200, 300), (40, 30)]));
}

#[test]
fn a_zip_with_any_byte_changed() {
    use_up_flipped("flipped.cbz", &zip_of(&[("1.png", numbered(1)), ("2.png", numbered(2))]));
    use_up_flipped("stored.cbz", &stored(&[("1.png", numbered(1)), ("2.png", numbered(2))]));
}

#[test]
fn noise_behind_a_sound_beginning() {
    let scratch = Scratch::new();
    let mut seed = 1_u32;
    let mut noise = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 24) as u8
    };
    for magic in [b"%PDF-1.7\n".as_slice(), b"PK\x03\x04", b"PK\x05\x06"] {
        for _ in 0..50 {
            let bytes: Vec<u8> = magic.iter().copied().chain((0..3000).map(|_| noise())).collect();
            let path = scratch.file("noise", bytes);
            assert!(Book::open(&path).is_err(), "noise is not a book");
            use_up(&path);
        }
    }
}

#[test]
fn entries_that_mean_harm() {
    let scratch = Scratch::new();
    for name in ["../1.png", "a/../../1.png", "/1.png", "..\\1.png"] {
        let zip = zip_of(&[("0.png", numbered(0)), (name, numbered(1))]);
        let error = refused(&scratch.file("a.cbz", zip));
        assert!(error.to_string().contains("leaves the archive"), "{name}: {error}");
    }
}

#[test]
fn entries_that_share_bytes() {
    let scratch = Scratch::new();
    let mut zip = zip_of(&[("1.png", png(50, 50, [1, 2, 3, 255])), ("2.png", numbered(2))]);
    let (_, directory) = common::zip_headers(&zip);
    // The second entry claims to be where the first one is.
    let first: Vec<u8> = zip[directory[0] + 42..directory[0] + 46].to_vec();
    zip.splice(directory[1] + 42..directory[1] + 46, first);
    let error = refused(&scratch.file("a.cbz", zip));
    assert!(error.to_string().contains("overlap"), "{error}");
}

#[test]
fn entries_of_one_name() {
    let scratch = Scratch::new();
    let mut zip = zip_of(&[("1.png", numbered(1)), ("2.png", numbered(2))]);
    for at in common::positions(&zip, b"2.png") {
        zip[at] = b'1';
    }
    let error = refused(&scratch.file("a.cbz", zip));
    assert!(error.to_string().contains("same name"), "{error}");
}

#[test]
fn a_name_cannot_break_the_line() {
    let scratch = Scratch::new();
    let path = scratch.path().join("two\nlines.pdf");
    let line = Book::open(&path).expect_err("there is no such file").to_string();
    assert_eq!(line.lines().count(), 1, "{line:?}");
}

#[test]
fn padding_after_the_end_is_no_damage() {
    let scratch = Scratch::new();
    let mut padded = pdf_pages(&[(200, 300)]);
    padded.extend_from_slice(&[0; 10_000]);
    assert_eq!(open(&scratch.file("padded.pdf", padded)).page_count(), 1, "zeros are padding");
}
