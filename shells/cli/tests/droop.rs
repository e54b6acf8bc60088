//! A clamped leaf hangs as the heavy elastica does: Young's modulus, thickness and mass mean what they say.
//!
//! `θ'' = Γ (1 - s) cos θ` with `Γ = w g L³ / D`, solved here by shooting, not read from a table.

mod common;

use common::{fixture, run_lines};

/// Pieces the reference is integrated in.
const PIECES: usize = 2000;

/// Where the elastica ends, `(W, H)` over its length.
fn elastica(gamma: f64) -> (f64, f64) {
    // The curvature at the clamp for which the free end is straight, by bisection.
    let (mut low, mut high) = (0.0, gamma);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if shoot(gamma, middle).0 > 0.0 { high = middle } else { low = middle }
    }
    let (_, w, h) = shoot(gamma, low);
    (w, h)
}

/// Curvature at the free end and its place, `θ` measured downwards from the level.
fn shoot(gamma: f64, curvature: f64) -> (f64, f64, f64) {
    let slope = |s: f64, [theta, kappa, _, _]: [f64; 4]| {
        [kappa, -gamma * (1.0 - s) * theta.cos(), theta.cos(), theta.sin()]
    };
    let step = 1.0 / PIECES as f64;
    let mut y = [0.0, curvature, 0.0, 0.0];
    for n in 0..PIECES {
        let s = n as f64 * step;
        let ahead = |y: [f64; 4], d: [f64; 4], t: f64| std::array::from_fn(|i| y[i] + t * d[i]);
        let a = slope(s, y);
        let b = slope(s + 0.5 * step, ahead(y, a, 0.5 * step));
        let c = slope(s + 0.5 * step, ahead(y, b, 0.5 * step));
        let d = slope(s + step, ahead(y, c, step));
        y = std::array::from_fn(|i| y[i] + step / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
    }
    (y[1], y[2], y[3])
}

/// Mean drop over mean reach of the free edge at rest.
fn hangs(gamma: u32, real: &str) -> f64 {
    let scene = fixture(&format!("scenes/droop_gamma_{gamma}.toml"));
    let lines = run_lines(&[&scene, "--real", real]);
    let nodes = lines.last().expect("frames")["leaf"]["nodes"].as_array().expect("nodes").clone();
    let sum = |c: usize| {
        nodes[nodes.len() - 8..].iter().map(|p| p[c].as_f64().expect("a number")).sum::<f64>()
    };
    -sum(1) / sum(0)
}

#[test]
fn the_reference_is_the_known_one() {
    for (gamma, w, h) in
        [(1.0, 0.99125, 0.12347), (10.0, 0.65635, 0.70020), (30.0, 0.34276, 0.87309)]
    {
        let (rw, rh) = elastica(gamma);
        assert!((rw - w).abs() < 2e-5 && (rh - h).abs() < 2e-5, "{gamma}: {rw} {rh}");
    }
}

#[test]
fn a_leaf_droops_as_the_heavy_elastica() {
    for (gamma, within) in [(1, 0.03), (3, 0.03), (10, 0.03), (30, 0.05)] {
        let (w, h) = elastica(f64::from(gamma));
        for real in ["f32", "f64"] {
            let error = hangs(gamma, real) / (h / w) - 1.0;
            assert!(error.abs() < within, "gamma {gamma}, {real}: off by {:.2} %", 100.0 * error);
        }
    }
}
