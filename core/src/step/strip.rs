//! The step of a chain of the midline: Eq. 4 on at most twelve unknowns, dense.
//!
//! Same condensation as the leaf's: `(H + JᵀJ/δ) dx = -(g + JᵀC/δ)` with `C_iso2D` as rows. A block is
//! stepped for one leaf's share of it: its mass, stiffness and glue all grow with its leaves, so its
//! motion does not depend on how many they are.

use crate::constraint::length;
use crate::potential::{bending, contact, glue};
use crate::real::{Real, V2, V3};
use crate::state::strip::{Fibre, Strip};
use nalgebra::{SMatrix, SVector};

/// What the step of a chain is asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripAsk<R> {
    /// Time step.
    pub h: R,
    /// `e^(-c h)`.
    pub keep: R,
    /// Gravity, outward coordinates.
    pub gravity: V2<R>,
    /// Dual regularisation.
    pub delta: R,
    /// Weight of in-solve contact.
    pub contact: R,
}

/// Matrix, column by column, and right-hand side while they are summed: one code for chains of every length.
struct System<'a, R> {
    a: &'a mut [R],
    b: &'a mut [R],
}

/// A chain of any length.
#[derive(Clone, Copy)]
struct Chain<'a, R> {
    x: &'a [V2<R>],
    v: &'a [V2<R>],
    pushed: &'a [V2<R>],
    offset: &'a [R],
    holding: &'a [R],
}

impl<R: Real> System<'_, R> {
    /// Adds to the entry between coordinate `c` of free node `n` and `d` of `m`; node 0 is held.
    fn add(&mut self, (n, c): (usize, usize), (m, d): (usize, usize), value: R) {
        let (Some(row), Some(column)) = (unknown(n, c), unknown(m, d)) else { return };
        if let Some(slot) = self.a.get_mut(column * self.b.len() + row) {
            *slot += value;
        }
    }
    /// Subtracts a gradient from the right-hand side.
    fn pull(&mut self, n: usize, gradient: V2<R>) {
        for (c, &value) in gradient.0.iter().enumerate() {
            if let Some(slot) = unknown(n, c).and_then(|row| self.b.get_mut(row)) {
                *slot -= value;
            }
        }
    }
    fn add_symmetric(&mut self, n: usize, [xx, xy, yy]: [R; 3]) {
        self.add((n, 0), (n, 0), xx);
        self.add((n, 0), (n, 1), xy);
        self.add((n, 1), (n, 0), xy);
        self.add((n, 1), (n, 1), yy);
    }
}

fn unknown(n: usize, c: usize) -> Option<usize> {
    n.checked_sub(1).map(|n| 2 * n + c)
}

/// Moves a chain by one implicit step; `D = 2 (N - 1)`. Answers whether the solve succeeded.
///
/// # Cost
///
/// A block about 3,000 multiply-adds.
///
/// # Hard case
///
/// A matrix that is not positive definite, or a step longer than two edges, leaves the chain in place, at rest.
pub fn step<R: Real, const N: usize, const D: usize>(
    strip: &mut Strip<R, N>,
    fibre: &Fibre<R>,
    ask: &StripAsk<R>,
) -> bool {
    let (mut a, mut b) = (SMatrix::<R, D, D>::repeat(R::ZERO), SVector::<R, D>::repeat(R::ZERO));
    let Strip { x, v, pushed, offset, holding } = &*strip;
    let chain = Chain { x, v, pushed, offset, holding };
    assemble(&mut System { a: a.as_mut_slice(), b: b.as_mut_slice() }, &chain, fibre, ask);
    let solved = R::solve_small(&mut a, &mut b) && within(b.as_slice(), fibre.edge);
    if !solved {
        strip.stop();
        return false;
    }
    let (steps, _) = b.as_slice().as_chunks::<2>();
    for (x, &step) in strip.x.iter_mut().skip(1).zip(steps) {
        *x = *x + V2(step);
    }
    true
}

fn within<R: Real>(dx: &[R], edge: R) -> bool {
    dx.iter().all(|d| d.magnitude() < R::of(2.0) * edge)
}

#[inline(never)]
fn assemble<R: Real>(
    system: &mut System<'_, R>,
    chain: &Chain<'_, R>,
    fibre: &Fibre<R>,
    ask: &StripAsk<R>,
) {
    inertia(system, chain, fibre, ask);
    bend(system, chain, fibre);
    glued(system, chain, fibre);
    lengths(system, chain, fibre, ask);
}

fn inertia<R: Real>(
    system: &mut System<'_, R>,
    chain: &Chain<'_, R>,
    fibre: &Fibre<R>,
    ask: &StripAsk<R>,
) {
    let contacts = chain.pushed.iter().zip(chain.offset.iter().zip(chain.holding));
    let nodes = chain.x.iter().zip(chain.v).zip(contacts);
    for (n, ((&x, &v), (&dir, (&o, &on)))) in nodes.enumerate() {
        let m = fibre.mass * if n + 1 == chain.x.len() { R::of(0.5) } else { R::of(1.0) };
        let stiff = m / (ask.h * ask.h);
        system.add_symmetric(n, [stiff, R::ZERO, stiff]);
        system.pull(n, -(v * (m * ask.keep / ask.h)) - ask.gravity * m);
        let w = on * ask.contact;
        system.add_symmetric(n, contact::hessian(dir, w));
        system.pull(n, contact::gradient(x, dir, o, w));
    }
}

fn bend<R: Real>(system: &mut System<'_, R>, chain: &Chain<'_, R>, fibre: &Fibre<R>) {
    let a = fibre.bend;
    for (n, three) in chain.x.array_windows::<3>().enumerate() {
        let flat = three.map(|p| V3([p.0[0], p.0[1], R::ZERO]));
        let l = bending::second(flat[1], flat[2], flat[0], a).xy();
        let shares = [(n, -a), (n + 1, R::of(2.0) * a), (n + 2, -a)];
        for &(i, si) in &shares {
            system.pull(i, l * (R::of(2.0) * si));
            for &(j, sj) in &shares {
                let s = bending::hessian(si, sj);
                system.add((i, 0), (j, 0), s);
                system.add((i, 1), (j, 1), s);
            }
        }
    }
}

fn glued<R: Real>(system: &mut System<'_, R>, chain: &Chain<'_, R>, fibre: &Fibre<R>) {
    if let [from, to, ..] = chain.x {
        let up = V2([R::ZERO, R::of(1.0)]);
        let g = glue::edge(*to - *from, up, fibre.edge, fibre.glue);
        system.pull(1, g.gradient);
        system.add_symmetric(1, g.hessian);
    }
}

fn lengths<R: Real>(
    system: &mut System<'_, R>,
    chain: &Chain<'_, R>,
    fibre: &Fibre<R>,
    ask: &StripAsk<R>,
) {
    let w = R::of(1.0) / ask.delta;
    for (n, [from, to]) in chain.x.array_windows::<2>().enumerate() {
        let (residual, row) = length::row(*to - *from, fibre.edge * fibre.edge);
        system.pull(n + 1, row * (w * residual));
        system.pull(n, -(row * (w * residual)));
        for c in 0..2 {
            for d in 0..2 {
                let v = w * row.0[c.min(1)] * row.0[d.min(1)];
                system.add((n + 1, c), (n + 1, d), v);
                system.add((n, c), (n, d), v);
                system.add((n + 1, c), (n, d), -v);
                system.add((n, c), (n + 1, d), -v);
            }
        }
    }
}
