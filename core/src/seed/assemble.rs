//! The leaf's part of the system: inertia, potentials, DOG rows, node by node.

use super::curvature;
use super::grid::{SeedGrid, get};
use super::matrix::Sink;
use super::midline;
use super::model::Model;
use super::number::{self, Node};
use super::pose::Pose;
use super::settings::SeedSettings;
use crate::constraint::dog::{ROWS, Star};
use crate::potential::{bending, gravity, isometry, position};
use crate::real::{Real, V3};
use crate::state::{Field, Grab};

/// Options of one assembly.
#[derive(Debug, Clone, Copy)]
pub(super) struct How<R> {
    pub(super) exact: bool,
    /// With `Σ λ ∇²C`.
    pub(super) curved: bool,
    pub(super) delta: R,
}

impl<R: Real> How<R> {
    pub(super) fn new(settings: &SeedSettings, curved: bool) -> Self {
        Self { exact: settings.exact, curved, delta: R::of(settings.delta) }
    }
}

/// Emits `K` and `[∇Φ + Jᵀλ, C]`.
pub(super) fn system<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    how: How<R>,
    pose: &Pose<R, G>,
    aim: &Pose<R, G>,
    lambda: &[R],
    sink: &mut impl Sink<R>,
) {
    for (i, k) in Field::<R, G>::nodes() {
        forces(model, pose, aim, (i, k), sink);
        bend(model, pose, (i, k), sink);
        twist(model, pose, (i, k), sink);
        edges(model, how, pose, (i, k), sink);
    }
    grabbed(model, pose, sink);
    stars(model, how, pose, lambda, sink);
    midline::system(model, how, pose, aim, lambda, sink);
}

/// One row of C: `-δ`, its residual, and its derivatives in `J` and `Jᵀλ`.
pub(super) fn row<R: Real>(
    sink: &mut impl Sink<R>,
    row: usize,
    (delta, lambda): (R, R),
    residual: R,
    terms: impl IntoIterator<Item = (usize, R)>,
) {
    sink.add(row, row, -delta);
    sink.pull(row, residual);
    for (at, d) in terms {
        sink.add(row, at, d);
        sink.pull(at, lambda * d);
    }
}

/// Adds to the gradient of a node.
pub(super) fn pull<R: Real>(sink: &mut impl Sink<R>, node: Node, gradient: &[R]) {
    for (c, &g) in gradient.iter().enumerate().take(node.dims) {
        sink.pull(node.at + c, g);
    }
}

/// A block between two nodes, or of one with itself.
pub(super) fn block<R: Real, const D: usize>(
    sink: &mut impl Sink<R>,
    n: Node,
    m: Node,
    h: &[[R; D]; D],
) {
    for (c, line) in h.iter().enumerate().take(n.dims) {
        let last = if n == m { c + 1 } else { m.dims };
        for (d, &v) in line.iter().enumerate().take(last) {
            sink.add(n.at + c, m.at + d, v);
        }
    }
}

/// A multiple of `I` between two nodes, or of one with itself.
pub(super) fn alike<R: Real>(sink: &mut impl Sink<R>, n: Node, m: Node, value: R) {
    for c in 0..n.dims.min(m.dims) {
        sink.add(n.at + c, m.at + c, value);
    }
}

fn forces<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    pose: &Pose<R, G>,
    aim: &Pose<R, G>,
    (i, k): (usize, usize),
    sink: &mut impl Sink<R>,
) {
    let node = number::leaf::<G>(i, k);
    let m = model.sheet.mass.at(i, k);
    let stiff = m / (model.ask.h * model.ask.h);
    let away = (pose.leaf.at(i, k) - aim.leaf.at(i, k)) * stiff;
    alike(sink, node, node, stiff);
    pull(sink, node, &(away + gravity::gradient(m, model.ask.gravity)).0);
}

/// Both second differences at a node, and how they meet.
fn bend<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    pose: &Pose<R, G>,
    (i, k): (usize, usize),
    sink: &mut impl Sink<R>,
) {
    if i == 0 {
        return;
    }
    let (inner_x, inner_z) = (i + 1 < G::NX, k > 0 && k + 1 < G::NZ);
    let keep = |there: bool, v: R| if there { v } else { R::zero() };
    let a = keep(inner_x, model.sheet.across.at(i, k));
    let b = keep(inner_z, model.sheet.along.at(i, k));
    let (x, two, o) = (&pose.leaf, R::of(2.0), R::zero());
    // A node without a neighbour stands in for it: the difference has no weight there.
    let [fore, head] = [if inner_x { i + 1 } else { i }, if inner_z { k + 1 } else { k }];
    let tail = if inner_z { k - 1 } else { k };
    let lx = bending::second(x.at(i, k), x.at(fore, k), x.at(i - 1, k), a);
    let lz = bending::second(x.at(i, k), x.at(i, head), x.at(i, tail), b);
    let at = number::leaf::<G>;
    let own = Some((at(i, k), [two * a, two * b]));
    let across = |i: usize| inner_x.then(|| (at(i, k), [-a, o]));
    let along = |k: usize| inner_z.then(|| (at(i, k), [o, -b]));
    let arms = [own, across(fore), across(i - 1), along(head), along(tail)];
    crossed(sink, &arms, [lx, lz], model.sheet.cross);
}

type Arm<R> = Option<(Node, [R; 2])>;

/// `‖L_x‖² + ‖L_z‖² + 2 χ ⟨L_x, L_z⟩` by the nodes that carry it, each with its coefficients `s_x, s_z`.
fn crossed<R: Real, const N: usize>(
    sink: &mut impl Sink<R>,
    arms: &[Arm<R>; N],
    [lx, lz]: [V3<R>; 2],
    chi: R,
) {
    let (px, pz) = (lx + lz * chi, lz + lx * chi);
    for (n, first) in arms.iter().enumerate() {
        let Some((node, [sx, sz])) = *first else { continue };
        pull(sink, node, &(bending::gradient(px, sx) + bending::gradient(pz, sz)).0);
        for (other, [tx, tz]) in arms.iter().take(n + 1).flatten() {
            let straight = bending::hessian(sx, *tx) + bending::hessian(sz, *tz);
            let mixed = bending::hessian(sx, *tz) + bending::hessian(sz, *tx);
            alike(sink, node, *other, straight + chi * mixed);
        }
    }
}

fn twist<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    pose: &Pose<R, G>,
    (i, k): (usize, usize),
    sink: &mut impl Sink<R>,
) {
    if i + 1 >= G::NX || k + 1 >= G::NZ {
        return;
    }
    let (c, o) = (model.sheet.twist.at(i, k), R::zero());
    let corners = [(i, k), (i + 1, k), (i, k + 1), (i + 1, k + 1)];
    let t = bending::mixed(corners.map(|(i, k)| pose.leaf.at(i, k)), c);
    let [n00, n10, n01, n11] = corners.map(|(i, k)| number::leaf::<G>(i, k));
    let arms =
        [Some((n00, [c, o])), Some((n10, [-c, o])), Some((n01, [-c, o])), Some((n11, [c, o]))];
    crossed(sink, &arms, [t, V3::zero()], o);
}

/// Isometry of the edges towards fore-edge and head. Edges within the spine column have no free length.
fn edges<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    how: How<R>,
    pose: &Pose<R, G>,
    (i, k): (usize, usize),
    sink: &mut impl Sink<R>,
) {
    let there = [(i + 1 < G::NX, (i + 1, k)), (i > 0 && k + 1 < G::NZ, (i, k + 1))];
    for ((there, (j, l)), (&rest, &w)) in
        there.into_iter().zip(model.sheet.spacing.iter().zip(&model.sheet.isometry))
    {
        if !there {
            continue;
        }
        let (from, to) = (number::leaf::<G>(i, k), number::leaf::<G>(j, l));
        let e = isometry::edge(pose.leaf.at(j, l) - pose.leaf.at(i, k), rest * rest, w, how.exact);
        pull(sink, to, &e.gradient.0);
        pull(sink, from, &(-e.gradient).0);
        block(sink, to, to, &e.hessian);
        block(sink, from, from, &e.hessian);
        block(sink, to, from, &e.hessian.map(|line| line.map(|v| -v)));
    }
}

fn grabbed<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    pose: &Pose<R, G>,
    sink: &mut impl Sink<R>,
) {
    let Some(Grab { node: (i, k), target, firm }) = model.ask.grab else { return };
    let (node, w) = (number::leaf::<G>(i, k), model.sheet.position * firm);
    pull(sink, node, &position::gradient(pose.leaf.at(i, k), target, w).0);
    alike(sink, node, node, position::hessian(w));
}

/// The DOG rows of every inner node.
fn stars<R: Real, G: SeedGrid>(
    model: &Model<'_, R, G>,
    how: How<R>,
    pose: &Pose<R, G>,
    lambda: &[R],
    sink: &mut impl Sink<R>,
) {
    let scales = model.sheet.row_scales();
    let mut at = number::stars::<G>();
    for i in 1..G::NX - 1 {
        for k in 1..G::NZ - 1 {
            let arms = [(i + 1, k), (i, k + 1), (i - 1, k), (i, k - 1)];
            let star = Star::new(pose.leaf.at(i, k), arms.map(|(i, k)| pose.leaf.at(i, k)));
            let [f, h, s, t] = arms.map(|(i, k)| number::leaf::<G>(i, k));
            let nodes = [f, h, s, t, number::leaf::<G>(i, k)];
            let own = [at, at + 1, at + 2].map(|r| get(lambda, r));
            star_rows(&star, scales, at, (how.delta, own), &nodes, sink);
            if how.curved {
                curve(&curvature::star(&star, scales, own), &nodes, sink);
            }
            at += 3;
        }
    }
}

fn star_rows<R: Real>(
    star: &Star<R>,
    scales: [R; 3],
    first: usize,
    (delta, lambda): (R, [R; 3]),
    nodes: &[Node; 5],
    sink: &mut impl Sink<R>,
) {
    let rows = star.rows(scales).into_iter().zip(ROWS).zip(lambda);
    for (r, ((found, named), l)) in rows.enumerate() {
        let [a, b, c] = found.gradient;
        let by_centre = -(a + b + c);
        let [na, nb, nc] = named;
        let parts = [(na, a), (nb, b), (nc, c), (4, by_centre)];
        let terms = parts.into_iter().flat_map(|(n, d)| {
            let node = nodes.get(n).copied().unwrap_or(Node { at: 0, dims: 0 });
            d.0.into_iter().enumerate().take(node.dims).map(move |(c, v)| (node.at + c, v))
        });
        row(sink, first + r, (delta, l), found.value, terms);
    }
}

fn curve<R: Real>(
    blocks: &[[curvature::Block<R>; 5]; 5],
    nodes: &[Node; 5],
    sink: &mut impl Sink<R>,
) {
    for (n, (line, &first)) in blocks.iter().zip(nodes).enumerate() {
        for (h, &second) in line.iter().zip(nodes).take(n + 1) {
            block(sink, first, second, h);
        }
    }
}
