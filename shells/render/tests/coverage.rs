//! Which samples a triangle covers: every one inside, none twice, none missed.

mod common;

use common::{Mesh, above, green, room_only, white};
use dogleaf_core::mesh::Vertex;
use dogleaf_render::{Renderer, Vec3};

/// Size of the little pictures, pixels; the camera sees one metre both ways.
const SIDE: usize = 16;

fn camera() -> dogleaf_render::Camera {
    above(1.0, 2.0 * 0.5_f32.atan())
}

fn at(x: f32, y: f32) -> Vertex {
    let side = SIDE as f32;
    Vertex {
        position: [x / side - 0.5, 0.0, y / side - 0.5],
        normal: [0.0, 1.0, 0.0],
        uv: [0.0; 2],
    }
}

fn picture(mesh: &Mesh, samples: u32) -> Vec<u8> {
    let mut renderer = Renderer::new(SIDE as u32, SIDE as u32, samples)
        .expect("size is sound")
        .with_background(Vec3::ZERO);
    green(&mut renderer, &camera(), &room_only(), &[mesh.patch(white())])
}

/// A row of a picture as text, to be read where a test fails.
fn text(row: impl Iterator<Item = bool>) -> String {
    row.map(|covered| if covered { '#' } else { '.' }).collect()
}

#[test]
fn a_triangle_covers_the_pixels_whose_middle_it_holds() {
    let p = [[2.0, 1.2], [4.1, 14.8], [13.7, 6.4]];
    let mesh =
        Mesh { vertices: p.iter().map(|&[x, y]| at(x, y)).collect(), indices: vec![0, 1, 2] };
    let inside = |x: f32, y: f32| {
        (0..3).all(|i| {
            let ([ax, ay], [bx, by]) = (p[i], p[(i + 1) % 3]);
            (bx - ax) * (y - ay) - (by - ay) * (x - ax) < 0.0
        })
    };
    let seen = picture(&mesh, 1);
    let found: Vec<String> =
        seen.chunks_exact(SIDE).map(|row| text(row.iter().map(|&v| v > 30))).collect();
    let row = |y: usize| text((0..SIDE).map(|x| inside(x as f32 + 0.5, y as f32 + 0.5)));
    let expected: Vec<String> = (0..SIDE).map(row).collect();
    assert_eq!(found, expected, "found on the left, expected on the right");
    let golden = [
        "................",
        "..#.............",
        "..###...........",
        "..#####.........",
        "...######.......",
        "...#########....",
        "...###########..",
        "...#########....",
        "...########.....",
        "...#######......",
        "...######.......",
        "....####........",
        "....###.........",
        "....##..........",
        "................",
        "................",
    ];
    assert_eq!(found, golden, "found on the left, the golden picture on the right");
}

#[test]
fn neighbours_share_an_edge_without_gap_or_overlap() {
    // A fan around a point that is on no pixel's border; its rim lies outside the picture.
    let mut mesh = Mesh { vertices: vec![at(7.3, 8.9)], indices: Vec::new() };
    let n = 23;
    for i in 0..n {
        let turn = i as f32 / n as f32 * std::f32::consts::TAU;
        mesh.vertices.push(at(8.0 + 30.0 * turn.cos(), 8.0 + 30.0 * turn.sin()));
        mesh.indices.extend([0, 1 + (i + 1) % n, 1 + i]);
    }
    let plain = Mesh::level(0.0, [-2.0, 2.0], [-2.0, 2.0]);
    for samples in [1, 4, 8] {
        let (fan, plane) = (picture(&mesh, samples), picture(&plain, samples));
        for (i, (a, b)) in fan.iter().zip(&plane).enumerate() {
            assert!(a.abs_diff(*b) <= 2, "{samples} samples, pixel {i}: {a} for {b}");
        }
    }
}

#[test]
fn an_edge_through_a_pixel_takes_its_share() {
    let mesh = Mesh::level(0.0, [-2.0, 0.25 / SIDE as f32], [-2.0, 2.0]);
    let row: Vec<u8> = picture(&mesh, 8)[..SIDE].to_vec();
    assert!(row[7] > 100 && row[9] < 8, "inside is light, outside is dark: {row:?}");
    assert!(row[8] > 20 && row[8] < row[7] - 20, "the pixel that is cut lies between: {row:?}");
}

#[test]
fn a_table_that_reaches_behind_the_eye_is_cut() {
    let mesh = Mesh::level(-0.3, [-5.0, 5.0], [-5.0, 5.0]);
    let camera = dogleaf_render::Camera {
        eye: Vec3::ZERO,
        target: Vec3::NEG_Z,
        up: Vec3::Y,
        fov_y_rad: 1.2,
    };
    let mut renderer = Renderer::new(32, 32, 4).expect("size is sound").with_background(Vec3::ZERO);
    let seen = green(&mut renderer, &camera, &room_only(), &[mesh.patch(white())]);
    assert!(seen[..32 * 15].iter().all(|&v| v < 8), "above the horizon there is nothing");
    assert!(
        seen[32 * 20..].iter().all(|&v| v > 60),
        "below it is the table, down to the picture's edge"
    );
}
