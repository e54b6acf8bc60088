//! The midline's part of the system: both blocks, the binding between them, the boards.

use super::assemble::{How, alike, block, pull, row};
use super::curvature;
use super::grid::{SeedGrid, get};
use super::matrix::Sink;
use super::model::Model;
use super::number::{self, Node};
use super::pose::Pose;
use super::rows;
use crate::potential::{bending, glue, gravity};
use crate::real::{Real, V2, V3};
use crate::state::strip::Fibre;

pub(super) fn system<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    how: How<R>,
    pose: &Pose<R, G>,
    aim: &Pose<R, G>,
    lambda: &[R],
    sink: &mut impl Sink<R>,
) {
    nodes(model, pose, |node, mass, pick| forces(model, node, mass, pick(pose), pick(aim), sink));
    for (side, fibre) in model.blocks.iter().enumerate() {
        bend(pose, side, fibre, sink);
        glued(model, how, pose, side, sink);
    }
    rows::lengths(model, pose, |found| {
        let [from, to] = found.nodes;
        let [x, y] = found.by_to.0;
        let terms = [(to.at, x), (to.at + 1, y), (from.at, -x), (from.at + 1, -y)];
        let own = get(lambda, found.row);
        row(sink, found.row, (how.delta, own), found.residual, terms);
        if how.curved {
            let h = curvature::length(found.rest_sq, own);
            alike(sink, from, from, h);
            alike(sink, to, to, h);
            alike(sink, to, from, -h);
        }
    });
    rows::bound(model, pose, |at, residual, terms| {
        row(sink, at, (how.delta, get(lambda, at)), residual, terms);
    });
}

/// Visits every node off the leaf: its number, its mass, and how to find it in a pose.
pub(super) fn nodes<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    pose: &Pose<R, G>,
    mut visit: impl FnMut(Node, R, &dyn Fn(&Pose<R, G>) -> V2<R>),
) {
    for (side, (block, fibre)) in pose.blocks.iter().zip(&model.blocks).enumerate() {
        for j in 0..block.len() {
            visit(number::block::<G>(side, j), fibre.mass, &|p| {
                p.blocks.get(side).and_then(|b| b.get(j)).copied().unwrap_or(V2::zero())
            });
        }
    }
    visit(number::centre::<G>(), model.centre, &|p| p.centre);
    let mass = model.board.map_or(R::zero(), |b| b.mass);
    for side in 0..pose.boards.len() {
        visit(number::board::<G>(side), mass, &|p| {
            p.boards.get(side).copied().unwrap_or(V2::zero())
        });
    }
}

fn forces<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    node: Node,
    mass: R,
    x: V2<R>,
    aim: V2<R>,
    sink: &mut impl Sink<R>,
) {
    let stiff = mass / (model.ask.h * model.ask.h);
    alike(sink, node, node, stiff);
    let fall = gravity::gradient(mass, model.ask.gravity).xy();
    pull(sink, node, &((x - aim) * stiff + fall).0);
}

fn bend<R: Real, G: SeedGrid>(
    pose: &Pose<R, G>,
    side: usize,
    fibre: &Fibre<R>,
    sink: &mut impl Sink<R>,
) {
    let a = fibre.bend;
    let Some(chain) = pose.blocks.get(side) else { return };
    for (j, three) in chain.array_windows::<3>().enumerate() {
        let flat = three.map(|p| V3([p.0[0], p.0[1], R::zero()]));
        let [before, here, after] = flat;
        let l = bending::second(here, after, before, a);
        let shares = [(j, -a), (j + 1, R::of(2.0) * a), (j + 2, -a)];
        for (n, &(first, s)) in shares.iter().enumerate() {
            let node = number::block::<G>(side, first);
            pull(sink, node, &bending::gradient(l, s).0);
            for &(second, t) in shares.iter().take(n + 1) {
                alike(sink, node, number::block::<G>(side, second), bending::hessian(s, t));
            }
        }
    }
}

/// Glue of one block, by its first edge `d` and the binding edge `e`, of which `n` is the normal.
///
/// ```text
/// c = ⟨left(e), d⟩ / l_b l_d = -⟨e, left(d)⟩ / l_b l_d
/// ```
///
/// so the same potential gives the derivatives by either edge.
fn glued<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    how: How<R>,
    pose: &Pose<R, G>,
    side: usize,
    sink: &mut impl Sink<R>,
) {
    let (Some([b, x, ..]), Some(fibre)) = (pose.blocks.get(side), model.blocks.get(side)) else {
        return;
    };
    let [b1, b2] = pose.binding();
    let (e, d) = (b2 - b1, *x - *b);
    let (by_l, by_b) = (R::of(1.0) / fibre.edge, R::of(1.0) / model.binding);
    let (normal, turned) = (e.left() * by_b, -d.left() * by_l);
    let along_d = glue::edge(d, normal, fibre.edge, fibre.glue);
    let along_e = glue::edge(e, turned, model.binding, fibre.glue);
    let two_w = R::of(2.0) * fibre.glue;
    let gap = if how.exact { normal.dot(d) * by_l - R::of(1.0) } else { R::zero() };
    let twist = two_w * gap * by_l * by_b;
    let [nx, ny] = (normal * by_l).0;
    let [tx, ty] = (turned * (by_b * two_w)).0;
    let mixed = [[nx * tx, nx * ty - twist], [ny * tx + twist, ny * ty]];
    let (one, none) = (R::of(1.0), R::zero());
    let at_binding = |s: usize| if s == side { -one } else { none };
    let nodes = [
        (number::block::<G>(side, 1), one, none),
        (number::block::<G>(0, 0), at_binding(0), -one),
        (number::block::<G>(1, 0), at_binding(1), one),
    ];
    for (n, &(first, fd, fe)) in nodes.iter().enumerate() {
        pull(sink, first, &(along_d.gradient * fd + along_e.gradient * fe).0);
        for &(second, sd, se) in nodes.iter().take(n + 1) {
            let factors = [fd * sd, fe * se, fd * se, fe * sd];
            block(sink, first, second, &combined(along_d.hessian, along_e.hessian, mixed, factors));
        }
    }
}

/// `f_0 H_dd + f_1 H_ee + f_2 H_de + f_3 H_deᵀ`.
fn combined<R: Real>(
    dd: [R; 3],
    ee: [R; 3],
    [[a, b], [c, d]]: [[R; 2]; 2],
    f: [R; 4],
) -> [[R; 2]; 2] {
    let [f0, f1, f2, f3] = f;
    let [xx, xy, yy] = [0, 1, 2].map(|n| get(&dd, n) * f0 + get(&ee, n) * f1);
    [[xx + (f2 + f3) * a, xy + f2 * b + f3 * c], [xy + f2 * c + f3 * b, yy + (f2 + f3) * d]]
}
