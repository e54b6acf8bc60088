//! Promise: the seed's own form stands beside the product's, and they agree where they must. Its matrix is
//! the derivative of its residual, its factor solves what it says, and over an ensemble of turns it
//! stretches a leaf as the seed reports.

#[path = "seed_agrees/derivatives.rs"]
mod derivatives;
#[path = "seed_agrees/figures.rs"]
mod figures;
#[path = "seed_agrees/linear.rs"]
mod linear;
#[path = "seed_agrees/product.rs"]
mod product;

use dogleaf_core::real::{Num, V2};
use dogleaf_core::seed::{Model, Pose, SeedGrid};
use dogleaf_core::state::strip::{BLOCK, Fibre};
use dogleaf_core::state::{Field, Leaf, Sheet};
use dogleaf_core::step::Ask;

/// Half the length of the binding edge of the book around a leaf.
const HALF: f64 = 0.6;

/// A leaf in the air over a book of 80 leaves a side.
fn model<'a, G: SeedGrid>(
    sheet: &'a Sheet<f64, G>,
    leaf: &'a Leaf<f64, G>,
    ask: Ask<f64>,
) -> Model<'a, f64, G> {
    let block = Fibre { edge: 2.0, mass: 80.0 / 7.5, bend: 200.0.root() / 2.0, glue: 600.0 };
    let root = leaf.x.at(0, 0).0[0];
    Model {
        sheet,
        leaf,
        ask,
        active: true,
        q: 0.5 + 0.5 * root / HALF,
        binding: 2.0 * HALF,
        blocks: [block; 2],
        centre: 80.0 / 7.5,
        board: Some(Fibre { edge: 12.3, mass: 10.0, bend: 0.0, glue: 0.0 }),
    }
}

/// The leaf as it is, both blocks and boards flat.
fn flat_book<G: SeedGrid>(leaf: &Field<f64, G>) -> Box<Pose<f64, G>> {
    let mut pose = Box::new(Pose::<f64, G>::ZERO);
    pose.leaf.copy_from(leaf);
    for (side, sign) in [-1.0, 1.0].into_iter().enumerate() {
        pose.blocks[side] =
            core::array::from_fn::<_, BLOCK, _>(|j| V2([sign * (HALF + 2.0 * j as f64), 0.0]));
        pose.boards[side] = V2([sign * (HALF + 12.3), 0.0]);
    }
    pose
}

/// `x̃` as a velocity: what carries `from` to `aim` in one step.
fn towards<G: SeedGrid>(
    from: &Pose<f64, G>,
    aim: &Pose<f64, G>,
    ask: &Ask<f64>,
) -> Box<Pose<f64, G>> {
    let (mut away, mut velocity) = (Box::new(Pose::ZERO), Box::new(Pose::ZERO));
    away.sum(aim, from, -1.0);
    velocity.sum(&Pose::ZERO, &away, 1.0 / (ask.h * ask.keep));
    velocity
}
