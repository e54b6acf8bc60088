//! The model of a few segments at a time, as many as one vector register holds: each knows nothing of the others until
//! they are eliminated.
//!
//! Inertia and weight, bending, the barrier, and how the next crease turns what is beyond it; what else pulls at a cell is
//! added one by one, see [`forces`](super::forces).
//!
//! Checked by `tests/ribbon_derivatives.rs`.

use super::barrier::wall;
use super::bending::Bend;
use super::body::{Body, End, Stage};
use super::frame::{Frame, Six};
use super::inertia::{Cell, Common};
use super::joint::{Crease, Turn, about};
use super::resample::{Pair, Sample};
use super::riccati::{Part, state};
use super::strip::Strip;
use crate::real::{LANES, Lanes, Real, V3};

/// Models of a few segments and of the creases that follow them, side by side.
struct Models<T> {
    /// Gradient by the state.
    z: [T; LANES],
    /// Hessian by turn and turn: `xx`, `yy`, `zz`, `xy`, `xz`, `yz`.
    turn: [T; 6],
    /// Hessian by turn and shift: `[lever]×`.
    lever: V3<T>,
    /// Hessian by twist and `c`.
    xc: Six<T>,
    /// Hessian by `ψψ`, `ψc`, `cc`.
    uu: [T; 3],
    /// The next crease's gradient by `ψ`, `c`.
    g: [T; 2],
    /// Its Hessian by `ψψ`, `ψc`, `cc`.
    h: [T; 3],
    /// Its Hessian by twist and `c`.
    far: Six<T>,
    /// Its Hessian by its own `ψ`, `c` (rows) and the nearer crease's.
    u: [[T; 2]; 2],
    /// Its axes `S_ψ`, `S_c`.
    axes: [Six<T>; 2],
    /// Its place, and the axes of its second derivatives `ψc` and `cc`.
    bend: Bends<T>,
}

/// How a crease turns a wrench beyond it, to second order.
#[derive(Debug, Clone, Copy)]
pub struct Bends<T> {
    /// Its place.
    pub p: V3<T>,
    /// The axis of `ψc`.
    pub mixed: V3<T>,
    /// The axis of `cc`.
    pub slope: V3<T>,
}

/// Room for as many segments as are assembled at a time, the last first.
#[derive(Debug, Clone)]
pub struct Room<R> {
    /// Their models; ties to wrenches beyond are not in them yet.
    pub parts: [Part<R>; LANES],
    /// How their next creases turn those.
    pub bends: [Bends<R>; LANES],
}

impl<R: Real> Room<R> {
    /// Nothing yet.
    pub const EMPTY: Self = Self {
        parts: [Part::ZERO; LANES],
        bends: [Bends { p: V3([R::ZERO; 3]), mixed: V3([R::ZERO; 3]), slope: V3([R::ZERO; 3]) };
            LANES],
    };
}

/// What follows a segment.
#[derive(Clone, Copy)]
struct Next<'a, R> {
    pair: &'a Pair<R>,
    want: &'a [Sample<R>; 2],
    crease: Crease<R>,
    turn: Turn<R>,
}

impl<'a, R: Real> Next<'a, R> {
    fn end(end: &'a End<R>) -> Self {
        Self { pair: &end.pair, want: &end.want, crease: Crease::default(), turn: Turn::NONE }
    }
    #[inline(always)]
    fn crease(s: &'a Stage<R>) -> Self {
        Self { pair: &s.pair, want: &s.want, crease: s.crease, turn: s.turn }
    }
}

/// Segments that are assembled together, the last first, and what follows that.
struct Few<'a, R> {
    last: usize,
    s: [&'a Stage<R>; LANES],
    beyond: Next<'a, R>,
}

impl<'a, R: Real> Few<'a, R> {
    #[inline(always)]
    fn of(stages: &'a [Stage<R>], end: &'a End<R>, last: usize) -> Option<Self> {
        let first = stages.first()?;
        let s = core::array::from_fn(|l| stages.get(last.saturating_sub(l)).unwrap_or(first));
        let beyond = stages.get(last + 1).map_or_else(|| Next::end(end), Next::crease);
        Some(Self { last, s, beyond })
    }
    #[inline(always)]
    fn near<F: Lanes<R>>(&self, at: impl Fn(&Stage<R>) -> R) -> F {
        F::each(|l| at(self.s[l % LANES]))
    }
    #[inline(always)]
    fn far<F: Lanes<R>>(&self, at: impl Fn(&Next<'a, R>) -> R) -> F {
        F::each(|l| match l.checked_sub(1) {
            Some(before) => at(&Next::crease(self.s[before % LANES])),
            None => at(&self.beyond),
        })
    }
    #[inline(always)]
    fn near3<F: Lanes<R>>(&self, at: impl Fn(&Stage<R>) -> V3<R>) -> V3<F> {
        V3([0, 1, 2].map(|i| self.near(|s| at(s).0[i])))
    }
    #[inline(always)]
    fn far3<F: Lanes<R>>(&self, at: impl Fn(&Next<'a, R>) -> V3<R>) -> V3<F> {
        V3([0, 1, 2].map(|i| self.far(|n| at(n).0[i])))
    }
    #[inline(always)]
    fn frames<F: Lanes<R>>(&self) -> Frame<F> {
        Frame {
            t: self.near3(|s| s.frame.t),
            b: self.near3(|s| s.frame.b),
            n: self.near3(|s| s.frame.n),
            p: self.near3(|s| s.frame.p),
        }
    }
    /// What the vertices aim at: A and B of the near crease, A and B of the far one.
    #[inline(always)]
    fn wants<F: Lanes<R>>(&self) -> [Sample<F>; 4] {
        let near = |rim: usize| Sample {
            y: self.near3(|s| s.want[rim].y),
            dy: self.near3(|s| s.want[rim].dy),
            ddy: self.near3(|s| s.want[rim].ddy),
        };
        let far = |rim: usize| Sample {
            y: self.far3(|n| n.want[rim].y),
            dy: self.far3(|n| n.want[rim].dy),
            ddy: self.far3(|n| n.want[rim].ddy),
        };
        [near(0), near(1), far(0), far(1)]
    }
    #[inline(always)]
    fn bends<F: Lanes<R>>(&self, strip: &Strip<R>) -> Bend<F> {
        let first = Bend::of(strip, self.last, R::ZERO);
        let mut factor = first.factor.map(F::all);
        if strip.wunderlich {
            let mut each = [[R::ZERO; 3]; LANES];
            let mut far = self.beyond.crease.c;
            for (each, s) in each.iter_mut().zip(self.s).take(F::WIDTH) {
                *each = Bend::of(strip, self.last, far - s.crease.c).factor;
                far = s.crease.c;
            }
            factor = [0, 1, 2].map(|i| F::each(|l| each[l % LANES][i]));
        }
        let weight = |far: usize| F::each(|l| strip.weight(self.last.saturating_sub(l) + far));
        Bend { factor, weight: [weight(0), weight(1)], slope: F::all(first.slope) }
    }
    #[inline(always)]
    fn turns<F: Lanes<R>>(&self) -> Turn<F> {
        Turn {
            c: self.far(|n| n.turn.c),
            inv_s: self.far(|n| n.turn.inv_s),
            sin: self.far(|n| n.turn.sin),
            versine: self.far(|n| n.turn.versine),
        }
    }
}

/// What all segments' models have in common.
#[derive(Debug, Clone, Copy)]
pub struct Assembly<R: Real> {
    common: Common<R::Few>,
    /// A cell's by `κ`.
    mass: R,
    rough: R,
    mu: R,
}

impl<R: Real> Assembly<R> {
    /// Of a body as it is evaluated.
    pub fn of<const N: usize>(body: &Body<R, N>) -> Self {
        let (strip, all) = (&body.strip, <R::Few as Lanes<R>>::all);
        let common = Common::of(strip, &body.motion, body.rough, all);
        let mass = body.motion.kappa * strip.cell_mass();
        Self { common, mass, rough: body.rough, mu: body.mu }
    }

    /// The models of eight segments, or of as many as there are: the segment `last`, the one before it, and so on.
    ///
    /// # Cost
    ///
    /// Some 800 operations a segment, as many segments at once as a register holds.
    #[inline(never)]
    pub fn fill(
        &self,
        strip: &Strip<R>,
        (stages, end): (&[Stage<R>], &End<R>),
        last: usize,
        room: &mut Room<R>,
    ) {
        let width = <R::Few as Lanes<R>>::WIDTH;
        let slots = room.parts.chunks_mut(width).zip(room.bends.chunks_mut(width));
        for (group, (parts, bends)) in slots.enumerate() {
            let Some(last) = last.checked_sub(group * width) else { return };
            let Some(few) = Few::of(stages, end, last) else { return };
            let models = self.models(strip, &few);
            for (l, (part, bend)) in parts.iter_mut().zip(bends).enumerate() {
                models.put(l, self.mass, part, bend);
            }
        }
    }

    #[inline(always)]
    fn models(&self, strip: &Strip<R>, few: &Few<'_, R>) -> Models<R::Few> {
        let [a, b] = [
            Crease { psi: few.near(|s| s.crease.psi), c: few.near(|s| s.crease.c) },
            Crease { psi: few.far(|n| n.crease.psi), c: few.far(|n| n.crease.c) },
        ];
        let (frame, want) = (few.frames::<R::Few>(), few.wants());
        let pairs = |rim: usize| (few.near3(|s| s.pair[rim]), few.far3(|n| n.pair[rim]));
        let ((x0, x2), (x1, x3)) = (pairs(0), pairs(1));
        let [w0, w1, w2, w3] = &want;
        let spread = b.c - a.c;
        let cell = Cell { t: frame.t, x: [x0, x1, x2, x3], want: [w0, w1, w2, w3], spread };
        let m = self.common.model(&cell);
        let bending = few.bends::<R::Few>(strip);
        let mut bent = bending.derivatives(a, b);
        let all = <R::Few as Lanes<R>>::all;
        if self.rough > R::ZERO {
            bent.roughen(&bending.rough(a, b), all(self.rough));
        }
        let dual = [0, 1].map(|i| few.near(|s| s.dual[i]));
        let w = wall(spread, all(strip.limit), all(self.mu), dual);
        let (g, h, [p, q, r, s, t, u]) = (&bent.g, &bent.h, m.x);
        let (turn, at) = (few.turns::<R::Few>(), frame.p + frame.t * all(strip.cell));
        let [mixed, slope] = turn.second_axes(&frame);
        Models {
            z: [p, q, r, s, t, u, g[0], g[1] + m.c[0] - w.slope],
            turn: m.turn,
            lever: m.lever,
            xc: m.xc[0],
            uu: [h[0][0], h[0][1], h[1][1] + m.cc[0] + w.curve],
            g: [g[2], g[3] + m.c[1] + w.slope],
            h: [h[2][2], h[2][3], h[3][3] + m.cc[2] + w.curve],
            far: m.xc[1],
            u: [[h[2][0], h[2][1]], [h[3][0], h[3][1] + m.cc[1] - w.curve]],
            axes: turn.axes(&frame).map(|a| about(a, at)),
            bend: Bends { p: at, mixed, slope },
        }
    }
}

impl<T> Models<T> {
    /// Writes one of them out; `mass` is a cell's by `κ`.
    #[inline(always)]
    fn put<R: Real>(&self, lane: usize, m: R, part: &mut Part<R>, bend: &mut Bends<R>)
    where
        T: Lanes<R>,
    {
        let (at, o, l) = (|v: &T| v.lane(lane), R::ZERO, R::ONE);
        let [xx, yy, zz, xy, xz, yz] = self.turn.each_ref().map(at);
        let [a, b, c] = self.lever.0.each_ref().map(at);
        let [p, q, r, s, t, u] = self.xc.each_ref().map(at);
        let [bb, bs, ss] = self.uu.each_ref().map(at);
        let [r0, r1, r2, r3, r4, r5, r6, r7] = &mut part.zz;
        *r0 = [xx, xy, xz, o, -c, b, o, p];
        *r1 = [xy, yy, yz, c, o, -a, o, q];
        *r2 = [xz, yz, zz, -b, a, o, o, r];
        *r3 = [o, c, -b, m, o, o, o, s];
        *r4 = [-c, o, a, o, m, o, o, t];
        *r5 = [b, -a, o, o, o, m, o, u];
        *r6 = [o, o, o, o, o, o, bb, bs];
        *r7 = [p, q, r, s, t, u, bs, ss];
        part.z = self.z.each_ref().map(at);
        let [turn, slope] = self.axes.each_ref().map(|axis| axis.each_ref().map(at));
        part.axes = [state(&turn, [l, o]), state(&slope, [o, l])];
        let [turn, slope] = self.u.each_ref().map(|u| u.each_ref().map(at));
        part.tie = [state(&[o; 6], turn), state(&self.far.each_ref().map(at), slope)];
        (part.g, part.h) = (self.g.each_ref().map(at), self.h.each_ref().map(at));
        let v3 = |v: &V3<T>| V3(v.0.each_ref().map(at));
        *bend =
            Bends { p: v3(&self.bend.p), mixed: v3(&self.bend.mixed), slope: v3(&self.bend.slope) };
    }
}
