//! `L y = b`, then `Lᵀ x = y`, on the panels of [`Factor`].

use super::factor::Factor;
use crate::grid::{Grid, Store};
use crate::real::{LANES, Lanes, Num, Real};

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
    fn eight(&self, p: usize) -> R::Lanes {
        R::Lanes::load(self.0.as_ref(), p * LANES)
    }
    #[inline(always)]
    fn set_eight(&mut self, p: usize, v: R::Lanes) {
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
    fn forward(&self, p: usize, x: &Unknowns<R, G>) -> R::Lanes {
        let rows = self.panel(p);
        let known = x.numbers().get(rows.place.stored..p * LANES).unwrap_or(&[]);
        let (columns, _) = rows.numbers.as_chunks::<LANES>();
        let (columns, _) = columns.as_chunks::<4>();
        let (known, _) = known.as_chunks::<4>();
        let mut sums = [R::Lanes::zero(); 4];
        for (c, k) in columns.iter().zip(known) {
            for ((s, column), &y) in sums.iter_mut().zip(c).zip(k) {
                *s = *s + R::Lanes::from_array(*column) * R::Lanes::all(y);
            }
        }
        let [a, b, c, d] = sums;
        let rest = (x.eight(p) - ((a + b) + (c + d))).array();
        let columns = R::Lanes::transpose(self.inverse(p));
        weighted::<R>(&columns, &rest)
    }

    /// `x_p = L_pp⁻ᵀ y_p`, then takes its share out of every earlier unknown the panel touches.
    #[inline(always)]
    fn backward(&self, p: usize, x: &mut Unknowns<R, G>) {
        let own = weighted::<R>(&self.inverse(p), &x.eight(p).array());
        x.set_eight(p, own);
        let rows = self.panel(p);
        let (tiles, _) = rows.numbers.as_chunks::<{ LANES * LANES }>();
        for (q, block) in (rows.place.stored / LANES..p).zip(tiles) {
            let products = core::array::from_fn(|j| R::Lanes::load(block, j * LANES) * own);
            let [a, b, c, d, e, f, g, h] = R::Lanes::transpose(products);
            let share = ((a + b) + (c + d)) + ((e + f) + (g + h));
            let rest = x.eight(q) - share;
            x.set_eight(q, rest);
        }
    }
}

/// `Σ_j vectors[j] · factors[j]`, in two partial sums of four.
#[inline(always)]
fn weighted<R: Real>(vectors: &[R::Lanes; LANES], factors: &[R; LANES]) -> R::Lanes {
    let term = |j: usize| match (vectors.get(j), factors.get(j)) {
        (Some(&v), Some(&f)) => v * R::Lanes::all(f),
        _ => R::Lanes::zero(),
    };
    ((term(0) + term(1)) + (term(2) + term(3))) + ((term(4) + term(5)) + (term(6) + term(7)))
}
