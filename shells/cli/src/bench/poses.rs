//! The poses of a turn, each with what its step was asked.

use super::turn::Turn;
use crate::error::CliError;
use dogleaf_core::collision::Profile;
use dogleaf_core::grid::Grid;
use dogleaf_core::real::{Real, V3};
use dogleaf_core::scene::WorldSpec;
use dogleaf_core::state::strip::{BLOCK, BOARD, Strip};
use dogleaf_core::state::{Leaf, Root, Sheet};
use dogleaf_core::step::Ask;

/// Everything the parts of one step need.
pub(super) struct Pose<R: Real, G: Grid> {
    pub(super) leaf: Leaf<R, G>,
    pub(super) ask: Ask<R>,
    pub(super) blocks: [Strip<R, BLOCK>; 2],
    pub(super) boards: [Strip<R, BOARD>; 2],
    pub(super) profiles: [Profile<R>; 2],
    pub(super) half: R,
}

/// The poses before each step with a leaf in the air, and what the leaf is made of.
pub(super) struct Poses<R: Real, G: Grid> {
    pub(super) sheet: Box<Sheet<R, G>>,
    pub(super) list: Vec<Pose<R, G>>,
}

/// Plays a turn once and keeps its poses.
pub(super) fn poses<R: Real, G: Grid>(turn: &mut Turn<R, G>) -> Result<Poses<R, G>, CliError> {
    let world = WorldSpec::default();
    let h = f64::from(world.step_us) * 1e-6;
    let mut poses = Poses { sheet: Box::new(Sheet::ZERO), list: Vec::new() };
    let seen = |book: &dogleaf_core::Book<R, G>| {
        *poses.sheet = book.sheet().clone();
        let Some(leaf) = book.leaf() else { return };
        let ask = Ask {
            h: R::of(h),
            keep: R::of((-world.damping_per_s * h).exp()),
            gravity: V3(world.gravity.map(|g| R::of(book.units().length(g)))),
            root: Root::Hinge,
            grab: book.held(),
        };
        poses.list.push(Pose {
            leaf: leaf.clone(),
            ask,
            blocks: *book.blocks(),
            boards: book.boards().copied().unwrap_or([Strip::ZERO; 2]),
            profiles: book.binding().profiles(book.blocks()),
            half: book.binding().half_held(),
        });
    };
    turn.steps(seen, |_, _, _| {})?;
    Ok(poses)
}
