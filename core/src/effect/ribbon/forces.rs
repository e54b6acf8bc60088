//! What other forces on a cell's vertices, and a pull at its normal, add to its model: pulls, guides, contact.
//!
//! Most cells of most ribbons have none, so these stand apart from inertia, which all have.
//!
//! Checked by `tests/ribbon_derivatives.rs`, `tests/ribbon_contact.rs`.

use super::contact::touch::{Touch, forces, stiffen};
use super::frame::{Frame, Six, halves};
use super::inertia::{Four, turned, virial, wrench};
use super::resample::Pair;
use super::strip::Strip;
use crate::real::{Real, V3};

/// A quadratic model of one cell.
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

/// Everything that pulls or pushes at a cell, but inertia and weight.
#[derive(Debug, Clone, Copy)]
pub struct Pushed<R> {
    /// Vertices.
    pub x: Four<V3<R>>,
    /// What pulls at them, as gradients.
    pub pulls: [Pair<R>; 2],
    /// What pulls at its normal.
    pub lean: V3<R>,
    /// How rough the model is: so far forces do not turn and normals are pulled as if they were where they are pulled to.
    pub rough: R,
}

impl<R: Real> Pushed<R> {
    /// The model of all of it, with what pushes at the segment.
    pub fn model<T: Touch<R>>(
        mut self,
        strip: &Strip<R>,
        frame: &Frame<R>,
        (touch, segment): (&T, usize),
    ) -> Model<R> {
        if !T::ACTIVE {
            return self.alone(strip, frame);
        }
        for (pair, force) in self.pulls.iter_mut().zip(forces(touch, segment)) {
            for (s, f) in pair.iter_mut().zip(force) {
                *s = *s + f;
            }
        }
        let mut model = self.alone(strip, frame);
        stiffen(touch, segment, &self.x, strip, frame.t, &mut model);
        model
    }

    fn alone(&self, strip: &Strip<R>, frame: &Frame<R>) -> Model<R> {
        let [[a0, b0], [a1, b1]] = self.pulls;
        let (all, turn, o) = ([a0, b0, a1, b1], R::one() - self.rough, R::ZERO);
        let (t, n, half) = (frame.t, frame.n, strip.half);
        let (torque, mut x) = (n.cross(self.lean), wrench(&self.x, &all));
        x.iter_mut().zip(torque.0).for_each(|(x, t)| *x += t);
        let lean = self.lean * turn - n * (self.lean.norm() * self.rough);
        let (mut sum, normal) = (virial(&self.x, &all.map(|f| f * turn)), [n, n, n, n]);
        let none = V3([o; 3]);
        for (s, v) in sum.iter_mut().zip(virial(&normal, &[lean, none, none, none])) {
            *s += v;
        }
        let [_, force] = halves(&x);
        let [xx, yy, zz, xy, xz, yz] = turned(sum);
        let [a, b, c] = (force * (turn * R::of(-0.5))).0;
        let slide = |d: V3<R>| {
            let [u, v, w] = t.cross(d * (half * turn)).0;
            [u, v, w, o, o, o]
        };
        Model {
            x,
            c: [t.dot(b0 - a0) * half, t.dot(b1 - a1) * half],
            xx: [
                [xx, xy, xz, o, -c, b],
                [xy, yy, yz, c, o, -a],
                [xz, yz, zz, -b, a, o],
                [o, c, -b, o, o, o],
                [-c, o, a, o, o, o],
                [b, -a, o, o, o, o],
            ],
            xc: [slide(b0 - a0), slide(b1 - a1)],
            cc: [o; 3],
        }
    }
}
