//! The tables of a scene, each into the core's spec of the same name.

use super::error::{Fault, SceneError};
use super::ribbon::{RibbonPart, extent};
use super::section::Section;
use super::{Body, PICTURE};
use crate::grid::GridName;
use dogleaf_core::hand::{Phase, Sample, View};
use dogleaf_core::scene::{
    BookSpec, Cover, Direction, LeafSpec, PaperSpec, Preset, SpecError, Weights, WorldSpec,
};

/// Shortest and longest frame, microseconds.
const FRAME_US: std::ops::RangeInclusive<u32> = 100..=1_000_000;

/// A spec's fault at the line of the key it names.
pub(super) fn check(
    section: &Section<'_>,
    result: Result<(), SpecError>,
) -> Result<(), SceneError> {
    result.map_err(|error| {
        let (SpecError::NotFinite(field) | SpecError::OutOfRange(field)) = error;
        let path = field.split(' ').next().unwrap_or(field);
        let key = path.rsplit('.').next().unwrap_or(path);
        section.fault(key, error.into())
    })
}

/// The world, and the time of a frame.
pub(super) fn world(root: &Section<'_>) -> Result<(WorldSpec, u32), SceneError> {
    let s = root.section("world", &["gravity", "damping_per_s", "step_us", "seed", "frame_us"])?;
    let d = WorldSpec::default();
    let world = WorldSpec {
        gravity: s.numbers("gravity", d.gravity)?,
        damping_per_s: s.number("damping_per_s", d.damping_per_s)?,
        step_us: s.whole("step_us", d.step_us)?,
        seed: s.whole("seed", d.seed)?,
    };
    check(&s, world.check())?;
    let frame_us = s.whole("frame_us", 16_667)?;
    if !FRAME_US.contains(&frame_us) {
        check(&s, Err(SpecError::OutOfRange("world.frame_us")))?;
    }
    Ok((world, frame_us))
}

/// The paper: a preset, changed number by number.
pub(super) fn paper(root: &Section<'_>) -> Result<PaperSpec, SceneError> {
    let known = ["preset", "areal_mass_gsm", "thickness_mm", "youngs_gpa", "poisson", "weights"];
    let s = root.section("paper", &known)?;
    let d = PaperSpec::from(s.choice("preset", Preset::default(), &Preset::ALL)?);
    let weights = weights(&s)?;
    let paper = PaperSpec {
        areal_mass_gsm: s.number("areal_mass_gsm", d.areal_mass_gsm)?,
        thickness_mm: s.number("thickness_mm", d.thickness_mm)?,
        youngs_gpa: s.number("youngs_gpa", d.youngs_gpa)?,
        poisson: s.number("poisson", d.poisson)?,
        weights: None,
    };
    check(&s, paper.check())?;
    let Some((section, weights)) = weights else { return Ok(paper) };
    let paper = PaperSpec { weights: Some(weights), ..paper };
    check(&section, paper.check())?;
    Ok(paper)
}

fn weights<'a>(paper: &Section<'a>) -> Result<Option<(Section<'a>, Weights)>, SceneError> {
    let known = ["bend_3d", "bend_2d", "glue", "iso_3d", "position"];
    let s = paper.section("paper.weights", &known)?;
    if !s.is_there() {
        return Ok(None);
    }
    let d = Weights::default();
    let weights = Weights {
        bend_3d: s.number("bend_3d", d.bend_3d)?,
        bend_2d: s.number("bend_2d", d.bend_2d)?,
        glue: s.number("glue", d.glue)?,
        iso_3d: s.number("iso_3d", d.iso_3d)?,
        position: s.number("position", d.position)?,
    };
    Ok(Some((s, weights)))
}

/// The book or the lone leaf; a book where the scene names neither, nor a ribbon.
pub(super) fn body(root: &Section<'_>) -> Result<(Body, GridName), SceneError> {
    if root.has("leaf") && root.has("book") {
        let fault = Fault::Conflict("a scene has a [book] or a [leaf], not both");
        return Err(root.fault("leaf", fault));
    }
    if root.has("leaf") {
        leaf(root)
    } else if root.has("ribbon") && !root.has("book") {
        Ok((Body::Nothing, GridName::default()))
    } else {
        book(root)
    }
}

fn book(root: &Section<'_>) -> Result<(Body, GridName), SceneError> {
    let known = ["width_m", "height_m", "pages", "open_at", "cover", "direction", "grid"];
    let s = root.section("book", &known)?;
    let d = BookSpec::default();
    let pages = s.whole("pages", d.pages)?;
    let covers = [("hard", Cover::Hard), ("soft", Cover::Soft)];
    let directions = [("ltr", Direction::Ltr), ("rtl", Direction::Rtl)];
    let book = BookSpec {
        width_m: s.number("width_m", d.width_m)?,
        height_m: s.number("height_m", d.height_m)?,
        pages,
        // The default place must lie inside a book shorter than the default one.
        open_at: s.whole("open_at", if d.open_at < pages { d.open_at } else { pages / 3 })?,
        cover: s.choice("cover", d.cover, &covers)?,
        direction: s.choice("direction", d.direction, &directions)?,
    };
    check(&s, book.check())?;
    Ok((Body::Book(book), grid(&s)?))
}

fn leaf(root: &Section<'_>) -> Result<(Body, GridName), SceneError> {
    let known = ["width_m", "height_m", "grid", "clamp", "clamp_angle_deg", "curl_per_m"];
    let s = root.section("leaf", &known)?;
    let d = LeafSpec::default();
    s.choice("clamp", (), &[("spine", ())])?;
    let leaf = LeafSpec {
        width_m: s.number("width_m", d.width_m)?,
        height_m: s.number("height_m", d.height_m)?,
        clamp_angle_deg: s.number("clamp_angle_deg", d.clamp_angle_deg)?,
        curl_per_m: s.number("curl_per_m", d.curl_per_m)?,
    };
    check(&s, leaf.check())?;
    Ok((Body::Leaf(leaf), grid(&s)?))
}

fn grid(s: &Section<'_>) -> Result<GridName, SceneError> {
    let size = s.numbers("grid", GridName::default().size().map(|n| n as f64))?;
    GridName::of(size).ok_or_else(|| {
        let known = GridName::ALL.map(|g| g.to_string().replace('x', ", "));
        let wanted = format!("one of [{}]", known.join("], ["));
        s.fault("grid", Fault::Kind { key: "grid".into(), wanted })
    })
}

/// Where the reader looks from: at the whole spread, at the side of a lone leaf, or at the ribbons; changed number by
/// number.
pub(super) fn view(
    root: &Section<'_>,
    body: &Body,
    ribbons: &[RibbonPart],
) -> Result<View, SceneError> {
    let s = root.section("view", &["eye_m", "target_m", "fov_y_deg", "width_px", "height_px"])?;
    let width_px = s.whole("width_px", PICTURE[0])?;
    let height_px = s.whole("height_px", PICTURE[1])?;
    let d = match body {
        Body::Book(b) => View::reading(b.width_m, b.height_m, width_px, height_px),
        Body::Leaf(l) => beside([l.width_m, l.height_m], [width_px, height_px]),
        Body::Nothing => facing(extent(ribbons), [width_px, height_px]),
    };
    let view = View {
        eye_m: s.numbers("eye_m", d.eye_m)?,
        target_m: s.numbers("target_m", d.target_m)?,
        fov_y_deg: s.number("fov_y_deg", d.fov_y_deg)?,
        width_px,
        height_px,
    };
    check(root, view.check())?;
    Ok(view)
}

/// A leaf that hangs from the clamp at the origin, seen from its tail and a little from above.
fn beside([width, height]: [f64; 2], [width_px, height_px]: [u32; 2]) -> View {
    let large = width.max(0.8 * height);
    let target_m = [0.45 * width, -0.35 * width, 0.0];
    let [x, y, _] = target_m;
    let eye_m = [x + 0.9 * large, y + 1.2 * large, 0.5 * height + 2.9 * large];
    View { eye_m, target_m, fov_y_deg: 30.0, width_px, height_px }
}

/// Something of a size, seen from its front and a little from above.
fn facing(([x, y, z], size): ([f64; 3], f64), [width_px, height_px]: [u32; 2]) -> View {
    let eye_m = [x + 0.5 * size, y + 0.6 * size, z + 2.2 * size];
    View { eye_m, target_m: [x, y, z], fov_y_deg: 30.0, width_px, height_px }
}

/// What the hand does: a file, or samples.
pub(super) enum Hand {
    File(String),
    Samples(Vec<Sample>),
}

pub(super) fn hand(root: &Section<'_>) -> Result<Hand, SceneError> {
    let s = root.section("hand", &["gesture", "samples"])?;
    match s.text("gesture")? {
        Some(_) if s.has("samples") => {
            let fault = Fault::Conflict("[hand] has a gesture file or samples, not both");
            Err(s.fault("samples", fault))
        }
        Some(file) => Ok(Hand::File(file)),
        None => samples(&s).map(Hand::Samples),
    }
}

fn samples(s: &Section<'_>) -> Result<Vec<Sample>, SceneError> {
    let known = ["t_us", "id", "phase", "x", "y", "leaves"];
    let mut samples: Vec<Sample> = Vec::new();
    for item in s.array("samples", "hand.samples", &known)? {
        let sample = Sample {
            t_us: item.whole("t_us", 0)?,
            id: item.whole("id", 0)?,
            phase: item.choice("phase", Phase::Move, &Phase::ALL)?,
            x: item.whole("x", 0)?,
            y: item.whole("y", 0)?,
            leaves: item.whole("leaves", 0)?,
        };
        if samples.last().is_some_and(|last| last.t_us > sample.t_us) {
            let fault = Fault::Conflict("hand.samples must be in the order of their t_us");
            return Err(item.fault("t_us", fault));
        }
        samples.push(sample);
    }
    Ok(samples)
}
