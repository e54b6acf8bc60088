//! Kinetic energy of a cell with its moving mass matrix: value, gradient, Hessian in (twist, c_j, c_{j+1}),
//! of one cell or of several side by side.
//!
//! ```text
//! F = κ/2 Σ M_ab(Δc) d_a·d_b - Σ M_ab(Δc) pull·x_a      d_a = x_a - Y_a(s_a)      κ = 1/h²
//! ```
//!
//! A vertex moves by `δx = ω×x + v + σ t δc`, with `σ = -w/2` on rim A and `+w/2` on rim B, and `s` by `σ δc`; so
//! `δd = ω×x + v + σ (t - Y') δc`. Dynamics have `κ` and gravity inside `Y`; statics have `κ = 0` and `pull = g`.
//!
//! Source: Ribbon Sec. 4, App. B; gradient as App. C collapses to. Checked by `tests/ribbon_derivatives.rs`.

use super::frame::{Six, six};
use super::resample::{Pair, Sample};
use super::strip::{CellMass, Strip};
use crate::real::{Num, Real, V3};

/// The four vertices of a cell: A and B of its first crease, A and B of its second.
pub type Four<T> = [T; 4];

/// Inertia or weight, whichever acts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion<R> {
    /// `1/h²`, or zero in statics.
    pub kappa: R,
    /// Gravity in statics, or zero.
    pub pull: V3<R>,
}

/// The quadratic model of a cell's inertia or weight, of one cell or of several side by side.
#[derive(Debug, Clone, Copy)]
pub struct Model<T> {
    /// Gradient by the segment's twist.
    pub x: Six<T>,
    /// Gradient by `c_j`, `c_{j+1}`.
    pub c: [T; 2],
    /// Hessian by turn and turn: `xx`, `yy`, `zz`, `xy`, `xz`, `yz`.
    pub turn: [T; 6],
    /// Hessian by turn and shift: `[lever]×`. That by shift and shift is the cell's mass by `κ`.
    pub lever: V3<T>,
    /// Hessian by twist and `c_j`, `c_{j+1}`.
    pub xc: [Six<T>; 2],
    /// Hessian by `c_j c_j`, `c_j c_{j+1}`, `c_{j+1} c_{j+1}`.
    pub cc: [T; 3],
}

/// What a cell's energy is made from.
#[derive(Debug, Clone, Copy)]
pub struct Cell<'a, R> {
    /// Its direction.
    pub t: V3<R>,
    /// Vertices.
    pub x: Four<V3<R>>,
    /// What they aim at.
    pub want: Four<&'a Sample<R>>,
    /// `c_{j+1} - c_j`.
    pub spread: R,
}

impl<'a, R: Num> Cell<'a, R> {
    /// Between two creases.
    pub fn between(
        t: V3<R>,
        [x0, x1]: [&Pair<R>; 2],
        [w0, w1]: [&'a [Sample<R>; 2]; 2],
        spread: R,
    ) -> Self {
        let ([a, b], [c, d]) = (*x0, *x1);
        Self { t, x: [a, b, c, d], want: [&w0[0], &w0[1], &w1[0], &w1[1]], spread }
    }
    #[inline(always)]
    fn gaps(&self) -> Four<V3<R>> {
        let (x, y) = (&self.x, &self.want);
        [x[0] - y[0].y, x[1] - y[1].y, x[2] - y[2].y, x[3] - y[3].y]
    }
}

impl<R: Real> Cell<'_, R> {
    /// The energy.
    #[inline]
    pub fn energy(&self, mass: &CellMass<R>, motion: &Motion<R>) -> R {
        let mut energy = R::ZERO;
        if motion.kappa > R::ZERO {
            let d = self.gaps();
            energy = motion.kappa * R::of(0.5) * inner(&d, &mass.times(self.spread, &d));
        } else {
            let m = mass.times(self.spread, &self.x);
            energy -= motion.pull.dot(m[0] + m[1] + m[2] + m[3]);
        }
        energy
    }
}

#[inline(always)]
fn inner<T: Num>(x: &Four<V3<T>>, y: &Four<V3<T>>) -> T {
    (x[0].dot(y[0]) + x[1].dot(y[1])) + (x[2].dot(y[2]) + x[3].dot(y[3]))
}

#[inline(always)]
fn total<T: Num>(x: &Four<V3<T>>) -> V3<T> {
    (x[0] + x[1]) + (x[2] + x[3])
}

impl<T: Num> CellMass<T> {
    /// `M x`.
    #[inline(always)]
    pub fn times(&self, spread: T, x: &Four<V3<T>>) -> Four<V3<T>> {
        let (grow, e, m) = (self.grow * spread, self.cross, self.along);
        let (a, b) = (self.even - grow, self.even + grow);
        let (p, q) = (x[0] * a + x[1] * e, x[0] * e + x[1] * b);
        let (r, s) = (x[2] * a + x[3] * e, x[2] * e + x[3] * b);
        [p + r * m, q + s * m, r + p * m, s + q * m]
    }
    /// `M` times vectors at one crease alone, there; at the other it is [`CellMass::along`] times that.
    #[inline(always)]
    fn times_pair(&self, spread: T, [x, y]: Pair<T>) -> Pair<T> {
        let (grow, e) = (self.grow * spread, self.cross);
        [x * (self.even - grow) + y * e, x * e + y * (self.even + grow)]
    }
    /// `dM/dΔc x`.
    #[inline(always)]
    pub fn grown(&self, x: &Four<V3<T>>) -> Four<V3<T>> {
        let (g, m) = (self.grow, self.along);
        let along = |x: V3<T>, y: V3<T>, g: T| (x + y * m) * g;
        [along(x[0], x[2], -g), along(x[1], x[3], g), along(x[2], x[0], -g), along(x[3], x[1], g)]
    }
}

/// What all cells share: in every lane the same.
#[derive(Debug, Clone, Copy)]
pub struct Common<T> {
    /// The mass matrix times `κ`.
    mass: CellMass<T>,
    half: T,
    /// In statics, weight at a vertex of a rectangle, and how it grows with `Δc` on rim B and shrinks on rim A.
    weight: V3<T>,
    grow: V3<T>,
    /// Share that is counted of what forces gain by turning.
    turns: T,
    moving: bool,
}

impl<T: Num> Common<T> {
    /// Of a strip in motion, a model that is so rough, `all` being what puts a number into all lanes.
    pub fn of<R: Real>(strip: &Strip<R>, motion: &Motion<R>, rough: R, all: fn(R) -> T) -> Self {
        let (m, kappa) = (&strip.mass, motion.kappa);
        let [even, cross, grow] = [m.even, m.cross, m.grow].map(|m| all(m * kappa));
        let weight = motion.pull * ((m.even + m.cross) * (R::one() + m.along));
        let slope = motion.pull * (m.grow * (R::one() + m.along));
        let v3 = |v: V3<R>| V3(v.0.map(all));
        Self {
            mass: CellMass { even, cross, along: all(m.along), grow },
            half: all(strip.half),
            weight: v3(weight),
            grow: v3(slope),
            turns: all(R::one() - rough),
            moving: kappa > R::ZERO,
        }
    }
    /// Forces at the vertices, and how they change with `Δc`; then the energy's own change with it.
    #[inline(always)]
    fn forces(&self, cell: &Cell<'_, T>) -> (Four<V3<T>>, Four<V3<T>>, T) {
        let spread = cell.spread;
        if self.moving {
            let d = cell.gaps();
            let grown = self.mass.grown(&d);
            let swell = T::of(0.5) * inner(&grown, &d);
            return (self.mass.times(spread, &d), grown, swell);
        }
        let (more, slope) = (self.grow * spread, self.grow);
        let (a, b) = (more - self.weight, -(more + self.weight));
        let grown = [slope, -slope, slope, -slope];
        ([a, b, a, b], grown, inner(&grown, &cell.x))
    }
    /// The model of a cell's inertia or weight. As far as it is rough, forces do not turn.
    ///
    /// # Cost
    ///
    /// Some 600 operations, of so many cells as there are lanes.
    #[inline(always)]
    pub fn model(&self, cell: &Cell<'_, T>) -> Model<T> {
        let (g, grown, swell) = self.forces(cell);
        let slide = self.slides(cell);
        let by = |i: usize| g[i].dot(slide[i]) + g[i + 1].dot(slide[i + 1]);
        let c = [by(0) - swell, by(2) + swell];
        let x = wrench(&cell.x, &g);
        let (turn, lever) = self.turning(cell, &g, &x);
        let (xc, cc) = self.sliding(cell, &g, &grown, &slide);
        Model { x, c, turn, lever, xc, cc }
    }

    /// `σ (t - Y')`.
    #[inline(always)]
    fn slides(&self, cell: &Cell<'_, T>) -> Four<V3<T>> {
        let (t, h, w) = (cell.t, self.half, &cell.want);
        [(w[0].dy - t) * h, (t - w[1].dy) * h, (w[2].dy - t) * h, (t - w[3].dy) * h]
    }

    /// By turn and turn `κ (tr S I - S) + sym N - tr N I`, by turn and shift `[κ M x - G/2]×`, with `S = Σ x (Mx)ᵀ`,
    /// `N = Σ x gᵀ`, `G = Σ g`.
    #[inline(always)]
    fn turning(&self, cell: &Cell<'_, T>, g: &Four<V3<T>>, wrench: &Six<T>) -> ([T; 6], V3<T>) {
        let mx = self.mass.times(cell.spread, &cell.x);
        // Forces less inertia, vertex by vertex.
        let less = |i: usize| g[i] * self.turns - mx[i];
        let f = [less(0), less(1), less(2), less(3)];
        let [.., p, q, r] = *wrench;
        let lever = total(&mx) - V3([p, q, r]) * (self.turns * T::of(0.5));
        (turned(virial(&cell.x, &f)), lever)
    }

    /// What sliding rulings add: by twist and slope, by slope and slope.
    #[inline(always)]
    fn sliding(
        &self,
        cell: &Cell<'_, T>,
        g: &Four<V3<T>>,
        grown: &Four<V3<T>>,
        slide: &Four<V3<T>>,
    ) -> ([Six<T>; 2], [T; 3]) {
        let (x, turns, two) = (&cell.x, self.turns, T::of(2.0));
        let (m, half) = (self.mass.along, self.half * turns);
        let swollen = wrench(x, grown).map(|w| w * turns);
        // A crease's slides are forces there, and a share of them at the other crease.
        let couple = |[p, q]: Pair<T>, near: usize, far: usize| {
            let (a, b) = (x[near] + x[far] * m, x[near + 1] + x[far + 1] * m);
            let slid = cell.t.cross((g[near + 1] - g[near]) * half);
            six(a.cross(p) + b.cross(q) + slid, (p + q) * (T::one() + m))
        };
        let first = self.mass.times_pair(cell.spread, [slide[0], slide[1]]);
        let second = self.mass.times_pair(cell.spread, [slide[2], slide[3]]);
        let (near, far) = (couple(first, 0, 2), couple(second, 2, 0));
        let xc = [lane6(&near, &swollen, |a, b| a - b), lane6(&far, &swollen, |a, b| a + b)];
        let (sq, want) = (half * self.half, &cell.want);
        let bend = |i: usize| (g[i].dot(want[i].ddy) + g[i + 1].dot(want[i + 1].ddy)) * sq;
        let by = |f: &[V3<T>], i: usize| slide[i].dot(f[0]) + slide[i + 1].dot(f[1]);
        let swell = |i: usize| by(&[grown[i], grown[i + 1]], i) * turns;
        let (inner, outer) = (swell(0), swell(2));
        let cc = [
            by(&first, 0) - bend(0) - two * inner,
            by(&first, 2) * m + inner - outer,
            by(&second, 2) - bend(2) + two * outer,
        ];
        (xc, cc)
    }
}

/// Number by number.
#[inline(always)]
fn lane6<T: Num>(a: &Six<T>, b: &Six<T>, f: impl Fn(T, T) -> T) -> Six<T> {
    core::array::from_fn(|i| f(a[i], b[i]))
}

/// Torque and force of four forces.
#[inline(always)]
pub(super) fn wrench<T: Num>(x: &Four<V3<T>>, f: &Four<V3<T>>) -> Six<T> {
    let torque = (x[0].cross(f[0]) + x[1].cross(f[1])) + (x[2].cross(f[2]) + x[3].cross(f[3]));
    six(torque, total(f))
}

/// `sym Σ x fᵀ` as `xx`, `yy`, `zz`, `xy`, `xz`, `yz`.
#[inline(always)]
pub(super) fn virial<T: Num>(x: &Four<V3<T>>, f: &Four<V3<T>>) -> [T; 6] {
    let entry = |r: usize, c: usize| {
        let part = |x: &V3<T>, f: &V3<T>| x.0[r] * f.0[c];
        (part(&x[0], &f[0]) + part(&x[1], &f[1])) + (part(&x[2], &f[2]) + part(&x[3], &f[3]))
    };
    let mixed = |r: usize, c: usize| (entry(r, c) + entry(c, r)) * T::of(0.5);
    [entry(0, 0), entry(1, 1), entry(2, 2), mixed(0, 1), mixed(0, 2), mixed(1, 2)]
}

/// What turns: `N - tr N` of `N = sym Σ x fᵀ`.
#[inline(always)]
pub(super) fn turned<T: Num>([xx, yy, zz, xy, xz, yz]: [T; 6]) -> [T; 6] {
    [-(yy + zz), -(xx + zz), -(xx + yy), xy, xz, yz]
}
