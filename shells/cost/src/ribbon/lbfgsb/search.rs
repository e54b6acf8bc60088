//! Along a line: a share of the step that lowers the value and flattens the slope enough.

use super::memory::Memory;
use super::{Bounds, Objective, Point, dot};

/// Share of the predicted fall that is asked for.
const FALL: f64 = 1e-3;
/// Share of the slope that may be left.
const SLOPE: f64 = 0.9;
/// Evaluations at most.
const MOST: u32 = 20;

/// One end of a bracket.
#[derive(Clone, Copy)]
struct Trial {
    share: f64,
    value: f64,
    slope: f64,
}

/// Searches from `at` towards `to`; `None` where no trial is good enough to be taken.
pub(super) fn search<O: Objective>(
    objective: &mut O,
    at: &Point,
    to: &[f64],
    bounds: &Bounds,
    memory: &Memory,
    evaluations: &mut u32,
) -> Option<Point> {
    let d: Vec<f64> = to.iter().zip(&at.x).map(|(to, x)| to - x).collect();
    let start = Trial { share: 0.0, value: at.value, slope: dot(&at.gradient, &d) };
    if start.slope >= 0.0 {
        return None;
    }
    let length = dot(&d, &d).sqrt();
    let most = farthest(at, &d, bounds);
    let mut share = if memory.is_empty() { (1.0 / length).min(most) } else { 1.0 };
    let (mut low, mut high): (Trial, Option<Trial>) = (start, None);
    let mut next = at.clone();
    for _ in 0..MOST {
        for ((x, old), d) in next.x.iter_mut().zip(&at.x).zip(&d) {
            *x = old + share * d;
        }
        bounds.project(&mut next.x);
        next.value = objective.evaluate(&next.x, &mut next.gradient);
        *evaluations += 1;
        let trial = Trial { share, value: next.value, slope: dot(&next.gradient, &d) };
        let enough = start.value + FALL * share * start.slope;
        if !trial.value.is_finite()
            || trial.value > enough
            || trial.value >= low.value && low.share > 0.0
        {
            high = Some(trial);
        } else if trial.slope.abs() <= -SLOPE * start.slope || share >= most && trial.slope < 0.0 {
            return Some(next);
        } else {
            if trial.slope * (high.map_or(most, |h| h.share) - low.share) >= 0.0 {
                high = Some(low);
            }
            low = trial;
        }
        share = match high {
            Some(high) => between(&low, &high),
            None => (share * 4.0).min(most),
        };
    }
    (next.value < at.value).then_some(next)
}

/// The least point of the cubic through two trials, kept off the bracket's ends.
fn between(a: &Trial, b: &Trial) -> f64 {
    let width = b.share - a.share;
    let middle = a.share + 0.5 * width;
    if !(b.value.is_finite() && b.slope.is_finite()) {
        return a.share + 0.1 * width;
    }
    let p = a.slope + b.slope - 3.0 * (b.value - a.value) / width;
    let root = p * p - a.slope * b.slope;
    if root < 0.0 {
        return middle;
    }
    let q = root.sqrt() * width.signum();
    let share = b.share - width * (b.slope + q - p) / (b.slope - a.slope + 2.0 * q);
    let (low, high) = (a.share + 0.05 * width, b.share - 0.05 * width);
    if share.is_finite() { share.clamp(low.min(high), low.max(high)) } else { middle }
}

/// The largest share of a step that stays inside.
fn farthest(at: &Point, d: &[f64], bounds: &Bounds) -> f64 {
    let one = |i: usize| match d[i] {
        d if d > 0.0 => (bounds.high[i] - at.x[i]) / d,
        d if d < 0.0 => (bounds.low[i] - at.x[i]) / d,
        _ => f64::INFINITY,
    };
    (0..d.len()).map(one).fold(1e10, f64::min).max(1.0)
}
