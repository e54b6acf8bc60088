//! The merit of the whole system: `φ = Φ(x) + μ ‖C(x)‖₂`. Source: RHS19.

use super::grid::SeedGrid;
use super::midline;
use super::model::Model;
use super::number;
use super::pose::Pose;
use super::rows;
use crate::potential::{bending, glue, gravity};
use crate::real::{Real, V2, V3};
use crate::step::merit::{Merit, merit as leaf_merit};

/// Evaluates both parts of the merit at one pose.
pub(super) fn merit<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    lock_spine: bool,
    pose: &Pose<R, G>,
    aim: &Pose<R, G>,
) -> Merit<R> {
    let half = R::of(0.5) / (model.ask.h * model.ask.h);
    let node = |mass: R, x: V3<R>, aim: V3<R>| {
        mass * half * (x - aim).norm_sq() + gravity::value(mass, model.ask.gravity, x)
    };
    let (mut energy, mut residual_sq) = (R::zero(), R::zero());
    if model.active {
        let own = leaf_merit(model.sheet, model.leaf, &pose.leaf, &aim.leaf, &model.ask);
        energy += own.energy;
        residual_sq += own.residual * own.residual;
        for k in 0..G::NZ {
            energy += node(model.sheet.mass.at(0, k), pose.leaf.at(0, k), aim.leaf.at(0, k));
        }
    }
    midline::nodes(model, pose, |_, mass, pick| {
        energy += node(mass, lifted(pick(pose)), lifted(pick(aim)));
    });
    for side in 0..model.blocks.len() {
        energy += chain(model, pose, side);
    }
    residual_sq += residuals(model, lock_spine, pose);
    Merit { energy, residual: residual_sq.root() }
}

fn lifted<R: Real>(p: V2<R>) -> V3<R> {
    V3([p.0[0], p.0[1], R::zero()])
}

/// Bending and glue of one block.
fn chain<R: Real, G: SeedGrid>(model: &Model<'_, R, G>, pose: &Pose<R, G>, side: usize) -> R {
    let (Some(chain), Some(fibre)) = (pose.blocks.get(side), model.blocks.get(side)) else {
        return R::zero();
    };
    let bent = chain.array_windows::<3>().fold(R::zero(), |sum, three| {
        let [before, here, after] = three.map(lifted);
        sum + bending::second(here, after, before, fibre.bend).norm_sq()
    });
    let [b1, b2] = pose.binding();
    let [b, x, ..] = *chain;
    let normal = (b2 - b1).left() * (R::of(1.0) / model.binding);
    bent + glue::edge(x - b, normal, fibre.edge, fibre.glue).value
}

/// `‖C‖²` of the rows that take part, without the stars'.
fn residuals<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    lock_spine: bool,
    pose: &Pose<R, G>,
) -> R {
    let mut sum = R::zero();
    rows::lengths(model, pose, |found| {
        let board = found.row + 2 >= number::binding::<G>();
        if !board || model.board.is_some() {
            sum += found.residual * found.residual;
        }
    });
    let centre = number::binding::<G>() + 2 * G::NZ;
    rows::bound(model, pose, |row, residual, _| {
        let counts = if row < centre { model.active } else { !lock_spine };
        if counts {
            sum += residual * residual;
        }
    });
    sum
}
