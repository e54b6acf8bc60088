//! Where a point of the flat ribbon would be by now: interpolation along each rim between last step's vertices.
//!
//! The vertices of this step lie elsewhere in the flat ribbon than those of the last, so a difference of the two means
//! nothing until the old ones are read where the new ones are.
//!
//! Source: Ribbon Eq. 4. Piecewise linear there, which has a kink exactly where the solver starts and acts like dry
//! friction on the rulings; cubic Hermite here. Checked by `tests/ribbon_parts.rs`.

use super::strip::Strip;
use crate::real::{Real, V3};

/// The two rim points of a crease: A at `-w/2`, B at `+w/2`.
pub type Pair<R> = [V3<R>; 2];

/// What is known at an old vertex pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Knot<R> {
    /// Places along rims A and B of the flat ribbon.
    pub s: [R; 2],
    /// Where they are bound for.
    pub y: Pair<R>,
    /// `dy/ds`.
    pub slope: Pair<R>,
}

/// An interpolated point and how it changes along the rim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample<R> {
    /// The point.
    pub y: V3<R>,
    /// Its first derivative.
    pub dy: V3<R>,
    /// Its second derivative.
    pub ddy: V3<R>,
}

/// The knots of a ribbon of up to `N` segments.
#[derive(Debug, Clone, Copy)]
pub struct Table<R, const N: usize> {
    knots: [Knot<R>; N],
    end: Knot<R>,
    n: usize,
    smooth: bool,
}

const fn zero<R: Real>() -> V3<R> {
    V3([R::ZERO; 3])
}

impl<R: Real> Knot<R> {
    /// Nothing.
    pub const ZERO: Self = Self { s: [R::ZERO; 2], y: [zero(); 2], slope: [zero(); 2] };
}

impl<R: Real> Sample<R> {
    /// Nothing.
    pub const ZERO: Self = Self { y: zero(), dy: zero(), ddy: zero() };
}

impl<R: Real, const N: usize> Table<R, N> {
    /// No knots.
    pub const EMPTY: Self = Self { knots: [Knot::ZERO; N], end: Knot::ZERO, n: 0, smooth: true };

    /// Takes the knots of rulings of the given slopes, then of the end, which crosses at a right angle.
    pub fn fill(
        &mut self,
        strip: &Strip<R>,
        bound_for: impl Iterator<Item = (R, Pair<R>)>,
        end: Pair<R>,
    ) {
        (self.n, self.smooth) = (strip.n.min(N), strip.smooth);
        for (j, (knot, (c, y))) in self.knots.iter_mut().zip(bound_for).take(self.n).enumerate() {
            let (at, lean) = (strip.cell * R::of(j as f64), strip.half * c);
            *knot = Knot { s: [at - lean, at + lean], y, slope: [zero(); 2] };
        }
        self.end = Knot { s: [strip.length(); 2], y: end, slope: [zero(); 2] };
        self.find_slopes();
    }
    /// Puts other values on the same knots.
    pub fn replace(&mut self, values: impl Iterator<Item = Pair<R>>, end: Pair<R>) {
        for (knot, y) in self.knots.iter_mut().zip(values).take(self.n) {
            knot.y = y;
        }
        self.end.y = end;
        self.find_slopes();
    }
    fn find_slopes(&mut self) {
        for j in 0..=self.n {
            let slope = [self.slope(j, 0), self.slope(j, 1)];
            if let Some(knot) = self.knot_mut(j) {
                knot.slope = slope;
            }
        }
    }
    fn knot(&self, j: usize) -> &Knot<R> {
        if j < self.n { self.knots.get(j).unwrap_or(&self.end) } else { &self.end }
    }
    fn knot_mut(&mut self, j: usize) -> Option<&mut Knot<R>> {
        if j < self.n { self.knots.get_mut(j) } else { Some(&mut self.end) }
    }
    /// Place and point on one rim.
    fn on(&self, j: usize, rim: usize) -> (R, V3<R>) {
        let k = self.knot(j);
        if rim == 0 { (k.s[0], k.y[0]) } else { (k.s[1], k.y[1]) }
    }
    /// The chord after a knot: its length in the flat ribbon, and its slope.
    fn chord(&self, i: usize, rim: usize) -> (R, V3<R>) {
        let ((s0, y0), (s1, y1)) = (self.on(i, rim), self.on(i + 1, rim));
        (s1 - s0, (y1 - y0) * (R::one() / (s1 - s0)))
    }
    /// The slope at an inner knot of the parabola through it and its neighbours.
    fn inner_slope(&self, j: usize, rim: usize) -> V3<R> {
        let ((before, low), (after, high)) =
            (self.chord(j.saturating_sub(1), rim), self.chord(j, rim));
        (low * after + high * before) * (R::one() / (before + after))
    }
    /// The slope at any knot: at an end that of its neighbour's parabola, on which slopes have the chord's for their mean.
    fn slope(&self, j: usize, rim: usize) -> V3<R> {
        let two = R::of(2.0);
        if j == 0 {
            self.chord(0, rim).1 * two - self.inner_slope(1, rim)
        } else if j >= self.n {
            self.chord(j - 1, rim).1 * two - self.inner_slope(j - 1, rim)
        } else {
            self.inner_slope(j, rim)
        }
    }
    /// The knot at or before `s`, sought from `from` outwards.
    fn cell(&self, rim: usize, s: R, from: usize) -> usize {
        let mut i = from.min(self.n.saturating_sub(1));
        for _ in 0..self.n {
            if i > 0 && s < self.on(i, rim).0 {
                i -= 1;
            } else if i + 1 < self.n && s >= self.on(i + 1, rim).0 {
                i += 1;
            } else {
                break;
            }
        }
        i
    }
    /// Reads a rim at `s`, near knot `from`.
    ///
    /// # Accuracy
    ///
    /// Exact at a knot; between knots third order in the cell, or second where linear.
    #[inline]
    pub fn sample(&self, rim: usize, s: R, from: usize) -> Sample<R> {
        let i = self.cell(rim, s, from);
        let ((s0, y0), (s1, y1)) = (self.on(i, rim), self.on(i + 1, rim));
        let inv = R::one() / (s1 - s0);
        let (u, chord) = ((s - s0) * inv, (y1 - y0) * inv);
        if !self.smooth {
            return Sample { y: y0 + chord * (s - s0), dy: chord, ddy: zero() };
        }
        let pick = |k: &Knot<R>| if rim == 0 { k.slope[0] } else { k.slope[1] };
        let (m0, m1) = (pick(self.knot(i)), pick(self.knot(i + 1)));
        // y = y0 + (s-s0) [m0 + u (p + u q)] with p, q from the two ends.
        let q = m0 + m1 - chord * R::of(2.0);
        let p = chord - m0 - q;
        let (two, three) = (R::of(2.0), R::of(3.0));
        Sample {
            y: y0 + (m0 + (p + q * u) * u) * (s - s0),
            dy: m0 + (p * two + q * (three * u)) * u,
            ddy: (p * two + q * (R::of(6.0) * u)) * inv,
        }
    }
}
