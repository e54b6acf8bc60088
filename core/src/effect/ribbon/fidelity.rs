//! What accuracy costs a ribbon: the dials of a solve behind a [`Fidelity`].
//!
//! The dials that count are the last barrier parameter, which is what a step errs by once it has converged, and the most
//! iterations, which are what it errs by where it has not. Source: ours. Checked by `tests/ribbon_fidelity.rs`.

use super::report::Settings;
use crate::real::{Num, Real};
use crate::scene::Fidelity;

/// Steps of a crease below this are rounding in `f32`, radians (and slope).
const FINEST_SINGLE: f64 = 1e-4;
/// A joint closed better than this is rounding in `f32`.
const CLOSEST_SINGLE: f64 = 1e-6;
/// A barrier below this is rounding in `f32`, as a share of the crease stiffness.
const LOWEST_SINGLE: f64 = 1e-9;

impl Settings {
    /// The dials for a ribbon of these numbers.
    ///
    /// | | iterations at most | barrier | a step of a helix in `f64`, n = 50, h = 0.01 s: iterations | error of its tip |
    /// |---|---|---|---|---|
    /// | draft | 15 | 1e-7 | 5.4 | 1e-5 of its length |
    /// | standard | 60 | 1e-9 | 6.4 | 1e-8 |
    /// | fine, thorough | 200 | 1e-11 | 7.4 | 1e-10 |
    /// | reference, thorough | 1000 | 1e-13 | 8.4 | |
    ///
    /// # Accuracy
    ///
    /// Errors are against reference. What a step itself errs by, of first order in `h`, none of these dials changes. In
    /// `f32` fine and reference have standard's dials, and more iterations.
    pub fn of<R: Real>(fidelity: Fidelity) -> Self {
        let dial = |iterations, tolerance, closure, barrier| Self {
            iterations,
            tolerance,
            closure,
            barrier,
            ..Self::STEP
        };
        let asked = match fidelity {
            Fidelity::Draft => dial(15, 1e-3, 1e-4, 1e-7),
            Fidelity::Standard => Self::STEP,
            Fidelity::Fine => Self { thorough: true, ..dial(200, 1e-6, 1e-9, 1e-11) },
            Fidelity::Reference => Self::EXACT,
        };
        if size_of::<R>() > size_of::<f32>() {
            return asked;
        }
        Self {
            tolerance: asked.tolerance.larger(FINEST_SINGLE),
            closure: asked.closure.larger(CLOSEST_SINGLE),
            barrier: asked.barrier.larger(LOWEST_SINGLE),
            ..asked
        }
    }
}
