//! Pages are opaque, on white paper, and scaled so that print stays print.

mod common;

use common::{Scratch, encode, open, pdf_page, pdf_pages, stored};
use dogleaf_content::{Book, Picture};
use image::{ImageFormat, Rgba, RgbaImage};

fn book_of(scratch: &Scratch, image: &RgbaImage, format: ImageFormat) -> Book {
    open(&scratch.file("a.cbz", stored(&[("1.png", encode(image, format))])))
}

fn page_of(image: &RgbaImage, format: ImageFormat, max: u32) -> Picture {
    book_of(&Scratch::new(), image, format).page(0, max, max).expect("a sound page")
}

fn is_opaque(page: &Picture) -> bool {
    page.rgba.chunks_exact(4).all(|p| p[3] == 255)
}

#[test]
fn every_format_is_read() {
    let image = RgbaImage::from_pixel(16, 24, Rgba([200, 40, 90, 255]));
    use ImageFormat::{Gif, Jpeg, Png, WebP};
    for format in [Png, Jpeg, WebP, Gif] {
        let page = page_of(&image, format, 24);
        assert_eq!((page.width, page.height), (16, 24), "{format:?}");
        let found = page.pixel(8, 12).expect("inside");
        let near = found.iter().zip([200, 40, 90, 255]).all(|(a, b)| a.abs_diff(b) <= 3);
        assert!(near, "{format:?} became {found:?}");
        assert!(is_opaque(&page), "{format:?}");
    }
}

#[test]
fn white_lies_beneath() {
    let mut image = RgbaImage::from_pixel(8, 8, Rgba([255, 0, 0, 0]));
    image.put_pixel(1, 1, Rgba([0, 0, 0, 128]));
    image.put_pixel(2, 2, Rgba([10, 20, 30, 255]));
    let page = page_of(&image, ImageFormat::Png, 8);
    assert_eq!(page.pixel(0, 0), Some([255; 4]), "clear is white, whatever colour it hides");
    assert_eq!(page.pixel(1, 1), Some([127, 127, 127, 255]), "half black is grey");
    assert_eq!(page.pixel(2, 2), Some([10, 20, 30, 255]), "opaque is itself");
    assert!(is_opaque(&page), "all of it");
}

#[test]
fn hidden_colours_do_not_bleed_when_scaled() {
    let image = RgbaImage::from_pixel(64, 64, Rgba([255, 0, 0, 0]));
    let page = page_of(&image, ImageFormat::Png, 7);
    assert!(page.rgba.iter().all(|&b| b == 255), "red under full transparency came through");
}

#[test]
fn a_pdf_is_on_white() {
    let scratch = Scratch::new();
    let book = open(&scratch.file("a.pdf", pdf_pages(&[(200, 300)])));
    let page = book.page(0, 200, 300).expect("a sound page");
    assert_eq!(page.pixel(50, 250), Some([255, 0, 0, 255]), "painted, and the foot is below");
    assert_eq!(page.pixel(150, 50), Some([255; 4]), "bare paper");
    assert!(is_opaque(&page), "all of it");
}

#[test]
fn a_pdf_may_leave_its_fonts_to_us() {
    let scratch = Scratch::new();
    let font = "/Font<</F<</Type/Font/Subtype/Type1/BaseFont/Times-Roman>>>>";
    let text = b"BT /F 60 Tf 20 150 Td (mmmm) Tj ET";
    let book = open(&scratch.file("a.pdf", pdf_page(font, text, &[])));
    let page = book.page(0, 200, 300).expect("a sound page");
    let dark = page.rgba.chunks_exact(4).filter(|p| p[0] < 100).count();
    assert!(dark > 500, "only {dark} dark pixels: the print is missing");
}

#[test]
fn flat_stays_flat_and_fine_print_becomes_grey() {
    let flat = RgbaImage::from_pixel(300, 300, Rgba([120, 130, 140, 255]));
    // One black pixel in two: half grey, at any ratio, without a pattern of its own.
    let fine = RgbaImage::from_fn(1200, 1200, |x, y| {
        let v = if (x + y) % 2 == 0 { 0 } else { 255 };
        Rgba([v, v, v, 255])
    });
    for max in [7, 31, 97, 150, 299] {
        let page = page_of(&flat, ImageFormat::Png, max);
        let even = page.rgba.chunks_exact(4).all(|p| p == [120, 130, 140, 255]);
        assert!(even, "flat colour changed at {max}");
        let page = page_of(&fine, ImageFormat::Png, max);
        let grey = page.rgba.chunks_exact(4).all(|p| p[0].abs_diff(127) <= 12);
        assert!(grey, "fine print shows a pattern at {max}");
    }
}

#[test]
fn an_edge_stays_where_it_was() {
    let image = RgbaImage::from_fn(1000, 500, |x, _| {
        let v = if x < 500 { 0 } else { 255 };
        Rgba([v, v, v, 255])
    });
    for max in [100, 200, 333, 2000] {
        let page = page_of(&image, ImageFormat::Png, max);
        let (row, width) = (page.height / 2, f64::from(page.width));
        let ink: f64 = (0..page.width)
            .filter_map(|x| page.pixel(x, row))
            .map(|p| 1.0 - f64::from(p[0]) / 255.0)
            .sum();
        let off = (ink - width / 2.0).abs();
        assert!(off < 0.6, "the edge moved by {off} pixels at {max}");
    }
}

#[test]
fn blank_leaves_are_white() {
    let blank = Picture::blank(3, 2);
    assert_eq!(blank.rgba, [255; 24], "bare paper");
    assert_eq!(blank.pixel(3, 0), None, "outside to the right");
    assert_eq!(blank.pixel(0, 2), None, "outside below");
}
