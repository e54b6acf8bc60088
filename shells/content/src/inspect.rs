//! Looks through a PDF page before it is drawn: is it one that may be drawn?
//!
//! hayro believes what a page says about its images, dashes and tiles, and takes memory for them;
//! memory that cannot be had ends the process, and no guard catches that. So the page is first
//! read with a device that draws nothing and adds up what it would cost.
//!
//! When the page has cost too much the device unwinds out of hayro, without a panic message: a few
//! nested forms can ask for more calls than anyone can wait for, and there is no other way out.

use crate::guard::guarded;
use crate::limits::MAX_PIXELS;
use hayro::hayro_interpret::font::{Glyph, GlyphRun, OutlineGlyph, PositionedGlyph};
use hayro::hayro_interpret::pattern::{Pattern, TilingPattern};
use hayro::hayro_interpret::{
    BlendMode, CacheKey, ClipPath, Context, Device, DrawMode, DrawProps, Image, ImageDrawProps,
    InterpreterCache, InterpreterSettings, Paint, SoftMask, StrokeProps, TransformExt,
    interpret_page,
};
use hayro::hayro_syntax::object::{Dict, Stream};
use hayro::hayro_syntax::page::Page;
use hayro::kurbo::{Affine, BezPath, PathEl, Rect};
use std::collections::{HashMap, HashSet};

/// Steps a page may take; a dense map has some 100,000 paths.
const MAX_STEPS: f64 = 2e6;

/// Steps of a soft mask or a tiling when it is first met: it needs a canvas of its own.
const CANVAS_STEPS: f64 = 1000.0;

/// Steps of filling a path with a tiling or a gradient, beyond drawing the tile.
const PATTERN_STEPS: f64 = 20.0;

/// Steps of a clip or a group, one of which every form begins with: forms within forms, each naming
/// the next one twice, are the quickest way to write a page that never ends.
const FORM_STEPS: f64 = 5.0;

/// Pixels of an image that count as one step.
const PIXELS_PER_STEP: f64 = 1000.0;

/// Says what is wrong with a page, if anything is; the cost of one reading without drawing.
pub(crate) fn inspect(page: &Page<'_>) -> Result<(), String> {
    let mut inspector = Inspector::default();
    let outcome = guarded(|| read(page, &mut inspector));
    match (outcome, inspector.fault) {
        (_, Some(fault)) => Err(fault.into()),
        (Ok(()), None) => Ok(()),
        (Err(_), None) => Err("its drawing instructions are damaged".into()),
    }
}

fn read(page: &Page<'_>, inspector: &mut Inspector) {
    let (width, height) = page.render_dimensions();
    let all = Rect::new(0.0, 0.0, f64::from(width), f64::from(height));
    let place = page.initial_transform(true).to_kurbo();
    let cache = InterpreterCache::new();
    let settings = InterpreterSettings::default();
    let mut context = Context::new(place, all, &cache, page.xref(), settings);
    interpret_page(page, &mut context, inspector);
}

#[derive(Default)]
struct Inspector {
    steps: f64,
    fault: Option<&'static str>,
    /// Soft masks met before, which hayro draws but once.
    masks: HashSet<u128>,
    /// The steps of drawing each tile met before: hayro draws it for every path.
    tiles: HashMap<u128, f64>,
}

impl Inspector {
    fn spend(&mut self, steps: f64) {
        self.steps += steps;
        // Written so that NaN is too much as well.
        let affordable = self.steps <= MAX_STEPS;
        if !affordable {
            self.refuse("it has too many drawing instructions");
        }
    }

    fn refuse(&mut self, fault: &'static str) {
        self.fault = Some(fault);
        std::panic::resume_unwind(Box::new(fault));
    }

    fn paint<'a>(&mut self, paint: &Paint<'a>) {
        if let Paint::Pattern(pattern) = paint {
            self.spend(PATTERN_STEPS);
            if let Pattern::Tiling(tiling) = pattern.as_ref() {
                self.tile(tiling);
            }
        }
    }

    fn tile<'a>(&mut self, tiling: &TilingPattern<'a>) {
        let key = tiling.cache_key();
        if let Some(&steps) = self.tiles.get(&key) {
            return self.spend(steps);
        }
        self.spend(CANVAS_STEPS);
        let before = self.steps;
        tiling.interpret(self, Affine::IDENTITY, false);
        let steps = (self.steps - before) * copies(tiling);
        self.spend(steps);
        self.tiles.insert(key, steps);
    }

    fn mask<'a>(&mut self, mask: Option<&SoftMask<'a>>) {
        if let Some(mask) = mask
            && self.masks.insert(mask.cache_key())
        {
            self.spend(CANVAS_STEPS);
            mask.interpret(self);
        }
    }

    fn image(&mut self, stream: &Stream<'_>) {
        let dict = stream.dict();
        self.pixels(dict);
        for mask in ["SMask", "Mask"] {
            if let Some(mask) = dict.get::<Stream<'_>>(mask) {
                self.pixels(mask.dict());
            }
        }
    }

    fn pixels(&mut self, dict: &Dict<'_>) {
        let side = |short, long| dict.get::<u32>(short).or_else(|| dict.get::<u32>(long));
        let (w, h) = (side("W", "Width").unwrap_or(0), side("H", "Height").unwrap_or(0));
        let pixels = u64::from(w) * u64::from(h);
        if pixels > MAX_PIXELS {
            self.refuse("an image on it has too many pixels");
        }
        self.spend(pixels as f64 / PIXELS_PER_STEP);
    }

    fn glyph(&mut self, glyph: &PositionedGlyph<'_>, outline: &OutlineGlyph, mode: &DrawMode) {
        if let Some(stroke) = dashed(mode) {
            let scale = glyph.transform().determinant().abs().sqrt();
            self.spend(scale * dashes(&outline.outline(), stroke));
        }
    }
}

impl<'a> Device<'a> for Inspector {
    fn draw_path(&mut self, path: &BezPath, props: DrawProps<'a>, mode: &DrawMode) {
        self.spend(1.0);
        if let Some(stroke) = dashed(mode) {
            self.spend(dashes(path, stroke));
        }
        self.paint(&props.paint);
        self.mask(props.soft_mask.as_ref());
    }

    fn push_clip_path(&mut self, _: &ClipPath) {
        self.spend(FORM_STEPS);
    }

    fn push_transparency_group(&mut self, _: f32, mask: Option<SoftMask<'a>>, _: BlendMode) {
        self.spend(FORM_STEPS);
        self.mask(mask.as_ref());
    }

    fn draw_glyph_run(&mut self, run: &GlyphRun<'_, 'a>, props: DrawProps<'a>, mode: &DrawMode) {
        self.paint(&props.paint);
        self.mask(props.soft_mask.as_ref());
        for glyph in run.glyphs() {
            self.spend(1.0);
            match &**glyph {
                Glyph::Outline(outline) => self.glyph(glyph, outline, mode),
                Glyph::Type3(drawn) => {
                    drawn.interpret(self, props.transform, glyph.transform(), &props.paint);
                }
            }
        }
    }

    fn draw_image(&mut self, image: Image<'a, '_>, props: ImageDrawProps<'a>) {
        self.mask(props.soft_mask.as_ref());
        match image {
            Image::Stencil(stencil) => self.image(stencil.stream()),
            Image::Raster(raster) => self.image(raster.stream()),
        }
    }

    fn pop_clip(&mut self) {}

    fn pop_transparency_group(&mut self) {}
}

/// How often a tiling's cell is drawn to fill one tile.
fn copies(tiling: &TilingPattern<'_>) -> f64 {
    let along = |length: f64, step: f32| (length / f64::from(step.abs())).max(1.0);
    along(tiling.bbox.width(), tiling.x_step) * along(tiling.bbox.height(), tiling.y_step)
}

fn dashed(mode: &DrawMode) -> Option<&StrokeProps> {
    match mode {
        DrawMode::Stroke(stroke) | DrawMode::FillAndStroke(_, stroke) => {
            (!stroke.dash_array.is_empty()).then_some(stroke)
        }
        DrawMode::Fill(_) | DrawMode::Invisible => None,
    }
}

/// Into how many dashes a path is cut; not a number where the dashes make no sense.
fn dashes(path: &BezPath, stroke: &StrokeProps) -> f64 {
    let dash = &stroke.dash_array;
    if dash.iter().any(|&part| part < 0.0) {
        return f64::NAN;
    }
    let period: f64 = dash.iter().copied().map(f64::from).sum();
    dash.len() as f64 * polygon_length(path) / period
}

/// The length of a path's control polygon: at least the path's own.
fn polygon_length(path: &BezPath) -> f64 {
    let (mut at, mut length) = (None, 0.0);
    for element in path.elements() {
        let points = match *element {
            PathEl::MoveTo(p) => {
                at = Some(p);
                continue;
            }
            PathEl::LineTo(p) => vec![p],
            PathEl::QuadTo(a, b) => vec![a, b],
            PathEl::CurveTo(a, b, c) => vec![a, b, c],
            PathEl::ClosePath => continue,
        };
        for p in points {
            length += at.map_or(0.0, |before: hayro::kurbo::Point| before.distance(p));
            at = Some(p);
        }
    }
    length
}
