//! The natural cubic spline through evenly spaced points: of all curves through them the one that
//! bends least, as a sheet does. Straight points stay straight. Both ends are free of moment, which is
//! what a hinge and a free border are.
//!
//! ```text
//! m_{i-1} + 4 m_i + m_{i+1} = 3 (p_{i+1} - p_{i-1})      2 m_0 + m_1 = 3 (p_1 - p_0), likewise at the end
//! ```

use crate::real::{Num, V3};

/// Points a spline has at most.
pub(super) const MOST: usize = 32;

/// Factors of the elimination; they depend on nothing but the place.
const SWEEP: [f64; MOST] = sweep();

const fn sweep() -> [f64; MOST] {
    let mut c = [0.5; MOST];
    let mut rest: &mut [f64] = &mut c;
    let mut before = 0.5;
    while let [first, others @ ..] = rest {
        *first = before;
        before = 1.0 / (4.0 - before);
        rest = others;
    }
    c
}

/// A row of vectors to read and to write; outside it there are zeros.
pub(super) trait Line<T> {
    /// The vector at `i`.
    fn at(&self, i: usize) -> V3<T>;
    /// Sets it.
    fn put(&mut self, i: usize, v: V3<T>);
}

impl<T: Num> Line<T> for [V3<T>; MOST] {
    fn at(&self, i: usize) -> V3<T> {
        self.get(i).copied().unwrap_or_else(V3::zero)
    }
    fn put(&mut self, i: usize, v: V3<T>) {
        if let Some(slot) = self.get_mut(i) {
            *slot = v;
        }
    }
}

/// Slopes at `n` points, a point apart being one.
pub(super) fn slopes<T: Num>(n: usize, p: &impl Line<T>, m: &mut impl Line<T>) {
    let mut before = V3::zero();
    let last = n.saturating_sub(1);
    let mut passed = 0.5;
    for (i, &c) in SWEEP.iter().enumerate().take(n) {
        let chord = p.at((i + 1).min(last)) - p.at(i.saturating_sub(1));
        let c = if i == last { 1.0 / (2.0 - passed) } else { c };
        before = (chord * T::of(3.0) - before) * T::of(c);
        passed = c;
        m.put(i, before);
    }
    let mut after = V3::zero();
    for (i, &c) in SWEEP.iter().enumerate().take(n).rev() {
        let c = if i == last { 0.0 } else { c };
        after = m.at(i) - after * T::of(c);
        m.put(i, after);
    }
}

/// Gives every slope the length of a span: paper is as long as its material, wherever it folds.
///
/// Without this the curve nearly stops at a sharp fold and turns on the spot.
pub(super) fn even_out<T: Num>(n: usize, m: &mut impl Line<T>, span: T) {
    for i in 0..n {
        let slope = m.at(i);
        m.put(i, slope * (span / slope.norm().larger(T::of(1e-6))));
    }
}

/// Weights of the two points and the two slopes at share `t` of a span.
pub(super) fn weights(t: f64) -> [f64; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [2.0 * t3 - 3.0 * t2 + 1.0, 3.0 * t2 - 2.0 * t3, t3 - 2.0 * t2 + t, t3 - t2]
}

/// The same for the slope of the curve.
pub(super) fn slope_weights(t: f64) -> [f64; 4] {
    let t2 = t * t;
    [6.0 * (t2 - t), 6.0 * (t - t2), 3.0 * t2 - 4.0 * t + 1.0, 3.0 * t2 - 2.0 * t]
}

/// The point with these weights between two points with their slopes.
#[inline(always)]
pub(super) fn blend<T: Num>(p: [V3<T>; 2], m: [V3<T>; 2], w: [f64; 4]) -> V3<T> {
    let [a, b, c, d] = w.map(T::of);
    p[0] * a + p[1] * b + m[0] * c + m[1] * d
}
