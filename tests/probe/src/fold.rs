//! Folds numbers into one: cheap, since unoptimised builds on emulated boards do it millions of times.

use dogleaf_core::real::{Eight, Real, V2, V3};

/// A running fold.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fold(u64);

impl Fold {
    /// Of nothing.
    pub(crate) const START: Self = Self(0x9e37_79b9_7f4a_7c15);

    /// Takes one word in.
    pub(crate) fn word(&mut self, word: u64) {
        let mixed = (self.0 ^ word).wrapping_mul(0xff51_afd7_ed55_8ccd);
        self.0 = mixed ^ (mixed >> 32);
    }
    /// Takes one number in.
    pub(crate) fn real<R: Real>(&mut self, value: R) {
        self.word(value.bits());
    }
    /// Takes eight in.
    pub(crate) fn lanes<R: Real>(&mut self, value: R::Eight) {
        value.array().into_iter().for_each(|v| self.real(v));
    }
    /// Takes a vector in.
    pub(crate) fn v3<R: Real>(&mut self, v: V3<R>) {
        v.0.into_iter().for_each(|c| self.real(c));
    }
    /// Takes a vector of the plane in.
    pub(crate) fn v2<R: Real>(&mut self, v: V2<R>) {
        v.0.into_iter().for_each(|c| self.real(c));
    }
    /// The fold so far.
    pub(crate) fn value(self) -> u64 {
        self.0
    }
}
