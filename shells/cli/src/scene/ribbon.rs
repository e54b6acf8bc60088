//! `[[ribbon]]`: each into the core's spec, and what the scene does to it.

use super::error::{Fault, SceneError};
use super::parts::check;
use super::section::Section;
use dogleaf_core::effect::ribbon::{Bending, Closure, Mass, Resample, RibbonSpec, Root};
use dogleaf_core::scene::{SpecError, WorldSpec};

/// Segments that a ribbon of a scene may have.
pub(crate) const MOST_SEGMENTS: usize = 512;
/// Ribbons that a scene may have.
const MOST_RIBBONS: usize = 64;
/// Pulls that a ribbon may have: as many springs as the core keeps.
const MOST_PULLS: usize = dogleaf_core::effect::ribbon::load::SPRINGS;

const KEYS: [&str; 26] = [
    "length_m",
    "width_m",
    "segments",
    "rigidity_nm",
    "areal_mass_gsm",
    "regularisation",
    "energy",
    "mass",
    "resample",
    "start",
    "turns",
    "slope",
    "clamp_start",
    "at_m",
    "along",
    "normal",
    "twist_end_rad",
    "twist_s",
    "twist_nm",
    "velocity_m_per_s",
    "spin_rad_per_s",
    "pulls",
    "floor_m",
    "contact",
    "look",
    "perturbation",
];

/// The shape it begins in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Start {
    Straight,
    Helix,
    Ring,
    Moebius,
}

/// What it is made of, to the eye.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Fabric {
    #[default]
    Satin,
    Paper,
}

/// A spring from a corner to a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PullPart {
    /// Crease.
    pub(crate) crease: usize,
    /// 0: rim A.
    pub(crate) rim: usize,
    pub(crate) to_m: [f64; 3],
    pub(crate) n_per_m: f64,
}

/// A turn of the end's normal about the ribbon's first direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Twist {
    pub(crate) angle_rad: f64,
    /// How long it takes.
    pub(crate) seconds: f64,
    /// Stiffness of the guide.
    pub(crate) stiffness_nm: f64,
}

impl Twist {
    /// How far it is turned.
    pub(crate) fn angle_at(&self, time_s: f64) -> f64 {
        self.angle_rad * (time_s / self.seconds).min(1.0)
    }
}

/// One ribbon of a scene.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RibbonPart {
    pub(crate) spec: RibbonSpec,
    pub(crate) start: Start,
    /// Turns of a helix, and the slope of its rulings.
    pub(crate) helix: [f64; 2],
    pub(crate) at_m: [f64; 3],
    pub(crate) along: [f64; 3],
    pub(crate) normal: [f64; 3],
    pub(crate) twist: Option<Twist>,
    pub(crate) velocity: [f64; 3],
    pub(crate) spin: [f64; 3],
    pub(crate) pulls: Vec<PullPart>,
    /// Height of a floor it does not pass through.
    pub(crate) floor_m: Option<f64>,
    /// It does not pass through itself and others that do not.
    pub(crate) contact: bool,
    pub(crate) fabric: Fabric,
}

/// All ribbons of a scene.
pub(super) fn ribbons(
    root: &Section<'_>,
    world: &WorldSpec,
) -> Result<Vec<RibbonPart>, SceneError> {
    let sections = root.array("ribbon", "ribbon", &KEYS)?;
    if sections.len() > MOST_RIBBONS {
        return Err(root.fault("ribbon", Fault::Conflict("a scene has at most 64 ribbons")));
    }
    let many = sections.len() > 1;
    sections.iter().enumerate().map(|(k, s)| ribbon(s, world, (k as u64, many))).collect()
}

fn ribbon(
    s: &Section<'_>,
    world: &WorldSpec,
    (number, many): (u64, bool),
) -> Result<RibbonPart, SceneError> {
    let starts = [
        ("straight", Start::Straight),
        ("helix", Start::Helix),
        ("ring", Start::Ring),
        ("mobius", Start::Moebius),
    ];
    let start = s.choice("start", Start::Straight, &starts)?;
    let spec = spec(s, start, world, number)?;
    let [along, normal] = directions(s)?;
    let floor_m = floor(s)?;
    Ok(RibbonPart {
        start,
        helix: [within(s, "ribbon.turns", 3.0, 1e3)?, within(s, "ribbon.slope", 0.3, 10.0)?],
        at_m: place(s, "ribbon.at_m")?,
        along,
        normal,
        twist: twist(s)?,
        velocity: place(s, "ribbon.velocity_m_per_s")?,
        spin: place(s, "ribbon.spin_rad_per_s")?,
        pulls: pulls(s, spec.segments)?,
        contact: s.flag("contact", many || floor_m.is_some())?,
        floor_m,
        fabric: s.choice(
            "look",
            Fabric::default(),
            &[("satin", Fabric::Satin), ("paper", Fabric::Paper)],
        )?,
        spec,
    })
}

fn spec(
    s: &Section<'_>,
    start: Start,
    world: &WorldSpec,
    number: u64,
) -> Result<RibbonSpec, SceneError> {
    let d = RibbonSpec::default();
    let root = s.flag("clamp_start", true)?;
    let energies = [("sadowsky", Bending::Sadowsky), ("wunderlich", Bending::Wunderlich)];
    let masses = [("consistent", Mass::Consistent), ("lumped", Mass::Lumped)];
    let ways = [("smooth", Resample::Smooth), ("linear", Resample::Linear)];
    let spec = RibbonSpec {
        length_m: s.number("length_m", d.length_m)?,
        width_m: s.number("width_m", d.width_m)?,
        segments: s.whole("segments", d.segments)?,
        rigidity_nm: s.number("rigidity_nm", d.rigidity_nm)?,
        areal_mass_gsm: s.number("areal_mass_gsm", d.areal_mass_gsm)?,
        regularisation: s.number("regularisation", d.regularisation)?,
        damping_per_s: world.damping_per_s,
        bending: s.choice("energy", d.bending, &energies)?,
        mass: s.choice("mass", d.mass, &masses)?,
        resample: s.choice("resample", d.resample, &ways)?,
        root: if root { Root::Clamp } else { Root::Free },
        closure: match start {
            Start::Straight | Start::Helix => Closure::Open,
            Start::Ring => Closure::Ring,
            Start::Moebius => Closure::Moebius,
        },
        perturbation: s.number("perturbation", d.perturbation)?,
        seed: world.seed.wrapping_add(number),
    };
    check(s, spec.check(MOST_SEGMENTS))?;
    Ok(spec)
}

/// The key a field's full name ends in.
fn last(field: &'static str) -> &'static str {
    field.rsplit('.').next().unwrap_or(field)
}

/// A number of at most a size.
fn within(
    s: &Section<'_>,
    field: &'static str,
    default: f64,
    most: f64,
) -> Result<f64, SceneError> {
    let value = s.number(last(field), default)?;
    let sound = value.is_finite() && value.abs() <= most;
    check(s, if sound { Ok(()) } else { Err(SpecError::OutOfRange(field)) })?;
    Ok(value)
}

/// A number between zero, exclusive, and a greatest.
fn positive(
    s: &Section<'_>,
    key: &'static str,
    default: f64,
    most: f64,
) -> Result<f64, SceneError> {
    let value = within(s, key, default, most)?;
    check(s, if value > 0.0 { Ok(()) } else { Err(SpecError::OutOfRange(key)) })?;
    Ok(value)
}

/// Three numbers of at most a million.
fn place(s: &Section<'_>, field: &'static str) -> Result<[f64; 3], SceneError> {
    let place: [f64; 3] = s.numbers(last(field), [0.0; 3])?;
    let bad = place.iter().find(|c| !(c.is_finite() && c.abs() <= 1e6));
    let fault = bad.map(|c| match c.is_finite() {
        true => SpecError::OutOfRange(field),
        false => SpecError::NotFinite(field),
    });
    check(s, fault.map_or(Ok(()), Err))?;
    Ok(place)
}

/// The way it runs and where its front faces.
fn directions(s: &Section<'_>) -> Result<[[f64; 3]; 2], SceneError> {
    let along = s.numbers("along", [1.0, 0.0, 0.0])?;
    let normal = s.numbers("normal", [0.0, 1.0, 0.0])?;
    let [[a, b, c], [x, y, z]] = [along, normal];
    let across = [b * z - c * y, c * x - a * z, a * y - b * x];
    let norm = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
    if norm(across) > 1e-3 * norm(along) * norm(normal) {
        return Ok([along, normal]);
    }
    let key = if s.has("normal") { "normal" } else { "along" };
    let fault = Fault::Conflict("ribbon.normal and ribbon.along must be two directions");
    Err(s.fault(key, fault))
}

fn twist(s: &Section<'_>) -> Result<Option<Twist>, SceneError> {
    let angle_rad = within(s, "ribbon.twist_end_rad", 0.0, 1e3)?;
    // A turn a second: the guide sees a normal only, which says nothing of whole turns.
    let turns = (angle_rad / std::f64::consts::TAU).abs().max(1e-3);
    let seconds = positive(s, "ribbon.twist_s", turns, 1e6)?;
    let stiffness_nm = positive(s, "ribbon.twist_nm", 10.0, 1e6)?;
    let asked = angle_rad != 0.0 || s.has("twist_end_rad");
    Ok(asked.then_some(Twist { angle_rad, seconds, stiffness_nm }))
}

fn floor(s: &Section<'_>) -> Result<Option<f64>, SceneError> {
    let height_m = within(s, "ribbon.floor_m", 0.0, 1e6)?;
    Ok(s.has("floor_m").then_some(height_m))
}

fn pulls(s: &Section<'_>, segments: usize) -> Result<Vec<PullPart>, SceneError> {
    let list = s.array("pulls", "ribbon.pulls", &["at", "rim", "to_m", "n_per_m"])?;
    if list.len() > MOST_PULLS {
        return Err(s.fault("pulls", Fault::Conflict("a ribbon has at most 8 pulls")));
    }
    let one = |s: &Section<'_>| {
        let at = within(s, "ribbon.pulls.at", 1.0, 1.0)?.abs();
        Ok(PullPart {
            crease: (at * segments as f64).round() as usize,
            rim: s.choice("rim", 0, &[("a", 0), ("b", 1)])?,
            to_m: place(s, "ribbon.pulls.to_m")?,
            n_per_m: positive(s, "ribbon.pulls.n_per_m", 100.0, 1e6)?,
        })
    };
    list.iter().map(one).collect()
}

/// The middle of all ribbons and a length that holds them, metres.
pub(super) fn extent(ribbons: &[RibbonPart]) -> ([f64; 3], f64) {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for r in ribbons {
        let (centre, half) = reach(r);
        for i in 0..3 {
            low[i] = low[i].min(centre[i] - half);
            high[i] = high[i].max(centre[i] + half);
        }
    }
    let middle = std::array::from_fn(|i| 0.5 * (low[i] + high[i]));
    (middle, (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max))
}

/// Where a ribbon will be seen: its middle, and half its size.
fn reach(r: &RibbonPart) -> ([f64; 3], f64) {
    let unit = |v: [f64; 3]| {
        let norm = v.iter().map(|c| c * c).sum::<f64>().sqrt();
        v.map(|c| c / norm)
    };
    let (t, n, l) = (unit(r.along), unit(r.normal), r.spec.length_m);
    let from = |a: f64, b: f64, down: f64| {
        let at: [f64; 3] = std::array::from_fn(|i| r.at_m[i] + a * t[i] + b * n[i]);
        [at[0], at[1] - down, at[2]]
    };
    let radius = l / std::f64::consts::TAU;
    match (r.start, r.spec.root) {
        (Start::Ring | Start::Moebius, _) => (from(0.0, 0.5 * radius, 0.0), 1.8 * radius),
        (_, Root::Free) => (from(0.5 * l, 0.0, 0.0), 0.5 * l),
        _ => (from(0.45 * l, 0.0, 0.35 * l), 0.5 * l),
    }
}
