//! The part of the matrix that no pose changes: bending and inertia.

use crate::grid::Grid;
use crate::kkt::Stencil;
use crate::kkt::stencil::NEIGHBOURS;
use crate::potential::bending;
use crate::real::Real;
use crate::state::field::{Field, Heights, groups};
use crate::state::{Root, Sheet};

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

    /// Starts the rows of column `i` of the matrix with it.
    pub fn copy_into(&self, s: &mut Stencil<R, G>, i: usize) {
        s.clear(i);
        for (n, plane) in self.planes.iter().enumerate() {
            for k in groups::<R, G>() {
                s.set_scalar(n, i, k, plane.rows(i, k));
            }
        }
    }
}

/// Border rows carry half a strip of paper: the share `√½` of the coefficients of their bending.
pub(super) fn row_share<R: Real, G: Grid>(sheet: &Sheet<R, G>, k: usize) -> R {
    let inner = sheet.across.at(1, 1);
    if inner > R::ZERO { sheet.across.at(1, k) / inner } else { R::of(1.0) }
}
