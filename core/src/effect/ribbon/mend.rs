//! Closes a loop that a solve has left ajar: Gauss and Newton's steps on the joint's six rows alone, each the shortest in
//! all creases' unknowns. Their matrix is positive definite whatever pulls, so a bounded number of them always closes it.
//!
//! Source: ours. Checked by `tests/ribbon_loops.rs`.

use super::body::Body;
use super::closure::Hold;
use super::joint::{Turn, about};
use super::riccati::{Tie, Value};
use crate::real::Real;

/// What a step of a slope weighs against one of an angle: slopes have bounds, angles have none.
const SLOPES: f64 = 100.0;
/// Penalty of a turn at the joint, against one for a crease's own.
const RATE: f64 = 1e6;

impl<R: Real, const N: usize> Body<R, N> {
    /// Factors the joint's rows; [`Body::solve`] then gives the step. A free start stays where it is.
    ///
    /// # Cost
    ///
    /// Some 500 operations a segment.
    pub fn factor_joint(&mut self) -> Option<R> {
        let (o, cell) = (R::ZERO, self.strip.cell);
        let (turn, length) = (R::of(RATE), self.strip.length());
        let rows = Hold { lambda: [o; 6], turn, shift: turn * R::of(40.0) / (length * length) };
        let mut value = Value::ZERO;
        let [at_end, _] = rows.gradient(&self.gap);
        (value.x, value.xx) = (at_end, rows.hessian(&self.gap));
        let (n, mut fall, one) = (self.strip.n, o, R::one());
        let tie = |free| Tie {
            x: [[o; 6]; 2],
            u: [[o; 2]; 2],
            g: [o; 2],
            h: [one, o, R::of(SLOPES)],
            free,
            drift: false,
        };
        let mut next: Option<Turn<R>> = None;
        for s in self.stages.iter_mut().take(n).rev() {
            if let Some(turn) = next {
                let p = s.frame.p + s.frame.t * cell;
                let axes = turn.axes(&s.frame).map(|a| about(a, p));
                value.eliminate(&axes, &tie([true; 2]), &mut fall, &mut s.gain)?;
            }
            next = Some(s.turn);
        }
        let axes = next?.axes(&self.base).map(|a| about(a, self.base.p));
        let hinged = self.strip.hinge > o;
        value.eliminate(&axes, &tie([hinged, false]), &mut fall, &mut self.root_gain)?;
        self.base_step = [o; 6];
        Some(fall)
    }
}
