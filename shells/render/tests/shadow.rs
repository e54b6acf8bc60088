//! Shadows, what shines through a leaf, and the dark of narrow places.

mod common;

use common::{Mesh, above, green, lamp_only, room_only, white};
use dogleaf_render::{Camera, Material, Renderer, Texture, Vec3};

const SIDE: usize = 60;

/// The camera sees 0.3 m both ways; pixel of a place at height zero.
fn camera() -> Camera {
    above(1.0, 2.0 * 0.15_f32.atan())
}

fn pixel(x: f32, z: f32) -> usize {
    let place = |v: f32| ((v / 0.3 + 0.5) * SIDE as f32) as usize;
    place(z) * SIDE + place(x)
}

fn renderer() -> Renderer {
    Renderer::new(SIDE as u32, SIDE as u32, 1).expect("size is sound")
}

#[test]
fn beneath_an_occluder_is_darker_than_beside() {
    let floor = Mesh::level(0.0, [-0.3, 0.3], [-0.3, 0.3]);
    // High enough to stay out of the picture, so that the camera sees its shadow.
    let roof = Mesh::level(0.1, [0.10, 0.30], [-0.05, 0.05]);
    // The lamp stands on the right: the shadow falls to the left of the roof.
    let lamp = lamp_only(Vec3::new(0.6, 0.5, 0.0));
    let seen =
        green(&mut renderer(), &camera(), &lamp, &[floor.patch(white()), roof.patch(white())]);
    let shadow_x = 0.10 - 0.1 / 0.4 * 0.5 + 0.02;
    let (under, beside) = (seen[pixel(shadow_x, 0.0)], seen[pixel(shadow_x, 0.11)]);
    assert!(under < 8 && beside > 60, "in the shadow {under}, beside it {beside}");
    let without = green(&mut renderer(), &camera(), &lamp, &[floor.patch(white())]);
    assert!(without[pixel(shadow_x, 0.0)] > 60, "without the roof it is light there");
}

#[test]
fn a_plain_page_does_not_shade_itself() {
    let page = Mesh::level(0.0, [-0.3, 0.3], [-0.3, 0.3]);
    for position in
        [Vec3::new(0.0, 0.8, 0.0), Vec3::new(-0.7, 0.25, 0.1), Vec3::new(0.4, 0.5, -0.6)]
    {
        let seen = green(&mut renderer(), &camera(), &lamp_only(position), &[page.patch(white())]);
        let mut jumps = 0;
        for y in 1..SIDE - 1 {
            for x in 1..SIDE - 1 {
                let at = y * SIDE + x;
                let mean = (i32::from(seen[at - 1]) + i32::from(seen[at + 1])) / 2;
                jumps += i32::from((i32::from(seen[at]) - mean).abs() > 3);
            }
        }
        assert_eq!(jumps, 0, "lamp at {position}: the light runs smoothly");
    }
}

#[test]
fn the_penumbra_widens_with_the_height() {
    let floor = Mesh::level(0.0, [-0.3, 0.3], [-0.3, 0.3]);
    let width = |height: f32| {
        let roof = Mesh::level(height, [0.0, 0.5], [-0.5, 0.5]);
        let mut lamp = lamp_only(Vec3::new(-0.6, 0.6, 0.0));
        lamp.point.radius_m = 0.06;
        let patches = [
            floor.patch(white()),
            roof.patch(Material::Board { colour: Vec3::ZERO, roughness: 1.0 }),
        ];
        // Seen from below the roof's height on the lamp's side nothing hides the shadow's rim.
        let camera = Camera {
            eye: Vec3::new(0.0, 0.9 * height, 0.35),
            target: Vec3::new(0.0, 0.0, 0.0),
            up: Vec3::Y,
            fov_y_rad: 0.9,
        };
        let mut renderer = Renderer::new(240, 60, 1).expect("size is sound");
        let seen = green(&mut renderer, &camera, &lamp, &patches);
        let row = &seen[50 * 240..51 * 240];
        let most = row.iter().copied().max().expect("some");
        row.iter().filter(|&&v| v > most / 6 && v < most - most / 6).count()
    };
    let (low, high) = (width(0.02), width(0.10));
    assert!(high > low + 3, "{low} pixels wide under a low roof, {high} under a high one");
}

fn black_on_the_left() -> Texture {
    let bytes: Vec<u8> =
        (0..16 * 16).flat_map(|i| if i % 16 < 8 { [0, 0, 0, 255] } else { [255; 4] }).collect();
    Texture::from_rgba8(16, 16, &bytes).expect("bytes match the size")
}

#[test]
fn a_leaf_lit_from_behind_shows_its_reverse() {
    let print = black_on_the_left();
    let leaf = Mesh::level(0.1, [-0.2, 0.2], [-0.2, 0.2]);
    let lamp = lamp_only(Vec3::new(0.0, -0.5, 0.0));
    let thin = Material::paper(None, Some(&print), 0.000_1);
    let seen = green(&mut renderer(), &camera(), &lamp, &[leaf.patch(thin)]);
    // The reverse's left is on our right.
    let (left, right) = (seen[pixel(-0.06, 0.0)], seen[pixel(0.06, 0.0)]);
    assert!(left > 60, "light shines through the bare paper: {left}");
    assert!(right < left / 2, "and not through the ink on the other side: {right}");
    let block = Material::paper(None, Some(&print), f32::INFINITY);
    let seen = green(&mut renderer(), &camera(), &lamp, &[leaf.patch(block)]);
    assert!(seen[pixel(-0.06, 0.0)] < 8, "nothing shines through a block");
}

#[test]
fn a_leaf_seen_from_behind_shows_its_other_picture() {
    let print = black_on_the_left();
    let leaf = Mesh::level(0.0, [-0.2, 0.2], [-0.2, 0.2]);
    let from_below = Camera { eye: Vec3::new(0.0, -1.0, 0.0), ..camera() };
    let thick = Material::paper(None, Some(&print), f32::INFINITY);
    let seen = green(&mut renderer(), &from_below, &room_only(), &[leaf.patch(thick)]);
    // From below -X is on the right; the reverse reads from its own left, which lies at +X.
    let row = &seen[(SIDE / 2) * SIDE..(SIDE / 2 + 1) * SIDE];
    assert!(
        row[SIDE / 4] < 40 && row[3 * SIDE / 4] > 80,
        "ink on the left, paper on the right: {row:?}"
    );
}

#[test]
fn narrow_places_are_dark() {
    let floor = Mesh::level(0.0, [-0.3, 0.3], [-0.3, 0.3]);
    let mut walls = Mesh::default();
    for x in [-0.02_f32, 0.02] {
        let base = walls.vertices.len() as u16;
        for (y, z) in [(0.0, -0.1), (0.0, 0.1), (0.08, 0.1), (0.08, -0.1)] {
            let normal = [-x.signum(), 0.0, 0.0];
            walls.vertices.push(dogleaf_core::mesh::Vertex {
                position: [x, y, z],
                normal,
                uv: [0.0; 2],
            });
        }
        walls.indices.extend([0, 1, 2, 0, 2, 3].map(|i| base + i));
    }
    let seen = green(
        &mut renderer(),
        &camera(),
        &room_only(),
        &[floor.patch(white()), walls.patch(white())],
    );
    let (between, beside) = (seen[pixel(0.0, 0.0)], seen[pixel(0.06, 0.0)]);
    assert!(between + 20 < beside, "between the walls {between}, beside them {beside}");
    let bare = green(&mut renderer(), &camera(), &room_only(), &[floor.patch(white())]);
    assert!(beside <= bare[pixel(0.06, 0.0)], "and a wall takes light from its other side, too");
}
