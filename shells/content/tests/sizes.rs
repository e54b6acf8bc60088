//! Page sizes are known without drawing, the typical page gives the shape, boxes are respected.

mod common;

use common::{Scratch, encode, numbered, open, pdf_of, pdf_pages, png, stored, zip_of};
use dogleaf_content::{Picture, limits};
use image::{ImageFormat, Rgba, RgbaImage};

#[test]
fn sizes_of_pdf_pages() {
    let scratch = Scratch::new();
    let book = open(&scratch.file("a.pdf", pdf_pages(&[(200, 300), (600, 400)])));
    assert_eq!(book.page_size(0).ok(), Some((200.0, 300.0)), "in points");
    assert_eq!(book.page_size(1).ok(), Some((600.0, 400.0)), "in points");
}

#[test]
fn a_turned_and_cropped_pdf_page() {
    let scratch = Scratch::new();
    let objects = [
        b"<</Type/Catalog/Pages 2 0 R>>".to_vec(),
        b"<</Type/Pages/Kids[3 0 R]/Count 1/MediaBox[0 0 200 300]>>".to_vec(),
        b"<</Type/Page/Parent 2 0 R/Rotate 90/CropBox[10 10 110 210]>>".to_vec(),
    ];
    let book = open(&scratch.file("a.pdf", pdf_of(&objects, "")));
    assert_eq!(book.page_size(0).ok(), Some((200.0, 100.0)), "as it is looked at");
}

#[test]
fn the_typical_page_gives_the_shape() {
    let scratch = Scratch::new();
    let sizes = [(200, 300), (400, 300), (200, 300), (200, 300), (300, 200)];
    let pdf = open(&scratch.file("a.pdf", pdf_pages(&sizes)));
    assert_eq!(pdf.aspect(), 200.0 / 300.0, "two spreads do not change the shape");
    let pages: Vec<_> =
        sizes.iter().zip(1..).map(|(s, i)| (format!("{i}.png"), png(s.0, s.1, [9; 4]))).collect();
    let cbz = open(&scratch.file("a.cbz", zip_of(&pages)));
    assert_eq!(cbz.aspect(), 200.0 / 300.0, "nor in a cbz");
    assert_eq!(cbz.page_size(1).ok(), Some((400.0, 300.0)), "a spread stays one picture");
}

#[test]
fn the_box_is_filled_and_the_shape_kept() {
    let scratch = Scratch::new();
    let pdf = open(&scratch.file("a.pdf", pdf_pages(&[(200, 300)])));
    for (max, size) in [
        ((100, 1000), (100, 150)),
        ((1000, 600), (400, 600)),
        ((3000, 3000), (2000, 3000)),
        ((1, 1), (1, 1)),
        ((0, 0), (1, 1)),
    ] {
        let page = pdf.page(0, max.0, max.1).expect("a sound page");
        assert_eq!((page.width, page.height), size, "in a box of {max:?}");
        assert_eq!(page.rgba.len(), 4 * (size.0 * size.1) as usize, "in a box of {max:?}");
    }
}

#[test]
fn images_are_enlarged_twofold_at_most() {
    let scratch = Scratch::new();
    let book = open(&scratch.file("a.cbz", zip_of(&[("1.png", numbered(1))])));
    for (max, size) in [((5000, 5000), (40, 60)), ((20, 30), (20, 30)), ((10, 100), (10, 15))] {
        let page = book.page(0, max.0, max.1).expect("a sound page");
        assert_eq!((page.width, page.height), size, "in a box of {max:?}");
    }
}

#[test]
fn no_box_is_too_large() {
    let scratch = Scratch::new();
    let book = open(&scratch.file("a.pdf", pdf_pages(&[(2000, 20)])));
    let page = book.page(0, u32::MAX, u32::MAX).expect("the box is clamped");
    assert_eq!(page.width, limits::MAX_SIDE_PX, "as wide as a picture may be");
    let blank = Picture::blank(u32::MAX, 0);
    assert_eq!((blank.width, blank.height), (limits::MAX_SIDE_PX, 1), "blank leaves too");
    let blank = Picture::blank(640, 480);
    assert_eq!((blank.width, blank.height), (640, 480), "and no smaller than asked");
}

/// A JPEG, wider than high, whose camera was held sideways; with or without long metadata.
fn turned_jpeg(padding: usize) -> Vec<u8> {
    let jpeg = encode(&RgbaImage::from_pixel(40, 20, Rgba([9, 9, 9, 255])), ImageFormat::Jpeg);
    let mut exif =
        b"Exif\0\0II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0".to_vec();
    let mut out = jpeg[..2].to_vec();
    let segment = |marker: u8, bytes: &mut Vec<u8>| {
        let length = (bytes.len() as u16 + 2).to_be_bytes();
        [vec![0xff, marker, length[0], length[1]], std::mem::take(bytes)].concat()
    };
    out.extend(segment(0xe1, &mut exif));
    for _ in 0..padding {
        out.extend(segment(0xe2, &mut vec![b'p'; 60_000]));
    }
    out.extend_from_slice(&jpeg[2..]);
    out
}

#[test]
fn a_photograph_is_turned_upright() {
    let scratch = Scratch::new();
    for padding in [0, 1, 4] {
        let book = open(&scratch.file("a.cbz", stored(&[("1.jpg", turned_jpeg(padding))])));
        assert_eq!(book.page_size(0).ok(), Some((20.0, 40.0)), "{padding} segments of padding");
        let page = book.page(0, 20, 40).expect("a sound page");
        assert_eq!((page.width, page.height), (20, 40), "drawn as it was sized");
    }
}
