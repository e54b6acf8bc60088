//! The shapes: two page blocks as extruded curves, a bent leaf, boards, a table.

use dogleaf_core::mesh::Vertex;
use dogleaf_render::{Material, PAPER_TINT, Patch, Texture, Vec3};

const WIDTH: f32 = 0.13;
const HEIGHT: f32 = 0.20;
const LEAF: f32 = 0.000_11;
const BOARD: f32 = 0.0028;
/// Thickness of the left and the right block.
const BLOCKS: [f32; 2] = [0.009, 0.015];
const STEPS: usize = 48;

/// Vertices and triangles of one part.
#[derive(Default)]
struct Mesh {
    vertices: Vec<Vertex>,
    indices: Vec<u16>,
}

impl Mesh {
    fn vertex(&mut self, position: Vec3, normal: Vec3, uv: [f32; 2]) -> u16 {
        self.vertices.push(Vertex { position: position.into(), normal: normal.into(), uv });
        (self.vertices.len() - 1) as u16
    }

    fn quad(&mut self, corners: [Vec3; 4], uv: [[f32; 2]; 4]) {
        let normal = (corners[1] - corners[0]).cross(corners[3] - corners[0]).normalize_or(Vec3::Y);
        let i: [u16; 4] = std::array::from_fn(|k| self.vertex(corners[k], normal, uv[k]));
        self.indices.extend([i[0], i[1], i[2], i[0], i[2], i[3]]);
    }

    /// A grid of `nu` by `nv` cells over `place(u, v)`, u and v in 0..1; the normal is on the side
    /// of ∂v × ∂u times `side`.
    fn sheet(
        &mut self,
        nu: usize,
        nv: usize,
        side: f32,
        place: impl Fn(f32, f32) -> Vec3,
        uv: impl Fn(f32, f32) -> [f32; 2],
    ) {
        let base = self.vertices.len();
        for j in 0..=nv {
            for i in 0..=nu {
                let (u, v) = (i as f32 / nu as f32, j as f32 / nv as f32);
                let e = 1e-3;
                let du = place(u + e, v) - place(u - e, v);
                let dv = place(u, v + e) - place(u, v - e);
                let normal = dv.cross(du).normalize_or(Vec3::Y) * side;
                self.vertex(place(u, v), normal, uv(u, v));
            }
        }
        let at = |i: usize, j: usize| (base + j * (nu + 1) + i) as u16;
        for j in 0..nv {
            for i in 0..nu {
                let (a, b, c, d) = (at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
                self.indices.extend([a, b, c, a, c, d]);
            }
        }
    }
}

/// All parts of the book.
pub(crate) struct Book {
    tops: [Mesh; 2],
    edges: [Mesh; 2],
    recto: Mesh,
    verso: Mesh,
    rim: Mesh,
    boards: Mesh,
    table: Mesh,
}

/// Upper page of a block: height above its foot at `s` metres from the binding.
fn profile(thickness: f32, s: f32) -> f32 {
    let rise = 1.0 - (-s / 0.011).exp();
    let sag = (s / WIDTH).powi(2);
    0.0012 + thickness * (rise * (1.10 - 0.13 * sag) - 0.02)
}

/// Place of the upper page, `side` -1 left, +1 right; `u` 0..1 from the binding.
fn top(side: f32, thickness: f32, u: f32, z: f32) -> Vec3 {
    // Leaves higher in the block start further from the spine: the cut edge is sheared.
    let s = u * (WIDTH - 0.25 * thickness);
    Vec3::new(side * s, BOARD + profile(thickness, s.max(0.0)), z)
}

fn z_of(v: f32) -> f32 {
    (v - 0.5) * HEIGHT
}

impl Book {
    /// A book whose active leaf has gone `turned` of its way from right to left.
    pub(crate) fn new(turned: f32) -> Self {
        let mut book = Self {
            tops: [Mesh::default(), Mesh::default()],
            edges: [Mesh::default(), Mesh::default()],
            recto: Mesh::default(),
            verso: Mesh::default(),
            rim: Mesh::default(),
            boards: boards(),
            table: table(),
        };
        for (k, side) in [-1.0_f32, 1.0].into_iter().enumerate() {
            let thickness = BLOCKS[k];
            let u_of = move |u: f32| if side < 0.0 { 1.0 - u } else { u };
            book.tops[k].sheet(
                STEPS,
                6,
                side,
                |u, v| top(side, thickness, u * u.abs().sqrt(), z_of(v)),
                |u, v| [u_of(u * u.sqrt()), v],
            );
            book.edges[k] = cut_edges(side, thickness);
        }
        let half = LEAF * 0.5;
        let normal = |u: f32, v: f32| {
            let e = 1e-3;
            let du = leaf(turned, u + e, v) - leaf(turned, u - e, v);
            let dv = leaf(turned, u, v + e) - leaf(turned, u, v - e);
            dv.cross(du).normalize_or(Vec3::Y)
        };
        book.recto.sheet(
            STEPS,
            14,
            1.0,
            |u, v| leaf(turned, u, v) + normal(u, v) * half,
            |u, v| [u, v],
        );
        book.verso.sheet(
            STEPS,
            14,
            -1.0,
            |u, v| leaf(turned, u, v) - normal(u, v) * half,
            |u, v| [1.0 - u, v],
        );
        for (v, _) in [(0.0, ()), (1.0, ())] {
            let place = |u: f32, w: f32| leaf(turned, u, v) + normal(u, v) * (LEAF * (w - 0.5));
            book.rim.sheet(STEPS, 1, if v > 0.5 { 1.0 } else { -1.0 }, place, |u, w| [u, w]);
        }
        let fore = |a: f32, w: f32| leaf(turned, 1.0, a) + normal(1.0, a) * (LEAF * (w - 0.5));
        book.rim.sheet(14, 1, 1.0, fore, |u, w| [u, w]);
        book
    }

    /// The parts with their materials; `pages` are left page, recto, verso, right page.
    pub(crate) fn patches<'a>(&'a self, pages: &'a [Texture]) -> Vec<Patch<'a>> {
        let patch = |mesh: &'a Mesh, material| Patch {
            vertices: &mesh.vertices,
            indices: &mesh.indices,
            material,
        };
        let block = |page: &'a Texture| Material::paper(Some(page), None, f32::INFINITY);
        let edges = |k: usize| Material::PageEdges { leaves: BLOCKS[k] / LEAF, tint: PAPER_TINT };
        let cloth = Material::Board { colour: Vec3::new(0.115, 0.022, 0.020), roughness: 0.75 };
        let wood = Material::Table { colour: Vec3::new(0.074, 0.040, 0.022), grain: 1.0 };
        vec![
            patch(&self.tops[0], block(&pages[0])),
            patch(&self.tops[1], block(&pages[3])),
            patch(&self.recto, Material::paper(Some(&pages[1]), Some(&pages[2]), LEAF)),
            patch(&self.verso, Material::paper(Some(&pages[2]), Some(&pages[1]), LEAF)),
            patch(&self.rim, Material::paper(None, None, LEAF)),
            patch(&self.edges[0], edges(0)),
            patch(&self.edges[1], edges(1)),
            patch(&self.boards, cloth),
            patch(&self.table, wood),
        ]
    }
}

/// The leaf's midsurface; `u` from the binding, `v` from head to tail.
fn leaf(turned: f32, u: f32, v: f32) -> Vec3 {
    use std::f32::consts::PI;
    let lag = (PI * turned).sin();
    let lead = 0.10 * lag * (v - 0.35);
    let middle = PI * (turned + lead).clamp(0.0, 1.0);
    let bend = 1.25 * lag * (1.0 - 2.0 * turned).clamp(-1.0, 1.0) + 0.55 * lag;
    let mut at = Vec3::new(0.0, BOARD + 0.0012, z_of(v));
    let steps = 32;
    let length = u * (WIDTH - 0.003) / steps as f32;
    for i in 0..steps {
        let s = (i as f32 + 0.5) / steps as f32 * u;
        // Rises from the gutter, then leans over.
        let root = 0.55 * (-s * 14.0).exp() * (PI * 0.5 - middle);
        let angle = middle + bend * (0.45 - s) + root;
        at += Vec3::new(angle.cos(), angle.sin(), 0.0) * length;
        let side = if at.x < 0.0 { 0 } else { 1 };
        let floor = BOARD + profile(BLOCKS[side], at.x.abs()) + 0.0003;
        at.y = at.y.max(floor);
    }
    at
}

/// Head, tail and fore-edge of a block; `uv.y` across the leaves.
fn cut_edges(side: f32, thickness: f32) -> Mesh {
    let mut mesh = Mesh::default();
    let foot = |u: f32| Vec3::new(side * u * WIDTH, BOARD, 0.0);
    for (z, out) in [(-0.5 * HEIGHT, -1.0), (0.5 * HEIGHT, 1.0)] {
        let place = move |u: f32, w: f32| {
            let (low, high) = (foot(u), top(side, thickness, u * u.abs().sqrt(), 0.0));
            low.lerp(high, w) + Vec3::Z * z
        };
        mesh.sheet(STEPS, 2, -side * out, place, |u, w| [u, w]);
    }
    let fore =
        move |w: f32, v: f32| foot(1.0).lerp(top(side, thickness, 1.0, 0.0), w) + Vec3::Z * z_of(v);
    mesh.sheet(2, 8, -side, fore, |w, v| [v, w]);
    mesh
}

/// Two boards and a spine strip, as boxes.
fn boards() -> Mesh {
    let mut mesh = Mesh::default();
    let (over, joint) = (0.0035, 0.004);
    let z = HEIGHT * 0.5 + over;
    for side in [-1.0, 1.0] {
        let (a, b) = (side * joint, side * (WIDTH + over));
        cuboid(&mut mesh, Vec3::new(a.min(b), 0.0002, -z), Vec3::new(a.max(b), BOARD, z));
    }
    cuboid(&mut mesh, Vec3::new(-joint, 0.0002, -z), Vec3::new(joint, 0.0016, z));
    mesh
}

fn cuboid(mesh: &mut Mesh, low: Vec3, high: Vec3) {
    let p = |x: u8, y: u8, z: u8| {
        let pick = |k: u8, a: f32, b: f32| if k == 0 { a } else { b };
        Vec3::new(pick(x, low.x, high.x), pick(y, low.y, high.y), pick(z, low.z, high.z))
    };
    let uv = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
    mesh.quad([p(0, 1, 0), p(0, 1, 1), p(1, 1, 1), p(1, 1, 0)], uv);
    mesh.quad([p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1)], uv);
    mesh.quad([p(1, 0, 0), p(0, 0, 0), p(0, 1, 0), p(1, 1, 0)], uv);
    mesh.quad([p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0)], uv);
    mesh.quad([p(1, 0, 1), p(1, 0, 0), p(1, 1, 0), p(1, 1, 1)], uv);
}

fn table() -> Mesh {
    let mut mesh = Mesh::default();
    let r = 3.0;
    let c = [[-r, -r], [-r, r], [r, r], [r, -r]].map(|[x, z]| Vec3::new(x, 0.0, z));
    mesh.quad(c, [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]]);
    mesh
}
