//! Caps hold before memory is taken, on what is really there and not on what headers claim.

mod common;

use common::{Scratch, check_line, numbered, open, png, refused, stored, zip_headers, zip_of};
use dogleaf_content::{ContentError, limits};
use std::fs::File;
use std::path::Path;

fn check_too_large(path: &Path) {
    let error = refused(path);
    assert!(matches!(error, ContentError::TooLarge { .. }), "{error}");
}

/// A sound little PNG and then nothing but zeros.
fn padded_png(bytes: usize) -> Vec<u8> {
    let mut bomb = numbered(7);
    bomb.resize(bytes, 0);
    bomb
}

/// The second page of this archive is a bomb: neither its size nor its picture is to be had, and
/// the first page is there all the same.
fn check_second_refused(zip: Vec<u8>) {
    let scratch = Scratch::new();
    let path = scratch.file("a.cbz", zip);
    let book = open(&path);
    assert!(book.page(0, 10, 10).is_ok(), "the sound page is there");
    let error = book.page(1, 10, 10).expect_err("a bomb");
    check_line(&error, &path);
    assert!(matches!(error, ContentError::BadPage { page: 2, .. }), "{error}");
}

#[test]
fn an_entry_that_inflates_a_thousandfold() {
    let zip = zip_of(&[("1.png", numbered(1)), ("2.png", padded_png(4 << 20))]);
    assert!(zip.len() < 20_000, "it is small, as bombs are");
    check_second_refused(zip);
}

#[test]
fn a_book_that_is_one_bomb() {
    let scratch = Scratch::new();
    let path = scratch.file("a.cbz", zip_of(&[("1.png", padded_png(4 << 20))]));
    let error = refused(&path);
    assert!(error.to_string().contains("inflates"), "{error}");
}

#[test]
fn an_entry_that_lies_about_its_size() {
    for claim in [0_u32, 100, 90_000] {
        let mut zip = zip_of(&[("1.png", numbered(1)), ("2.png", padded_png(4 << 20))]);
        let (local, directory) = zip_headers(&zip);
        zip[local[1] + 22..local[1] + 26].copy_from_slice(&claim.to_le_bytes());
        zip[directory[1] + 24..directory[1] + 28].copy_from_slice(&claim.to_le_bytes());
        check_second_refused(zip);
    }
}

#[test]
fn an_entry_over_64_mib() {
    let big = padded_png(limits::MAX_PICTURE_BYTES as usize + 1);
    check_second_refused(stored(&[("1.png", numbered(1)), ("2.png", big)]));
}

#[test]
fn a_file_over_64_mib_in_a_folder() {
    let scratch = Scratch::new();
    scratch.file("folder/1.png", numbered(1));
    let path = scratch.file("folder/2.png", numbered(2));
    let file = File::options().write(true).open(path).expect("writable");
    file.set_len(limits::MAX_PICTURE_BYTES + 1).expect("a sparse file");
    let folder = scratch.path().join("folder");
    let error = open(&folder).page(1, 10, 10).expect_err("too large");
    check_line(&error, &folder);
    assert!(error.to_string().contains("64 MiB"), "{error}");
}

#[test]
fn a_pdf_over_512_mib() {
    let scratch = Scratch::new();
    let path = scratch.file("a.pdf", b"%PDF-1.7\n");
    let file = File::options().write(true).open(&path).expect("writable");
    file.set_len(limits::MAX_PDF_BYTES + 1).expect("a sparse file");
    check_too_large(&path);
}

#[test]
fn a_pdf_of_10001_pages() {
    let scratch = Scratch::new();
    check_too_large(&scratch.file("a.pdf", common::pdf_pages(&vec![(200, 300); 10_001])));
}

#[test]
fn an_archive_of_20001_entries() {
    let scratch = Scratch::new();
    let page = numbered(1);
    let entries = |n: usize| -> Vec<_> { (0..n).map(|i| (format!("{i}.png"), &page)).collect() };
    let zip = |n: usize| stored(&entries(n));
    let path = scratch.file("a.cbz", zip(limits::MAX_ENTRIES));
    assert_eq!(open(&path).page_count(), limits::MAX_ENTRIES, "20,000 are allowed");
    let path = scratch.file("b.cbz", zip(limits::MAX_ENTRIES + 1));
    check_too_large(&path);
}

#[test]
fn an_archive_with_an_endless_directory() {
    let scratch = Scratch::new();
    let name = |i: usize| format!("{i:05}{}.png", "n".repeat(1000));
    let entries: Vec<_> = (0..10_000).map(|i| (name(i), "")).collect();
    check_too_large(&scratch.file("a.cbz", stored(&entries)));
}

#[test]
fn a_folder_of_20001_files() {
    let scratch = Scratch::new();
    let page = scratch.file("folder/0.png", numbered(1));
    for i in 1..=limits::MAX_ENTRIES {
        let link = page.with_file_name(format!("{i}.png"));
        std::fs::hard_link(&page, &link).or_else(|_| File::create(&link).map(drop)).expect("room");
    }
    check_too_large(&scratch.path().join("folder"));
}

fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |crc, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |c, _| (c >> 1) ^ (0xedb8_8320 & (c & 1).wrapping_neg()))
    })
}

/// A PNG that claims to be of this size and is sound otherwise.
fn claiming_png(width: u32, height: u32) -> Vec<u8> {
    let mut bytes = png(1, 1, [0, 0, 0, 255]);
    bytes[16..20].copy_from_slice(&width.to_be_bytes());
    bytes[20..24].copy_from_slice(&height.to_be_bytes());
    let crc = crc32(&bytes[12..29]);
    bytes[29..33].copy_from_slice(&crc.to_be_bytes());
    bytes
}

fn claiming_gif(width: u16, height: u16) -> Vec<u8> {
    let (w, h) = (width.to_le_bytes(), height.to_le_bytes());
    let tail = [0x80, 0, 0, 0, 0, 0, 255, 255, 255, 0x2c, 0, 0, 0, 0];
    [b"GIF89a".as_slice(), &w, &h, &tail, &w, &h, &[0, 2, 2, 0x4c, 1, 0, 0x3b]].concat()
}

/// The heads of a lossless and of an extended WebP.
fn claiming_webp(width: u32, height: u32) -> Vec<u8> {
    let bits = ((width - 1) | ((height - 1) << 14)).to_le_bytes();
    [b"RIFF\x18\0\0\0WEBPVP8L\x0c\0\0\0\x2f".as_slice(), &bits, &[0; 7]].concat()
}

#[test]
fn images_that_claim_to_be_huge() {
    let scratch = Scratch::new();
    let claims = [
        ("2.png", claiming_png(100_000, 100_000)),
        ("2.png", claiming_png(u32::MAX, u32::MAX)),
        ("2.png", claiming_png(limits::MAX_SIDE_PX + 1, 100)),
        ("2.png", claiming_png(16_000, 16_000)),
        ("2.gif", claiming_gif(65_535, 65_535)),
        ("2.gif", claiming_gif(8_001, 8_000)),
        ("2.webp", claiming_webp(16_383, 16_383)),
    ];
    for (i, (name, bytes)) in claims.into_iter().enumerate() {
        let path = scratch.file("a.cbz", zip_of(&[("1.png", numbered(1)), (name, bytes)]));
        let book = open(&path);
        for error in [book.page_size(1).err(), book.page(1, 10, 10).err()] {
            let error = error.expect("so many pixels are refused");
            check_line(&error, &path);
            assert!(error.to_string().contains("too many"), "claim {i}: {error}");
        }
    }
}

#[test]
fn an_image_as_large_as_allowed_is_no_claim() {
    let scratch = Scratch::new();
    let path = scratch.file("a.cbz", zip_of(&[("1.png", claiming_png(8_000, 8_000))]));
    assert_eq!(open(&path).page_size(0).ok(), Some((8_000.0, 8_000.0)), "64 megapixels");
    assert!(open(&path).page(0, 10, 10).is_err(), "its pixels are missing all the same");
}
