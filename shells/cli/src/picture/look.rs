//! How a shot looks: materials, light, camera, table.

use super::band::fabric;
use super::{Faces, Pages, Shot};
use crate::error::CliError;
use dogleaf_core::hand::View;
use dogleaf_core::mesh::{Surface, Vertex, table_drop_m};
use dogleaf_core::scene::{Cover, Direction};
use dogleaf_render::{Camera, Lights, Material, PAPER_ALPHA, PAPER_TINT, Patch, Renderer, Vec3};

/// Half a side of the table, metres.
const TABLE_M: f32 = 3.0;
/// Gap between the table and what lies on it, metres: none of them shall show through the other.
const GAP_M: f32 = 1e-4;
/// Samples a pixel.
const SAMPLES: u32 = 8;

/// What stands around and does not move.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Set {
    pub(crate) view: View,
    pub(crate) direction: Direction,
    /// Nothing lies on a table where there is no book, unless a ribbon has a floor.
    pub(crate) cover: Option<Cover>,
    /// Height of that floor, metres.
    pub(crate) floor_m: Option<f64>,
    /// Thickness of a leaf, metres.
    pub(crate) thickness_m: f32,
}

/// Draws shots.
#[derive(Debug)]
pub(crate) struct Look {
    set: Set,
    camera: Camera,
    lights: Lights,
    renderer: Renderer,
    table: [Vertex; 4],
    pages: Pages,
}

const TABLE_TRIANGLES: [u16; 6] = [0, 1, 2, 0, 2, 3];

impl Look {
    pub(crate) fn new(set: Set, pages: Pages) -> Result<Self, CliError> {
        let View { eye_m, target_m, fov_y_deg, width_px, height_px } = set.view;
        let camera = Camera {
            eye: Vec3::from(eye_m.map(|c| c as f32)),
            target: Vec3::from(target_m.map(|c| c as f32)),
            // As the core's camera: the picture's up leans towards the head of the page.
            up: Vec3::new(0.0, 1.0, -1e-3),
            fov_y_rad: fov_y_deg.to_radians() as f32,
        };
        let ground = set.floor_m.unwrap_or(-set.cover.map_or(0.0, table_drop_m)) as f32;
        Ok(Self {
            camera,
            lights: Lights::reading_room(),
            renderer: Renderer::new(width_px, height_px, SAMPLES)?,
            table: table(ground - GAP_M),
            set,
            pages,
        })
    }

    /// Width and height of the picture, pixels.
    pub(crate) fn size(&self) -> [u32; 2] {
        [self.set.view.width_px, self.set.view.height_px]
    }

    /// Draws a shot: RGB bytes, rows from the top.
    pub(crate) fn draw(&mut self, shot: &Shot) -> Result<&[u8], CliError> {
        let faces = Faces::of(shot, self.set.direction);
        for page in seen(shot, &faces) {
            self.pages.make(page)?;
        }
        let Self { set, pages, table, .. } = self;
        let mut patches: Vec<Patch<'_>> = shot
            .pieces
            .iter()
            .map(|piece| Patch {
                vertices: &shot.vertices,
                indices: shot.triangles(piece),
                material: material(piece.surface, shot, &faces, pages, set),
            })
            .collect();
        patches.extend(shot.bands.iter().map(|band| Patch {
            vertices: &band.vertices,
            indices: &band.indices,
            material: fabric(band.fabric),
        }));
        if set.cover.is_some() || set.floor_m.is_some() {
            let material = Material::Table { colour: Vec3::new(0.105, 0.066, 0.042), grain: 1.0 };
            patches.push(Patch { vertices: table, indices: &TABLE_TRIANGLES, material });
        }
        Ok(self.renderer.render(&self.camera, &self.lights, &patches)?)
    }
}

/// The pages a shot shows.
fn seen(shot: &Shot, faces: &Faces) -> impl Iterator<Item = Option<u32>> {
    let pages = [
        (Surface::LeftTop, faces.left),
        (Surface::RightTop, faces.right),
        (Surface::LeafUp, Some(faces.leaf_up)),
        (Surface::LeafDown, Some(faces.leaf_down)),
    ];
    pages
        .into_iter()
        .filter(|(surface, _)| shot.pieces.iter().any(|p| p.surface == *surface))
        .map(|(_, page)| page)
}

fn material<'a>(
    surface: Surface,
    shot: &Shot,
    faces: &Faces,
    pages: &'a Pages,
    set: &Set,
) -> Material<'a> {
    let page = |page| Material::paper(pages.get(page), None, f32::INFINITY);
    let (up, down) = (pages.get(Some(faces.leaf_up)), pages.get(Some(faces.leaf_down)));
    let edges = |leaves: u32| Material::PageEdges { leaves: leaves as f32, tint: PAPER_TINT };
    let thickness = optical_thickness_m(shot, set.thickness_m);
    match surface {
        Surface::LeafUp => Material::paper(up, down, thickness),
        Surface::LeafDown => Material::paper(down, up, thickness),
        Surface::LeafRim if shot.held > 1 => edges(shot.held),
        Surface::LeafRim => Material::paper(None, None, thickness),
        Surface::LeftTop => page(faces.left),
        Surface::RightTop => page(faces.right),
        Surface::LeftSides => edges(shot.leaves[0]),
        Surface::RightSides => edges(shot.leaves[1]),
        Surface::LeftBottom | Surface::RightBottom => page(None),
        Surface::LeftBoard | Surface::RightBoard | Surface::Spine => {
            Material::Board { colour: Vec3::new(0.16, 0.035, 0.03), roughness: 0.75 }
        }
    }
}

/// What light has to pass: one leaf, not a stack. What passes a leaf that lies on a page comes back
/// from that page, so a leaf is opaque to the eye until it has risen.
fn optical_thickness_m(shot: &Shot, leaf_m: f32) -> f32 {
    if shot.held > 1 { f32::INFINITY } else { leaf_m - shot.free.ln() / PAPER_ALPHA }
}

fn table(y: f32) -> [Vertex; 4] {
    let r = TABLE_M;
    [[-r, -r], [-r, r], [r, r], [r, -r]].map(|[x, z]| Vertex {
        position: [x, y, z],
        normal: [0.0, 1.0, 0.0],
        uv: [0.5 + 0.5 * x / r, 0.5 + 0.5 * z / r],
    })
}
