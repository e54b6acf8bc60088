//! An open book that no physics has touched, to judge the renderer by eye.
//!
//! ```text
//! cargo run --release -p dogleaf-render --example still_life -- OUT_DIR [PAGES_DIR] [--view NAME] [--turn OUT.webp]
//! ```
//!
//! PAGES_DIR may hold page pictures (PNG, JPEG) to be used instead of the drawn ones.

mod book;
mod text;

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use dogleaf_render::anim::Writer;
use dogleaf_render::{Camera, Lights, Renderer, Texture, Vec3};

use crate::book::Book;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let mut args: Vec<String> = std::env::args().skip(1).collect();
    let turn = args.iter().position(|a| a == "--turn").map(|i| {
        let out = args.get(i + 1).cloned().unwrap_or_default();
        args.drain(i..(i + 2).min(args.len()));
        PathBuf::from(out)
    });
    let only = args
        .iter()
        .position(|a| a == "--view")
        .map(|i| args.drain(i..(i + 2).min(args.len())).next_back());
    let only = only.flatten().unwrap_or_default();
    let out = PathBuf::from(args.first().map_or("still_life", String::as_str));
    let pages = pages(args.get(1).map(Path::new))?;
    std::fs::create_dir_all(&out)?;
    let mut renderer = Renderer::new(960, 720, 8)?;
    for (name, camera, turned) in views().into_iter().filter(|v| v.0.starts_with(&only)) {
        let book = Book::new(turned);
        let patches = book.patches(&pages);
        renderer.render(&camera, &Lights::reading_room(), &patches)?;
        let start = Instant::now();
        let picture = renderer.render(&camera, &Lights::reading_room(), &patches)?;
        let took = start.elapsed().as_secs_f64() * 1e3;
        let file = out.join(name).with_extension("png");
        image::save_buffer(&file, picture, 960, 720, image::ColorType::Rgb8)?;
        println!("{}: {took:.0} ms, {} triangles", file.display(), renderer.stats().triangles);
    }
    match turn {
        Some(file) => animate(&mut renderer, &pages, &file),
        None => Ok(()),
    }
}

/// Four page pictures: left page, recto and verso of the leaf, right page.
fn pages(folder: Option<&Path>) -> Result<Vec<Texture>, Failure> {
    let mut files = Vec::new();
    if let Some(folder) = folder {
        files = std::fs::read_dir(folder)?.filter_map(|f| Some(f.ok()?.path())).collect();
        files.sort();
    }
    let mut pages = Vec::new();
    for (i, file) in files.iter().take(4).enumerate() {
        println!("page {i}: {}", file.display());
        let picture = image::open(file)?.to_rgba8();
        pages.push(Texture::from_rgba8(picture.width(), picture.height(), picture.as_raw())?);
    }
    for i in pages.len()..4 {
        let (width, height, bytes) = text::page(i);
        pages.push(Texture::from_rgba8(width, height, &bytes)?);
    }
    Ok(pages)
}

/// Name, camera, and how far the leaf is turned (0 on the right, 1 on the left).
fn views() -> Vec<(&'static str, Camera, f32)> {
    let camera = |eye: [f32; 3], target: [f32; 3], degrees: f32| Camera {
        eye: eye.into(),
        target: target.into(),
        up: Vec3::Y,
        fov_y_rad: degrees.to_radians(),
    };
    let reader = camera([0.0, 0.50, 0.36], [0.0, 0.012, 0.008], 27.0);
    vec![
        ("a_lifted", reader, 0.28),
        ("b_upright", reader, 0.5),
        ("c_over", reader, 0.7),
        ("d_flat", reader, 0.02),
        ("e_low", camera([0.16, 0.16, 0.42], [0.0, 0.03, 0.0], 30.0), 0.42),
        ("f_gutter", camera([0.0, 0.20, 0.17], [0.0, 0.02, 0.03], 24.0), 0.25),
        ("g_behind_light", camera([0.30, 0.22, 0.20], [0.0, 0.04, 0.0], 28.0), 0.55),
        ("h_edges", camera([0.26, 0.05, 0.20], [0.09, 0.012, 0.06], 22.0), 0.3),
    ]
}

/// The leaf from right to left in three seconds.
fn animate(renderer: &mut Renderer, pages: &[Texture], file: &Path) -> Result<(), Failure> {
    let camera = views()[0].1;
    let mut writer = Writer::create(file, 960, 720, 30)?;
    let (mut drawing, mut writing) = (Duration::ZERO, Duration::ZERO);
    for i in 0..90 {
        let turned = (i as f32 - 4.0).max(0.0) / 80.0;
        let eased = turned.min(1.0).powi(2) * (3.0 - 2.0 * turned.min(1.0));
        let book = Book::new(0.01 + 0.98 * eased);
        let start = Instant::now();
        let picture = renderer.render(&camera, &Lights::reading_room(), &book.patches(pages))?;
        drawing += start.elapsed();
        let start = Instant::now();
        writer.push(picture)?;
        writing += start.elapsed();
    }
    writer.finish()?;
    let size = std::fs::metadata(file)?.len() / 1000;
    let ms = |d: Duration| d.as_secs_f64() * 1e3 / 90.0;
    println!(
        "{}: {size} kB, a frame drawn in {:.0} ms and written in {:.0} ms",
        file.display(),
        ms(drawing),
        ms(writing)
    );
    Ok(())
}
