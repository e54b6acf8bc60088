//! Locked books are refused as locked, not as broken.

mod common;

use common::{Scratch, numbered, pdf_of, refused, stream, zip_headers, zip_of};
use dogleaf_content::ContentError;
use std::path::Path;

fn check_locked(path: &Path) {
    let error = refused(path);
    assert!(matches!(error, ContentError::PasswordProtected { .. }), "{error}");
    assert!(error.to_string().contains("is password-protected"), "{error}");
}

fn locked_pdf(trailer: &str) -> Vec<u8> {
    let objects = [
        b"<</Type/Catalog/Pages 2 0 R>>".to_vec(),
        b"<</Type/Pages/Kids[3 0 R]/Count 1>>".to_vec(),
        b"<</Type/Page/Parent 2 0 R/MediaBox[0 0 200 300]/Contents 4 0 R>>".to_vec(),
        stream("", b"0 0 10 10 re f"),
    ];
    pdf_of(&objects, trailer)
}

fn standard(version: &str) -> String {
    let (owner, user) = ("ab".repeat(32), "cd".repeat(32));
    format!("/Encrypt<</Filter/Standard{version}/O<{owner}>/U<{user}>/P -4>>")
}

#[test]
fn pdf_with_a_password() {
    let scratch = Scratch::new();
    let id = "/ID[<0011><0011>]";
    for version in ["/V 1/R 2", "/V 2/R 3/Length 128", "/V 5/R 6", "/V 9/R 9"] {
        check_locked(&scratch.file("a.pdf", locked_pdf(&(standard(version) + id))));
        check_locked(&scratch.file("no-id.pdf", locked_pdf(&standard(version))));
    }
    check_locked(
        &scratch.file("public-key.pdf", locked_pdf("/Encrypt<</Filter/Adobe.PubSec/V 4>>")),
    );
}

#[test]
fn pdf_with_a_password_that_must_be_mended() {
    let scratch = Scratch::new();
    let mut bytes = locked_pdf(&standard("/V 1/R 2"));
    let at = common::positions(&bytes, b"startxref")[0];
    bytes.splice(at.., b"startxref\n999999\n%%EOF\n".iter().copied());
    check_locked(&scratch.file("a.pdf", bytes));
    let bare = b"%PDF-1.4\n1 0 obj\n<</Type/Catalog/Pages 2 0 R>>\nendobj\n2 0 obj\n\
        <</Type/Pages/Kids[]/Count 0>>\nendobj\ntrailer<</Root 1 0 R/Encrypt 9 0 R>>\n%%EOF";
    check_locked(&scratch.file("bare.pdf", bare));
}

#[test]
fn zip_with_a_password() {
    let scratch = Scratch::new();
    let plain = zip_of(&[("1.png", numbered(1)), ("2.png", numbered(2))]);
    let (local, directory) = zip_headers(&plain);
    for page in 0..2 {
        let mut locked = plain.clone();
        // Bit 0 of the general purpose flags.
        locked[local[page] + 6] |= 1;
        locked[directory[page] + 8] |= 1;
        check_locked(&scratch.file("a.cbz", locked));
    }
}
