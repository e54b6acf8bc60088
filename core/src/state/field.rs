//! Numbers on the nodes of a leaf, eight rows side by side.

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
    /// Eight rows of column `i`, from row `k` on. `k` may be one outside on either side.
    #[inline(always)]
    pub fn rows(&self, i: usize, k: usize, shift: isize) -> V3<R::Lanes> {
        let load =
            |c| R::Lanes::load(self.0.as_ref(), vector_at::<G>(i, c, k).wrapping_add_signed(shift));
        V3([load(0), load(1), load(2)])
    }
    /// Stores eight rows of column `i`.
    #[inline(always)]
    pub fn set_rows(&mut self, i: usize, k: usize, shift: isize, v: V3<R::Lanes>) {
        for (c, lanes) in v.0.iter().enumerate() {
            lanes.store(self.0.as_mut(), vector_at::<G>(i, c, k).wrapping_add_signed(shift));
        }
    }
    /// Adds to eight rows of column `i`.
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
    /// Eight rows of column `i`.
    #[inline(always)]
    pub fn rows(&self, i: usize, k: usize) -> R::Lanes {
        R::Lanes::load(self.0.as_ref(), scalar_at::<G>(i, k))
    }
    /// Stores eight rows of column `i`.
    #[inline(always)]
    pub fn set_rows(&mut self, i: usize, k: usize, v: R::Lanes) {
        v.store(self.0.as_mut(), scalar_at::<G>(i, k));
    }
    /// Zeros everywhere.
    pub fn clear(&mut self) {
        self.0.as_mut().fill(R::ZERO);
    }
}

/// Starts of the groups of eight rows in a column.
#[inline(always)]
pub fn blocks<G: Grid>() -> impl Iterator<Item = usize> {
    (0..G::BLOCKS).map(|b| b * LANES)
}

/// One where row `k + lane` is in `from..to`, else zero.
#[inline(always)]
pub fn row_mask<R: Real>(k: usize, from: usize, to: usize) -> R::Lanes {
    let inside = |lane: usize| if (from..to).contains(&(k + lane)) { R::of(1.0) } else { R::ZERO };
    R::Lanes::from_array(core::array::from_fn(inside))
}
