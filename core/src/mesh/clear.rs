//! Keeps the drawn leaf out of the drawn blocks.
//!
//! Collisions hold the nodes of the leaf above the blocks; a curve through the nodes may still dip
//! between two of them. Eight rows at a time it is lifted to where the collisions would put it, and by a
//! hair more, for the drawn edges are chords.

use crate::collision::Profile;
use crate::real::{Lanes, Num, Real, V2, V3};

/// The hair, model units: 0.05 mm of a leaf of 130 mm.
const HAIR: f64 = 5e-3;
/// At the spine, where leaf and blocks meet, the hair is this share of the distance from it.
const TAPER: f64 = 0.1;

/// One block, and how high above its midline the middle of the leaf has to be.
#[derive(Debug, Clone, Copy)]
struct Side<R> {
    profile: Profile<R>,
    sign: R,
    /// Above this nothing can touch.
    roof: R,
    clearance: R,
}

/// Both blocks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Clear<R>([Side<R>; 2]);

impl<R: Real> Clear<R> {
    /// For a leaf of thickness `2 half`.
    pub(super) fn new([left, right]: [Profile<R>; 2], half: R) -> Self {
        let side = |profile: Profile<R>, sign: f64| {
            let clearance = profile.thickness + half;
            let ends = profile.segments.iter().map(|s| s.from.0[1].larger(tip(s)));
            let highest = ends.fold(R::ZERO, |m, y| m.larger(y));
            Side { profile, sign: R::of(sign), roof: highest + clearance, clearance }
        };
        Self([side(left, -1.0), side(right, 1.0)])
    }

    /// Eight points at distance `s` from the spine, lifted where they are too deep.
    pub(super) fn lift(&self, p: V3<R::Lanes>, s: R) -> V3<R::Lanes> {
        let hair = R::of(HAIR).smaller(s * R::of(TAPER));
        self.0.iter().fold(p, |p, side| side.lift(p, hair))
    }
}

fn tip<R: Real>(s: &crate::collision::profile::Segment<R>) -> R {
    s.from.0[1] + s.along.0[1] * s.length
}

impl<R: Real> Side<R> {
    #[inline(always)]
    fn lift(&self, p: V3<R::Lanes>, hair: R) -> V3<R::Lanes> {
        if (-p.0[1]).largest() < -(self.roof + hair) {
            return p;
        }
        let sign = R::Lanes::all(self.sign);
        let (height, normal) = self.above(V2([p.0[0] * sign, p.0[1]]));
        let zero = R::Lanes::zero();
        let depth = (R::Lanes::all(self.clearance + hair) - height).larger(zero);
        V3([p.0[0] + normal.0[0] * sign * depth, p.0[1] + normal.0[1] * depth, p.0[2]])
    }

    /// Signed distance from the midline and the way out; far away where the block is not below.
    #[inline(always)]
    fn above(&self, p: V2<R::Lanes>) -> (R::Lanes, V2<R::Lanes>) {
        let mut nearest_sq = R::Lanes::of(1e12);
        let mut height = R::Lanes::of(1e6);
        let mut normal = V2::zero();
        let (zero, tiny) = (R::Lanes::zero(), R::Lanes::of(1e-9));
        let last = self.profile.segments.len().saturating_sub(1);
        for (n, s) in self.profile.segments.iter().enumerate() {
            let lanes = |v: V2<R>| V2(v.0.map(R::Lanes::all));
            let (along, up, to) = (lanes(s.along), lanes(s.normal), p - lanes(s.from));
            let t = to.dot(along).larger(zero);
            let t = if n == last { t } else { t.smaller(R::Lanes::all(s.length)) };
            let away = to - along * t;
            let (d_sq, side) = (away.norm_sq(), to.dot(up));
            let d = d_sq.root();
            let signed = R::Lanes::pick_less(side, zero, -d, d);
            let scale = R::Lanes::one() / R::Lanes::pick_less(signed, zero, -d, d + tiny);
            // Beside the binding, on the far side of the fan, there is no paper of this block.
            let beside = if n == 0 { to.0[0] } else { zero };
            let signed = R::Lanes::pick_less(
                beside,
                zero,
                R::Lanes::pick_less(p.0[1], zero, R::Lanes::of(1e6), signed),
                signed,
            );
            let better = |new, old| R::Lanes::pick_less(d_sq, nearest_sq, new, old);
            height = better(signed, height);
            normal = V2([
                better(away.0[0] * scale, normal.0[0]),
                better(away.0[1] * scale, normal.0[1]),
            ]);
            nearest_sq = better(d_sq, nearest_sq);
        }
        (height, normal)
    }
}
