//! Gradient and condensed matrix of the leaf at one pose, column by column from the spine.
//!
//! Whatever is added to row `k + 1` is added first, then what is added to `k`, then to `k - 1`: see
//! [`Lanes`].

use super::ask::Ask;
use super::bend::{bend, hinge};
use super::matrix::Blocks;
use super::star::rows;
use crate::grid::Grid;
use crate::kkt::stencil::pair;
use crate::potential::{contact, gravity, isometry, position};
use crate::real::{Lanes, Num, Real, V2, V3};
use crate::state::field::{Field, groups};
use crate::state::{Grab, Leaf, Root, Sheet};

/// Fills gradient and matrix at the leaf's pose.
///
/// # Source
///
/// Book Eq. 3-4, condensed: `g + JᵀC/δ` and `H + JᵀJ/δ`.
///
/// # Cost
///
/// At 11x8 about 20,000 operations on eight rows.
pub fn assemble<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    inertia: &Field<R, G>,
    ask: &Ask<R>,
    s: &mut impl Blocks<R, G>,
    g: &mut Field<R, G>,
) {
    g.copy_from(inertia);
    s.begin(1);
    for i in 1..G::NX {
        if i + 1 < G::NX {
            s.begin(i + 1);
        }
        forces(sheet, leaf, ask, i, s, g);
        edges(sheet, leaf, i, s, g);
        if i + 1 < G::NX {
            stars(sheet, leaf, i, s, g);
        }
        grabbed(sheet, leaf, ask, i, s, g);
        if i > 1 {
            s.end(i - 1);
        }
    }
    s.end(G::NX - 1);
    if let Root::Clamp(tangent) = ask.root {
        hinge(sheet, leaf, tangent, g);
    }
}

/// Gravity, bending and contact of column `i`.
#[inline(always)]
fn forces<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    ask: &Ask<R>,
    i: usize,
    s: &mut impl Blocks<R, G>,
    g: &mut Field<R, G>,
) {
    let fall = V3(ask.gravity.0.map(R::Lanes::all));
    let contact = R::Lanes::all(sheet.contact);
    let zero = R::Lanes::zero();
    for k in groups::<R, G>() {
        let x = leaf.x.rows(i, k, 0);
        let own = gravity::gradient(sheet.mass.rows(i, k), fall);
        let p = leaf.pushed.rows(i, k, 0);
        let w = leaf.holding.rows(i, k) * contact;
        let n = V2([p.0[0], p.0[1]]);
        let push = contact::gradient(x.xy(), n, p.0[2], w);
        let [xx, xy, yy] = contact::hessian(n, w);
        s.add_block(pair::SELF, i, k, 0, &[[xx, xy, zero], [xy, yy, zero], [zero; 3]]);
        bend(sheet, leaf, i, k, own + V3([push.0[0], push.0[1], zero]), g);
    }
}

/// Isometry of the edges from column `i - 1` to `i`, and along column `i`.
#[inline(always)]
fn edges<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    i: usize,
    s: &mut impl Blocks<R, G>,
    g: &mut Field<R, G>,
) {
    let [across, along] = sheet.spacing.map(|l| R::Lanes::all(l * l));
    let [wx, wz] = sheet.isometry.map(R::Lanes::all);
    for k in groups::<R, G>() {
        let inside = R::Lanes::mask(k, 0, G::NZ);
        let between = R::Lanes::mask(k, 0, G::NZ - 1);
        let x = leaf.x.rows(i, k, 0);
        let e = isometry::edge(leaf.x.rows(i, k, 1) - x, along, wz * between, false);
        join(s, g, k, pair::ROW, (i, 1), (i, 0), &e);
        let e = isometry::edge(x - leaf.x.rows(i - 1, k, 0), across, wx * inside, false);
        join(s, g, k, pair::COLUMN, (i, 0), (i - 1, 0), &e);
    }
}

/// Adds an edge between two nodes, each a column and a shift of the rows, the later one first.
#[inline(never)]
fn join<R: Real, G: Grid>(
    s: &mut impl Blocks<R, G>,
    g: &mut Field<R, G>,
    k: usize,
    which: usize,
    later: (usize, isize),
    earlier: (usize, isize),
    e: &isometry::Edge<R::Lanes>,
) {
    s.add_block(which, later.0, k, later.1, &negative(&e.hessian));
    s.add_block(pair::SELF, later.0, k, later.1, &e.hessian);
    g.add_rows(later.0, k, later.1, e.gradient);
    // The column at the spine is held.
    if earlier.0 > 0 {
        s.add_block(pair::SELF, earlier.0, k, earlier.1, &e.hessian);
        g.add_rows(earlier.0, k, earlier.1, -e.gradient);
    }
}

#[inline(always)]
fn negative<T: Num>(m: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    m.map(|row| row.map(|v| -v))
}

/// DOG rows of column `i`: residuals, `JᵀC/δ` and `JᵀJ/δ`.
#[inline(always)]
fn stars<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    i: usize,
    s: &mut impl Blocks<R, G>,
    g: &mut Field<R, G>,
) {
    let scales = sheet.row_scales();
    for k in groups::<R, G>() {
        let weight = sheet.star.rows(i, k);
        if weight.largest() <= R::ZERO {
            continue;
        }
        let rows = rows(&leaf.x, i, k, &scales.map(|v| R::Lanes::all(v) * weight));
        let mut pull = [V3::zero(); 5];
        for (p, node) in pull.iter_mut().zip(&rows.nodes) {
            *p = node.iter().zip(rows.values).fold(*p, |sum, (&g, value)| sum + g * value);
        }
        add_star_gradient(g, i, k, &pull);
        add_star_blocks(s, i, k, &rows.nodes);
    }
}

#[inline(always)]
fn add_star_gradient<R: Real, G: Grid>(
    g: &mut Field<R, G>,
    i: usize,
    k: usize,
    p: &[V3<R::Lanes>; 5],
) {
    g.add_rows(i + 1, k, 0, p[0]);
    g.add_rows(i, k, 1, p[1]);
    g.add_rows(i, k, 0, p[4]);
    g.add_rows(i, k, -1, p[3]);
    g.add_rows(i - 1, k, 0, p[2]);
}

/// The fifteen pairs of a star's nodes `x⁺, z⁺, x⁻, z⁻, centre`, each stored at the later node. The calls are
/// written out: every place is then a constant away from the star's.
#[inline(always)]
fn add_star_blocks<R: Real, G: Grid>(
    s: &mut impl Blocks<R, G>,
    i: usize,
    k: usize,
    [front, head, spine, tail, centre]: &[[V3<R::Lanes>; 3]; 5],
) {
    s.add_products(pair::SELF, i + 1, k, 0, front, front);
    s.add_products(pair::HEADWARD, i + 1, k, 0, front, head);
    s.add_products(pair::COLUMN2, i + 1, k, 0, front, spine);
    s.add_products(pair::TAILWARD, i + 1, k, 0, front, tail);
    s.add_products(pair::COLUMN, i + 1, k, 0, front, centre);
    s.add_products(pair::TAILWARD, i, k, 1, head, spine);
    s.add_products(pair::COLUMN, i, k, 0, centre, spine);
    s.add_products(pair::HEADWARD, i, k, -1, tail, spine);
    s.add_products(pair::SELF, i, k, 1, head, head);
    s.add_products(pair::ROW, i, k, 1, head, centre);
    s.add_products(pair::ROW2, i, k, 1, head, tail);
    s.add_products(pair::SELF, i, k, 0, centre, centre);
    s.add_products(pair::ROW, i, k, 0, centre, tail);
    s.add_products(pair::SELF, i, k, -1, tail, tail);
    // The column at the spine is held.
    if i > 1 {
        s.add_products(pair::SELF, i - 1, k, 0, spine, spine);
    }
}

/// The hand's pull, if it holds a node of column `i`.
#[inline(always)]
fn grabbed<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    ask: &Ask<R>,
    i: usize,
    s: &mut impl Blocks<R, G>,
    g: &mut Field<R, G>,
) {
    let Some(Grab { node: (held, k), target, firm }) = ask.grab else { return };
    if held != i {
        return;
    }
    let w = sheet.position * firm;
    g.set(i, k, g.at(i, k) + position::gradient(leaf.x.at(i, k), target, w));
    s.add_diagonal(i, k, position::hessian(w));
}
