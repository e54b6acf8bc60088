//! What pulls at a ribbon from outside: springs on its rim, guides of its normals, and whatever a caller adds.

use super::resample::Pair;
use crate::real::{Real, V3};
use heapless::Vec;

/// Springs that one ribbon can have.
pub const SPRINGS: usize = 8;
/// Guides that one ribbon can have.
pub const GUIDES: usize = 4;
/// Curvature terms that one vertex pair can have.
pub const TERMS: usize = 8;

/// `k/2 |x - target|²` at one rim vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring<R> {
    /// Crease, 0 to the number of segments.
    pub crease: usize,
    /// 0: rim A, else rim B.
    pub rim: usize,
    /// Where to, metres.
    pub target: V3<R>,
    /// Newton per metre.
    pub stiffness: R,
}

/// `K/2 |n - normal|²` at one segment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Guide<R> {
    /// Segment.
    pub segment: usize,
    /// Unit normal it shall have.
    pub normal: V3<R>,
    /// Newton metres.
    pub stiffness: R,
}

/// First and second derivatives of loads on one vertex pair.
#[derive(Debug, Clone)]
pub struct Pull<R> {
    /// Gradient at A and B.
    pub gradient: Pair<R>,
    /// Hessian as a sum of `weight (row_A·δA + row_B·δB)²`.
    pub terms: Vec<(R, Pair<R>), TERMS>,
    /// Whether anything pulls.
    some: bool,
}

impl<R: Real> Pull<R> {
    /// Nothing.
    pub fn none() -> Self {
        Self { gradient: [V3([R::ZERO; 3]); 2], terms: Vec::new(), some: false }
    }
    /// Whether anything pulls.
    #[inline(always)]
    pub(super) fn some(&self) -> bool {
        self.some
    }
    /// Nothing again.
    #[inline(always)]
    pub(super) fn clear(&mut self) {
        if core::mem::replace(&mut self.some, false) {
            self.gradient = [V3([R::ZERO; 3]); 2];
            self.terms.clear();
        }
    }
    /// Adds to the gradient at A and B.
    #[inline]
    pub fn push(&mut self, a: V3<R>, b: V3<R>) {
        if a.0 == [R::ZERO; 3] && b.0 == [R::ZERO; 3] {
            return;
        }
        let [x, y] = self.gradient;
        self.gradient = [x + a, y + b];
        self.some = true;
    }
    /// Adds a curvature term; those beyond [`TERMS`] are left out, which costs iterations, not truth.
    pub fn curve(&mut self, weight: R, rows: Pair<R>) {
        let _ = self.terms.push((weight, rows));
        self.some = true;
    }
}

/// Loads on the vertex pairs of a ribbon: contact, a hand, wind.
///
/// A pair's loads see nothing but the pair, so each term stays within its stage of the solver.
pub trait Loads<R> {
    /// Energy at the pair of a crease, joules.
    fn energy(&self, crease: usize, pair: &Pair<R>) -> R;
    /// Its derivatives, added.
    fn pull(&self, crease: usize, pair: &Pair<R>, pull: &mut Pull<R>);
}

/// Nothing pulls.
impl<R: Real> Loads<R> for () {
    fn energy(&self, _: usize, _: &Pair<R>) -> R {
        R::ZERO
    }
    fn pull(&self, _: usize, _: &Pair<R>, _: &mut Pull<R>) {}
}

/// The springs and guides of one ribbon.
#[derive(Debug, Clone, Default)]
pub struct Ask<R> {
    /// Springs.
    pub springs: Vec<Spring<R>, SPRINGS>,
    /// Guides.
    pub guides: Vec<Guide<R>, GUIDES>,
}

impl<R: Real> Ask<R> {
    /// Nothing asked.
    pub const NONE: Self = Self { springs: Vec::new(), guides: Vec::new() };

    /// Energy of the guides of a segment.
    pub(super) fn guided(&self, segment: usize, n: V3<R>) -> R {
        let own = self.guides.iter().filter(|g| g.segment == segment);
        own.fold(R::ZERO, |sum, g| sum + g.stiffness * R::of(0.5) * (n - g.normal).norm_sq())
    }
    /// What pulls at a segment's normal; the energy is linear in a unit normal.
    pub(super) fn guide(&self, segment: usize) -> V3<R> {
        let own = self.guides.iter().filter(|g| g.segment == segment);
        own.fold(V3([R::ZERO; 3]), |sum, g| sum - g.normal * g.stiffness)
    }
}

impl<R: Real> Loads<R> for Ask<R> {
    fn energy(&self, crease: usize, pair: &Pair<R>) -> R {
        let own = self.springs.iter().filter(|s| s.crease == crease);
        own.fold(R::ZERO, |sum, s| {
            let at = if s.rim == 0 { pair[0] } else { pair[1] };
            sum + s.stiffness * R::of(0.5) * (at - s.target).norm_sq()
        })
    }
    fn pull(&self, crease: usize, pair: &Pair<R>, pull: &mut Pull<R>) {
        let none = V3([R::ZERO; 3]);
        for s in self.springs.iter().filter(|s| s.crease == crease) {
            let at = if s.rim == 0 { pair[0] } else { pair[1] };
            let force = (at - s.target) * s.stiffness;
            if s.rim == 0 {
                pull.push(force, none);
            } else {
                pull.push(none, force);
            }
            for i in 0..3 {
                let mut axis = none;
                axis.0[i] = R::one();
                let rows = if s.rim == 0 { [axis, none] } else { [none, axis] };
                pull.curve(s.stiffness, rows);
            }
        }
    }
}
