//! A finger that holds a bookmark.

use super::ground::Layer;
use crate::effect::ribbon::resample::Pair;
use crate::effect::ribbon::{Ask, Spring};
use crate::hand::view::Ray;
use crate::real::{Real, V3};

/// A finger this near it takes it, metres.
const NEAR: f64 = 8e-3;
/// How firmly, newton per metre.
const FIRM: f64 = 2.0;
/// How far a finger lifts what it takes, metres.
const LIFT: f64 = 5e-3;

/// What is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Finger<R> {
    pub(super) id: u8,
    crease: usize,
    /// The plane it moves in, through where it took it, towards the eye.
    plane: [V3<R>; 2],
    /// From where it pulls to the middle of the ribbon and to its rims.
    across: V3<R>,
    pub(super) to: V3<R>,
}

impl<R: Real> Finger<R> {
    /// Takes what is nearest the ray, if that is near enough. What lies between leaves cannot be taken.
    pub(super) fn take(
        id: u8,
        ray: &Ray<R>,
        towards: V3<R>,
        pairs: impl Iterator<Item = Pair<R>>,
        covered: impl Fn(V3<R>) -> bool,
    ) -> Option<Self> {
        let mut best = (R::of(NEAR * NEAR), None);
        for (crease, [a, b]) in pairs.enumerate().skip(2) {
            let middle = (a + b) * R::of(0.5);
            let d = ray.distance_sq(middle);
            if d < best.0 && !covered(middle) {
                best = (d, Some((crease, middle, (b - a) * R::of(0.5))));
            }
        }
        let (crease, middle, across) = best.1?;
        let plane = [middle + towards * R::of(LIFT), towards];
        Some(Self { id, crease, plane, across, to: middle })
    }

    /// Moves to where the ray meets its plane.
    pub(super) fn follow(&mut self, ray: &Ray<R>) {
        let [point, normal] = self.plane;
        if let Some(to) = ray.meet(point, normal).filter(|p| p.norm_sq() < R::of(4.0)) {
            self.to = to;
        }
    }

    /// Pulls at both rims.
    pub(super) fn pull(&self, ask: &mut Ask<R>) {
        for (rim, side) in [-R::one(), R::one()].into_iter().enumerate() {
            let target = self.to + self.across * side;
            let spring = Spring { crease: self.crease, rim, target, stiffness: R::of(FIRM) };
            let _ = ask.springs.push(spring);
        }
    }
}

/// Whether what lies at a layer can be seen at all.
pub(super) fn hidden(layer: Layer) -> bool {
    !matches!(layer, Layer::Open(_))
}
