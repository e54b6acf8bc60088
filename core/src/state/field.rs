//! Numbers on the nodes of a leaf, the rows of a column side by side.

use crate::grid::{Grid, Store, scalar_at, vector_at};
use crate::real::{LANES, Lanes, Real, V3};

/// One vector a node: positions, velocities, gradients.
///
/// Reading outside the net gives zeros, writing there does nothing: no index can panic.
#[derive(Debug, Clone)]
pub struct Field<R: Real, G: Grid>(G::Vectors<R>);

/// One number a node: masses, weights.
#[derive(Debug, Clone)]
pub struct Heights<R: Real, G: Grid>(G::Scalars<R>);

impl<R: Real, G: Grid> Field<R, G> {
    /// Zeros.
    pub const ZERO: Self = Self(<G::Vectors<R> as Store<R>>::ZERO);

    /// The vector at node `(i, k)`.
    #[inline(always)]
    pub fn at(&self, i: usize, k: usize) -> V3<R> {
        let get = |c| self.0.as_ref().get(vector_at::<G>(i, c, k)).copied().unwrap_or(R::ZERO);
        V3([get(0), get(1), get(2)])
    }
    /// Sets the vector at node `(i, k)`.
    #[inline(always)]
    pub fn set(&mut self, i: usize, k: usize, v: V3<R>) {
        for (c, &value) in v.0.iter().enumerate() {
            if let Some(slot) = self.0.as_mut().get_mut(vector_at::<G>(i, c, k)) {
                *slot = value;
            }
        }
    }
    /// The rows of column `i` that travel together from row `k` on, shifted by at most one.
    #[inline(always)]
    pub fn rows(&self, i: usize, k: usize, shift: isize) -> V3<R::Lanes> {
        let load =
            |c| R::Lanes::load(self.0.as_ref(), vector_at::<G>(i, c, k).wrapping_add_signed(shift));
        V3([load(0), load(1), load(2)])
    }
    /// Stores rows of column `i`.
    #[inline(always)]
    pub fn set_rows(&mut self, i: usize, k: usize, shift: isize, v: V3<R::Lanes>) {
        for (c, lanes) in v.0.iter().enumerate() {
            lanes.store(self.0.as_mut(), vector_at::<G>(i, c, k).wrapping_add_signed(shift));
        }
    }
    /// Eight rows of column `i`, from row `k` on.
    #[inline(always)]
    pub fn eight(&self, i: usize, k: usize) -> V3<R::Eight> {
        V3([0, 1, 2].map(|c| R::Eight::load(self.0.as_ref(), vector_at::<G>(i, c, k))))
    }
    /// Stores eight rows of column `i`.
    #[inline(always)]
    pub fn set_eight(&mut self, i: usize, k: usize, v: V3<R::Eight>) {
        for (c, lanes) in v.0.iter().enumerate() {
            lanes.store(self.0.as_mut(), vector_at::<G>(i, c, k));
        }
    }
    /// Adds to rows of column `i`.
    #[inline(always)]
    pub fn add_rows(&mut self, i: usize, k: usize, shift: isize, v: V3<R::Lanes>) {
        let sum = self.rows(i, k, shift) + v;
        self.set_rows(i, k, shift, sum);
    }
    /// Zeros everywhere.
    pub fn clear(&mut self) {
        self.0.as_mut().fill(R::ZERO);
    }
    /// Every number, padding included: for copying and for whole-field arithmetic.
    pub fn raw(&self) -> &[R] {
        self.0.as_ref()
    }
    /// Every number, to change.
    pub fn raw_mut(&mut self) -> &mut [R] {
        self.0.as_mut()
    }
    /// Nodes `(i, k)` in order: column by column from the spine, each tail to head.
    pub fn nodes() -> impl Iterator<Item = (usize, usize)> {
        (0..G::NX).flat_map(|i| (0..G::NZ).map(move |k| (i, k)))
    }
    /// Every coordinate of every node is a finite number.
    pub fn finite(&self) -> bool {
        self.0.as_ref().iter().all(|x| x.finite())
    }
    /// Copies from another field.
    pub fn copy_from(&mut self, other: &Self) {
        self.0.as_mut().copy_from_slice(other.0.as_ref());
    }
}

impl<R: Real, G: Grid> Heights<R, G> {
    /// Zeros.
    pub const ZERO: Self = Self(<G::Scalars<R> as Store<R>>::ZERO);

    /// Takes over another's numbers.
    pub fn copy_from(&mut self, other: &Self) {
        self.0.as_mut().copy_from_slice(other.0.as_ref());
    }

    /// The number at node `(i, k)`.
    #[inline(always)]
    pub fn at(&self, i: usize, k: usize) -> R {
        self.0.as_ref().get(scalar_at::<G>(i, k)).copied().unwrap_or(R::ZERO)
    }
    /// Sets the number at node `(i, k)`.
    #[inline(always)]
    pub fn set(&mut self, i: usize, k: usize, value: R) {
        if let Some(slot) = self.0.as_mut().get_mut(scalar_at::<G>(i, k)) {
            *slot = value;
        }
    }
    /// The rows of column `i` that travel together from row `k` on.
    #[inline(always)]
    pub fn rows(&self, i: usize, k: usize) -> R::Lanes {
        R::Lanes::load(self.0.as_ref(), scalar_at::<G>(i, k))
    }
    /// Stores rows of column `i`.
    #[inline(always)]
    pub fn set_rows(&mut self, i: usize, k: usize, v: R::Lanes) {
        v.store(self.0.as_mut(), scalar_at::<G>(i, k));
    }
    /// Zeros everywhere.
    pub fn clear(&mut self) {
        self.0.as_mut().fill(R::ZERO);
    }
}

/// First rows of the groups that travel together through a kernel.
#[inline(always)]
pub fn groups<R: Real, G: Grid>() -> impl Iterator<Item = usize> {
    (0..G::KP / R::Lanes::WIDTH).map(|group| group * R::Lanes::WIDTH)
}

/// First rows of the groups of eight in a column.
#[inline(always)]
pub fn eights<G: Grid>() -> impl Iterator<Item = usize> {
    (0..G::KP / LANES).map(|group| group * LANES)
}
