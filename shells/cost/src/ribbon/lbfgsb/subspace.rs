//! The least point of the model in the numbers that are not at a bound.

use super::cauchy::Aim;
use super::memory::{Memory, Small, solve};
use super::{Bounds, Point};

/// That point, as far as the bounds allow (Byrd et al., the direct primal method).
pub(super) fn minimum(at: &Point, aim: Aim, bounds: &Bounds, memory: &Memory) -> Vec<f64> {
    let Aim { mut x, way } = aim;
    let is_free = |i: usize| bounds.low[i] < x[i] && x[i] < bounds.high[i];
    let free: Vec<bool> = (0..x.len()).map(is_free).collect();
    if memory.is_empty() || !free.contains(&true) {
        return x;
    }
    let theta = memory.theta;
    let mut r: Vec<f64> =
        at.gradient.iter().zip(&x).zip(&at.x).map(|((g, x), old)| g + theta * (x - old)).collect();
    memory.lift(&memory.times_middle(&way), -1.0, &mut r);
    hold(&mut r, &free);
    let v = memory.times_middle(&memory.project(&r));
    let mut small = memory.middle_times(&free_square(memory, &free));
    for (i, row) in small.iter_mut().enumerate() {
        row.iter_mut().for_each(|e| *e /= -theta);
        row[i] += 1.0;
    }
    let Some(v) = solve(small, vec![v]) else { return x };
    let mut step: Vec<f64> = r.iter().map(|r| -r / theta).collect();
    memory.lift(&v[0], -1.0 / (theta * theta), &mut step);
    hold(&mut step, &free);
    let share = room(&x, &step, bounds);
    x.iter_mut().zip(&step).for_each(|(x, d)| *x += share * d);
    bounds.project(&mut x);
    x
}

fn hold(v: &mut [f64], free: &[bool]) {
    v.iter_mut().zip(free).filter(|(_, free)| !**free).for_each(|(v, _)| *v = 0.0);
}

/// `WᵀW` over the free rows: the whole one, less those that are held.
fn free_square(memory: &Memory, free: &[bool]) -> Small {
    let mut square = memory.square();
    for i in (0..free.len()).filter(|&i| !free[i]) {
        let row = memory.row(i);
        for (to, a) in square.iter_mut().zip(&row) {
            to.iter_mut().zip(&row).for_each(|(to, b)| *to -= a * b);
        }
    }
    square
}

/// The largest share of a step, at most one, that stays inside.
fn room(x: &[f64], step: &[f64], bounds: &Bounds) -> f64 {
    let one = |i: usize| match step[i] {
        d if d > 0.0 => (bounds.high[i] - x[i]) / d,
        d if d < 0.0 => (bounds.low[i] - x[i]) / d,
        _ => f64::INFINITY,
    };
    (0..x.len()).map(one).fold(1.0, f64::min)
}
