//! What the fuzz targets share: a book that stands ready, and input made of arbitrary bytes.
//!
//! Built and run by `cargo ci fuzz`; see there for how.

pub mod draw;

use dogleaf_core::Book;
use dogleaf_core::grid::Grid;
use dogleaf_core::real::Real;
use dogleaf_tests::gesture::Scene;
use dogleaf_tests::watch::fault;

/// A copy of a book in the middle of nothing, opened once: opening costs more than most inputs do.
pub fn fresh<R: Real, G: Grid>(model: &std::sync::OnceLock<Box<Book<R, G>>>) -> Box<Book<R, G>> {
    model.get_or_init(|| Scene::default().open().expect("the default scene is sound")).clone()
}

/// Runs what may be refused; whatever was refused has left the book as it was.
pub fn refused<R: Real, G: Grid, T, E>(
    book: &mut Book<R, G>,
    ask: impl FnOnce(&mut Book<R, G>) -> Result<T, E>,
) -> Result<T, E> {
    let (hash, now_us, spec) = (book.state_hash(), book.now_us(), *book.spec());
    let answer = ask(book);
    if answer.is_err() {
        let after = (book.state_hash(), book.now_us(), *book.spec());
        assert_eq!(after, (hash, now_us, spec), "what is refused changes nothing");
    }
    answer
}

/// What must hold of a book after every step.
pub fn sound<R: Real, G: Grid>(book: &Book<R, G>) {
    assert_eq!(fault(book), None, "a state no book may be in");
}
