//! The mesh is closed, turned outwards and of true width whatever a hand does: random gestures on thin
//! and thick books, single leaves and stacks, first page to last, both reading directions.

#[path = "mesh_support.rs"]
mod support;

use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;
use std::panic::AssertUnwindSafe;
use support::{Case, Eleven, Mesh, check};

/// Frames between two looks.
const EVERY: usize = 7;

#[test]
fn closed_and_upright_over_random_gestures() {
    let gestures = if cfg!(debug_assertions) { 60 } else { 1000 };
    let mut book: Box<Eleven> = Box::new(Book::EMPTY);
    let mut mesh = Mesh::new::<G11x8>();
    let fixed = mesh.indices.clone();
    let (mut looks, mut bad) = (0, Vec::new());
    for n in 0..gestures {
        let case = Case::random(n);
        let played = std::panic::catch_unwind(AssertUnwindSafe(|| {
            case.play(&mut book, 120, |frame, book| {
                if frame % EVERY == 0 {
                    mesh.draw(book);
                    looks += 1;
                    if let Err(why) = check::<G11x8>(&mesh, case.spec.width_m) {
                        bad.push(format!("gesture {n} frame {frame}: {why}\n{case:?}"));
                    }
                }
            });
        }));
        assert!(played.is_ok(), "gesture {n} panicked: {case:?}");
    }
    assert_eq!(mesh.indices, fixed, "the index buffer never changes");
    let step = (bad.len() / 4).max(1);
    let first: Vec<_> = bad.iter().step_by(step).collect();
    assert!(bad.is_empty(), "{} of {looks} meshes are bad, such as {first:#?}", bad.len());
    println!("{looks} meshes of {gestures} gestures");
}
