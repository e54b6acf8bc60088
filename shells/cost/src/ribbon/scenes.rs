//! The seed's experiments as both methods see them. The paper gives lengths, widths and segments; stiffness and masses
//! are ours.

use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::joint::Crease;
use dogleaf_core::effect::ribbon::resample::Pair;
use dogleaf_core::effect::ribbon::{
    Bending, Closure, Guide, Loads, Mass, Pull, Ribbon, RibbonSpec, Root, Settings, Spring,
};
use dogleaf_core::real::V3;
use dogleaf_core::scene::SpecError;
use std::f64::consts::TAU;

/// Segments a ribbon of these scenes may have.
pub const MOST: usize = 160;
/// A ribbon of these scenes.
pub type Long = Ribbon<f64, MOST>;

/// A soft floor at height zero: `k/2 d²` at a vertex that is `d` deep. Nothing where `k` is zero.
#[derive(Debug, Clone, Copy)]
pub struct Floor(pub f64);

impl Floor {
    fn depth(self, p: &V3<f64>) -> f64 {
        if self.0 > 0.0 { (-p.0[2]).max(0.0) } else { 0.0 }
    }
}

impl Loads<f64> for Floor {
    fn energy(&self, _: usize, pair: &Pair<f64>) -> f64 {
        pair.iter().map(|p| 0.5 * self.0 * self.depth(p).powi(2)).sum()
    }
    fn pull(&self, _: usize, pair: &Pair<f64>, pull: &mut Pull<f64>) {
        let (none, up) = (V3([0.0; 3]), V3([0.0, 0.0, 1.0]));
        let depth = pair.each_ref().map(|p| self.depth(p));
        pull.push(up * (-self.0 * depth[0]), up * (-self.0 * depth[1]));
        for (d, rows) in depth.into_iter().zip([[up, none], [none, up]]) {
            if d > 0.0 {
                pull.curve(self.0, rows);
            }
        }
    }
}

/// An experiment.
#[derive(Debug)]
pub struct Scene {
    /// Its name.
    pub name: &'static str,
    /// The ribbon.
    pub ribbon: Box<Long>,
    /// Seconds a step.
    pub h: f64,
    /// Steps of it.
    pub steps: u32,
    /// The floor.
    pub floor: Floor,
    /// How far the end's normal is turned, radians.
    pub twist: f64,
}

impl Scene {
    /// What is asked of the ribbon in a step.
    pub fn ask(&mut self, step: u32) {
        if self.twist == 0.0 {
            return;
        }
        let angle = self.twist * f64::from(step + 1) / f64::from(self.steps);
        let normal = V3([0.0, -angle.sin(), angle.cos()]);
        let guide = Guide { segment: self.ribbon.spec().segments - 1, normal, stiffness: 10.0 };
        self.ribbon.ask.guides.clear();
        // There is room for one.
        let _ = self.ribbon.ask.guides.push(guide);
    }
}

/// The frame that a ribbon is laid from.
pub fn start() -> Frame<f64> {
    Frame::at(V3([0.0; 3]))
}

fn open(spec: &RibbonSpec, gravity: [f64; 3]) -> Result<Box<Long>, SpecError> {
    let mut ribbon = Box::new(Long::EMPTY);
    ribbon.open(&RibbonSpec { rigidity_nm: 2e-3, ..*spec }, [0.0; 3])?;
    ribbon.gravity = gravity;
    Ok(ribbon)
}

/// Three turns of a helix, clamped at one end, let go (Ribbon Fig. 8).
///
/// # Errors
///
/// None for these numbers: as [`Ribbon::open`].
pub fn helix(name: &'static str, h: f64) -> Result<Scene, SpecError> {
    let spec = RibbonSpec::default();
    let mut ribbon = open(&spec, [0.0, -9.81, 0.0])?;
    let psi = 3.0 * TAU / spec.segments as f64;
    ribbon.lay(&start(), |_| Crease { psi, c: 0.3 });
    let steps = (1.0 / h).round() as u32;
    Ok(Scene { name, ribbon, h, steps, floor: Floor(0.0), twist: 0.0 })
}

/// Three metres in 150 segments, free, half a metre above a soft floor (Ribbon Fig. 12).
///
/// # Errors
///
/// As [`helix`].
pub fn fall() -> Result<Scene, SpecError> {
    let spec =
        RibbonSpec { length_m: 3.0, segments: 150, root: Root::Free, ..RibbonSpec::default() };
    let mut ribbon = open(&spec, [0.0, 0.0, -9.81])?;
    let wave = |j: usize, k: f64| (j as f64 * k).sin();
    ribbon.lay(&Frame::at(V3([0.0, 0.0, 0.5])), |j| Crease {
        psi: 0.1 * wave(j, 0.05),
        c: 0.2 * wave(j, 0.03),
    });
    Ok(Scene { name: "fall n=150", ribbon, h: 0.01, steps: 100, floor: Floor(5.0), twist: 0.0 })
}

/// The end's normal turned by `4π` with a stiff guide (Ribbon Figs 7 and 9).
///
/// # Errors
///
/// As [`helix`].
pub fn torsion(width_m: f64) -> Result<Scene, SpecError> {
    let ribbon = open(&RibbonSpec { width_m, ..RibbonSpec::default() }, [0.0; 3])?;
    let twist = 2.0 * TAU;
    Ok(Scene { name: "torsion 4 pi", ribbon, h: 0.01, steps: 100, floor: Floor(0.0), twist })
}

/// A free ring or Möbius band of five grams at rest, and a spring of so many newtons a metre from one of its corners to
/// a point a metre away (Ribbon Figs 5 and 7).
///
/// # Errors
///
/// As [`helix`].
pub fn loop_of(closure: Closure, stiffness: f64) -> Result<Scene, SpecError> {
    let spec =
        RibbonSpec { closure, root: Root::Free, regularisation: 4e-2, ..RibbonSpec::default() };
    let mut ribbon = open(&spec, [0.0, 0.0, -9.81])?;
    ribbon.wind(&start(), &Settings::EXACT);
    let crease = spec.segments / 3;
    let from = ribbon.pairs().nth(crease).map_or(V3([0.0; 3]), |pair| pair[0]);
    let spring = Spring { crease, rim: 0, target: from + V3([0.7, 0.5, 0.5]), stiffness };
    if stiffness > 0.0 {
        // There is room for one.
        let _ = ribbon.ask.springs.push(spring);
    }
    Ok(Scene { name: "loop", ribbon, h: 0.01, steps: 40, floor: Floor(0.0), twist: 0.0 })
}

/// A flat ribbon that turns about its own centreline (Ribbon Fig. 11).
///
/// # Errors
///
/// As [`helix`].
pub fn spin(mass: Mass) -> Result<Scene, SpecError> {
    let spec = RibbonSpec {
        width_m: 0.1,
        root: Root::Free,
        perturbation: 1e-4,
        mass,
        ..RibbonSpec::default()
    };
    let mut ribbon = open(&spec, [0.0; 3])?;
    ribbon.launch(|x| V3([40.0, 0.0, 0.0]).cross(x));
    Ok(Scene { name: "spin", ribbon, h: 0.01, steps: 100, floor: Floor(0.0), twist: 0.0 })
}

/// A Möbius band of half-width `π/30` and length `2π` (Ribbon Fig. 13), not wound yet.
///
/// # Errors
///
/// As [`helix`].
pub fn band(segments: usize, bending: Bending) -> Result<Box<Long>, SpecError> {
    let spec = RibbonSpec {
        length_m: TAU,
        width_m: TAU / 30.0,
        segments,
        rigidity_nm: 1.0,
        regularisation: 1e-9,
        bending,
        closure: Closure::Moebius,
        root: Root::Segment,
        ..RibbonSpec::default()
    };
    let mut ribbon = Box::new(Long::EMPTY);
    ribbon.open(&spec, [0.0; 3])?;
    Ok(ribbon)
}
