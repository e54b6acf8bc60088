//! The barrier of one distance: nothing beyond its reach, steep below it.
//!
//! ```text
//! b(d) = -k (d - r)² ln(d/r)      0 < d < r
//! ```
//!
//! Below a small share of `r` it goes on as its parabola there, so that what is already inside something is pushed out by a
//! finite force. Two ribbons never come there by a step: that is what `advance` is for.
//!
//! Source: Li et al. 2020, Eq. 6. Checked by `tests/ribbon_contact.rs`.

use super::super::elementary::logarithm;
use crate::real::Real;

/// Where the parabola begins against another segment, as a share of the reach.
pub const FLOOR: f64 = 1e-3;
/// The same against a solid, which has an inside: less stiff, so that a hard fall stays easy to solve.
pub const SOLID: f64 = 0.05;

/// How far a barrier reaches and how strong it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cushion {
    /// Distance at which it begins, metres: about what the ribbon looks thick.
    pub reach_m: f64,
    /// `k`, newton per metre.
    pub stiffness: f64,
}

impl Default for Cushion {
    /// Two millimetres; carries a newton at a fifth of them.
    fn default() -> Self {
        Self { reach_m: 2e-3, stiffness: 200.0 }
    }
}

/// Value, slope and curvature at a distance; the parabola begins at `floor` of the reach.
///
/// # Accuracy
///
/// Some ten roundings.
#[inline]
pub fn barrier<R: Real>(cushion: &Cushion, d: R, floor: f64) -> [R; 3] {
    let (reach, k) = (R::of(cushion.reach_m), R::of(cushion.stiffness));
    if d >= reach {
        return [R::ZERO; 3];
    }
    let at = d.larger(reach * R::of(floor));
    let (ln, x, two) = (logarithm(at / reach), at - reach, R::of(2.0));
    let ratio = x / at;
    let value = -(k * x * x * ln);
    let slope = -(k * x * (two * ln + ratio));
    let curve = -(k * (two * ln + ratio * (R::of(4.0) - ratio)));
    let below = d - at;
    [value + below * (slope + below * curve * R::of(0.5)), slope + below * curve, curve]
}
