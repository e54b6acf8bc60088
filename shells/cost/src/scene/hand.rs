//! The hand of the scene "turn": a smooth path over the spine, known at every moment and the same on every grid.

use dogleaf_core::real::Real;

/// Seconds the whole path takes; the window ends before.
pub const PATH_S: f64 = 1.4;
/// Where the corner is held at first, model units: a little above the spine, nearly stretched out.
const START: [f64; 2] = [11.6, 1.4];
/// Where the path ends, radians above the page.
const END: f64 = 2.0;
/// How much nearer to the spine the hand passes at half the way, as a share.
const PULL: f64 = 0.12;

/// A path of the held corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hand {
    start_angle: f64,
    radius: f64,
    z: f64,
}

impl Hand {
    /// The path of the corner that lies at `z` along the spine.
    pub fn new(z: f64) -> Self {
        let [x, y] = START;
        Self { start_angle: y.atan2(x), radius: (x * x + y * y).sqrt(), z }
    }

    /// Where the corner is wanted at a moment.
    pub fn at(&self, t_s: f64) -> [f64; 3] {
        let s = smooth(t_s / PATH_S);
        let angle = self.start_angle + s * (END - self.start_angle);
        let radius = self.radius * (1.0 - PULL * (core::f64::consts::PI * s).sine());
        [radius * angle.cosine(), radius * angle.sine(), self.z * (1.0 - 0.1 * s)]
    }
}

/// From 0 to 1 with neither speed nor acceleration at the ends.
fn smooth(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * t * (10.0 - 15.0 * t + 6.0 * t * t)
}
