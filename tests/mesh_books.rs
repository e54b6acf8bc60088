//! Resting books of every size: one leaf to five thousand, first page to last, hard and soft, wide and tall.

use crate::meshes::{Eleven, Mesh, check};
use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::View;
use dogleaf_core::mesh::{BOARD_M, Surface, table_drop_m};
use dogleaf_core::scene::{BookSpec, Cover, Direction, Fidelity, PaperSpec, Preset, WorldSpec};

fn drawn(spec: &BookSpec, paper: &PaperSpec, book: &mut Eleven) -> Mesh {
    let view = View::reading(spec.width_m, spec.height_m, 960, 720);
    book.open(spec, paper, &WorldSpec::default(), &view, Fidelity::Standard).expect("a good spec");
    let mut mesh = Mesh::new::<G11x8>();
    mesh.draw(book);
    mesh
}

#[test]
fn every_resting_book_is_good() {
    let mut book: Box<Eleven> = Box::new(Book::EMPTY);
    for pages in [1, 2, 3, 4, 10, 60, 320, 1000, 3000, 10_000] {
        for share in [0.0, 0.01, 0.5, 0.99, 1.0] {
            for (cover, direction) in [(Cover::Hard, Direction::Ltr), (Cover::Soft, Direction::Rtl)]
            {
                for (width_m, aspect) in [(0.13, 1.54), (0.3, 0.5), (0.05, 2.0)] {
                    let open_at = (f64::from(pages) * share) as u32;
                    let height_m = width_m * aspect;
                    let spec = BookSpec { pages, open_at, cover, direction, width_m, height_m };
                    let mesh = drawn(&spec, &Preset::Book.into(), &mut book);
                    let done = check::<G11x8>(&mesh, width_m);
                    assert_eq!(done, Ok(()), "{spec:?}");
                }
            }
        }
    }
}

#[test]
fn taking_up_any_stack_is_good() {
    let mut book: Box<Eleven> = Box::new(Book::EMPTY);
    let spec = BookSpec::default();
    for leaves in (1..=45).chain([60, 100]) {
        for on_right in [true, false] {
            let mut mesh = drawn(&spec, &PaperSpec::default(), &mut book);
            assert!(book.take_up(on_right, leaves), "{leaves} leaves are there");
            mesh.draw(&book);
            let done = check::<G11x8>(&mesh, spec.width_m);
            assert_eq!(done, Ok(()), "{leaves} leaves, from the right: {on_right}");
        }
    }
}

#[test]
fn parts_are_there_when_they_should_be() {
    let mut book: Box<Eleven> = Box::new(Book::EMPTY);
    let first = BookSpec { open_at: 0, ..BookSpec::default() };
    let mesh = drawn(&first, &PaperSpec::default(), &mut book);
    let there = |s| mesh.visible(s);
    assert!(!there(Surface::LeftTop) && !there(Surface::LeafUp), "nothing read, nothing held");
    assert!(there(Surface::RightTop) && there(Surface::Spine), "a block in its cover");
    let soft = BookSpec { cover: Cover::Soft, ..BookSpec::default() };
    let mesh = drawn(&soft, &PaperSpec::default(), &mut book);
    assert!(mesh.visible(Surface::LeftTop) && !mesh.visible(Surface::LeftBoard), "no boards");
}

#[test]
fn the_fore_edge_is_sheared_and_boards_lie_on_the_table() {
    let mut book: Box<Eleven> = Box::new(Book::EMPTY);
    let spec = BookSpec::default();
    let mesh = drawn(&spec, &PaperSpec::default(), &mut book);
    let furthest = |s| mesh.of(s).iter().fold(0.0f32, |m, v| m.max(v.position[0]));
    let [_, thickness] = book.binding().thickness();
    let thickness = f64::from(thickness) * book.units().metres;
    let shear = f64::from(furthest(Surface::RightBottom) - furthest(Surface::RightTop));
    // On a flat block the open page goes a quarter circle round the end of the binding.
    let flat = thickness * std::f64::consts::FRAC_PI_2;
    assert!((shear / flat - 1.0).abs() < 0.05, "sheared by {shear} m, a flat block by {flat} m");
    let lowest = mesh.of(Surface::RightBoard).iter().fold(0.0f32, |m, v| m.min(v.position[1]));
    assert!((f64::from(lowest) + table_drop_m(Cover::Hard)).abs() < 1e-4, "lowest at {lowest} m");
    assert_eq!(table_drop_m(Cover::Hard), BOARD_M, "boards lie on the table");
    assert_eq!(table_drop_m(Cover::Soft), 0.0, "so do leaves without boards");
}
