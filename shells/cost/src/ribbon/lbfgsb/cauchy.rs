//! The first least point of the quadratic model along the projected gradient.

use super::memory::Memory;
use super::{Bounds, Point, dot};

/// That point, and `Wᵀ` of the way there.
pub(super) struct Aim {
    pub(super) x: Vec<f64>,
    pub(super) way: Vec<f64>,
}

/// Walks from bound to bound (Byrd et al., Algorithm CP).
pub(super) fn cauchy(at: &Point, bounds: &Bounds, memory: &Memory) -> Aim {
    let g = &at.gradient;
    let ends: Vec<f64> = (0..g.len()).map(|i| end(at, bounds, i)).collect();
    let mut d: Vec<f64> =
        g.iter().zip(&ends).map(|(g, &t)| if t > 0.0 { -g } else { 0.0 }).collect();
    let mut order: Vec<usize> =
        (0..g.len()).filter(|&i| ends[i] > 0.0 && ends[i].is_finite()).collect();
    order.sort_by(|&i, &j| ends[i].total_cmp(&ends[j]));
    let (mut p, theta) = (memory.project(&d), memory.theta);
    let mut aim = Aim { x: at.x.clone(), way: vec![0.0; memory.width()] };
    let mut slope = -dot(&d, &d);
    let mut curve = -theta * slope - dot(&p, &memory.times_middle(&p));
    let least = f64::EPSILON * curve.abs();
    let (mut best, mut before) = (-slope / curve, 0.0);
    for &b in &order {
        let step = ends[b] - before;
        if best < step {
            break;
        }
        aim.x[b] = if d[b] > 0.0 { bounds.high[b] } else { bounds.low[b] };
        let moved = aim.x[b] - at.x[b];
        add(&mut aim.way, &p, step);
        let (row, gb) = (memory.row(b), g[b]);
        let mixed = memory.times_middle(&row);
        slope += step * curve + gb * gb + theta * gb * moved - gb * dot(&mixed, &aim.way);
        curve -= theta * gb * gb + 2.0 * gb * dot(&mixed, &p) + gb * gb * dot(&mixed, &row);
        curve = curve.max(least);
        add(&mut p, &row, gb);
        d[b] = 0.0;
        (best, before) = (-slope / curve, ends[b]);
    }
    let best = best.max(0.0);
    add(&mut aim.way, &p, best);
    let share = before + best;
    aim.x.iter_mut().zip(&d).for_each(|(x, d)| *x += share * d);
    aim
}

/// How far along the gradient a number meets its bound.
fn end(at: &Point, bounds: &Bounds, i: usize) -> f64 {
    let g = at.gradient[i];
    let bound = if g < 0.0 { bounds.high[i] } else { bounds.low[i] };
    if g == 0.0 { f64::INFINITY } else { (at.x[i] - bound) / g }
}

fn add(to: &mut [f64], v: &[f64], by: f64) {
    to.iter_mut().zip(v).for_each(|(to, v)| *to += by * v);
}
