//! `L y = b`, then `Lᵀ x = y`, on the panels of [`Factor`].

use super::factor::Factor;
use super::{one, tile};
use crate::grid::{Grid, Store};
use crate::real::{Eight, LANES, Lanes, Num, Real};

/// One number an unknown: right-hand sides and steps, in the order of the unknowns, padded to panels.
#[derive(Debug, Clone)]
pub struct Unknowns<R: Real, G: Grid>(G::Unknowns<R>);

impl<R: Real, G: Grid> Unknowns<R, G> {
    /// Zeros.
    pub const ZERO: Self = Self(<G::Unknowns<R> as Store<R>>::ZERO);

    /// The numbers, column by column from the first free one, tail to head, x y z.
    pub fn numbers(&self) -> &[R] {
        self.0.as_ref()
    }
    /// The numbers, to change.
    pub fn numbers_mut(&mut self) -> &mut [R] {
        self.0.as_mut()
    }

    #[inline(always)]
    fn eight(&self, p: usize) -> R::Eight {
        R::Eight::load(self.0.as_ref(), p * LANES)
    }
    #[inline(always)]
    fn set_eight(&mut self, p: usize, v: R::Eight) {
        v.store(self.0.as_mut(), p * LANES);
    }
}

impl<R: Real, G: Grid> Factor<R, G> {
    /// Solves `S x = b`; `x` holds `b` on entry.
    ///
    /// # Cost
    ///
    /// About 24,000 multiply-adds at 11x8.
    pub fn solve(&self, x: &mut Unknowns<R, G>) {
        for p in 0..G::PANELS.len() {
            let y = self.forward(p, x);
            x.set_eight(p, y);
        }
        for p in (0..G::PANELS.len()).rev() {
            self.backward(p, x);
        }
    }

    /// Rows of panel `p`: `L_pp⁻¹ (b_p - Σ_k L_pk y_k)`, four partial sums added in a fixed order.
    #[inline(always)]
    fn forward(&self, p: usize, x: &Unknowns<R, G>) -> R::Eight {
        let (place, numbers) = self.panel(p);
        let known = x.numbers().get(place.stored..p * LANES).unwrap_or(&[]);
        if R::Lanes::WIDTH == 1 {
            return R::Eight::from_array(one::forward(numbers, known, x.eight(p).array()));
        }
        let (columns, _) = numbers.as_chunks::<LANES>();
        let (columns, _) = columns.as_chunks::<4>();
        let (known, _) = known.as_chunks::<4>();
        let mut sums = [R::Eight::zero(); 4];
        for (c, k) in columns.iter().zip(known) {
            for ((s, column), &y) in sums.iter_mut().zip(c).zip(k) {
                *s = *s + R::Eight::from_array(*column) * R::Eight::all(y);
            }
        }
        let [a, b, c, d] = sums;
        let rest = (x.eight(p) - ((a + b) + (c + d))).array();
        weighted::<R>(&R::Eight::transpose(inverse::<R>(numbers)), &rest)
    }

    /// `x_p = L_pp⁻ᵀ y_p`, then takes its share out of every earlier unknown the panel touches.
    #[inline(always)]
    fn backward(&self, p: usize, x: &mut Unknowns<R, G>) {
        let (place, numbers) = self.panel(p);
        let earlier = place.stored / LANES..p;
        if R::Lanes::WIDTH == 1 {
            let own = one::backward(numbers, x.eight(p).array());
            x.set_eight(p, R::Eight::from_array(own));
            let touched = x.numbers_mut().get_mut(place.stored..p * LANES).unwrap_or(&mut []);
            one::take_out(numbers, &own, touched);
            return;
        }
        let own = weighted::<R>(&inverse::<R>(numbers), &x.eight(p).array());
        x.set_eight(p, own);
        let (tiles, _) = numbers.as_chunks::<{ LANES * LANES }>();
        for (q, block) in earlier.zip(tiles) {
            let products = core::array::from_fn(|j| R::Eight::load(block, j * LANES) * own);
            let share = tree(R::Eight::transpose(products));
            let rest = x.eight(q) - share;
            x.set_eight(q, rest);
        }
    }
}

/// The inverse of a panel's diagonal block, row by row.
#[inline(always)]
fn inverse<R: Real>(numbers: &[R]) -> tile::Tile<R> {
    tile::load::<R>(numbers.last_chunk::<{ LANES * LANES }>().map_or(&[], |block| block))
}

/// `Σ_j vectors[j] · factors[j]`, in pairs of pairs.
#[inline(always)]
fn weighted<R: Real>(vectors: &[R::Eight; LANES], factors: &[R; LANES]) -> R::Eight {
    tree(core::array::from_fn(|j| match (vectors.get(j), factors.get(j)) {
        (Some(&v), Some(&f)) => v * R::Eight::all(f),
        _ => R::Eight::zero(),
    }))
}

/// `((0+1)+(2+3))+((4+5)+(6+7))`.
#[inline(always)]
pub(super) fn tree<T: Num>([a, b, c, d, e, f, g, h]: [T; LANES]) -> T {
    ((a + b) + (c + d)) + ((e + f) + (g + h))
}
