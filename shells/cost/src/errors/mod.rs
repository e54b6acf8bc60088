//! How far a trajectory is from a reference.

mod outline;

pub use outline::Eye;

use crate::run::Trajectory;
use serde::Serialize;

/// Errors of one run. Nothing where the scene has no such thing, or no reference for it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Errors {
    /// Root mean square distance of material points over all pictures, page widths.
    pub shape_rms: Option<f64>,
    /// Largest of them.
    pub shape_max: Option<f64>,
    /// Largest distance of the outline as a reader sees it, pixels at 1920x1080.
    pub outline_px: Option<f64>,
    /// Largest, mean of the pictures' largest, and root mean square edge stretch.
    pub stretch: [f64; 3],
    /// Largest difference between the angles of a star, radians.
    pub star_rad: f64,
    /// Energy gained or lost beside the reference, as a share of the reference's greatest kinetic energy, per second.
    pub drift_per_s: Option<f64>,
    /// How much later the page passes the vertical, milliseconds.
    pub vertical_ms: Option<f64>,
    /// How much later it has come to lie, milliseconds.
    pub settled_ms: Option<f64>,
    /// Deepest place inside a block, thicknesses of a leaf.
    pub depth: Option<f64>,
}

impl Errors {
    /// What needs no reference.
    pub fn alone(run: &Trajectory) -> Self {
        let depth = run.depth.is_finite().then(|| run.depth.max(0.0));
        Self { stretch: run.stretch, star_rad: run.star, depth, ..Self::default() }
    }

    /// Everything, beside a reference of the same pictures.
    pub fn beside(run: &Trajectory, reference: &Trajectory, eye: Option<&Eye>) -> Self {
        let (rms, max) = distance(run, reference);
        Self {
            shape_rms: Some(rms),
            shape_max: Some(max),
            outline_px: eye.map(|eye| eye.furthest(run, reference)),
            drift_per_s: drift(run, reference),
            vertical_ms: later(run.vertical_s, reference.vertical_s),
            ..Self::alone(run)
        }
    }
}

/// Milliseconds by which one event is later than the other.
pub fn later(run: Option<f64>, reference: Option<f64>) -> Option<f64> {
    Some((run? - reference?) * 1e3)
}

/// Root mean square and largest distance of the same places in the same pictures.
pub fn distance(a: &Trajectory, b: &Trajectory) -> (f64, f64) {
    let pairs = a.pictures.iter().zip(&b.pictures).flat_map(|(p, q)| p.iter().zip(q));
    let (mut sum, mut most, mut count) = (0.0, 0.0_f64, 0.0);
    for (p, q) in pairs {
        let d: f64 = p.iter().zip(q).map(|(x, y)| (x - y) * (x - y)).sum();
        sum += d;
        most = most.max(d);
        count += 1.0;
    }
    ((sum / f64::max(count, 1.0)).sqrt(), most.sqrt())
}

fn drift(run: &Trajectory, reference: &Trajectory) -> Option<f64> {
    let total = |t: &Trajectory| t.energy.last().map(|e| e[0] + e[1]);
    let scale = reference.energy.iter().fold(0.0_f64, |m, e| m.max(e[0]));
    let seconds = *reference.times.last()?;
    (scale > 0.0).then_some(())?;
    Some((total(run)? - total(reference)?) / (scale * seconds))
}
