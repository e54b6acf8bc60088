//! The seed's Algorithm 2: L-BFGS-B, multipliers, again; with every iteration seen.

use super::lbfgsb::{Limits, Outcome, minimise};
use super::unknowns::Unknowns;
use dogleaf_core::effect::ribbon::Loads;

/// Turns of the outer loop at most.
const OUTER: u32 = 10;
/// The seed's measure of having arrived: the largest change of an unknown between two turns.
const STILL: f64 = 1e-4;

/// What Algorithm 2 came to.
#[derive(Debug, Clone, Copy)]
pub struct Answer {
    /// The objective, joules.
    pub objective: f64,
    /// Turns of the outer loop.
    pub outer: u32,
    /// Iterations of all inner solves.
    pub inner: u32,
    /// Evaluations of all inner solves.
    pub evaluations: u32,
    /// How the last one ended.
    pub last: Outcome,
    /// How far the rows are violated, as a share of the limit.
    pub violation: f64,
}

/// Minimises (Ribbon Alg. 2). `go_on` is asked after every inner iteration, with the objective in joules and the rows'
/// violation.
pub fn algorithm_2<L: Loads<f64>, const N: usize>(
    unknowns: &mut Unknowns<'_, L, N>,
    limits: &Limits,
    mut go_on: impl FnMut(f64, f64) -> bool,
) -> Answer {
    let (mut x, bounds) = unknowns.start();
    let (mut inner, mut evaluations, mut outer) = (0, 0, 0);
    loop {
        let before = x.clone();
        let (mut asked, mut objective) = (true, f64::INFINITY);
        let last = minimise(unknowns, &mut x, &bounds, limits, |u, _| {
            objective = u.objective;
            asked = go_on(u.objective, violation(u));
            asked
        });
        (outer, inner, evaluations) =
            (outer + 1, inner + last.iterations, evaluations + last.evaluations);
        let moved = x.iter().zip(&before).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let (violation, held) = (violation(unknowns), unknowns.lambda);
        unknowns.update();
        // The seed asks for stillness alone, which is met by loops that stay open, too.
        let arrived = unknowns.lambda == held || moved < STILL && violation < STILL;
        if arrived || !asked || outer >= OUTER {
            let objective = if objective.is_finite() { objective } else { unknowns.objective };
            return Answer { objective, outer, inner, evaluations, last, violation };
        }
    }
}

fn violation<L: Loads<f64>, const N: usize>(unknowns: &Unknowns<'_, L, N>) -> f64 {
    unknowns.rows().iter().fold(0.0, |worst, row| worst.max(-row))
}
