//! Grounds that a ribbon lies on: solid below, so a vertex is on one side or the other.

use super::push::SOLID;
use crate::real::{Real, V3};

/// A solid. A vertex that is inside is pushed out; one that is outside never gets in by a step.
pub trait Surface<R> {
    /// No step lets a vertex in. Where grounds move and close on one another that cannot be had: then they only push, from
    /// however deep.
    const HARD: bool = true;
    /// Where the barrier goes on as its parabola, as a share of its reach.
    const FLOOR: f64 = SOLID;

    /// The distance of a point above it, negative inside, and the unit normal there; infinite where there is none.
    fn above(&self, p: V3<R>) -> (R, V3<R>);

    /// The same of everything it is made of, one after the other: what lies between two of them is pushed by both.
    fn each(&self, p: V3<R>, mut take: impl FnMut(R, V3<R>)) {
        let (d, normal) = self.above(p);
        take(d, normal);
    }

    /// As [`Surface::each`], for a vertex known by its number along the ribbon, rim by rim: what is known to be out of the
    /// barrier's reach may be left out.
    fn each_of(&self, _vertex: usize, p: V3<R>, take: impl FnMut(R, V3<R>)) {
        self.each(p, take);
    }
}

/// No ground.
impl<R: Real> Surface<R> for () {
    fn above(&self, _: V3<R>) -> (R, V3<R>) {
        (R::of(f64::INFINITY), V3([R::ZERO; 3]))
    }
}

/// Everything below a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfSpace<R> {
    /// A point of the plane.
    pub point: V3<R>,
    /// Unit normal, outwards.
    pub normal: V3<R>,
}

impl<R: Real> Surface<R> for HalfSpace<R> {
    fn above(&self, p: V3<R>) -> (R, V3<R>) {
        ((p - self.point).dot(self.normal), self.normal)
    }
}

/// Several: the one that is nearest, or that a point is deepest in; every one of them pushes.
impl<R: Real, S: Surface<R>> Surface<R> for [S] {
    const HARD: bool = S::HARD;
    const FLOOR: f64 = S::FLOOR;

    fn above(&self, p: V3<R>) -> (R, V3<R>) {
        self.iter().fold(().above(p), |best, s| {
            let found = s.above(p);
            if found.0 < best.0 { found } else { best }
        })
    }
    fn each(&self, p: V3<R>, mut take: impl FnMut(R, V3<R>)) {
        self.iter().for_each(|s| s.each(p, &mut take));
    }
}

impl<R: Real, S: Surface<R>, const M: usize> Surface<R> for [S; M] {
    const HARD: bool = S::HARD;
    const FLOOR: f64 = S::FLOOR;

    fn above(&self, p: V3<R>) -> (R, V3<R>) {
        self.as_slice().above(p)
    }
    fn each(&self, p: V3<R>, take: impl FnMut(R, V3<R>)) {
        self.as_slice().each(p, take);
    }
}

impl<R, S: Surface<R> + ?Sized> Surface<R> for &S {
    const HARD: bool = S::HARD;
    const FLOOR: f64 = S::FLOOR;

    fn above(&self, p: V3<R>) -> (R, V3<R>) {
        (*self).above(p)
    }
    fn each(&self, p: V3<R>, take: impl FnMut(R, V3<R>)) {
        (*self).each(p, take);
    }
}

/// A field of heights: the top of a page block, a leaf as it is read just now.
///
/// # Accuracy
///
/// The distance is that of the tangent plane below the point: exact where the field is flat. Bumps between a ribbon's
/// vertices are not seen.
#[derive(Debug, Clone, Copy)]
pub struct Field<F> {
    /// From a point, the height of the field above or below it, and the unit normal there.
    pub height: F,
    /// Which coordinate is the height: 0, 1 or 2.
    pub up: usize,
}

impl<R: Real, F: Fn(V3<R>) -> (R, V3<R>)> Surface<R> for Field<F> {
    fn above(&self, p: V3<R>) -> (R, V3<R>) {
        let (height, normal) = (self.height)(p);
        let pick = |v: V3<R>| v.0.get(self.up).copied().unwrap_or(R::ZERO);
        ((pick(p) - height) * pick(normal), normal)
    }
}
