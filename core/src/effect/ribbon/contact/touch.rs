//! What a solver asks of contact: an energy, its derivatives by segment, and how much of a step is free.

use super::super::body::{End, Stage};
use super::super::forces::Model;
use super::super::frame::six;
use super::super::inertia::Four;
use super::super::resample::Pair;
use super::super::strip::Strip;
use crate::real::{Real, V3};

/// A ribbon as placed and as last accepted.
#[derive(Debug, Clone, Copy)]
pub struct Pose<'a, R> {
    /// Segments in use.
    pub stages: &'a [Stage<R>],
    /// The end.
    pub end: &'a End<R>,
}

/// The push at one point of a segment, `Σ w_i x_i` of its four vertices.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Push<R> {
    /// Shares of the vertices.
    pub weights: Four<R>,
    /// Unit direction away from what is touched.
    pub normal: V3<R>,
    /// Slope of the energy along it, newton; not positive.
    pub slope: R,
    /// Curvature of the energy along it, newton per metre; not negative.
    pub curve: R,
}

/// What a segment is touched by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum By<R> {
    /// The ground, which stands still.
    Ground,
    /// Another segment of the ribbon.
    Itself {
        /// Which.
        segment: usize,
        /// Shares of its vertices.
        weights: Four<R>,
    },
    /// Another ribbon.
    Other {
        /// How many others were added before it.
        ribbon: usize,
        /// Its segment.
        segment: usize,
        /// Shares of that one's vertices.
        weights: Four<R>,
    },
}

/// A point of a segment that something touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touched<R> {
    /// The segment.
    pub segment: usize,
    /// Shares of its vertices.
    pub weights: Four<R>,
    /// Unit direction away from what touches.
    pub normal: V3<R>,
    /// What does.
    pub by: By<R>,
}

/// Contact of one ribbon, while that is solved for.
pub trait Touch<R: Real> {
    /// Nothing is asked of what is not active.
    const ACTIVE: bool = true;

    /// Energy at a pose as placed, joules.
    fn energy(&mut self, pose: &Pose<'_, R>) -> R;
    /// Finds the pushes at a pose as placed.
    fn press(&mut self, pose: &Pose<'_, R>);
    /// Hands over the pushes that were found at a segment.
    fn pushes(&self, segment: usize, take: impl FnMut(&Push<R>));
    /// The share of the way from the pose accepted to the pose placed that is free; one if all is. Only `range` of the
    /// way that was searched for things near may be gone.
    fn free(&mut self, pose: &Pose<'_, R>, range: R) -> R;
    /// Hands over all points that are touched at a pose as placed.
    fn touched(&self, _: &Pose<'_, R>, _: impl FnMut(&Touched<R>)) {}
}

/// Nothing is near.
impl<R: Real> Touch<R> for () {
    const ACTIVE: bool = false;

    fn energy(&mut self, _: &Pose<'_, R>) -> R {
        R::ZERO
    }
    fn press(&mut self, _: &Pose<'_, R>) {}
    fn pushes(&self, _: usize, _: impl FnMut(&Push<R>)) {}
    fn free(&mut self, _: &Pose<'_, R>, _: R) -> R {
        R::of(1.0)
    }
}

impl<R: Real> Pose<'_, R> {
    /// The vertices of a segment as placed.
    pub fn corners(&self, segment: usize) -> Four<V3<R>> {
        four(self.pair(segment), self.pair(segment + 1))
    }
    /// The vertices of a segment as accepted.
    pub fn kept(&self, segment: usize) -> Four<V3<R>> {
        four(self.kept_pair(segment), self.kept_pair(segment + 1))
    }
    /// The vertices of a crease as placed.
    pub fn pair(&self, crease: usize) -> Pair<R> {
        self.stages.get(crease).map_or(self.end.pair, |s| s.pair)
    }
    /// The vertices of a crease as accepted.
    pub fn kept_pair(&self, crease: usize) -> Pair<R> {
        self.stages.get(crease).map_or(self.end.kept_pair, |s| s.kept_pair)
    }
}

/// Two creases' vertices as a segment's.
pub fn four<R: Real>([a, b]: Pair<R>, [c, d]: Pair<R>) -> Four<V3<R>> {
    [a, b, c, d]
}

/// What pushes the vertices of a segment, as gradients at its two creases.
pub fn forces<R: Real>(touch: &impl Touch<R>, segment: usize) -> [Pair<R>; 2] {
    let mut sum = [V3([R::ZERO; 3]); 4];
    touch.pushes(segment, |p| {
        let force = p.normal * p.slope;
        for (s, &w) in sum.iter_mut().zip(&p.weights) {
            *s = *s + force * w;
        }
    });
    let [a, b, c, d] = sum;
    [[a, b], [c, d]]
}

/// Adds the curvature of a segment's pushes to its model: rank one each, over the twist and both slopes.
pub fn stiffen<R: Real>(
    touch: &impl Touch<R>,
    segment: usize,
    x: &Four<V3<R>>,
    strip: &Strip<R>,
    along: V3<R>,
    model: &mut Model<R>,
) {
    touch.pushes(segment, |p| stiffen_by(p, x, strip, along, model));
}

/// Adds the curvature of one push.
#[inline(always)]
pub fn stiffen_by<R: Real>(
    p: &Push<R>,
    x: &Four<V3<R>>,
    strip: &Strip<R>,
    along: V3<R>,
    model: &mut Model<R>,
) {
    let [a, b, c, d] = p.weights;
    let at = x[0] * a + x[1] * b + x[2] * c + x[3] * d;
    let row = six(at.cross(p.normal), p.normal);
    let slide = along.dot(p.normal) * strip.half;
    let (near, far) = (slide * (b - a), slide * (d - c));
    for (i, &r) in row.iter().enumerate() {
        let r = r * p.curve;
        for (k, &q) in row.iter().enumerate() {
            model.xx[i][k] += r * q;
        }
        model.xc[0][i] += r * near;
        model.xc[1][i] += r * far;
    }
    model.cc[0] += p.curve * near * near;
    model.cc[1] += p.curve * near * far;
    model.cc[2] += p.curve * far * far;
}
