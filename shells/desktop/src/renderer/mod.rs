//! A book drawn by OpenGL ES 3.0: one mesh, one program for all that is seen, one for what throws shadows.
//!
//! It knows no window and no input. A host hands it the mesh of a frame and the pages it shows; it draws into the
//! window the context belongs to, or into a picture to be kept. Where a context is lost, make another renderer.

mod look;
mod stage;

pub use look::Leaves;
pub use stage::{Lamp, Stage};

use crate::gl::{Canvas, Gl, Maps, Mesh, Program, Texture};
use crate::glsl;
use dogleaf_core::mesh::Vertex;
use dogleaf_core::reading::{Face, Piece};
use look::{Look, look};
use std::collections::BTreeMap;
use std::ops::Range;

/// Maps of the lamp: how many, how many beside each other, their side in texels. As in `common.glsl`.
const LAMP: (i32, i32, i32) = (16, 4, 512);
/// The same of the sky.
const SKY: (i32, i32, i32) = (32, 8, 192);
/// Size of the grain's picture, texels. As in `grain.frag`.
const GRAIN: [u32; 2] = [192, 1536];
/// Linear colour where nothing is drawn, as it is encoded.
const BACKGROUND: [f32; 3] = [0.152; 3];
/// Samples a pixel of a picture that is kept.
const SAMPLES: i32 = 8;
/// Units through which the textures are read.
const UNITS: [(&str, i32); 5] =
    [("front", 0), ("back", 1), ("grain", 2), ("lampMaps", 3), ("skyMaps", 4)];

/// Why nothing can be drawn: the driver's own words.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("OpenGL ES 3.0 is wanted ({0})")]
pub struct DrawError(String);

/// One frame of a book.
#[derive(Debug, Clone, Copy)]
pub struct Scene<'a> {
    /// Where it is seen.
    pub stage: &'a Stage,
    /// What there is of it, and what it shows: from `Reading::vertices`.
    pub pieces: &'a [Piece],
    /// Where its leaves are.
    pub leaves: Leaves,
}

/// Draws books of one grid.
#[derive(Debug)]
pub struct BookRenderer {
    gl: Gl,
    page: Program,
    shadow: Program,
    mesh: Mesh,
    table: Mesh,
    lamp: Maps,
    sky: Maps,
    grain: Texture,
    blank: Texture,
    pages: BTreeMap<u32, Texture>,
    canvas: Option<([u32; 2], Canvas)>,
}

impl BookRenderer {
    /// A renderer for meshes of so many vertices, with these triangles between them.
    ///
    /// # Errors
    ///
    /// What the driver refuses.
    pub fn new(gl: Gl, vertices: usize, indices: &[u16]) -> Result<Self, DrawError> {
        Self::made(gl, vertices, indices).map_err(|why| DrawError(one_line(&why)))
    }

    fn made(gl: Gl, vertices: usize, indices: &[u16]) -> Result<Self, String> {
        let program = |pair: glsl::Pair| {
            let [vertex, fragment] = pair.sources();
            gl.program(&vertex, &fragment)
        };
        let page = program(glsl::PAGE)?;
        let shadow = program(glsl::SHADOW)?;
        let mesh = gl.mesh(vertices, indices)?;
        let table = gl.mesh(4, &[0, 1, 2, 0, 2, 3])?;
        let wood = program(glsl::GRAIN)?;
        let grain = gl.drawn(GRAIN, || {
            gl.use_program(wood);
            gl.draw_everywhere(table);
        })?;
        let room = |(count, across, side): (i32, i32, i32)| {
            gl.maps([across * side, count / across * side])
        };
        let (lamp, sky) = (room(LAMP)?, room(SKY)?);
        let blank = gl.picture([1, 1], &[255; 4])?;
        gl.use_program(page);
        UNITS.iter().for_each(|(name, unit)| gl.int(page, name, *unit));
        let pages = BTreeMap::new();
        let canvas = None;
        match gl.complaint() {
            Some(error) => Err(format!("error {error:#x} while setting up")),
            None => {
                Ok(Self { gl, page, shadow, mesh, table, lamp, sky, grain, blank, pages, canvas })
            }
        }
    }

    /// What the driver calls itself.
    #[must_use]
    pub fn driver(&self) -> String {
        self.gl.name()
    }

    /// Whether a page's picture is there.
    #[must_use]
    pub fn has_page(&self, page: u32) -> bool {
        self.pages.contains_key(&page)
    }

    /// Takes a page's picture: RGBA bytes, sRGB, rows from the top, opaque.
    ///
    /// # Errors
    ///
    /// The bytes are no picture of that size, or the card is full.
    pub fn set_page(&mut self, page: u32, size: [u32; 2], rgba: &[u8]) -> Result<(), DrawError> {
        let texture = self.gl.picture(size, rgba).map_err(DrawError)?;
        if let Some(old) = self.pages.insert(page, texture) {
            self.gl.forget(old);
        }
        Ok(())
    }

    /// Gives back the pictures of all pages but these.
    pub fn keep_pages(&mut self, wanted: impl Fn(u32) -> bool) {
        let gl = &self.gl;
        self.pages.retain(|page, texture| {
            let keep = wanted(*page);
            if !keep {
                gl.forget(*texture);
            }
            keep
        });
    }

    /// Takes the mesh of a frame.
    pub fn upload(&mut self, vertices: &[Vertex]) {
        self.gl.fill(self.mesh, vertices);
    }

    /// Draws into the window.
    pub fn draw(&mut self, scene: &Scene<'_>) {
        self.maps(scene);
        self.gl.to_window([scene.stage.view.width_px, scene.stage.view.height_px]);
        self.picture(scene);
    }

    /// Draws into a picture of its own: RGBA bytes, rows from the top.
    ///
    /// # Errors
    ///
    /// The card is full.
    pub fn shoot(&mut self, scene: &Scene<'_>) -> Result<Vec<u8>, DrawError> {
        self.maps(scene);
        let size = [scene.stage.view.width_px, scene.stage.view.height_px];
        let canvas = self.canvas(size)?;
        self.gl.to_canvas(&canvas);
        self.picture(scene);
        let bytes = self.gl.read(&canvas);
        match self.gl.complaint() {
            Some(error) => Err(DrawError(format!("error {error:#x} while drawing"))),
            None => Ok(bytes),
        }
    }

    /// Waits until all that was asked for is drawn; for measuring.
    pub fn finish(&self) {
        self.gl.finish();
    }

    fn canvas(&mut self, size: [u32; 2]) -> Result<Canvas, DrawError> {
        if let Some((_, canvas)) = self.canvas.filter(|(has, _)| *has == size) {
            return Ok(canvas);
        }
        if let Some((_, old)) = self.canvas.take() {
            self.gl.forget_canvas(&old);
        }
        let canvas = self.gl.canvas(size, SAMPLES).map_err(DrawError)?;
        self.canvas = Some((size, canvas));
        Ok(canvas)
    }

    /// Draws every shadow map.
    fn maps(&self, scene: &Scene<'_>) {
        let runs = runs(scene.pieces);
        self.gl.use_program(self.shadow);
        self.light(self.shadow, scene.stage);
        let mut first = 0;
        for (maps, (count, across, side)) in [(self.lamp, LAMP), (self.sky, SKY)] {
            self.gl.to_maps(maps);
            self.gl.part([0, 0, across * side, count / across * side]);
            self.gl.begin_maps();
            for n in 0..count {
                self.gl.part([n % across * side, n / across * side, side, side]);
                self.gl.int(self.shadow, "map", first + n);
                runs.iter().for_each(|run| self.gl.draw(self.mesh, run.clone()));
            }
            first += count;
        }
    }

    /// Where the lamp is and what can stand in its way.
    fn light(&self, program: Program, stage: &Stage) {
        let [x, y, z] = stage.lamp.position;
        self.gl.vec4(program, "lamp", [x, y, z, stage.lamp.radius_m]);
        self.gl.vec4(program, "bound", [0.0, 0.0, 0.0, stage.radius_m]);
    }

    /// Draws the book and the table into the target.
    fn picture(&self, scene: &Scene<'_>) {
        let (gl, stage) = (&self.gl, scene.stage);
        gl.begin_picture(BACKGROUND);
        gl.use_program(self.page);
        self.light(self.page, stage);
        gl.mat4(self.page, "clipFromWorld", &stage.clip_from_world());
        gl.vec3(self.page, "eye", stage.eye());
        gl.vec2(self.page, "picture", [stage.view.width_px as f32, stage.view.height_px as f32]);
        gl.float(self.page, "pixelAtOneMetre", stage.pixel_at_one_metre());
        gl.vec3(self.page, "lampColour", stage.lamp.colour);
        gl.bind(2, self.grain);
        gl.bind(3, self.lamp.texture);
        gl.bind(4, self.sky.texture);
        for piece in scene.pieces.iter().filter(|p| p.visible) {
            let look = look(piece, scene.pieces, &scene.leaves, stage.leaf_m);
            self.piece(&look, self.mesh, piece.indices.clone());
        }
        // Last: most of it is hidden by then.
        gl.fill(self.table, &stage.table());
        self.piece(&Look::TABLE, self.table, 0..6);
    }

    fn piece(&self, look: &Look, mesh: Mesh, indices: Range<usize>) {
        let gl = &self.gl;
        let picture = |page: Option<u32>| {
            page.and_then(|page| self.pages.get(&page)).copied().unwrap_or(self.blank)
        };
        gl.int(self.page, "material", look.material);
        gl.vec3(self.page, "tint", look.tint);
        gl.float(self.page, "passing", look.passing);
        gl.float(self.page, "thickness", look.thickness);
        gl.float(self.page, "leaves", look.leaves);
        gl.bind(0, picture(look.front));
        gl.bind(1, picture(look.back));
        gl.draw(mesh, indices);
    }
}

/// The pages a frame shows.
pub fn pages(pieces: &[Piece]) -> impl Iterator<Item = u32> {
    pieces.iter().filter(|p| p.visible).filter_map(|p| match p.face {
        Face::Page(page) => Some(page),
        Face::Edge | Face::Cover => None,
    })
}

/// The indices of all that is there, in as few ranges as possible.
fn runs(pieces: &[Piece]) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    for piece in pieces.iter().filter(|p| p.visible) {
        match runs.last_mut() {
            Some(last) if last.end == piece.indices.start => last.end = piece.indices.end,
            _ => runs.push(piece.indices.clone()),
        }
    }
    runs
}

/// Text without line breaks and other controls.
fn one_line(text: &str) -> String {
    let parts: Vec<&str> = text.split_whitespace().collect();
    parts.join(" ").chars().filter(|c| !c.is_control()).collect()
}
