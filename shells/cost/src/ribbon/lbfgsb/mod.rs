//! Least value of a smooth function of many numbers within bounds: L-BFGS-B, the method inside the seed's Algorithm 2.
//!
//! ```text
//! B = θ I - W M Wᵀ     W = [Y  θ S]     M⁻¹ = [[-D, Lᵀ], [L, θ SᵀS]]     SᵀY = L + D + upper part
//! ```
//!
//! Each iteration finds the first least point of the model along the projected gradient (`cauchy`), the least point of
//! the model in the numbers that are free there (`subspace`), and searches the line to it (`search`).
//!
//! Source: Byrd, Lu, Nocedal, Zhu 1995. Host only: an oracle.

mod cauchy;
mod memory;
mod search;
mod subspace;

use memory::Memory;

/// What is minimised.
pub trait Objective {
    /// Its value at `x`; writes the gradient.
    fn evaluate(&mut self, x: &[f64], gradient: &mut [f64]) -> f64;
}

/// Least and greatest value of each number.
#[derive(Debug, Clone)]
pub struct Bounds {
    /// Least.
    pub low: Vec<f64>,
    /// Greatest.
    pub high: Vec<f64>,
}

/// When to end.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Pairs that are kept.
    pub memory: usize,
    /// Iterations at most.
    pub iterations: u32,
    /// Largest entry of the projected gradient.
    pub gradient: f64,
    /// Relative fall of the value in one iteration, in units of the spacing of `f64`.
    pub factor: f64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { memory: 8, iterations: 6_000, gradient: 1e-10, factor: 1e1 }
    }
}

/// How it ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// The projected gradient is small.
    Gradient,
    /// The value hardly fell.
    Value,
    /// The iterations were used up.
    Iterations,
    /// No step along a descent direction lowers the value.
    Search,
    /// The caller has seen enough.
    Stopped,
}

/// What it cost.
#[derive(Debug, Clone, Copy)]
pub struct Outcome {
    /// How it ended.
    pub ended: Ended,
    /// Iterations.
    pub iterations: u32,
    /// Evaluations of value and gradient.
    pub evaluations: u32,
    /// The value.
    pub value: f64,
}

/// A point with value and gradient.
#[derive(Debug, Clone)]
struct Point {
    x: Vec<f64>,
    value: f64,
    gradient: Vec<f64>,
}

impl Bounds {
    /// The nearest point inside.
    fn project(&self, x: &mut [f64]) {
        for ((x, low), high) in x.iter_mut().zip(&self.low).zip(&self.high) {
            *x = x.clamp(*low, *high);
        }
    }

    /// The largest entry of `P(x - g) - x`.
    fn slope(&self, at: &Point) -> f64 {
        let one = |i: usize| {
            let to = (at.x[i] - at.gradient[i]).clamp(self.low[i], self.high[i]);
            (to - at.x[i]).abs()
        };
        (0..at.x.len()).map(one).fold(0.0, f64::max)
    }
}

/// Minimises from `x`, which becomes the best point found. `go_on` is asked after every iteration.
pub fn minimise<O: Objective>(
    objective: &mut O,
    x: &mut Vec<f64>,
    bounds: &Bounds,
    limits: &Limits,
    mut go_on: impl FnMut(&mut O, f64) -> bool,
) -> Outcome {
    bounds.project(x);
    let mut at = Point { x: x.clone(), value: 0.0, gradient: vec![0.0; x.len()] };
    at.value = objective.evaluate(&at.x, &mut at.gradient);
    let mut memory = Memory::new(limits.memory);
    let mut out =
        Outcome { ended: Ended::Iterations, iterations: 0, evaluations: 1, value: at.value };
    while out.iterations < limits.iterations {
        if bounds.slope(&at) <= limits.gradient {
            out.ended = Ended::Gradient;
            break;
        }
        let aim = cauchy::cauchy(&at, bounds, &memory);
        let to = subspace::minimum(&at, aim, bounds, &memory);
        let Some(next) = search::search(objective, &at, &to, bounds, &memory, &mut out.evaluations)
        else {
            if memory.is_empty() {
                out.ended = Ended::Search;
                break;
            }
            memory.clear();
            continue;
        };
        out.iterations += 1;
        memory.learn(&at, &next);
        let fell = (at.value - next.value) / at.value.abs().max(next.value.abs()).max(1.0);
        at = next;
        if !go_on(objective, at.value) {
            out.ended = Ended::Stopped;
            break;
        }
        if fell <= limits.factor * f64::EPSILON {
            out.ended = Ended::Value;
            break;
        }
    }
    out.value = at.value;
    *x = at.x;
    out
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests;
