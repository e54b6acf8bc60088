//! What a reader sees of an error: how far the leaf's outline is off on the screen.

use crate::resample::{ACROSS, ALONG};
use crate::run::Trajectory;
use dogleaf_core::hand::{Camera, View};
use dogleaf_core::real::V3;
use dogleaf_core::scene::Units;
use dogleaf_core::scene::units::WIDTH;

/// A reader in front of a screen of 1920 by 1080 pixels.
#[derive(Debug, Clone, Copy)]
pub struct Eye {
    camera: Camera<f64>,
}

impl Eye {
    /// Looks at a book whose page has this size.
    pub fn new(width_m: f64, height_m: f64, units: &Units) -> Self {
        Self { camera: View::reading(width_m, height_m, 1920, 1080).camera(units) }
    }

    /// Largest distance of a place of one outline from the other, either way, over all pictures.
    pub fn furthest(&self, a: &Trajectory, b: &Trajectory) -> f64 {
        let pairs = a.pictures.iter().zip(&b.pictures);
        pairs.map(|(p, q)| between(&self.outline(p), &self.outline(q))).fold(0.0, f64::max)
    }

    fn outline(&self, points: &[[f64; 3]]) -> Vec<[f64; 2]> {
        if points.is_empty() {
            return Vec::new();
        }
        let at = |a: usize, b: usize| points[a * ALONG + b];
        let tail = (0..ACROSS).map(|a| at(a, 0));
        let edge = (1..ALONG).map(|b| at(ACROSS - 1, b));
        let head = (0..ACROSS - 1).rev().map(|a| at(a, ALONG - 1));
        let spine = (1..ALONG - 1).rev().map(|b| at(0, b));
        let all = tail.chain(edge).chain(head).chain(spine);
        all.filter_map(|p| self.camera.project(V3(p.map(|c| c * WIDTH)))).collect()
    }
}

/// Hausdorff's distance of two closed lines, taken at their corners.
fn between(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    if a.is_empty() || b.is_empty() {
        return 0.0;
    }
    let one_way = |from: &[[f64; 2]], to: &[[f64; 2]]| {
        from.iter().map(|&p| nearest(p, to)).fold(0.0, f64::max)
    };
    one_way(a, b).max(one_way(b, a))
}

/// Distance of a point from a closed line.
fn nearest(p: [f64; 2], line: &[[f64; 2]]) -> f64 {
    let next = line.iter().cycle().skip(1);
    let to = line.iter().zip(next).map(|(&a, &b)| {
        let e = [b[0] - a[0], b[1] - a[1]];
        let free =
            ((p[0] - a[0]) * e[0] + (p[1] - a[1]) * e[1]) / (e[0] * e[0] + e[1] * e[1]).max(1e-12);
        let t = free.clamp(0.0, 1.0);
        let d = [p[0] - a[0] - t * e[0], p[1] - a[1] - t * e[1]];
        d[0] * d[0] + d[1] * d[1]
    });
    to.fold(f64::INFINITY, f64::min).sqrt()
}
