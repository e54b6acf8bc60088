//! Kinetic energy of a cell with its moving mass matrix: value, gradient, Hessian in (twist, c_j, c_{j+1}).
//!
//! ```text
//! F = κ/2 Σ M_ab(Δc) d_a·d_b - Σ M_ab(Δc) pull·x_a      d_a = x_a - Y_a(s_a)      κ = 1/h²
//! ```
//!
//! A vertex moves by `δx = ω×x + v + σ t δc`, with `σ = -w/2` on rim A and `+w/2` on rim B, and `s` by `σ δc`; so
//! `δd = ω×x + v + σ (t - Y') δc`. Dynamics have `κ` and gravity inside `Y`; statics have `κ = 0` and `pull = g`.
//!
//! Source: Ribbon Sec. 4, App. B; gradient as App. C collapses to. Checked by `tests/ribbon_derivatives.rs`.

use super::frame::{Frame, Six, six};
use super::resample::{Pair, Sample};
use super::strip::{CellMass, Strip};
use crate::real::{Real, V3};

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

/// The quadratic model of one cell.
#[derive(Debug, Clone, Copy)]
pub struct Model<R> {
    /// Gradient by the segment's twist.
    pub x: Six<R>,
    /// Gradient by `c_j`, `c_{j+1}`.
    pub c: [R; 2],
    /// Hessian by the twist.
    pub xx: [Six<R>; 6],
    /// Hessian by twist and `c_j`, `c_{j+1}`.
    pub xc: [Six<R>; 2],
    /// Hessian by `c_j c_j`, `c_j c_{j+1}`, `c_{j+1} c_{j+1}`.
    pub cc: [R; 3],
}

/// What a cell's energy is made from.
#[derive(Debug, Clone, Copy)]
pub struct Cell<'a, R> {
    /// Its frame.
    pub frame: &'a Frame<R>,
    /// Vertices.
    pub x: Four<V3<R>>,
    /// What they aim at.
    pub want: Four<&'a Sample<R>>,
    /// `c_{j+1} - c_j`.
    pub spread: R,
}

impl<'a, R: Real> Cell<'a, R> {
    /// Between two creases.
    pub fn between(
        frame: &'a Frame<R>,
        [x0, x1]: [&Pair<R>; 2],
        [w0, w1]: [&'a [Sample<R>; 2]; 2],
        spread: R,
    ) -> Self {
        let ([a, b], [c, d]) = (*x0, *x1);
        Self { frame, x: [a, b, c, d], want: [&w0[0], &w0[1], &w1[0], &w1[1]], spread }
    }
    fn gaps(&self) -> Four<V3<R>> {
        let (x, y) = (&self.x, &self.want);
        [x[0] - y[0].y, x[1] - y[1].y, x[2] - y[2].y, x[3] - y[3].y]
    }
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

fn inner<R: Real>(x: &Four<V3<R>>, y: &Four<V3<R>>) -> R {
    (x[0].dot(y[0]) + x[1].dot(y[1])) + (x[2].dot(y[2]) + x[3].dot(y[3]))
}

fn total<R: Real>(x: &Four<V3<R>>) -> V3<R> {
    (x[0] + x[1]) + (x[2] + x[3])
}

impl<R: Real> CellMass<R> {
    /// `M x`.
    #[inline(always)]
    pub fn times(&self, spread: R, x: &Four<V3<R>>) -> Four<V3<R>> {
        let (grow, e, m) = (self.grow * spread, self.cross, self.along);
        let (a, b) = (self.even - grow, self.even + grow);
        let (p, q) = (x[0] * a + x[1] * e, x[0] * e + x[1] * b);
        let (r, s) = (x[2] * a + x[3] * e, x[2] * e + x[3] * b);
        [p + r * m, q + s * m, r + p * m, s + q * m]
    }
    /// `M` times vectors at one crease alone: at that crease, then at the other.
    #[inline(always)]
    fn times_pair(&self, spread: R, x: V3<R>, y: V3<R>) -> [Pair<R>; 2] {
        let (grow, e, m) = (self.grow * spread, self.cross, self.along);
        let p = x * (self.even - grow) + y * e;
        let q = x * e + y * (self.even + grow);
        [[p, q], [p * m, q * m]]
    }
    /// `dM/dΔc x`.
    #[inline(always)]
    pub fn grown(&self, x: &Four<V3<R>>) -> Four<V3<R>> {
        let (g, m) = (self.grow, self.along);
        let along = |x: V3<R>, y: V3<R>, g: R| (x + y * m) * g;
        [along(x[0], x[2], -g), along(x[1], x[3], g), along(x[2], x[0], -g), along(x[3], x[1], g)]
    }
    /// Row sums of `M`, A then B; the same for both creases.
    fn shares(&self, spread: R) -> [R; 2] {
        let (even, one) = (self.even + self.cross, R::one() + self.along);
        [(even - self.grow * spread) * one, (even + self.grow * spread) * one]
    }
}

/// The model of a cell's inertia (or weight), of other forces on its vertices, and of a pull `lean` at its normal. As far
/// as it is `rough`, forces do not turn and normals are pulled as if they were where they are pulled to.
#[inline(always)]
pub fn model<R: Real>(
    strip: &Strip<R>,
    motion: &Motion<R>,
    cell: &Cell<'_, R>,
    others: &[Pair<R>; 2],
    lean: V3<R>,
    rough: R,
) -> Model<R> {
    let (mass, spread, kappa) = (&strip.mass, cell.spread, motion.kappa);
    let d = cell.gaps();
    let [share_a, share_b] = mass.shares(spread).map(|s| motion.pull * s);
    let mut g = mass.times(spread, &d).map(|v| v * kappa);
    let mut grown = mass.grown(&d).map(|v| v * kappa);
    let moving = kappa > R::ZERO;
    if !moving {
        g = [-share_a, -share_b, -share_a, -share_b];
        let slope = motion.pull * (mass.grow * (R::one() + mass.along));
        grown = [slope, -slope, slope, -slope];
    }
    // The energy's own change with Δc, at fixed vertices.
    let swell = if moving { R::of(0.5) * inner(&grown, &d) } else { inner(&grown, &cell.x) };
    let [[a0, b0], [a1, b1]] = *others;
    let all = [g[0] + a0, g[1] + b0, g[2] + a1, g[3] + b1];
    let slide = slides(strip, cell);
    let mx = mass.times(spread, &cell.x).map(|v| v * kappa);
    let (torque, turn) = (cell.frame.n.cross(lean), R::one() - rough);
    let turned = |f: &Four<V3<R>>| f.map(|f| f * turn);
    let lean = lean * turn - cell.frame.n * (lean.norm() * rough);
    let second = (turned(&g), turned(&all), turned(&grown), lean);
    let mut model = Model {
        x: wrench(&cell.x, &all),
        c: [
            g[0].dot(slide[0]) + g[1].dot(slide[1]) - swell
                + cell.frame.t.dot(b0 - a0) * strip.half,
            g[2].dot(slide[2])
                + g[3].dot(slide[3])
                + swell
                + cell.frame.t.dot(b1 - a1) * strip.half,
        ],
        xx: turning(cell, &mx, &second.1, second.3, kappa * strip.cell_mass()),
        xc: [[R::ZERO; 6]; 2],
        cc: [R::ZERO; 3],
    };
    for (x, t) in model.x.iter_mut().zip(torque.0) {
        *x += t;
    }
    sliding(strip, cell, &mut model, [&second.0, &second.1], &second.2, &slide, kappa);
    model
}

/// `σ (t - Y')`.
fn slides<R: Real>(strip: &Strip<R>, cell: &Cell<'_, R>) -> Four<V3<R>> {
    let (t, h, w) = (cell.frame.t, strip.half, &cell.want);
    [(w[0].dy - t) * h, (t - w[1].dy) * h, (w[2].dy - t) * h, (t - w[3].dy) * h]
}

/// Torque and force of four forces.
#[inline(always)]
fn wrench<R: Real>(x: &Four<V3<R>>, f: &Four<V3<R>>) -> Six<R> {
    let torque = (x[0].cross(f[0]) + x[1].cross(f[1])) + (x[2].cross(f[2]) + x[3].cross(f[3]));
    six(torque, total(f))
}

/// Twist by twist: `κ (tr S I - S) + sym N - tr N I`, `[κ M x - G/2]×`, `κ m I`, with `S = Σ x (Mx)ᵀ`, `N = Σ x gᵀ`.
#[inline(always)]
fn turning<R: Real>(
    cell: &Cell<'_, R>,
    mx: &Four<V3<R>>,
    g: &Four<V3<R>>,
    lean: V3<R>,
    mass: R,
) -> [Six<R>; 6] {
    let half = R::of(0.5);
    // sym N - S, whose trace decides the rest: forces less inertia, vertex by vertex.
    let f = [g[0] - mx[0], g[1] - mx[1], g[2] - mx[2], g[3] - mx[3]];
    let n = cell.frame.n;
    let entry = |r: usize, c: usize| {
        let part = |x: &V3<R>, f: &V3<R>| x.0[r] * f.0[c] + x.0[c] * f.0[r];
        let sum = (part(&cell.x[0], &f[0]) + part(&cell.x[1], &f[1]))
            + (part(&cell.x[2], &f[2]) + part(&cell.x[3], &f[3]));
        (sum + part(&n, &lean)) * half
    };
    let [xx, yy, zz] = [entry(0, 0), entry(1, 1), entry(2, 2)];
    let [xy, xz, yz] = [entry(0, 1), entry(0, 2), entry(1, 2)];
    let [a, b, c] = (total(mx) - total(g) * half).0;
    let o = R::ZERO;
    [
        [-(yy + zz), xy, xz, o, -c, b],
        [xy, -(xx + zz), yz, c, o, -a],
        [xz, yz, -(xx + yy), -b, a, o],
        [o, c, -b, mass, o, o],
        [-c, o, a, o, mass, o],
        [b, -a, o, o, o, mass],
    ]
}

/// What sliding rulings add.
#[inline(always)]
fn sliding<R: Real>(
    strip: &Strip<R>,
    cell: &Cell<'_, R>,
    model: &mut Model<R>,
    [g, all]: [&Four<V3<R>>; 2],
    grown: &Four<V3<R>>,
    slide: &Four<V3<R>>,
    kappa: R,
) {
    let (t, h) = (cell.frame.t, strip.half);
    let mass = |a: V3<R>, b: V3<R>| strip.mass.times_pair(cell.spread, a * kappa, b * kappa);
    let ([[a, b], [c, d]], [[e, f], [g2, h2]]) =
        (mass(slide[0], slide[1]), mass(slide[2], slide[3]));
    let (first, second) = ([a, b, c, d], [g2, h2, e, f]);
    let couple = |m: &Four<V3<R>>, f: &Four<V3<R>>, a: V3<R>, b: V3<R>| {
        let sum = [m[0] + f[0], m[1] + f[1], m[2] + f[2], m[3] + f[3]];
        let [x, y, z, p, q, r] = wrench(&cell.x, &sum);
        let [u, v, w] = (t.cross((b - a) * h)).0;
        [x + u, y + v, z + w, p, q, r]
    };
    let less = grown.map(|v| -v);
    model.xc = [couple(&first, &less, all[0], all[1]), couple(&second, grown, all[2], all[3])];
    let sq = h * h;
    let bend = |i: usize, k: usize| -(g[i].dot(cell.want[i].ddy) + g[k].dot(cell.want[k].ddy)) * sq;
    let swell = |i: usize, k: usize| slide[i].dot(grown[i]) + slide[k].dot(grown[k]);
    let two = R::of(2.0);
    model.cc = [
        slide[0].dot(first[0]) + slide[1].dot(first[1]) + bend(0, 1) - two * swell(0, 1),
        slide[2].dot(first[2]) + slide[3].dot(first[3]) + swell(0, 1) - swell(2, 3),
        slide[2].dot(second[2]) + slide[3].dot(second[3]) + bend(2, 3) + two * swell(2, 3),
    ];
}
