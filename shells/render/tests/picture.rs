//! What a picture promises: same bytes on any number of threads, right perspective, legible print.

mod common;

use common::{Mesh, green, lamp_only, room_only, white};
use dogleaf_render::{Camera, Lights, Material, Renderer, Texture, Vec3};

fn slanting() -> Camera {
    Camera {
        eye: Vec3::new(0.0, 0.25, 0.30),
        target: Vec3::new(0.0, 0.0, -0.02),
        up: Vec3::Y,
        fov_y_rad: 0.7,
    }
}

fn texture(width: u32, height: u32, ink: impl Fn(u32, u32) -> bool) -> Texture {
    let mut bytes = Vec::new();
    for y in 0..height {
        for x in 0..width {
            let v = if ink(x, y) { 0 } else { 255 };
            bytes.extend([v, v, v, 255]);
        }
    }
    Texture::from_rgba8(width, height, &bytes).expect("bytes match the size")
}

#[test]
fn threads_do_not_show() {
    let page = texture(64, 64, |x, y| (x / 4 + y / 4) % 2 == 0);
    let (sheet, table) = (
        Mesh::level(0.04, [-0.1, 0.02], [-0.08, 0.08]),
        Mesh::level(0.0, [-1.0, 1.0], [-1.0, 1.0]),
    );
    let leaf = Material::paper(Some(&page), Some(&page), 0.000_1);
    let wood = Material::Table { colour: Vec3::new(0.1, 0.05, 0.03), grain: 1.0 };
    let patches = [sheet.patch(leaf), table.patch(wood)];
    let mut pictures = Vec::new();
    for threads in [1, 2, 3] {
        let mut renderer = Renderer::new(90, 70, 8).expect("size is sound").with_threads(threads);
        for _ in 0..2 {
            let picture =
                renderer.render(&slanting(), &Lights::reading_room(), &patches).expect("sound");
            pictures.push(picture.to_vec());
        }
    }
    assert!(pictures.iter().all(|p| *p == pictures[0]), "every picture has the same bytes");
}

#[test]
fn the_middle_of_a_slanting_page_is_not_the_middle_of_its_picture() {
    // White beyond z = 0, black before it.
    let page = texture(256, 256, |_, y| y >= 128);
    let mesh = Mesh::level(0.0, [-0.3, 0.3], [-0.2, 0.2]);
    let paper = Material::Paper {
        front: Some(&page),
        back: None,
        thickness_m: f32::INFINITY,
        alpha: 1.0,
        tint: Vec3::ONE,
        roughness: 1.0,
    };
    let (width, height) = (65, 240);
    let mut renderer = Renderer::new(width, height, 4).expect("size is sound");
    let seen = green(&mut renderer, &slanting(), &room_only(), &[mesh.patch(paper)]);
    let column: Vec<u8> = (0..height).map(|y| seen[(y * width + width / 2) as usize]).collect();
    let lit = column.iter().position(|&v| v > 120).expect("the far half is white");
    let found = lit + column[lit..].iter().position(|&v| v < 120).expect("the near half is black");
    // Where the camera sees (0, 0, 0).
    let camera = slanting();
    let ahead = (camera.target - camera.eye).normalize();
    let up = Vec3::X.cross(ahead);
    let to = Vec3::ZERO - camera.eye;
    let y = to.dot(up) / to.dot(ahead) / (camera.fov_y_rad * 0.5).tan();
    let expected = (0.5 - 0.5 * y) * height as f32;
    assert!(
        (found as f32 - expected).abs() <= 1.5,
        "the border is seen at {found}, it lies at {expected}"
    );
}

#[test]
fn fine_print_fades_to_grey_and_not_to_glitter() {
    let page = texture(1024, 1024, |_, y| y % 2 == 0);
    let mesh = Mesh::level(0.0, [-0.2, 0.2], [-0.2, 0.2]);
    let paper = Material::Paper {
        front: Some(&page),
        back: None,
        thickness_m: f32::INFINITY,
        alpha: 1.0,
        tint: Vec3::ONE,
        roughness: 1.0,
    };
    let mut renderer = Renderer::new(64, 64, 4).expect("size is sound");
    let seen = green(&mut renderer, &slanting(), &room_only(), &[mesh.patch(paper)]);
    let middle: Vec<u8> = (24..40).flat_map(|y| seen[y * 64 + 24..y * 64 + 40].to_vec()).collect();
    let (least, most) = (middle.iter().min().expect("some"), middle.iter().max().expect("some"));
    assert!(
        most - least < 12 && *least > 60,
        "lines far below a pixel are an even grey: {least}..{most}"
    );
}

#[test]
fn lines_two_pixels_apart_are_still_seen() {
    let page = texture(512, 512, |x, _| x % 8 < 4);
    let mesh = Mesh::level(0.0, [-0.2, 0.2], [-0.2, 0.2]);
    let paper = Material::Paper {
        front: Some(&page),
        back: None,
        thickness_m: f32::INFINITY,
        alpha: 1.0,
        tint: Vec3::ONE,
        roughness: 1.0,
    };
    let mut renderer = Renderer::new(300, 300, 4).expect("size is sound");
    let seen = green(
        &mut renderer,
        &common::above(0.5, 2.0 * 0.4_f32.atan()),
        &room_only(),
        &[mesh.patch(paper)],
    );
    let row = &seen[150 * 300 + 100..150 * 300 + 200];
    let swing: u32 = row.windows(2).map(|w| u32::from(w[0].abs_diff(w[1]))).sum();
    assert!(swing > 100 * 30, "the lines keep their contrast: mean step {}", swing / 99);
}

#[test]
fn white_paper_is_white_and_warm() {
    let mesh = Mesh::level(0.0, [-0.2, 0.2], [-0.2, 0.2]);
    let mut renderer = Renderer::new(64, 48, 4).expect("size is sound");
    let page = [mesh.patch(Material::paper(None, None, f32::INFINITY))];
    let picture = renderer.render(&slanting(), &Lights::reading_room(), &page).expect("sound");
    let at = (24 * 64 + 32) * 3;
    let [r, g, b] = [picture[at], picture[at + 1], picture[at + 2]];
    assert!((238..=252).contains(&r), "red {r}");
    assert!(r >= g && g >= b && r - b <= 24, "warm, but not yellow: {r} {g} {b}");
}

#[test]
fn unsound_triangles_are_left_out() {
    let mut mesh = Mesh::level(0.0, [-0.1, 0.1], [-0.1, 0.1]);
    mesh.indices.extend([0, 1, 99]);
    mesh.vertices
        .push(dogleaf_core::mesh::Vertex { position: [f32::NAN, 0.0, 0.0], ..Default::default() });
    mesh.indices.extend([0, 1, 4]);
    mesh.vertices
        .push(dogleaf_core::mesh::Vertex { position: [1e30, 0.0, 0.0], ..Default::default() });
    mesh.indices.extend([0, 1, 5, 7]);
    let mut renderer = Renderer::new(20, 20, 1).expect("size is sound");
    let seen = green(
        &mut renderer,
        &slanting(),
        &lamp_only(Vec3::new(0.0, 0.5, 0.0)),
        &[mesh.patch(white())],
    );
    assert_eq!(
        renderer.stats().refused,
        3,
        "a wild index, a NaN and the far end of the world; the odd index at the end is no triangle"
    );
    assert!(seen[10 * 20 + 10] > 60, "the others are drawn");
}

#[test]
fn unsound_calls_are_refused() {
    assert!(Renderer::new(0, 10, 4).is_err(), "no picture");
    assert!(Renderer::new(10, 100_000, 4).is_err(), "too large");
    assert!(Renderer::new(10, 10, 3).is_err(), "three samples");
    assert!(Texture::from_rgba8(2, 2, &[0; 15]).is_err(), "a byte is missing");
    assert!(Texture::from_rgba8(0, 2, &[]).is_err(), "no texel");
    let mut renderer = Renderer::new(8, 8, 1).expect("size is sound");
    for camera in [
        Camera { up: Vec3::new(0.0, 0.25, 0.32), ..slanting() },
        Camera { eye: slanting().target, ..slanting() },
        Camera { fov_y_rad: f32::NAN, ..slanting() },
        Camera { fov_y_rad: 4.0, ..slanting() },
    ] {
        assert!(renderer.render(&camera, &room_only(), &[]).is_err(), "{camera:?}");
    }
    assert!(
        renderer.render(&slanting(), &room_only(), &[]).is_ok(),
        "an empty scene is a picture, too"
    );
}
