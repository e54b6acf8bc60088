//! Rows of C other than the stars': lengths, binding, fix.

use super::grid::SeedGrid;
use super::model::Model;
use super::number::{self, Node};
use super::pose::Pose;
use crate::constraint::{binding, fix, length};
use crate::real::{Real, V2};
use crate::state::strip::BLOCK;

/// A length row: its residual, its derivative by `to`, its nodes, its squared rest length.
pub(super) struct Length<R> {
    pub(super) row: usize,
    pub(super) nodes: [Node; 2],
    pub(super) residual: R,
    pub(super) by_to: V2<R>,
    pub(super) rest_sq: R,
}

/// Visits `C_iso2D`: the edges of both blocks, the binding edge, both boards.
pub(super) fn lengths<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    pose: &Pose<R, G>,
    mut visit: impl FnMut(Length<R>),
) {
    let mut row = number::lengths::<G>();
    let mut edge = |nodes: [Node; 2], from: V2<R>, to: V2<R>, rest: R| {
        let rest_sq = rest * rest;
        let (residual, by_to) = length::row(to - from, rest_sq);
        visit(Length { row, nodes, residual, by_to, rest_sq });
        row += 1;
    };
    for (side, (block, fibre)) in pose.blocks.iter().zip(&model.blocks).enumerate() {
        for (j, [from, to]) in block.array_windows::<2>().enumerate().take(BLOCK - 1) {
            let nodes = [number::block::<G>(side, j), number::block::<G>(side, j + 1)];
            edge(nodes, *from, *to, fibre.edge);
        }
    }
    let [b1, b2] = pose.binding();
    edge([number::block::<G>(0, 0), number::block::<G>(1, 0)], b1, b2, model.binding);
    let rest = model.board.map_or(R::of(1.0), |b| b.edge);
    for (side, (&end, &b)) in pose.boards.iter().zip(&[b1, b2]).enumerate() {
        edge([number::block::<G>(side, 0), number::board::<G>(side)], b, end, rest);
    }
}

/// Visits `C_binding` and `C_fix`: row, residual, and at most three unknowns with their derivatives.
pub(super) fn bound<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    pose: &Pose<R, G>,
    mut visit: impl FnMut(usize, R, [(usize, R); 3]),
) {
    let [b1, b2] = pose.binding();
    let ends = [number::block::<G>(0, 0).at, number::block::<G>(1, 0).at];
    let mut row = number::binding::<G>();
    let mut node = |node: Node, x: V2<R>, q: R| {
        let [own, first, second] = binding::gradient(q);
        for (c, &residual) in binding::residual(x, b1, b2, q).0.iter().enumerate() {
            let [e1, e2] = ends.map(|e| e + c);
            visit(row, residual, [(node.at + c, own), (e1, first), (e2, second)]);
            row += 1;
        }
    };
    for k in 0..G::NZ {
        node(number::leaf::<G>(0, k), pose.leaf.at(0, k).xy(), model.q);
    }
    node(number::centre::<G>(), pose.centre, R::of(0.5));
    let half: R = fix::gradient();
    for (c, &residual) in fix::residual(b1, b2, V2::zero()).0.iter().enumerate() {
        let [e1, e2] = ends.map(|e| e + c);
        visit(number::fix::<G>() + c, residual, [(e1, half), (e2, half), (e2, R::zero())]);
    }
}
