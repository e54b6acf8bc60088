//! The heavy elastica: a sheet clamped level at one end, bent by nothing but its weight. An oracle in `f64`.
//!
//! ```text
//! θ'' = Γ (1 - s) cos θ     θ(0) = 0     θ'(1) = 0     x' = cos θ     y' = sin θ     (θ and y downwards)
//! ```
//!
//! With the length as unit. Solved by shooting on `θ'(0)`.

/// Steps of the fourth-order integration.
const STEPS: u32 = 2_000;
/// Halvings of the bracket on `θ'(0)`.
const HALVINGS: u32 = 80;

/// Drop and reach of the free end, for `Γ = w g L³ / D`.
pub fn droop(gamma: f64) -> [f64; 2] {
    let (mut low, mut high) = (0.0, gamma.max(1e-9));
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if shoot(gamma, middle).1 < 0.0 { low = middle } else { high = middle }
    }
    let [_, _, x, y] = shoot(gamma, 0.5 * (low + high)).0;
    [y, x]
}

/// The end of a sheet that leaves the clamp with curvature `start`: its state, and which way to correct.
fn shoot(gamma: f64, start: f64) -> ([f64; 4], f64) {
    let h = 1.0 / f64::from(STEPS);
    // θ falls as Γ pulls, so the equation is integrated with the curvature's sign turned round.
    let slope = |s: f64, [theta, kappa, ..]: [f64; 4]| {
        [kappa, -gamma * (1.0 - s) * theta.cos(), theta.cos(), theta.sin()]
    };
    let mut at = [0.0, start, 0.0, 0.0];
    for n in 0..STEPS {
        let s = h * f64::from(n);
        let k1 = slope(s, at);
        let k2 = slope(s + 0.5 * h, add(at, k1, 0.5 * h));
        let k3 = slope(s + 0.5 * h, add(at, k2, 0.5 * h));
        let k4 = slope(s + h, add(at, k3, h));
        for (c, v) in at.iter_mut().enumerate() {
            *v += h / 6.0 * (k1[c] + 2.0 * k2[c] + 2.0 * k3[c] + k4[c]);
        }
    }
    (at, at[1])
}

fn add(a: [f64; 4], b: [f64; 4], h: f64) -> [f64; 4] {
    [a[0] + h * b[0], a[1] + h * b[1], a[2] + h * b[2], a[3] + h * b[3]]
}
