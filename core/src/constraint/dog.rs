//! `C_DOG`: around each inner node all four angles between consecutive arms are equal.
//!
//! Arms `a, b, c` of a star, consecutive, enclose two equal angles when their cosines agree:
//!
//! ```text
//! C = ( ⟨a,b⟩ |c| - ⟨b,c⟩ |a| ) / l_a l_b l_c
//! ∂C/∂a = ( b |c| - ⟨b,c⟩ a/|a| ) / l³      ∂C/∂b = ( a |c| - c |a| ) / l³
//! ∂C/∂c = ( ⟨a,b⟩ c/|c| - b |a| ) / l³      ∂C/∂x_0 = -(∂C/∂a + ∂C/∂b + ∂C/∂c)
//! ```
//!
//! Three such rows, for `(x⁺, z⁺, x⁻)`, `(z⁺, x⁻, z⁻)`, `(x⁻, z⁻, x⁺)`, make all four angles equal.
//! Residual and Jacobian are scaled by the same rest lengths `l`, so the rows are pure numbers.
//!
//! Source: Book Fig. 3; RHS18b. Checked by `tests/derivatives.rs`.
//!
//! # Hard case
//!
//! In the flat state the rows lose rank: in the plane the angles of neighbouring stars depend on one
//! another. The solve's dual regularisation answers for that, see [`step`](crate::step).

use crate::real::{Num, V3};

/// Below this share of a unit, an arm's length is not divided by.
const SHORTEST: f64 = 1e-12;

/// One star: its node, and its arms towards fore-edge, head, spine and tail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Star<T> {
    /// Arms as edge vectors from the centre: `x⁺, z⁺, x⁻, z⁻`.
    pub arms: [V3<T>; 4],
    /// Their lengths.
    pub lengths: [T; 4],
}

/// One row: which arms it names, and its derivatives by them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row<T> {
    /// `C`.
    pub value: T,
    /// `∂C/∂a, ∂C/∂b, ∂C/∂c`; by the centre it is minus their sum.
    pub gradient: [V3<T>; 3],
}

/// Arms named by each of the three rows.
pub const ROWS: [[usize; 3]; 3] = [[0, 1, 2], [1, 2, 3], [2, 3, 0]];

impl<T: Num> Star<T> {
    /// A star from its centre and its neighbours `x⁺, z⁺, x⁻, z⁻`.
    #[inline(always)]
    pub fn new(x0: V3<T>, [f, h, s, t]: [V3<T>; 4]) -> Self {
        let arms = [f - x0, h - x0, s - x0, t - x0];
        let length = |e: V3<T>| e.norm().larger(T::of(SHORTEST));
        Self { arms, lengths: [length(arms[0]), length(arms[1]), length(arms[2]), length(arms[3])] }
    }
    /// The three residuals; `s[r]` is `1 / l³` of row `r`.
    #[inline(always)]
    pub fn values(&self, s: [T; 3]) -> [T; 3] {
        let [a, b, c, d] = self.arms;
        let [la, lb, lc, ld] = self.lengths;
        let (ab, bc, cd, da) = (a.dot(b), b.dot(c), c.dot(d), d.dot(a));
        [(ab * lc - bc * la) * s[0], (bc * ld - cd * lb) * s[1], (cd * la - da * lc) * s[2]]
    }
    /// The three rows with their derivatives.
    #[inline(always)]
    pub fn rows(&self, s: [T; 3]) -> [Row<T>; 3] {
        let [a, b, c, d] = self.arms;
        let [la, lb, lc, ld] = self.lengths;
        [
            row([a, b, c], [la, lb, lc], s[0]),
            row([b, c, d], [lb, lc, ld], s[1]),
            row([c, d, a], [lc, ld, la], s[2]),
        ]
    }
}

#[inline(always)]
fn row<T: Num>([a, b, c]: [V3<T>; 3], [la, lb, lc]: [T; 3], s: T) -> Row<T> {
    let _ = lb;
    let (ab, bc) = (a.dot(b), b.dot(c));
    let (sa, sc) = (s * la, s * lc);
    Row {
        value: (ab * lc - bc * la) * s,
        gradient: [b * sc - a * (s * bc / la), a * sc - c * sa, c * (s * ab / lc) - b * sa],
    }
}
