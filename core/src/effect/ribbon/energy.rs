//! What energy a ribbon has: of its motion, of its bending, of its height.

use super::bending;
use super::body::Body;
use super::joint::Crease;
use super::life::Ribbon;
use crate::real::{Real, V3};

/// Energy in its parts, joules.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Parts<R> {
    /// Of motion.
    pub kinetic: R,
    /// Of bent creases and slanted rulings.
    pub bending: R,
    /// Against gravity, from the ribbon's own origin.
    pub height: R,
}

impl<R: Real> Parts<R> {
    /// The sum.
    pub fn total(&self) -> R {
        self.kinetic + self.bending + self.height
    }
}

impl<R: Real, const N: usize> Ribbon<R, N> {
    /// Its energy now, springs, guides and contact left out.
    ///
    /// # Cost
    ///
    /// Some hundred operations a segment.
    pub fn energy(&self) -> Parts<R> {
        let Body { strip, end, .. } = self.posed();
        let mut parts = Parts { kinetic: R::ZERO, bending: R::ZERO, height: R::ZERO };
        let gravity = V3(self.gravity.map(R::of));
        let mut stages = self.posed().used().iter().enumerate().peekable();
        while let Some((j, s)) = stages.next() {
            let (pair, velocity, crease) = match stages.peek() {
                Some((_, next)) => (&next.pair, &next.velocity, next.kept),
                None => (&end.pair, &end.velocity, Crease::default()),
            };
            let spread = crease.c - s.kept.c;
            let ([a, b], [c, d]) = (s.velocity, *velocity);
            let v = [a, b, c, d];
            let moved = strip.mass.times(spread, &v);
            let motion = v.iter().zip(&moved).fold(R::ZERO, |sum, (v, m)| sum + v.dot(*m));
            parts.kinetic += R::of(0.5) * motion;
            let ([a, b], [c, d]) = (s.pair, *pair);
            let weight = strip.mass.times(spread, &[a, b, c, d]);
            parts.height -= weight.iter().fold(R::ZERO, |sum, m| sum + gravity.dot(*m));
            parts.bending += bending::energy(strip, j, s.kept, crease);
        }
        parts
    }
}
