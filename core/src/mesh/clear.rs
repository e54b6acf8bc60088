//! Keeps the drawn leaf out of the drawn blocks.
//!
//! Collisions hold the nodes of the leaf above the blocks; a curve through the nodes may still dip
//! between two of them. Eight rows at a time it is lifted to where the collisions would put it, and by a
//! hair more, for the drawn edges are chords.
//!
//! Round the end of the binding, the closer the smaller the block, the nearest way out is no help: from
//! a leaf that runs straight across, all points would be lifted to the same place. There a point goes
//! to where a leaf that lies on the block has it.

use super::block;
use super::columns;
use super::curve::Polyline;
use crate::collision::Profile;
use crate::real::{Lanes, Num, Real, V2, V3};
use crate::state::strip::{BLOCK, Strip};

/// The hair, model units: 0.05 mm of a leaf of 130 mm.
const HAIR: f64 = 5e-3;
/// At the spine, where leaf and blocks meet, the hair is this share of the distance from it.
const TAPER: f64 = 0.1;

/// How deep a point lies when it goes to its place in a lying leaf, as a share of the clearance.
const DEEP: f64 = 0.25;
/// How far from the spine that may be, in clearances: round a quarter circle.
const ROUND: f64 = 2.0;

/// One block, and how high above its midline the middle of the leaf has to be.
#[derive(Debug)]
struct Side<R: Real> {
    profile: Profile<R>,
    sign: R,
    /// Above this nothing can touch.
    roof: R,
    clearance: R,
    /// The columns of a leaf that lies on the block, outward.
    lying: [V2<f32>; columns::MOST],
}

/// Both blocks.
#[derive(Debug)]
pub(super) struct Clear<R: Real>([Side<R>; 2]);

impl<R: Real> Clear<R> {
    /// For a leaf of thickness `2 half`.
    pub(super) fn new(
        [left, right]: [Profile<R>; 2],
        blocks: &[Strip<R, BLOCK>; 2],
        half: R,
        columns: usize,
    ) -> Self {
        let side = |profile, strip, sign| Side::new(profile, strip, half, sign, columns);
        Self([side(left, &blocks[0], -1.0), side(right, &blocks[1], 1.0)])
    }

    /// Eight points of a column at distance `s` from the spine, lifted where they are too deep.
    pub(super) fn lift(&self, p: V3<R::Eight>, column: usize, s: R) -> V3<R::Eight> {
        let p = V3([p.0[0], p.0[1].larger(R::Eight::zero()), p.0[2]]);
        self.0.iter().fold(p, |p, side| side.lift(p, column, s))
    }
}

impl<R: Real> Side<R> {
    fn new(
        profile: Profile<R>,
        strip: &Strip<R, BLOCK>,
        half: R,
        sign: f64,
        columns: usize,
    ) -> Self {
        let clearance = profile.thickness + half;
        let highest = strip.x.iter().fold(R::ZERO, |m, x| m.larger(x.0[1]));
        let mut lying = [V2([0.0; 2]); columns::MOST];
        let mut line = Polyline::new();
        block::curve(&block::dense(strip), clearance.narrow(), &mut line);
        let end = V2(strip.x[0].0.map(Real::narrow));
        let row = line.pace(columns, columns::steps(columns));
        for (slot, (_, knot)) in lying.iter_mut().zip(row) {
            *slot = knot.p.xy() + end;
        }
        Self { profile, sign: R::of(sign), roof: highest + clearance, clearance, lying }
    }

    #[inline(always)]
    fn lift(&self, p: V3<R::Eight>, column: usize, s: R) -> V3<R::Eight> {
        let hair = R::of(HAIR).smaller(s * R::of(TAPER));
        if (-p.0[1]).largest() < -(self.roof + hair) {
            return p;
        }
        let (sign, zero) = (R::Eight::all(self.sign), R::Eight::zero());
        let at = V2([p.0[0] * sign, p.0[1]]);
        let (height, normal) = self.above(at);
        let depth = (R::Eight::all(self.clearance + hair) - height).larger(zero);
        let mut out = at + normal * depth;
        if s < self.clearance * R::of(ROUND) {
            let lying = self.lying.get(column).copied().unwrap_or(V2([0.0; 2]));
            let lying = V2(lying.0.map(|c| R::Eight::of(f64::from(c))));
            let share = depth * R::Eight::all(R::of(1.0 / DEEP) / self.clearance);
            out = out + (lying - out) * share.smaller(R::Eight::one());
        }
        V3([out.0[0] * sign, out.0[1], p.0[2]])
    }

    /// Signed distance from the midline and the way out; far away where the block is not below.
    #[inline(always)]
    fn above(&self, p: V2<R::Eight>) -> (R::Eight, V2<R::Eight>) {
        let mut nearest_sq = R::Eight::of(1e12);
        let mut height = R::Eight::of(1e6);
        let mut normal = V2::zero();
        let (zero, tiny) = (R::Eight::zero(), R::Eight::of(1e-9));
        let last = self.profile.segments.len().saturating_sub(1);
        for (n, s) in self.profile.segments.iter().enumerate() {
            let lanes = |v: V2<R>| V2(v.0.map(R::Eight::all));
            let (along, up, to) = (lanes(s.along), lanes(s.normal), p - lanes(s.from));
            let t = to.dot(along).larger(zero);
            let t = if n == last { t } else { t.smaller(R::Eight::all(s.length)) };
            let away = to - along * t;
            let (d_sq, side) = (away.norm_sq(), to.dot(up));
            let d = d_sq.root();
            let signed = R::Eight::pick_less(side, zero, -d, d);
            let scale = R::Eight::one() / R::Eight::pick_less(signed, zero, -d, d + tiny);
            // Beside the binding, on the far side of the fan, there is no paper of this block.
            let beside = if n == 0 { to.0[0] } else { zero };
            let signed = R::Eight::pick_less(
                beside,
                zero,
                R::Eight::pick_less(p.0[1], zero, R::Eight::of(1e6), signed),
                signed,
            );
            let better = |new, old| R::Eight::pick_less(d_sq, nearest_sq, new, old);
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
