//! What a file is, is read from its first bytes; what is no book is refused with a word on what it is.

mod common;

use common::{Scratch, numbered, open, pdf_pages, png, refused, zip_of};
use dogleaf_content::{BookKind, ContentError};

#[test]
fn names_do_not_decide() {
    let scratch = Scratch::new();
    let pdf = pdf_pages(&[(200, 300)]);
    let cbz = zip_of(&[("1.png", numbered(1))]);
    for name in ["a.pdf", "a.cbz", "a.txt", "a"] {
        assert_eq!(open(&scratch.file(name, &pdf)).kind(), BookKind::Pdf, "a pdf called {name}");
        assert_eq!(open(&scratch.file(name, &cbz)).kind(), BookKind::Cbz, "a cbz called {name}");
    }
    scratch.file("folder.pdf/1.png", numbered(1));
    assert_eq!(open(&scratch.path().join("folder.pdf")).kind(), BookKind::Folder, "a folder");
}

#[test]
fn a_pdf_header_may_come_late() {
    let scratch = Scratch::new();
    let late = [b"\xef\xbb\xbf\n".to_vec(), pdf_pages(&[(200, 300)])].concat();
    assert_eq!(
        open(&scratch.file("late.pdf", late)).page_count(),
        1,
        "a byte order mark before it"
    );
}

#[test]
fn what_is_no_book_is_named() {
    let scratch = Scratch::new();
    let image = png(4, 4, [0; 4]);
    let cases: [(&str, &[u8], &str); 8] = [
        ("text.pdf", b"Dear reader, this is only a letter.\n", "no known kind"),
        ("text.cbz", b"PKnot a zip", "no known kind"),
        ("page.html.pdf", b"<!DOCTYPE html><html></html>", "no known kind"),
        ("empty.pdf", b"", "empty file"),
        ("comic.cbz", b"Rar!\x1a\x07\x01\x00", "rar"),
        ("comic7.cbz", b"7z\xbc\xaf\x27\x1c\x00\x04", "7z"),
        ("print.pdf", b"%!PS-Adobe-3.0\n", "postscript"),
        ("photo.png", &image, "single image"),
    ];
    for (name, bytes, word) in cases {
        let error = refused(&scratch.file(name, bytes));
        assert!(matches!(error, ContentError::NotABook { .. }), "{name}: {error}");
        assert!(error.to_string().contains(word), "{name} lacks {word:?}: {error}");
    }
}

#[test]
fn zips_that_are_something_else() {
    let scratch = Scratch::new();
    for mark in ["mimetype", "META-INF/container.xml", "[Content_Types].xml"] {
        let zip = zip_of(&[(mark, b"x".to_vec()), ("images/1.png", numbered(1))]);
        let error = refused(&scratch.file("book.cbz", zip));
        assert!(matches!(error, ContentError::NotABook { .. }), "{mark}: {error}");
    }
}

#[test]
fn nothing_there() {
    let scratch = Scratch::new();
    let error = refused(&scratch.path().join("gone.pdf"));
    assert!(matches!(error, ContentError::Missing { .. }), "{error}");
}

#[cfg(unix)]
#[test]
fn a_device_is_not_read() {
    let error = refused("/dev/zero".as_ref());
    assert!(error.to_string().contains("device"), "{error}");
}

#[test]
fn no_pages() {
    let scratch = Scratch::new();
    scratch.file("folder/notes.txt", b"no images here");
    scratch.file("folder/inner/1.png", numbered(1));
    scratch.file("folder/.hidden.png", numbered(1));
    let empty_zip = scratch.file("empty.cbz", zip_of::<&str, &[u8]>(&[]));
    let text_zip = scratch.file("text.cbz", zip_of(&[("a.txt", "a"), ("b/", "")]));
    let pdf = scratch.file("empty.pdf", pdf_pages(&[]));
    for path in [scratch.path().join("folder"), empty_zip, text_zip, pdf] {
        let error = refused(&path);
        assert!(matches!(error, ContentError::Empty { .. }), "{error}");
    }
}

#[test]
fn titles() {
    let scratch = Scratch::new();
    let plain = scratch.file("My Novel.pdf", pdf_pages(&[(200, 300)]));
    assert_eq!(open(&plain).title(), "My Novel", "the file's name serves");
    let mut objects = vec![b"<</Type/Catalog/Pages 2 0 R>>".to_vec()];
    objects.push(b"<</Type/Pages/Kids[3 0 R]/Count 1/MediaBox[0 0 9 9]>>".to_vec());
    objects.push(b"<</Type/Page/Parent 2 0 R>>".to_vec());
    objects.push(b"<</Title(The Real\\nTitle)>>".to_vec());
    let titled = scratch.file("x.pdf", common::pdf_of(&objects, "/Info 4 0 R"));
    assert_eq!(open(&titled).title(), "The Real\u{fffd}Title", "the pdf's own title, on one line");
    scratch.file("Vol. 2/1.png", numbered(1));
    assert_eq!(open(&scratch.path().join("Vol. 2")).title(), "Vol. 2", "a folder has no ending");
}
