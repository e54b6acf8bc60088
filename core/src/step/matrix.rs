//! What the assembly adds blocks to: the matrix, or nothing where only the gradient is asked for.

use super::constant::Constant;
use crate::grid::Grid;
use crate::kkt::stencil::pair;
use crate::kkt::{Factor, Stencil};
use crate::real::{Real, V3};

/// Takes the blocks of the matrix as they come.
pub trait Blocks<R: Real, G: Grid> {
    /// Nothing has been added to the rows of column `i` yet.
    fn begin(&mut self, i: usize);
    /// A 3x3 block of the rows that travel together, at the later node of a pair.
    fn add_block(&mut self, which: usize, i: usize, k: usize, shift: isize, b: &[[R::Lanes; 3]; 3]);
    /// `Σ_r later[r] · earlier[r]ᵀ`, as [`Blocks::add_block`] takes a block.
    fn add_products(
        &mut self,
        which: usize,
        i: usize,
        k: usize,
        shift: isize,
        later: &[V3<R::Lanes>; 3],
        earlier: &[V3<R::Lanes>; 3],
    );
    /// The same number on the diagonal of one node.
    fn add_diagonal(&mut self, i: usize, k: usize, value: R);
    /// Nothing more will be added to the rows of column `i`.
    fn end(&mut self, i: usize);
}

/// The matrix: begins with its constant part, grows in the stencil, ends in the factor.
#[derive(Debug)]
pub struct Matrix<'a, R: Real, G: Grid> {
    /// What no pose changes.
    pub constant: &'a Constant<R, G>,
    /// The three columns that grow.
    pub stencil: &'a mut Stencil<R, G>,
    /// The columns that are complete.
    pub factor: &'a mut Factor<R, G>,
}

impl<R: Real, G: Grid> Blocks<R, G> for Matrix<'_, R, G> {
    #[inline(always)]
    fn begin(&mut self, i: usize) {
        if i == 1 {
            self.factor.clear();
        }
        self.constant.copy_into(self.stencil, i);
    }
    #[inline(always)]
    fn add_block(
        &mut self,
        which: usize,
        i: usize,
        k: usize,
        shift: isize,
        b: &[[R::Lanes; 3]; 3],
    ) {
        self.stencil.add_block(which, i, k, shift, b);
    }
    #[inline(always)]
    fn add_products(
        &mut self,
        which: usize,
        i: usize,
        k: usize,
        shift: isize,
        later: &[V3<R::Lanes>; 3],
        earlier: &[V3<R::Lanes>; 3],
    ) {
        self.stencil.add_products(which, i, k, shift, later, earlier);
    }
    #[inline(always)]
    fn add_diagonal(&mut self, i: usize, k: usize, value: R) {
        for c in 0..3 {
            self.stencil.add(pair::SELF, c, c, i, k, value);
        }
    }
    #[inline(always)]
    fn end(&mut self, i: usize) {
        self.factor.take(self.stencil, i);
    }
}

/// Only the gradient is asked for.
#[derive(Debug)]
pub struct NoMatrix;

impl<R: Real, G: Grid> Blocks<R, G> for NoMatrix {
    #[inline(always)]
    fn begin(&mut self, _: usize) {}
    #[inline(always)]
    fn add_block(&mut self, _: usize, _: usize, _: usize, _: isize, _: &[[R::Lanes; 3]; 3]) {}
    #[inline(always)]
    fn add_products(
        &mut self,
        _: usize,
        _: usize,
        _: usize,
        _: isize,
        _: &[V3<R::Lanes>; 3],
        _: &[V3<R::Lanes>; 3],
    ) {
    }
    #[inline(always)]
    fn add_diagonal(&mut self, _: usize, _: usize, _: R) {}
    #[inline(always)]
    fn end(&mut self, _: usize) {}
}
