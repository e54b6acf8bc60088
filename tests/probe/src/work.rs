//! The memory that probes run in: placed by the caller, as a book is.

use crate::matrix::Matrix;
use dogleaf_core::grid::{G6x5, G11x8};
use dogleaf_core::real::Real;
use dogleaf_core::{Book, LoneLeaf};

/// Memory for one kind of number.
#[derive(Debug)]
pub struct Tier<R: Real> {
    pub(crate) book: Book<R, G11x8>,
    pub(crate) small: Book<R, G6x5>,
    pub(crate) lone: LoneLeaf<R, G11x8>,
    pub(crate) matrix: Matrix<R, G6x5>,
    #[cfg(feature = "ribbon")]
    pub(crate) ribbon: crate::ribbon::Short<R>,
    #[cfg(feature = "ribbon")]
    pub(crate) ground: crate::ribbon::Ground<R>,
}

impl<R: Real> Tier<R> {
    const EMPTY: Self = Self {
        book: Book::EMPTY,
        small: Book::EMPTY,
        lone: LoneLeaf::EMPTY,
        matrix: Matrix::EMPTY,
        #[cfg(feature = "ribbon")]
        ribbon: crate::ribbon::Short::EMPTY,
        #[cfg(feature = "ribbon")]
        ground: crate::ribbon::ground(),
    };
}

/// Memory for all probes.
#[derive(Debug)]
pub struct Work {
    single: Tier<f32>,
    double: Tier<f64>,
}

impl Work {
    /// For the caller to place.
    pub const EMPTY: Self = Self { single: Tier::EMPTY, double: Tier::EMPTY };
}

/// A number with its part of the memory.
pub trait Pick: Real {
    /// Its part.
    fn of_work(work: &mut Work) -> &mut Tier<Self>;
}

impl Pick for f32 {
    fn of_work(work: &mut Work) -> &mut Tier<Self> {
        &mut work.single
    }
}

impl Pick for f64 {
    fn of_work(work: &mut Work) -> &mut Tier<Self> {
        &mut work.double
    }
}
