//! Where everything is: leaf, midline and boards together, in the book's frame.

use super::grid::get;
use super::number::{self, Node};
use crate::grid::Grid;
use crate::real::{Real, V2, V3};
use crate::state::Field;
use crate::state::strip::{BLOCK, BOARD, Strip};

/// Positions (or velocities) of all nodes of the system.
#[derive(Debug, Clone)]
pub struct Pose<R: Real, G: Grid> {
    /// The leaf.
    pub leaf: Field<R, G>,
    /// Left and right block from the binding outwards; node 0 is `b_1`, `b_2`.
    pub blocks: [[V2<R>; BLOCK]; 2],
    /// The middle of the binding edge.
    pub centre: V2<R>,
    /// Free ends of the left and right board.
    pub boards: [V2<R>; 2],
}

impl<R: Real, G: Grid> Pose<R, G> {
    /// Everything at the origin.
    pub const ZERO: Self = Self {
        leaf: Field::ZERO,
        blocks: [[V2([R::ZERO; 2]); BLOCK]; 2],
        centre: V2([R::ZERO; 2]),
        boards: [V2([R::ZERO; 2]); 2],
    };

    /// The ends `b_1`, `b_2` of the binding edge.
    pub fn binding(&self) -> [V2<R>; 2] {
        let [[b1, ..], [b2, ..]] = self.blocks;
        [b1, b2]
    }

    /// Every coordinate is a finite number.
    pub(super) fn finite(&self) -> bool {
        let nodes = self.blocks.as_flattened().iter().chain(&self.boards).chain([&self.centre]);
        self.leaf.finite() && nodes.flat_map(|p| p.0).all(|c| c.finite())
    }

    /// Takes the midline from chains in outward coordinates, by what `of` picks: positions or velocities.
    pub(super) fn load(
        &mut self,
        blocks: &[Strip<R, BLOCK>; 2],
        boards: &[Strip<R, BOARD>; 2],
        of: impl Fn(&Strip<R, BLOCK>) -> [V2<R>; BLOCK],
        of_board: impl Fn(&Strip<R, BOARD>) -> [V2<R>; BOARD],
    ) {
        for ((side, to), strip) in self.blocks.iter_mut().enumerate().zip(blocks) {
            *to = of(strip).map(|p| outward(side, p));
        }
        for ((side, to), strip) in self.boards.iter_mut().enumerate().zip(boards) {
            let [_, end] = of_board(strip);
            *to = outward(side, end);
        }
    }

    /// Gives the midline's positions back to the chains.
    pub(super) fn store(
        &self,
        blocks: &mut [Strip<R, BLOCK>; 2],
        boards: &mut [Strip<R, BOARD>; 2],
    ) {
        for ((side, from), strip) in self.blocks.iter().enumerate().zip(blocks) {
            strip.x = from.map(|p| outward(side, p));
        }
        let binding = self.binding();
        for (((side, &end), &b), strip) in self.boards.iter().enumerate().zip(&binding).zip(boards)
        {
            strip.x = [outward(side, b), outward(side, end)];
        }
    }

    /// Sets every node, `self = a + s b`.
    pub fn sum(&mut self, a: &Self, b: &Self, s: R) {
        let leaf = self.leaf.raw_mut().iter_mut().zip(a.leaf.raw()).zip(b.leaf.raw());
        leaf.for_each(|((to, &a), &b)| *to = a + s * b);
        let nodes = self.blocks.as_flattened_mut().iter_mut();
        let others = a.blocks.as_flattened().iter().zip(b.blocks.as_flattened());
        nodes.zip(others).for_each(|(to, (&a, &b))| *to = a + b * s);
        self.centre = a.centre + b.centre * s;
        let ends = self.boards.iter_mut().zip(a.boards.iter().zip(&b.boards));
        ends.for_each(|(to, (&a, &b))| *to = a + b * s);
    }

    /// Reads a vector of unknowns into nodes; what is not unknown becomes zero.
    ///
    /// # Shapes and units
    ///
    /// `unknowns`: in the order of the rows of `K`; multipliers behind them are not read.
    pub fn spread(&mut self, unknowns: &[R]) {
        for (i, k) in Field::<R, G>::nodes() {
            self.leaf.set(i, k, three(unknowns, number::leaf::<G>(i, k)));
        }
        for (side, block) in self.blocks.iter_mut().enumerate() {
            for (j, p) in block.iter_mut().enumerate() {
                *p = two(unknowns, number::block::<G>(side, j));
            }
        }
        self.centre = two(unknowns, number::centre::<G>());
        for (side, p) in self.boards.iter_mut().enumerate() {
            *p = two(unknowns, number::board::<G>(side));
        }
    }
}

/// Between the book's frame and the outward coordinates of a side: its own inverse.
fn outward<R: Real>(side: usize, p: V2<R>) -> V2<R> {
    if side == 0 { V2([-p.0[0], p.0[1]]) } else { p }
}

fn two<R: Real>(from: &[R], node: Node) -> V2<R> {
    V2([get(from, node.at), get(from, node.at + 1)])
}

fn three<R: Real>(from: &[R], node: Node) -> V3<R> {
    let z = if node.dims > 2 { get(from, node.at + 2) } else { R::ZERO };
    V3([get(from, node.at), get(from, node.at + 1), z])
}
