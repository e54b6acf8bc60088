//! What the system is made of in one step: masses, weights, rest lengths, forces.

use super::number;
use crate::book::Binding;
use crate::grid::Grid;
use crate::real::Real;
use crate::scene::Cover;
use crate::state::strip::{BLOCK, Fibre};
use crate::state::{Leaf, Sheet};
use crate::step::Ask;

/// Everything but the pose and the options.
#[derive(Debug, Clone, Copy)]
pub struct Model<'a, R: Real, G: Grid> {
    /// The leaf's material.
    pub sheet: &'a Sheet<R, G>,
    /// The leaf, for its contacts: the seed has none in the solve, so they must have been cleared.
    pub leaf: &'a Leaf<R, G>,
    /// Time step, damping, gravity, hand.
    pub ask: Ask<R>,
    /// There is a leaf in the air.
    pub active: bool,
    /// Place of the leaf on the binding edge.
    pub q: R,
    /// Length of the binding edge.
    pub binding: R,
    /// Left and right block as wholes.
    pub blocks: [Fibre<R>; 2],
    /// Mass of the midline's node in the middle of the binding.
    pub centre: R,
    /// A board: length of its edge, mass of its free end. `None` for a soft cover.
    pub board: Option<Fibre<R>>,
}

/// Nodes the mass of a block is spread over: its own, and half the centre.
const SHARES: f64 = BLOCK as f64 + 0.5;

impl<R: Real, G: Grid> Model<'_, R, G> {
    /// The whole block of `leaves` leaves from one leaf's share of it.
    ///
    /// The seed's masses add up to the weight of all leaves while its weights of bending and glue are the
    /// block's; rigidity and glue of paper in physical units belong to one leaf.
    pub(super) fn block(share: &Fibre<R>, leaves: u32, seeds_weights: bool) -> Fibre<R> {
        let leaves = R::of(f64::from(leaves.max(1)));
        let times = if seeds_weights { R::of(1.0) } else { leaves };
        Fibre {
            edge: share.edge,
            mass: leaves / R::of(SHARES),
            bend: share.bend * times.root(),
            glue: share.glue * times,
        }
    }

    /// Mass of the centre.
    pub(super) fn centre(binding: &Binding<R>) -> R {
        let [left, right] = binding.leaves.map(|n| R::of(0.5 * f64::from(n.max(1)) / SHARES));
        left + right
    }

    /// A board as the system sees it.
    pub(super) fn board(share: &Fibre<R>, cover: Cover) -> Option<Fibre<R>> {
        let half = Fibre { mass: share.mass * R::of(0.5), ..*share };
        (cover == Cover::Hard).then_some(half)
    }

    /// Marks with one what does not take part: the leaf while none is in the air, boards of a soft cover, a locked spine.
    pub(super) fn mark_held(&self, lock_spine: bool, held: &mut [u16]) {
        held.fill(0);
        let mut mark = |from: usize, count: usize| {
            held.iter_mut().skip(from).take(count).for_each(|h| *h = 1);
        };
        let (lengths, binding) = (number::lengths::<G>(), number::binding::<G>());
        if !self.active {
            mark(0, number::leaf_unknowns::<G>());
            mark(number::stars::<G>(), lengths - number::stars::<G>());
            mark(binding, 2 * G::NZ);
        }
        if lock_spine {
            mark(number::block::<G>(0, 0).at, 2);
            mark(number::block::<G>(1, 0).at, 2);
            mark(number::centre::<G>().at, 2);
            mark(lengths + 2 * (BLOCK - 1), 1);
            mark(binding + 2 * G::NZ, 4);
        }
        if self.board.is_none() {
            mark(number::board::<G>(0).at, 4);
            mark(lengths + number::LENGTHS - 2, 2);
        }
    }
}
