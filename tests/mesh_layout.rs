//! The buffers' layout: the same for every frame, refused when too short, and where a page's picture goes.

use crate::meshes::{Case, Eleven, Mesh, check, closed, distance, sound, upright};
use dogleaf_core::Book;
use dogleaf_core::book::LoneLeaf;
use dogleaf_core::grid::{G6x5, G8x6, G11x8, G12x9, G16x12, G22x16, G32x24, Grid};
use dogleaf_core::mesh::{Layout, MeshError, Surface, Vertex, indices, lone_vertices, vertices};
use dogleaf_core::scene::{Fidelity, LeafSpec, PaperSpec, WorldSpec};

fn a_case() -> Case {
    Case::random(2)
}

/// Parts follow one another, and no index leaves its part.
fn parts_fit<G: Grid>() {
    let mesh = Mesh::new::<G>();
    let (mut vertex, mut index) = (0, 0);
    for part in &mesh.counts.parts {
        assert_eq!((part.vertices.start, part.indices.start), (vertex, index), "{part:?}");
        (vertex, index) = (part.vertices.end, part.indices.end);
        for &i in &mesh.indices[part.indices.clone()] {
            assert!(part.vertices.contains(&usize::from(i)), "{part:?} uses vertex {i}");
        }
    }
    assert_eq!(
        (vertex, index),
        (Layout::<G>::VERTICES, Layout::<G>::INDICES),
        "nothing is left over"
    );
}

#[test]
fn parts_fit_on_every_grid() {
    parts_fit::<G6x5>();
    parts_fit::<G8x6>();
    parts_fit::<G11x8>();
    parts_fit::<G12x9>();
    parts_fit::<G16x12>();
    parts_fit::<G22x16>();
    parts_fit::<G32x24>();
}

fn good_on<G: Grid>() {
    let case = a_case();
    let mut book: Box<Book<f32, G>> = Box::new(Book::EMPTY);
    let mut mesh = Mesh::new::<G>();
    case.play(&mut *book, 10, |frame, book| {
        if frame % 9 == 0 {
            mesh.draw(book);
            let done = check::<G>(&mesh, case.spec.width_m);
            assert_eq!(done, Ok(()), "{}x{} frame {frame}", G::NX, G::NZ);
        }
    });
}

#[test]
fn good_on_every_grid() {
    good_on::<G6x5>();
    good_on::<G8x6>();
    good_on::<G12x9>();
    good_on::<G16x12>();
    good_on::<G22x16>();
    good_on::<G32x24>();
}

#[test]
fn double_precision_draws_the_same_book() {
    let case = a_case();
    let mut single: Box<Eleven> = Box::new(Book::EMPTY);
    let mut double: Box<Book<f64, G11x8>> = Box::new(Book::EMPTY);
    case.open(&mut *single);
    case.open(&mut *double);
    let (mut a, mut b) = (Mesh::new::<G11x8>(), Mesh::new::<G11x8>());
    a.draw(&single);
    b.draw(&double);
    assert_eq!(a.counts, b.counts, "the same parts");
    for part in a.counts.parts.iter().filter(|p| p.visible) {
        for (v, w) in a.of(part.surface).iter().zip(b.of(part.surface)) {
            let off = distance(v.position, w.position);
            assert!(off < 1e-6, "{:?} is {off} m off", part.surface);
        }
    }
}

#[test]
fn equal_books_give_equal_bytes_and_indices_never_change() {
    let case = Case::random(5);
    let frames = || {
        let mut book: Box<Eleven> = Box::new(Book::EMPTY);
        let mut mesh = Mesh::new::<G11x8>();
        let mut all = Vec::new();
        case.play(&mut book, 30, |_, book| {
            mesh.draw(book);
            all.extend(mesh.vertices.iter().flat_map(|v| {
                let [x, y, z] = v.position.map(f32::to_bits);
                let [a, b, c] = v.normal.map(f32::to_bits);
                let [s, t] = v.uv.map(f32::to_bits);
                [x, y, z, a, b, c, s, t]
            }));
            let mut again = vec![0; Layout::<G11x8>::INDICES];
            indices::<G11x8>(&mut again).expect("room");
            assert_eq!(again, mesh.indices, "the index buffer never changes");
        });
        all
    };
    let (first, second) = (frames(), frames());
    assert!(!first.is_empty() && first == second, "two runs give the same bytes");
}

#[test]
fn a_short_buffer_is_refused_and_left_alone() {
    let mut book: Box<Eleven> = Box::new(Book::EMPTY);
    a_case().open(&mut *book);
    let mark = Vertex { uv: [7.0; 2], ..Vertex::default() };
    let mut short = vec![mark; Layout::<G11x8>::VERTICES - 1];
    let refused = vertices(&book, &mut short).map(|_| ());
    let needs = Layout::<G11x8>::VERTICES;
    assert_eq!(refused, Err(MeshError::TooSmall { has: needs - 1, needs }), "too short by one");
    assert!(short.iter().all(|v| *v == mark), "nothing was written");
    let mut short = vec![9; Layout::<G11x8>::INDICES - 1];
    assert!(indices::<G11x8>(&mut short).is_err(), "too short by one");
    assert!(short.iter().all(|&i| i == 9), "nothing was written");
}

#[test]
fn a_book_never_opened_has_no_parts() {
    let book: Box<Eleven> = Box::new(Book::EMPTY);
    let mut mesh = Mesh::new::<G11x8>();
    mesh.draw(&book);
    assert_eq!(mesh.counts.triangles(), 0, "nothing to draw");
}

/// The vertex of a surface where its picture has this place.
fn at(mesh: &Mesh, surface: Surface, uv: [f32; 2]) -> [f32; 3] {
    let found = mesh.of(surface).iter().find(|v| v.uv == uv);
    found.unwrap_or_else(|| panic!("{surface:?} has no vertex at {uv:?}")).position
}

#[test]
fn pictures_lie_to_be_read() {
    let mut book: Box<Eleven> = Box::new(Book::EMPTY);
    let mut case = a_case();
    case.spec = dogleaf_core::scene::BookSpec::default();
    let mut mesh = Mesh::new::<G11x8>();
    for on_right in [true, false] {
        case.open(&mut *book);
        assert!(book.take_up(on_right, 1), "there are leaves on both sides");
        mesh.draw(&book);
        let leaf = if on_right { Surface::LeafUp } else { Surface::LeafDown };
        let top = if on_right { Surface::RightTop } else { Surface::LeftTop };
        for surface in [leaf, top] {
            let [left, right] = [at(&mesh, surface, [0.0, 0.0]), at(&mesh, surface, [1.0, 0.0])];
            let foot = at(&mesh, surface, [0.0, 1.0]);
            assert!(left[0] < right[0], "{surface:?}: the picture's left edge is on the left");
            assert!(left[2] < 0.0 && foot[2] > 0.0, "{surface:?}: its top is at the head");
        }
    }
}

#[test]
fn a_lying_leaf_is_drawn_where_its_block_had_it() {
    let mut book: Box<Eleven> = Box::new(Book::EMPTY);
    let mut case = a_case();
    case.spec = dogleaf_core::scene::BookSpec::default();
    case.open(&mut *book);
    let mut mesh = Mesh::new::<G11x8>();
    mesh.draw(&book);
    let before: Vec<_> = mesh.of(Surface::RightTop).iter().step_by(2).copied().collect();
    assert!(book.take_up(true, 1), "there are leaves on the right");
    mesh.draw(&book);
    let rows = Layout::<G11x8>::ROWS;
    for is in mesh.of(Surface::LeafUp).chunks(rows).map(|column| &column[0]) {
        let was = printed_at(&before, is.uv[0]);
        let off = distance(was, is.position);
        // The net's first nodes round the shoulder of the gutter a little more than the block's.
        assert!(off < 6e-4, "the tail edge's picture jumps by {off} m at u = {}", is.uv[0]);
    }
    let shifted = printed_at(&before, 0.51);
    let off = distance(shifted, printed_at(&before, 0.5));
    assert!(off > 6e-4, "a shift of a hundredth of the picture would be seen");
}

/// Where along a row of vertices the picture has this `u`.
fn printed_at(row: &[Vertex], u: f32) -> [f32; 3] {
    let next = row.partition_point(|v| v.uv[0] < u).clamp(1, row.len() - 1);
    let (a, b) = (&row[next - 1], &row[next]);
    let t = (u - a.uv[0]) / (b.uv[0] - a.uv[0]);
    core::array::from_fn(|c| a.position[c] + (b.position[c] - a.position[c]) * t)
}

#[test]
fn a_lone_leaf_has_three_parts() {
    let mut lone: Box<LoneLeaf<f32, G11x8>> = Box::new(LoneLeaf::EMPTY);
    let (spec, paper) = (LeafSpec::default(), PaperSpec::default());
    lone.open(&spec, &paper, &WorldSpec::default(), Fidelity::Standard).expect("a good spec");
    let mut mesh = Mesh::new::<G11x8>();
    for _ in 0..60 {
        lone.advance(16_667);
        let t = paper.thickness_mm * 1e-3;
        mesh.counts = lone_vertices(&lone, t, &mut mesh.vertices).expect("room");
        assert_eq!(mesh.counts.parts.iter().filter(|p| p.visible).count(), 3, "only the leaf");
        assert_eq!(check::<G11x8>(&mesh, spec.width_m), Ok(()), "a good leaf");
    }
    assert!(sound(&mesh).is_ok() && upright(&mesh).is_ok() && closed(&mesh).is_ok(), "all of it");
}
