//! The loop: six rows that join the end to the start, and their augmented Lagrangian.
//!
//! ```text
//! r = (log(Q_B Q_Cᵀ), p_B - p_C)      φ = λ·r + ρ_w/2 |r_w|² + ρ_p/2 |r_p|²
//! ```
//!
//! B is the last segment's frame carried on to its end, C the start's, for a Möbius band turned half a turn about its
//! tangent. The logarithm vanishes at closure alone, unlike differences of normals, which vanish at the antipode too.
//!
//! Source: Ribbon Sec. 5.1, with six independent rows for its nine. Checked by `tests/ribbon_derivatives.rs`.

use super::frame::{Frame, Six, halves, log_slope, six};
use crate::real::{Real, V3};

/// Multiplier and penalties of a loop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hold<R> {
    /// Multipliers of the rotation's rows, then of the position's.
    pub lambda: Six<R>,
    /// Penalty of the rotation.
    pub turn: R,
    /// Penalty of the position.
    pub shift: R,
}

/// The joint's state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap<R> {
    /// Rotation vector from the start's frame to the end's.
    pub turn: V3<R>,
    /// From the start's place to the end's.
    pub shift: V3<R>,
    /// The end's place.
    pub end: V3<R>,
    /// The start's place.
    pub start: V3<R>,
}

impl<R: Real> Hold<R> {
    /// Nothing held.
    pub const NONE: Self = Self { lambda: [R::ZERO; 6], turn: R::ZERO, shift: R::ZERO };

    /// `λ + ρ r`: torque and force at the joint.
    pub fn force(&self, gap: &Gap<R>) -> [V3<R>; 2] {
        let [turn, shift] = halves(&self.lambda);
        [turn + gap.turn * self.turn, shift + gap.shift * self.shift]
    }
    /// The augmented Lagrangian's value.
    pub fn energy(&self, gap: &Gap<R>) -> R {
        let [turn, shift] = halves(&self.lambda);
        let half = R::of(0.5);
        let square = self.turn * gap.turn.norm_sq() + self.shift * gap.shift.norm_sq();
        turn.dot(gap.turn) + shift.dot(gap.shift) + half * square
    }
    /// Its gradient by the end's twist and by the start's.
    pub fn gradient(&self, gap: &Gap<R>) -> [Six<R>; 2] {
        let [torque, force] = self.force(gap);
        let at =
            |p: V3<R>, transposed: bool| log_slope(gap.turn, torque, transposed) + p.cross(force);
        [six(at(gap.end, true), force), six(-at(gap.start, false), -force)]
    }
    /// Its Gauss-Newton Hessian by the difference of the two twists.
    pub fn hessian(&self, gap: &Gap<R>) -> [Six<R>; 6] {
        let p = (gap.start + gap.end) * R::of(0.5);
        let (k, [x, y, z], o) = (self.shift, p.0, R::ZERO);
        let (turn, [a, b, c]) = (self.turn, [x * k, y * k, z * k]);
        [
            [turn + y * b + z * c, -x * b, -x * c, o, -c, b],
            [-x * b, turn + x * a + z * c, -y * c, c, o, -a],
            [-x * c, -y * c, turn + x * a + y * b, -b, a, o],
            [o, c, -b, k, o, o],
            [-c, o, a, o, k, o],
            [b, -a, o, o, o, k],
        ]
    }
    /// Drops multipliers that no loop of such stiffness and length comes to by itself: a solve that failed has left them.
    pub fn forget(&mut self, most: R, length: R) {
        let [turn, shift] = halves(&self.lambda);
        let sane = turn.norm() <= most && shift.norm() * length <= most * R::of(40.0);
        if !sane {
            self.lambda = [R::ZERO; 6];
        }
    }
    /// First-order multiplier update.
    pub fn update(&mut self, gap: &Gap<R>) {
        let [turn, shift] = self.force(gap);
        self.lambda = six(turn, shift);
    }
}

impl<R: Real> Gap<R> {
    /// Between the end's frame and the start's, which is to be met turned about its tangent by an angle given by its
    /// sine and cosine.
    pub fn between(end: &Frame<R>, start: &Frame<R>, [sin, cos]: [R; 2]) -> Self {
        let (b, n) = (start.b * cos + start.n * sin, start.n * cos - start.b * sin);
        let [turn, shift] = end.apart(&Frame { b, n, ..*start });
        Self { turn, shift, end: end.p, start: start.p }
    }
    /// The larger of the angle, in radians, and the distance as a share of `length`.
    pub fn size(&self, length: R) -> R {
        self.turn.norm().larger(self.shift.norm() / length)
    }
}
