//! A book's picture by the software renderer: the reference; and how far another one is from it.

use dogleaf_content::{Book, Picture};
use dogleaf_core::mesh::{Surface, Vertex, table_drop_m};
use dogleaf_core::reading::{Face, Piece};
use dogleaf_desktop::{BookView, Lamp, Leaves};
use dogleaf_render::{
    Camera, Lights, Material, PAPER_ALPHA, PAPER_TINT, Patch, Renderer, Texture, Vec3,
};
use std::collections::BTreeMap;
use std::path::Path;

/// Pictures of pages, by their numbers.
pub(crate) type Sheets = BTreeMap<u32, Picture>;

/// Pictures of the pages that are seen, as large as `texels` at most.
pub(crate) fn sheets(view: &mut BookView, content: &Book, texels: [u32; 2]) -> Sheets {
    let pieces = view.mesh().expect("a mesh");
    let seen = pieces.iter().filter(|p| p.visible).filter_map(|p| page(p.face));
    let printed = seen.filter(|page| (*page as usize) < content.page_count());
    let made = |page: u32| content.page(page as usize, texels[0], texels[1]);
    printed.map(|page| (page, made(page).expect("a sound page"))).collect()
}

/// The reference picture: RGB bytes, rows from the top. Its shape is that of the view, its size need not be.
pub(crate) fn picture(view: &mut BookView, sheets: &Sheets, size: [u32; 2]) -> Vec<u8> {
    let pieces = view.mesh().expect("a mesh");
    let leaves = Leaves::of(view.reading().book(), &pieces, view.vertices());
    let texture = |p: &Picture| Texture::from_rgba8(p.width, p.height, &p.rgba);
    let pages: BTreeMap<u32, Texture> =
        sheets.iter().map(|(n, p)| (*n, texture(p).expect("a texture"))).collect();
    let setup = view.setup();
    let mut indices = vec![0; dogleaf_core::reading::Shape::<dogleaf_core::grid::G11x8>::INDICES];
    dogleaf_desktop::view::Paper::indices(&mut indices).expect("room for the indices");
    let table = table(-(table_drop_m(setup.book.cover) as f32) - 1e-4);
    let leaf_m = (setup.paper.thickness_mm * 1e-3) as f32;
    let mut patches: Vec<Patch<'_>> = pieces
        .iter()
        .filter(|p| p.visible)
        .map(|piece| Patch {
            vertices: view.vertices(),
            indices: &indices[piece.indices.clone()],
            material: material(piece, &pieces, &leaves, leaf_m, &pages),
        })
        .collect();
    let wood = Material::Table { colour: Vec3::new(0.105, 0.066, 0.042), grain: 1.0 };
    patches.push(Patch { vertices: &table, indices: &[0, 1, 2, 0, 2, 3], material: wood });
    let v = setup.view;
    let camera = Camera {
        eye: Vec3::from(v.eye_m.map(|c| c as f32)),
        target: Vec3::from(v.target_m.map(|c| c as f32)),
        up: Vec3::new(0.0, 1.0, -1e-3),
        fov_y_rad: v.fov_y_deg.to_radians() as f32,
    };
    let mut renderer = Renderer::new(size[0], size[1], 8).expect("a renderer");
    let lights = Lights::reading_room();
    assert_eq!(lights.point.position.to_array(), Lamp::READING.position, "one lamp for both");
    renderer.render(&camera, &lights, &patches).expect("a picture").to_vec()
}

fn page(face: Face) -> Option<u32> {
    match face {
        Face::Page(page) => Some(page),
        Face::Edge | Face::Cover => None,
    }
}

fn material<'a>(
    piece: &Piece,
    pieces: &[Piece],
    leaves: &Leaves,
    leaf_m: f32,
    pages: &'a BTreeMap<u32, Texture>,
) -> Material<'a> {
    let of = |face| page(face).and_then(|n| pages.get(&n));
    let shown = |surface| {
        let found = pieces.iter().find(|p| p.surface == surface && p.flying == piece.flying);
        found.and_then(|p| of(p.face))
    };
    let edges = |count: u32| Material::PageEdges { leaves: count as f32, tint: PAPER_TINT };
    let stack = leaves.held > 1 && !piece.flying;
    let free = leaves.free[usize::from(piece.flying)];
    let thickness = if stack { f32::INFINITY } else { leaf_m - free.ln() / PAPER_ALPHA };
    let (up, down) = (shown(Surface::LeafUp), shown(Surface::LeafDown));
    match piece.surface {
        Surface::LeafUp => Material::paper(up, down, thickness),
        Surface::LeafDown => Material::paper(down, up, thickness),
        Surface::LeafRim if stack => edges(leaves.held),
        Surface::LeafRim => Material::paper(None, None, thickness),
        Surface::LeftTop | Surface::RightTop => {
            Material::paper(of(piece.face), None, f32::INFINITY)
        }
        Surface::LeftSides => edges(leaves.blocks[0]),
        Surface::RightSides => edges(leaves.blocks[1]),
        Surface::LeftBottom | Surface::RightBottom => Material::paper(None, None, f32::INFINITY),
        Surface::LeftBoard | Surface::RightBoard | Surface::Spine => {
            Material::Board { colour: Vec3::new(0.16, 0.035, 0.03), roughness: 0.75 }
        }
    }
}

fn table(y: f32) -> [Vertex; 4] {
    let r = 3.0;
    [[-r, -r], [-r, r], [r, r], [r, -r]].map(|[x, z]| Vertex {
        position: [x, y, z],
        normal: [0.0, 1.0, 0.0],
        uv: [0.5 + 0.5 * x / r, 0.5 + 0.5 * z / r],
    })
}

/// How far two pictures are apart, in 1/255 of a channel: on the mean, and 99 of 100 bytes at most.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Apart {
    /// Mean.
    pub(crate) mean: f64,
    /// 99th percentile.
    pub(crate) most: u8,
}

/// Compares RGB bytes with RGBA bytes.
pub(crate) fn apart(rgb: &[u8], rgba: &[u8]) -> Apart {
    assert_eq!(rgb.len() / 3, rgba.len() / 4, "pictures of one size");
    let mut counts = [0_u64; 256];
    for (a, b) in rgb.chunks_exact(3).zip(rgba.chunks_exact(4)) {
        a.iter().zip(b).for_each(|(a, b)| counts[usize::from(a.abs_diff(*b))] += 1);
    }
    let all: u64 = counts.iter().sum();
    let sum: u64 = counts.iter().zip(0_u64..).map(|(n, d)| n * d).sum();
    let mut seen = 0;
    let most = (0..=255).find(|d| {
        seen += counts[usize::from(*d)];
        seen * 100 >= all * 99
    });
    Apart { mean: sum as f64 / all as f64, most: most.unwrap_or(255) }
}

/// Keeps a picture to be looked at where `DOGLEAF_PICTURES` names a folder.
pub(crate) fn keep(name: &str, size: [u32; 2], bytes: &[u8]) {
    let Some(folder) = std::env::var_os("DOGLEAF_PICTURES") else { return };
    let kind = if bytes.len() == 3 * (size[0] * size[1]) as usize {
        image::ExtendedColorType::Rgb8
    } else {
        image::ExtendedColorType::Rgba8
    };
    let path = Path::new(&folder).join(name);
    image::save_buffer(path, bytes, size[0], size[1], kind).expect("a place for pictures");
}
