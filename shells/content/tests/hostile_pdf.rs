//! A PDF page that asks for more than a page may is refused as that page, before it is drawn.

mod common;

use common::{Scratch, check_line, open, pdf_page, stream};

fn check_refused(name: &str, bytes: &[u8], word: &str) {
    let scratch = Scratch::new();
    let path = scratch.file(name, bytes);
    let error = open(&path).page(0, 60, 90).expect_err("it asks for too much");
    check_line(&error, &path);
    assert!(error.to_string().contains(word), "{name}: {error}");
}

#[test]
fn images_that_claim_to_be_huge() {
    for (side, filter) in [(60_000, ""), (2_000_000_000, ""), (60_000, "/Filter/CCITTFaxDecode")] {
        for kind in
            ["/ImageMask true/BitsPerComponent 1", "/ColorSpace/DeviceRGB/BitsPerComponent 8"]
        {
            let dict =
                format!("/Type/XObject/Subtype/Image/Width {side}/Height {side}{kind}{filter}");
            let contents = b"200 0 0 300 0 0 cm /I Do";
            let pdf = pdf_page("/XObject<</I 5 0 R>>", contents, &[stream(&dict, b"few")]);
            check_refused("image.pdf", &pdf, "too many pixels");
        }
    }
}

#[test]
fn masks_that_claim_to_be_huge() {
    let image = "/Type/XObject/Subtype/Image/Width 1/Height 1/ColorSpace/DeviceGray\
        /BitsPerComponent 8/SMask 6 0 R";
    let mask = "/Type/XObject/Subtype/Image/Width 99999/Height 99999/ColorSpace/DeviceGray\
        /BitsPerComponent 8";
    let further = [stream(image, b"\0"), stream(mask, b"\0")];
    let pdf = pdf_page("/XObject<</I 5 0 R>>", b"/I Do", &further);
    check_refused("mask.pdf", &pdf, "too many pixels");
}

#[test]
fn an_inline_image_that_claims_to_be_huge() {
    let contents = b"BI /W 90000 /H 90000 /BPC 8 /CS /G ID xx EI";
    check_refused("inline.pdf", &pdf_page("", contents, &[]), "too many pixels");
}

#[test]
fn dashes_without_end() {
    for dash in ["[0.00001 0.00001] 0", "[-1 1] 0", "[0.0000001] 0"] {
        let contents = format!("{dash} d 0 0 m 200 300 l S");
        check_refused("dash.pdf", &pdf_page("", contents.as_bytes(), &[]), "too many drawing");
    }
}

#[test]
fn tiles_without_end() {
    let tile = "/Type/Pattern/PatternType 1/PaintType 1/TilingType 1/BBox[0 0 1000 1000]\
        /XStep 0.01/YStep 0.01/Resources<<>>";
    let contents = b"/Pattern cs /P scn 0 0 200 300 re f";
    let pdf = pdf_page("/Pattern<</P 5 0 R>>", contents, &[stream(tile, b"0 0 1 1 re f")]);
    check_refused("tile.pdf", &pdf, "too many drawing");
}

#[test]
fn forms_that_name_the_next_one_thrice() {
    let form = |next: usize| {
        let dict = format!(
            "/Type/XObject/Subtype/Form/BBox[0 0 9 9]/Resources<</XObject<</I {next} 0 R>>>>"
        );
        stream(&dict, b"/I Do /I Do /I Do")
    };
    let forms: Vec<_> = (0..40).map(|i| form(6 + i)).collect();
    let pdf = pdf_page("/XObject<</I 5 0 R>>", b"/I Do", &forms);
    check_refused("forms.pdf", &pdf, "too many drawing");
}

#[test]
fn a_heavy_tile_under_many_paths() {
    let tile = "/Type/Pattern/PatternType 1/PaintType 1/TilingType 1/BBox[0 0 9 9]\
        /XStep 9/YStep 9/Resources<<>>";
    let tile = stream(tile, &b"0 0 5 5 re f ".repeat(10_000));
    let contents = [b"/Pattern cs /P scn ".to_vec(), b"0 0 200 300 re f ".repeat(1000)].concat();
    let pdf = pdf_page("/Pattern<</P 5 0 R>>", &contents, &[tile]);
    check_refused("tiles.pdf", &pdf, "too many drawing");
}

#[test]
fn rich_pages_are_drawn() {
    let scratch = Scratch::new();
    let tile = "/Type/Pattern/PatternType 1/PaintType 1/TilingType 1/BBox[0 0 9 9]\
        /XStep 9/YStep 9/Resources<<>>";
    let hatch = [b"/Pattern cs /P scn ".to_vec(), b"9 9 20 20 re f ".repeat(2000)].concat();
    let hatched = pdf_page("/Pattern<</P 5 0 R>>", &hatch, &[stream(tile, b"0 0 5 5 re f")]);
    let soft = "/ExtGState<</M<</SMask<</S/Alpha/G 5 0 R>>>>>>";
    let group = "/Type/XObject/Subtype/Form/BBox[0 0 200 300]/Group<</S/Transparency>>";
    let masked = [b"/M gs ".to_vec(), b"9 9 20 20 re f ".repeat(2000)].concat();
    let masked = pdf_page(soft, &masked, &[stream(group, b"0 0 200 300 re f")]);
    let map = pdf_page("", &b"9 9 m 50 60 l 70 20 l h f ".repeat(100_000), &[]);
    for (i, bytes) in [hatched, masked, map].iter().enumerate() {
        let book = open(&scratch.file("a.pdf", bytes));
        let page = book.page(0, 60, 90).unwrap_or_else(|e| panic!("case {i}: {e}"));
        assert!(page.rgba.iter().any(|&b| b < 128), "case {i} has no ink");
    }
}

#[test]
fn what_only_looks_dangerous_is_drawn() {
    let scratch = Scratch::new();
    let deep = [vec![b'['; 100_000], vec![b']'; 100_000]].concat();
    let saves = b"q ".repeat(200_000);
    let itself = stream(
        "/Type/XObject/Subtype/Form/BBox[0 0 9 9]/Resources<</XObject<</I 5 0 R>>>>",
        b"/I Do /I Do",
    );
    let tile = stream(
        "/Type/Pattern/PatternType 1/PaintType 1/TilingType 1/BBox[0 0 9 9]/XStep 9/YStep 9\
        /Resources<<>>",
        b"0 0 5 5 re f",
    );
    let cases = [
        pdf_page("", &deep, &[]),
        pdf_page("", &saves, &[]),
        pdf_page("/XObject<</I 5 0 R>>", b"/I Do", &[itself]),
        pdf_page("/Pattern<</P 5 0 R>>", b"/Pattern cs /P scn 0 0 200 300 re f", &[tile]),
        pdf_page("", b"[3 1] 0 d 0 0 m 200 300 l S", &[]),
    ];
    for (i, bytes) in cases.iter().enumerate() {
        let book = open(&scratch.file("a.pdf", bytes));
        assert!(book.page(0, 60, 90).is_ok(), "case {i} is harmless");
    }
}
