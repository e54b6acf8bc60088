//! A ribbon's unknowns as the seed counts them, and its objective in them.
//!
//! ```text
//! x = (ψ_first .. ψ_{n-1},  Δ_0 .. Δ_{n-2},  w, t where the start is free)      c_j = Δ_0 + .. + Δ_{j-1}
//! ```
//!
//! Bounds hold every `Δ` (Ribbon Eq. 1); that the last slope can come back to zero, `|c_{n-1}| ≤ limit`, is left to the
//! augmented Lagrangian (Ribbon Sec. 5.1). The objective is counted in units of `D w / 2 l`, so that its size says
//! something to a method that compares it with one.

use super::lbfgsb::{Bounds, Objective};
use dogleaf_core::effect::ribbon::body::Body;
use dogleaf_core::effect::ribbon::frame::{Frame, halves};
use dogleaf_core::effect::ribbon::load::Ask;
use dogleaf_core::effect::ribbon::{Loads, Ribbon};
use dogleaf_core::real::V3;

/// A ribbon's objective, and the augmented Lagrangian of the two rows that are no bounds.
#[derive(Debug)]
pub struct Unknowns<'a, L, const N: usize> {
    body: &'a mut Body<f64, N>,
    ask: Ask<f64>,
    loads: &'a L,
    /// The first crease with an angle.
    first: usize,
    /// Gradient by angles and slopes.
    psi: Vec<f64>,
    slope: Vec<f64>,
    /// Joules of one.
    unit: f64,
    /// Multipliers of `limit ∓ c_{n-1} ≥ 0`; not positive.
    pub lambda: [f64; 2],
    /// Penalty of those rows.
    pub penalty: f64,
    /// The objective at the last evaluation, joules, without the Lagrangian.
    pub objective: f64,
}

/// Sets a ribbon's body out for a step as the core does, for a solver that is not the core's: `Y = X + h V + h² g`.
pub fn set_out<const N: usize>(ribbon: &mut Ribbon<f64, N>, h: f64) {
    let keep = (-ribbon.spec().damping_per_s * h).exp();
    let fall = V3(ribbon.gravity.map(|g| g * h * h));
    let body = ribbon.body();
    body.place(0.0);
    body.reconstruct();
    let aims: Vec<_> = body
        .used()
        .iter()
        .map(|s| (s.crease.c, [0, 1].map(|rim| s.pair[rim] + s.velocity[rim] * (h * keep) + fall)))
        .collect();
    let end = [0, 1].map(|rim| body.end.pair[rim] + body.end.velocity[rim] * (h * keep) + fall);
    body.table.fill(&body.strip, aims.into_iter(), end);
    body.motion.kappa = 1.0 / (h * h);
    body.motion.pull = V3([0.0; 3]);
    body.mu = 0.0;
}

impl<'a, L: Loads<f64>, const N: usize> Unknowns<'a, L, N> {
    /// Of a body that was set out, from its accepted creases.
    pub fn new(body: &'a mut Body<f64, N>, ask: Ask<f64>, loads: &'a L) -> Self {
        body.part_rulings();
        body.mu = 0.0;
        let first = usize::from(body.strip.hinge == 0.0);
        let unit = body.strip.stiff / body.strip.n as f64;
        let (psi, slope) = (vec![0.0; body.strip.n], vec![0.0; body.strip.n]);
        let (lambda, penalty, objective) = ([0.0; 2], 1e3, 0.0);
        Self { body, ask, loads, first, psi, slope, unit, lambda, penalty, objective }
    }

    /// The unknowns at the start of the solve, and their bounds.
    pub fn start(&self) -> (Vec<f64>, Bounds) {
        let (used, limit) = (self.body.used(), self.body.strip.limit);
        let slopes = used.windows(2).map(|s| s[1].kept.c - s[0].kept.c);
        let base = if self.body.strip.free { 6 } else { 0 };
        let angles = used[self.first..].iter().map(|s| s.kept.psi);
        let x: Vec<f64> = angles.chain(slopes).chain(vec![0.0; base]).collect();
        let (n, wide) = (used.len(), f64::INFINITY);
        let is_slope = |i: usize| (n - self.first..2 * n - 1 - self.first).contains(&i);
        let high: Vec<f64> = (0..x.len()).map(|i| if is_slope(i) { limit } else { wide }).collect();
        (x, Bounds { low: high.iter().map(|h| -h).collect(), high })
    }

    /// Values of the rows: not negative where they hold.
    pub fn rows(&self) -> [f64; 2] {
        let (limit, c) =
            (self.body.strip.limit, self.body.used().last().map_or(0.0, |s| s.crease.c));
        [(limit - c) / limit, (limit + c) / limit]
    }

    /// Moves the multipliers (Ribbon Alg. 2).
    pub fn update(&mut self) {
        let rows = self.rows();
        self.lambda = [0, 1].map(|i| (self.lambda[i] + self.penalty * rows[i]).min(0.0));
    }

    /// Puts the unknowns into the body; answers the way the start's own rotation acts.
    fn place(&mut self, x: &[f64]) -> [V3<f64>; 2] {
        let (n, first) = (self.body.strip.n, self.first);
        let mut c = 0.0;
        for (j, s) in self.body.used_mut().iter_mut().enumerate() {
            s.crease.psi = if j < first { 0.0 } else { x[j - first] };
            if j > 0 {
                c += x[n - first + j - 1];
            }
            s.crease.c = c;
        }
        let Some(six) = x.get(2 * n - 1 - first..).filter(|six| six.len() == 6) else {
            self.body.base = self.body.kept_base;
            return [V3([0.0; 3]); 2];
        };
        let [w, t] = [V3([six[0], six[1], six[2]]), V3([six[3], six[4], six[5]])];
        let kept = self.body.kept_base;
        // About the start's own place, then shifted.
        let here =
            Frame { p: V3([0.0; 3]), ..kept }.moved(&[six[0], six[1], six[2], 0.0, 0.0, 0.0]);
        self.body.base = Frame { p: kept.p + t, ..here };
        [w, t]
    }

    fn joint(&self) -> f64 {
        if self.body.looped() { self.body.hold.energy(&self.body.gap) } else { 0.0 }
    }
}

impl<L: Loads<f64>, const N: usize> Objective for Unknowns<'_, L, N> {
    fn evaluate(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
        let (n, first) = (self.body.strip.n, self.first);
        let [w, _] = self.place(x);
        self.objective = self.body.evaluate(&self.ask, self.loads).objective;
        let Self { body, ask, loads, psi, slope, .. } = self;
        let start = super::gradient::gradient(body, ask, *loads, psi, slope);
        let (rows, limit) = (self.rows(), self.body.strip.limit);
        let force = [0, 1].map(|i| (self.lambda[i] + self.penalty * rows[i]).min(0.0));
        let lagrangian: f64 = (0..2)
            .map(|i| (force[i] * force[i] - self.lambda[i] * self.lambda[i]) / (2.0 * self.penalty))
            .sum();
        let unit = 1.0 / self.unit;
        gradient[..n - first].iter_mut().zip(&self.psi[first..]).for_each(|(g, p)| *g = p * unit);
        // A difference moves every slope beyond it.
        let mut beyond = (force[1] - force[0]) / limit;
        for j in (1..n).rev() {
            beyond += self.slope[j] * unit;
            gradient[n - first + j - 1] = beyond;
        }
        if gradient.len() > 2 * n - 1 - first {
            let [torque, shift] = halves(&start);
            let turn = pulled_back(w, torque - self.body.base.p.cross(shift));
            let six = turn.0.into_iter().chain(shift.0);
            gradient[2 * n - 1 - first..].iter_mut().zip(six).for_each(|(g, s)| *g = s * unit);
        }
        (self.objective + self.joint()) * unit + lagrangian
    }
}

/// `J_l(w)ᵀ τ`, what a torque does to a rotation vector.
fn pulled_back(w: V3<f64>, torque: V3<f64>) -> V3<f64> {
    let sq = w.norm_sq();
    let (b, c) = if sq < 1e-6 {
        (0.5 - sq / 24.0, 1.0 / 6.0 - sq / 120.0)
    } else {
        let angle = sq.sqrt();
        ((1.0 - angle.cos()) / sq, (angle - angle.sin()) / (sq * angle))
    };
    let once = w.cross(torque);
    torque - once * b + w.cross(once) * c
}
