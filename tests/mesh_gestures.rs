//! The mesh is closed, turned outwards and of true width whatever a hand does: random gestures on thin
//! and thick books, single leaves and stacks, first page to last, both reading directions.

use crate::meshes::{Case, Eleven, Mesh, check};
use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;

/// Frames between two looks.
const EVERY: usize = 7;
/// Frames watched after the finger has left.
const AFTER: usize = 120;

#[test]
fn closed_and_upright_over_random_gestures() {
    let gestures = if cfg!(debug_assertions) { 60 } else { 1000 };
    let mut book: Box<Eleven> = Box::new(Book::EMPTY);
    let mut mesh = Mesh::new::<G11x8>();
    let (mut looks, mut in_air, mut bad) = (0, 0, Vec::new());
    for n in 0..gestures {
        let case = Case::random(n);
        case.play(&mut book, AFTER, |frame, book| {
            if frame % EVERY == 0 {
                mesh.draw(book);
                looks += 1;
                in_air += usize::from(book.leaf().is_some());
                if let Err(why) = check::<G11x8>(&mesh, case.spec.width_m) {
                    bad.push(format!("gesture {n} frame {frame}: {why}\n{case:?}"));
                }
            }
        });
    }
    let first: Vec<_> = bad.iter().take(3).collect();
    assert!(bad.is_empty(), "{} of {looks} meshes are bad, such as {first:#?}", bad.len());
    assert!(in_air * 2 > looks, "most looks see a leaf in the air: {in_air} of {looks}");
    println!("{looks} meshes of {gestures} gestures, {in_air} with a leaf in the air");
}
