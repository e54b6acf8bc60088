//! The merit function the line search judges by: `φ = Φ(x) + μ ‖C(x)‖₂`. Source: RHS19.

use super::ask::Ask;
use super::bend::{cell_twist, differences, hinge_laplacian};
use super::star::star;
use crate::grid::Grid;
use crate::potential::{bending, contact, gravity, isometry, position};
use crate::real::{Eight, LANES, Lanes, Num, Real, V2, V3};
use crate::state::field::{Field, groups};
use crate::state::{Grab, Leaf, Root, Sheet};

/// The two parts of the merit at one pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Merit<R> {
    /// `Φ`: inertia and potentials.
    pub energy: R,
    /// `‖C‖₂`.
    pub residual: R,
}

impl<R: Real> Merit<R> {
    /// `Φ + μ ‖C‖`.
    pub fn at(self, mu: R) -> R {
        self.energy + mu * self.residual
    }
}

/// Evaluates the merit of pose `x`; `aim` is `x̃`, `leaf` gives the contacts.
pub fn merit<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    x: &Field<R, G>,
    aim: &Field<R, G>,
    ask: &Ask<R>,
) -> Merit<R> {
    // Eight partial sums, however many rows travel together.
    let (mut energies, mut residuals) = ([R::ZERO; LANES], [R::ZERO; LANES]);
    for k in groups::<R, G>() {
        let inside = R::Lanes::mask(k, 0, G::NZ);
        let between = R::Lanes::mask(k, 0, G::NZ - 1);
        let mut energy = R::Lanes::load(&energies, k % LANES);
        let mut residual = R::Lanes::load(&residuals, k % LANES);
        for i in 1..G::NX {
            energy = energy
                + node_energy(sheet, leaf, x, aim, ask, i, k)
                + edge_energy(sheet, x, i, k, inside, between);
            if i + 1 < G::NX {
                residual = residual + star_residual(sheet, x, i, k);
            }
        }
        energy.store(&mut energies, k % LANES);
        residual.store(&mut residuals, k % LANES);
    }
    let alone = sum(energies) + clamp_energy(sheet, x, ask) + grab_energy(sheet, x, ask);
    Merit { energy: alone, residual: (sum(residuals) * sheet.delta).root() }
}

fn sum<R: Real>(partial: [R; LANES]) -> R {
    R::Eight::from_array(partial).sum()
}

/// Inertia, weight, bending and contact of eight rows.
#[inline(always)]
fn node_energy<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    x: &Field<R, G>,
    aim: &Field<R, G>,
    ask: &Ask<R>,
    i: usize,
    k: usize,
) -> R::Lanes {
    let here = x.rows(i, k, 0);
    let m = sheet.mass.rows(i, k);
    let half = R::Lanes::all(R::of(0.5) / (ask.h * ask.h));
    let inertia = m * half * (here - aim.rows(i, k, 0)).norm_sq();
    let weight = gravity::value(m, V3(ask.gravity.0.map(R::Lanes::all)), here);
    let (lx, lz) = differences(sheet, x, i, k);
    let bend =
        bending::value(lx, lz, R::Lanes::all(sheet.cross)) + cell_twist(sheet, x, i, k).norm_sq();
    let p = leaf.pushed.rows(i, k, 0);
    let w = leaf.holding.rows(i, k) * R::Lanes::all(sheet.contact);
    (inertia + weight) + (bend + contact::value(here.xy(), V2([p.0[0], p.0[1]]), p.0[2], w))
}

#[inline(always)]
fn edge_energy<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    x: &Field<R, G>,
    i: usize,
    k: usize,
    inside: R::Lanes,
    between: R::Lanes,
) -> R::Lanes {
    let [across, along] = sheet.spacing.map(|l| R::Lanes::all(l * l));
    let [wx, wz] = sheet.isometry.map(R::Lanes::all);
    let here = x.rows(i, k, 0);
    isometry::value(here - x.rows(i - 1, k, 0), across, wx * inside)
        + isometry::value(x.rows(i, k, 1) - here, along, wz * between)
}

/// Squares of the three rows of eight stars, scaled by `1/δ`.
#[inline(always)]
fn star_residual<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    x: &Field<R, G>,
    i: usize,
    k: usize,
) -> R::Lanes {
    let weight = sheet.star.rows(i, k);
    if weight.largest() <= R::ZERO {
        return R::Lanes::zero();
    }
    let [a, b, c] = star(x, i, k).values(sheet.row_scales().map(|v| R::Lanes::all(v) * weight));
    a * a + b * b + c * c
}

fn clamp_energy<R: Real, G: Grid>(sheet: &Sheet<R, G>, x: &Field<R, G>, ask: &Ask<R>) -> R {
    let Root::Clamp(tangent) = ask.root else { return R::ZERO };
    (0..G::NZ).fold(R::ZERO, |sum, k| sum + hinge_laplacian(sheet, x, tangent, k).0.norm_sq())
}

fn grab_energy<R: Real, G: Grid>(sheet: &Sheet<R, G>, x: &Field<R, G>, ask: &Ask<R>) -> R {
    let Some(Grab { node: (i, k), target, firm }) = ask.grab else { return R::ZERO };
    position::value(x.at(i, k), target, sheet.position * firm)
}
