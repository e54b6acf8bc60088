//! Gradient, Jacobian and condensed matrix of the leaf at one pose, eight rows at a time.

use crate::constraint::dog::{ROWS, Star};
use crate::grid::{Grid, Store};
use crate::kkt::Stencil;
use crate::kkt::stencil::{NEIGHBOURS, pair};
use crate::potential::{bending, contact, gravity, isometry, position};
use crate::real::{LANES, Lanes, Num, Real, V2, V3};
use crate::state::field::{Field, Heights, blocks};
use crate::state::{Grab, Leaf, Root, Sheet};

/// What one step is asked: time step, forces, and what is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ask<R> {
    /// Time step `h`, seconds.
    pub h: R,
    /// `e^(-c h)`: what damping leaves of a velocity over one step.
    pub keep: R,
    /// Acceleration of free fall.
    pub gravity: V3<R>,
    /// How the spine column is held.
    pub root: Root<R>,
    /// What the hand holds.
    pub grab: Option<Grab<R>>,
}

/// The constant part of the matrix: bending and inertia, one number a pair of nodes.
#[derive(Debug, Clone)]
pub struct Constant<R: Real, G: Grid> {
    planes: [Heights<R, G>; 7],
}

impl<R: Real, G: Grid> Constant<R, G> {
    /// Zeros.
    pub const ZERO: Self = Self { planes: [const { Heights::ZERO }; 7] };

    /// Fills it for a sheet and a time step.
    ///
    /// # Cost
    ///
    /// Some thousand operations; done once for a book, a time step and a kind of root.
    pub fn fill(&mut self, sheet: &Sheet<R, G>, h: R, root: Root<R>) {
        for plane in &mut self.planes {
            plane.clear();
        }
        for (i, k) in Field::<R, G>::nodes() {
            self.add((i, k), (i, k), sheet.mass.at(i, k) / (h * h));
            self.add_star(sheet, i, k);
            if i == 1 && matches!(root, Root::Clamp(_)) {
                let c = sheet.hinge * row_share::<R, G>(sheet, k);
                self.add((i, k), (i, k), bending::hessian(c, c));
            }
        }
    }

    fn add_star(&mut self, sheet: &Sheet<R, G>, i: usize, k: usize) {
        let (a, b, c) = (sheet.across.at(i, k), sheet.along.at(i, k), sheet.twist.at(i, k));
        let two = R::of(2.0);
        let before = |n: usize| n.wrapping_sub(1);
        let x = [((i, k), two * a), ((i + 1, k), -a), ((before(i), k), -a)];
        let z = [((i, k), two * b), ((i, k + 1), -b), ((i, before(k)), -b)];
        let t = [((i, k), c), ((i + 1, k), -c), ((i, k + 1), -c), ((i + 1, k + 1), c)];
        self.add_product(&x, &x, R::of(1.0));
        self.add_product(&z, &z, R::of(1.0));
        self.add_product(&t, &t, R::of(1.0));
        self.add_product(&x, &z, sheet.cross);
        self.add_product(&z, &x, sheet.cross);
    }

    /// `2 χ s_n s_m` for every pair of nodes of two differences, stored at the later one.
    fn add_product(
        &mut self,
        first: &[((usize, usize), R)],
        second: &[((usize, usize), R)],
        chi: R,
    ) {
        for &(n, sn) in first {
            for &(m, sm) in second {
                if sn != R::ZERO && sm != R::ZERO && n >= m {
                    self.add(n, m, chi * bending::hessian(sn, sm));
                }
            }
        }
    }

    fn add(&mut self, (i, k): (usize, usize), (j, l): (usize, usize), value: R) {
        for (plane, &(di, dk)) in self.planes.iter_mut().zip(&NEIGHBOURS) {
            if i.checked_sub(di) == Some(j) && k.checked_add_signed(-dk) == Some(l) {
                plane.set(i, k, plane.at(i, k) + value);
            }
        }
    }

    fn copy_into(&self, s: &mut Stencil<R, G>) {
        for (n, plane) in self.planes.iter().enumerate() {
            for i in 1..G::NX {
                for k in blocks::<G>() {
                    s.set_scalar(n, i, k, plane.rows(i, k));
                }
            }
        }
    }
}

/// Border rows carry half a strip of paper: the share `√½` of the coefficients of their bending.
fn row_share<R: Real, G: Grid>(sheet: &Sheet<R, G>, k: usize) -> R {
    let inner = sheet.across.at(1, 1);
    if inner > R::ZERO { sheet.across.at(1, k) / inner } else { R::of(1.0) }
}

/// Derivatives of the three rows of every star, scaled by `1/√δ`, with their residuals.
#[derive(Debug, Clone)]
pub struct Jacobian<R: Real, G: Grid>(G::Jacobian<R>);

/// Numbers a star keeps: three rows of three arms of three coordinates, then three residuals.
const STAR: usize = 36;

impl<R: Real, G: Grid> Jacobian<R, G> {
    /// Zeros.
    pub const ZERO: Self = Self(<G::Jacobian<R> as Store<R>>::ZERO);

    #[inline(always)]
    fn place(i: usize, k: usize, n: usize) -> usize {
        (i * G::KP + k) * STAR + n * LANES
    }
    #[inline(always)]
    fn set(
        &mut self,
        i: usize,
        k: usize,
        r: usize,
        gradient: &[V3<R::Lanes>; 3],
        residual: R::Lanes,
    ) {
        for (a, g) in gradient.iter().enumerate() {
            for (c, &value) in g.0.iter().enumerate() {
                value.store(self.0.as_mut(), Self::place(i, k, (r * 3 + a) * 3 + c));
            }
        }
        residual.store(self.0.as_mut(), Self::place(i, k, 27 + r));
    }
    /// Row `r` of the stars of column `i`: by its three arms, and its residual.
    #[inline(always)]
    pub fn row(&self, i: usize, k: usize, r: usize) -> ([V3<R::Lanes>; 3], R::Lanes) {
        let load = |n| R::Lanes::load(self.0.as_ref(), Self::place(i, k, n));
        let arm = |a: usize| {
            V3([load((r * 3 + a) * 3), load((r * 3 + a) * 3 + 1), load((r * 3 + a) * 3 + 2)])
        };
        ([arm(0), arm(1), arm(2)], load(27 + r))
    }
}

/// The star of eight rows of column `i`: centre and neighbours `x⁺, z⁺, x⁻, z⁻`.
#[inline(always)]
pub(super) fn star<R: Real, G: Grid>(x: &Field<R, G>, i: usize, k: usize) -> Star<R::Lanes> {
    Star::new(
        x.rows(i, k, 0),
        [x.rows(i + 1, k, 0), x.rows(i, k, 1), x.rows(i - 1, k, 0), x.rows(i, k, -1)],
    )
}

/// Fills gradient, Jacobian and matrix at the leaf's pose.
///
/// # Source
///
/// Book Eq. 3-4 with `book.md`'s condensation: `g + JᵀC/δ` and `H + JᵀJ/δ`.
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

/// Bending of column `i`: `2 s_n L` at each node its differences name.
#[inline(always)]
fn bend<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    i: usize,
    k: usize,
    own: &mut V3<R::Lanes>,
    g: &mut Field<R, G>,
) {
    let (a, b) = (sheet.across.rows(i, k), sheet.along.rows(i, k));
    let chi = R::Lanes::all(sheet.cross);
    let (lx, lz) = differences(sheet, &leaf.x, i, k);
    let (px, pz) = (lx + lz * chi, lz + lx * chi);
    let two = R::Lanes::of(2.0);
    *own = *own + bending::gradient(px, two * a) + bending::gradient(pz, two * b);
    let (towards_x, towards_z) = (bending::gradient(px, -a), bending::gradient(pz, -b));
    g.add_rows(i - 1, k, 0, towards_x);
    if i + 1 < G::NX {
        g.add_rows(i + 1, k, 0, towards_x);
    }
    g.add_rows(i, k, 1, towards_z);
    g.add_rows(i, k, -1, towards_z);
}

/// Twist of the cells between columns `i - 1` and `i`.
#[inline(always)]
fn twist<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    i: usize,
    k: usize,
    g: &mut Field<R, G>,
) {
    let c = sheet.twist.rows(i - 1, k);
    let pull = bending::gradient(cell_twist(sheet, &leaf.x, i, k), c);
    g.add_rows(i - 1, k, 0, pull);
    g.add_rows(i, k, 0, -pull);
    g.add_rows(i - 1, k, 1, -pull);
    g.add_rows(i, k, 1, pull);
}

/// `T` of the cells between columns `i - 1` and `i`.
#[inline(always)]
pub(super) fn cell_twist<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    x: &Field<R, G>,
    i: usize,
    k: usize,
) -> V3<R::Lanes> {
    let corners = [x.rows(i - 1, k, 0), x.rows(i, k, 0), x.rows(i - 1, k, 1), x.rows(i, k, 1)];
    bending::mixed(corners, sheet.twist.rows(i - 1, k))
}

/// `L_x` and `L_z` of column `i`; a difference a node lacks has coefficient zero.
#[inline(always)]
pub(super) fn differences<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    x: &Field<R, G>,
    i: usize,
    k: usize,
) -> (V3<R::Lanes>, V3<R::Lanes>) {
    let x0 = x.rows(i, k, 0);
    let front = if i + 1 < G::NX { x.rows(i + 1, k, 0) } else { x0 };
    let across = bending::second(x0, front, x.rows(i - 1, k, 0), sheet.across.rows(i, k));
    (across, bending::second(x0, x.rows(i, k, 1), x.rows(i, k, -1), sheet.along.rows(i, k)))
}

/// The clamp: half a cell of bending between the held tangent and the first edge.
fn hinge<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    tangent: V3<R>,
    g: &mut Field<R, G>,
) {
    for k in 0..G::NZ {
        let (l, c) = hinge_laplacian(sheet, &leaf.x, tangent, k);
        g.set(1, k, g.at(1, k) + bending::gradient(l, -c));
    }
}

/// `L` at the clamped spine, with the node the tangent implies behind it; and its coefficient.
pub(super) fn hinge_laplacian<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    x: &Field<R, G>,
    tangent: V3<R>,
    k: usize,
) -> (V3<R>, R) {
    let c = sheet.hinge * row_share(sheet, k);
    let x0 = x.at(0, k);
    (bending::second(x0, x.at(1, k), x0 - tangent * sheet.spacing[0], c), c)
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
        let inside = row_mask::<R, G>(k, 0, G::NZ);
        let between = row_mask::<R, G>(k, 0, G::NZ - 1);
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

/// One where row `k + lane` is in `from..to`, else zero.
#[inline(always)]
pub(crate) fn row_mask<R: Real, G: Grid>(k: usize, from: usize, to: usize) -> R::Lanes {
    let inside = |lane: usize| if (from..to).contains(&(k + lane)) { R::of(1.0) } else { R::ZERO };
    R::Lanes::from_array(core::array::from_fn(inside))
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

/// Derivatives by the five nodes `x⁺, z⁺, x⁻, z⁻, centre` from those by the three arms a row names.
#[inline(always)]
pub(super) fn spread<T: Num>(nodes: &mut [V3<T>; 5], named: [usize; 3], gradient: &[V3<T>; 3]) {
    let mut centre = V3::zero();
    for (&n, &g) in named.iter().zip(gradient) {
        if let Some(slot) = nodes.get_mut(n) {
            *slot = g;
        }
        centre = centre - g;
    }
    nodes[4] = centre;
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
