//! A whole real book, where one lies beside the repository; quietly nothing where none does.

mod common;

use common::{Scratch, refused};
use dogleaf_content::{Book, BookKind};
use std::fs;
use std::path::{Path, PathBuf};

fn real_pdfs() -> Vec<PathBuf> {
    let books = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/books");
    let listed = fs::read_dir(books).into_iter().flatten().flatten();
    listed.map(|entry| entry.path()).filter(|p| p.extension().is_some_and(|e| e == "pdf")).collect()
}

#[test]
fn every_page_has_print_and_paper() {
    for path in real_pdfs() {
        let book = Book::open(&path).expect("a real book opens");
        assert_eq!(book.kind(), BookKind::Pdf, "{book:?}");
        assert!((0.5..2.0).contains(&book.aspect()), "{book:?} has aspect {}", book.aspect());
        for i in 0..book.page_count() {
            let page = book.page(i, 300, 450).expect("a real page can be drawn");
            let (w, h) = book.page_size(i).expect("and has a size");
            let shape = page.width as f32 / page.height as f32;
            assert!((shape / (w / h) - 1.0).abs() < 0.01, "page {i} is {page:?} of {w} x {h}");
            assert!(page.rgba.chunks_exact(4).any(|p| p[0] > 250), "page {i} has no paper");
            assert!(page.rgba.chunks_exact(4).any(|p| p[0] < 128), "page {i} has no print");
        }
    }
}

#[test]
fn cut_short_it_is_refused() {
    for path in real_pdfs() {
        let scratch = Scratch::new();
        let whole = fs::read(&path).expect("readable");
        for part in 0..40 {
            let length = whole.len() * part / 40;
            refused(&scratch.file("cut.pdf", &whole[..length]));
        }
    }
}

#[test]
fn any_book_can_be_shared() {
    fn shared<T: Send + Sync>() {}
    shared::<Book>();
}

#[test]
fn it_can_be_shared_between_threads() {
    for path in real_pdfs() {
        let book = Book::open(&path).expect("a real book opens");
        let alone = book.page(0, 200, 300).expect("a sound page");
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    let page = book.page(0, 200, 300).expect("a sound page");
                    assert_eq!(page.rgba, alone.rgba, "the same page in every thread");
                });
            }
        });
    }
}
