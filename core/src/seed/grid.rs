//! Grids the oracle exists for, and the arrays their sizes ask for.

use crate::grid::Grid;
use crate::real::Real;
use core::fmt::Debug;

/// What a table holds: a scalar, or an index.
pub trait Cell: Copy + Debug + PartialEq {
    /// Zero.
    const BLANK: Self;
}

impl<R: Real> Cell for R {
    const BLANK: Self = R::ZERO;
}
impl Cell for u16 {
    const BLANK: Self = 0;
}
impl Cell for u32 {
    const BLANK: Self = 0;
}

/// An array of a size fixed by a grid, usable in constants.
pub trait Table<T>: AsRef<[T]> + AsMut<[T]> + Clone + Debug {
    /// Zeros.
    const BLANK: Self;
}

impl<T: Cell, const N: usize> Table<T> for [T; N] {
    const BLANK: Self = [T::BLANK; N];
}

/// Elimination order and sizes of the seed's KKT matrix on one grid. Implemented by `cargo ci slots` only.
///
/// Pairs are without and with the constraint Hessian.
pub trait SeedGrid: Grid {
    /// Unknowns and multipliers.
    const N: usize;
    /// Slots of the upper triangle of `K`, diagonal included.
    const ENTRIES: [usize; 2];
    /// Entries of `L` below its diagonal.
    const FILL: [usize; 2];
    /// Which unknown or multiplier is eliminated when: AMD's order.
    const ORDER: &'static [u16];
    /// One a row of `K`.
    type Numbers<T: Cell>: Table<T>;
    /// One a column, and the end.
    type Starts<T: Cell>: Table<T>;
    /// One a slot of `K`.
    type Entries<T: Cell>: Table<T>;
    /// One an entry of `L`.
    type Fill<T: Cell>: Table<T>;
}

/// Reads a table; zero outside.
#[inline(always)]
pub(super) fn get<T: Cell>(table: &[T], at: usize) -> T {
    table.get(at).copied().unwrap_or(T::BLANK)
}

/// Writes into a table; nothing outside.
#[inline(always)]
pub(super) fn set<T>(table: &mut [T], at: usize, value: T) {
    if let Some(slot) = table.get_mut(at) {
        *slot = value;
    }
}
