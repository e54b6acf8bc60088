//! Gradient, Jacobian and condensed matrix of the leaf at one pose, eight rows at a time.

use super::ask::Ask;
use super::bend::{bend, hinge, twist};
use super::constant::Constant;
use super::jacobian::{Jacobian, spread, star};
use crate::constraint::dog::ROWS;
use crate::grid::Grid;
use crate::kkt::Stencil;
use crate::kkt::stencil::pair;
use crate::potential::{contact, gravity, isometry, position};
use crate::real::{Lanes, Num, Real, V2, V3};
use crate::state::field::{Field, blocks, row_mask};
use crate::state::{Grab, Leaf, Root, Sheet};

/// Fills gradient, Jacobian and matrix at the leaf's pose.
///
/// # Source
///
/// Book Eq. 3-4, condensed: `g + JᵀC/δ` and `H + JᵀJ/δ`.
///
/// # Cost
///
/// At 11x8 about 20,000 lane operations.
pub fn assemble<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    constant: &Constant<R, G>,
    inertia: &Field<R, G>,
    ask: &Ask<R>,
    s: &mut Stencil<R, G>,
    g: &mut Field<R, G>,
    j: &mut Jacobian<R, G>,
) {
    constant.copy_into(s);
    g.copy_from(inertia);
    forces(sheet, leaf, ask, s, g);
    edges(sheet, leaf, s, g);
    stars(sheet, leaf, s, g, j);
    grabbed(sheet, leaf, ask, s, g);
}

/// Gravity, bending and contact.
#[inline(always)]
fn forces<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    ask: &Ask<R>,
    s: &mut Stencil<R, G>,
    g: &mut Field<R, G>,
) {
    let fall = V3(ask.gravity.0.map(R::Lanes::all));
    let contact = R::Lanes::all(sheet.contact);
    for i in 0..G::NX {
        for k in blocks::<G>() {
            let x = leaf.x.rows(i, k, 0);
            let mut own = gravity::gradient(sheet.mass.rows(i, k), fall);
            let p = leaf.pushed.rows(i, k, 0);
            let w = leaf.holding.rows(i, k) * contact;
            let n = V2([p.0[0], p.0[1]]);
            let push = contact::gradient(x.xy(), n, p.0[2], w);
            own = own + V3([push.0[0], push.0[1], R::Lanes::zero()]);
            let [xx, xy, yy] = contact::hessian(n, w);
            let zero = R::Lanes::zero();
            s.add_block(pair::SELF, i, k, 0, &[[xx, xy, zero], [xy, yy, zero], [zero; 3]]);
            if i > 0 {
                bend(sheet, leaf, i, k, &mut own, g);
                twist(sheet, leaf, i, k, g);
            }
            g.add_rows(i, k, 0, own);
        }
    }
    if let Root::Clamp(tangent) = ask.root {
        hinge(sheet, leaf, tangent, g);
    }
}

/// Isometry of all edges with a free node.
#[inline(always)]
fn edges<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    s: &mut Stencil<R, G>,
    g: &mut Field<R, G>,
) {
    let [across, along] = sheet.spacing.map(|l| R::Lanes::all(l * l));
    let [wx, wz] = sheet.isometry.map(R::Lanes::all);
    for k in blocks::<G>() {
        let inside = row_mask::<R>(k, 0, G::NZ);
        let between = row_mask::<R>(k, 0, G::NZ - 1);
        for i in 1..G::NX {
            let x = leaf.x.rows(i, k, 0);
            let e = isometry::edge(x - leaf.x.rows(i - 1, k, 0), across, wx * inside, false);
            s.add_block(pair::SELF, i, k, 0, &e.hessian);
            s.add_block(pair::SELF, i - 1, k, 0, &e.hessian);
            s.add_block(pair::COLUMN, i, k, 0, &negative(&e.hessian));
            g.add_rows(i, k, 0, e.gradient);
            g.add_rows(i - 1, k, 0, -e.gradient);
            let e = isometry::edge(leaf.x.rows(i, k, 1) - x, along, wz * between, false);
            s.add_block(pair::SELF, i, k, 0, &e.hessian);
            s.add_block(pair::ROW, i, k, 1, &negative(&e.hessian));
            s.add_block(pair::SELF, i, k, 1, &e.hessian);
            g.add_rows(i, k, 0, -e.gradient);
            g.add_rows(i, k, 1, e.gradient);
        }
    }
}

#[inline(always)]
fn negative<T: Num>(m: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    m.map(|row| row.map(|v| -v))
}

/// DOG rows: residuals, `JᵀC/δ` and `JᵀJ/δ`.
#[inline(always)]
fn stars<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    s: &mut Stencil<R, G>,
    g: &mut Field<R, G>,
    j: &mut Jacobian<R, G>,
) {
    let scales = sheet.row_scales();
    for i in 1..G::NX - 1 {
        for k in blocks::<G>() {
            let weight = sheet.star.rows(i, k);
            let rows = star(&leaf.x, i, k).rows(scales.map(|v| R::Lanes::all(v) * weight));
            let mut by_node = [[V3::zero(); 5]; 3];
            let mut pull = [V3::zero(); 5];
            for (r, (row, named)) in rows.iter().zip(ROWS).enumerate() {
                j.set(i, k, r, &row.gradient, row.value);
                if let Some(nodes) = by_node.get_mut(r) {
                    spread(nodes, named, &row.gradient);
                    for (p, n) in pull.iter_mut().zip(nodes.iter()) {
                        *p = *p + *n * row.value;
                    }
                }
            }
            add_star_gradient(g, i, k, &pull);
            add_star_blocks(s, i, k, &by_node);
        }
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
    g.add_rows(i - 1, k, 0, p[2]);
    g.add_rows(i, k, -1, p[3]);
    g.add_rows(i, k, 0, p[4]);
}

/// The fifteen pairs of a star's nodes, each stored at the later node: `(later, earlier, pair, column, row)`.
const PAIRS: [(usize, usize, usize, isize, isize); 15] = [
    (0, 0, pair::SELF, 1, 0),
    (0, 1, pair::HEADWARD, 1, 0),
    (0, 2, pair::COLUMN2, 1, 0),
    (0, 3, pair::TAILWARD, 1, 0),
    (0, 4, pair::COLUMN, 1, 0),
    (1, 2, pair::TAILWARD, 0, 1),
    (4, 2, pair::COLUMN, 0, 0),
    (3, 2, pair::HEADWARD, 0, -1),
    (1, 1, pair::SELF, 0, 1),
    (1, 4, pair::ROW, 0, 1),
    (1, 3, pair::ROW2, 0, 1),
    (4, 4, pair::SELF, 0, 0),
    (4, 3, pair::ROW, 0, 0),
    (3, 3, pair::SELF, 0, -1),
    (2, 2, pair::SELF, -1, 0),
];

#[inline(always)]
fn add_star_blocks<R: Real, G: Grid>(
    s: &mut Stencil<R, G>,
    i: usize,
    k: usize,
    rows: &[[V3<R::Lanes>; 5]; 3],
) {
    for (later, earlier, which, column, shift) in PAIRS {
        let mut block = [[R::Lanes::zero(); 3]; 3];
        for nodes in rows {
            let (Some(a), Some(b)) = (nodes.get(later), nodes.get(earlier)) else { continue };
            for (line, &ac) in block.iter_mut().zip(&a.0) {
                for (slot, &bd) in line.iter_mut().zip(&b.0) {
                    *slot = *slot + ac * bd;
                }
            }
        }
        s.add_block(which, i.wrapping_add_signed(column), k, shift, &block);
    }
}

/// The hand's pull.
#[inline(always)]
fn grabbed<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    ask: &Ask<R>,
    s: &mut Stencil<R, G>,
    g: &mut Field<R, G>,
) {
    let Some(Grab { node: (i, k), target }) = ask.grab else { return };
    g.set(i, k, g.at(i, k) + position::gradient(leaf.x.at(i, k), target, sheet.position));
    for c in 0..3 {
        s.add(pair::SELF, c, c, i, k, position::hessian(sheet.position));
    }
}
