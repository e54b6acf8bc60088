//! The heavy elastica: a sheet clamped level at one end, bent by nothing but its weight. An oracle in `f64`.
//!
//! ```text
//! θ'' = Γ (1 - s) cos θ     θ(0) = 0     θ'(1) = 0     x' = cos θ     y' = sin θ     (θ and y downwards)
//! ```
//!
//! With the length as unit. Solved by shooting from the free end, on its angle: from the clamp, on `θ'(0)`, there is more
//! than one answer where `Γ` is above some thirty. The sheet that hangs never rises above its clamp's level.

/// Steps of the fourth-order integration.
const STEPS: u32 = 2_000;
/// Halvings of the bracket on the free end's angle.
const HALVINGS: u32 = 80;

/// Drop and reach of the free end, for `Γ = w g L³ / D`.
pub fn droop(gamma: f64) -> [f64; 2] {
    let (mut low, mut high) = (0.0, std::f64::consts::FRAC_PI_2);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if shoot(gamma, middle)[0] < 0.0 { low = middle } else { high = middle }
    }
    let [_, _, x, y] = shoot(gamma, 0.5 * (low + high));
    [y, x]
}

/// The clamp of a sheet whose free end hangs at an angle: its angle and curvature there, and the way between the two; or
/// where it is level before that.
fn shoot(gamma: f64, tip: f64) -> [f64; 4] {
    let h = 1.0 / f64::from(STEPS);
    let slope = |u: f64, [theta, kappa, ..]: [f64; 4]| {
        [kappa, -gamma * u * theta.cos(), theta.cos(), theta.sin()]
    };
    let mut at = [tip, 0.0, 0.0, 0.0];
    for n in 0..STEPS {
        if at[0] < 0.0 {
            break;
        }
        let u = h * f64::from(n);
        let k1 = slope(u, at);
        let k2 = slope(u + 0.5 * h, add(at, k1, 0.5 * h));
        let k3 = slope(u + 0.5 * h, add(at, k2, 0.5 * h));
        let k4 = slope(u + h, add(at, k3, h));
        for (c, v) in at.iter_mut().enumerate() {
            *v += h / 6.0 * (k1[c] + 2.0 * k2[c] + 2.0 * k3[c] + k4[c]);
        }
    }
    at
}

fn add(a: [f64; 4], b: [f64; 4], h: f64) -> [f64; 4] {
    [a[0] + h * b[0], a[1] + h * b[1], a[2] + h * b[2], a[3] + h * b[3]]
}
