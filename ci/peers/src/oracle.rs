//! The seed form's own factor: `LDLᵀ` on slots found once, in `f64`.

use std::hint::black_box;
use std::time::Instant;

use dogleaf_core::grid::G11x8;
use dogleaf_core::seed::{Factor, SeedGrid};

use crate::bench::{Contender, Pass, ns};
use crate::matrices::Matrices;
use crate::turn::{Kkt, Turn};

/// What our oracle takes for the matrices that Eigen gets.
#[derive(Debug)]
pub(crate) struct Oracle<'a> {
    kkt: &'a [Box<Kkt>],
    factor: Box<Factor<f64, G11x8>>,
    /// The matrix at hand: copied before the clock starts, as Eigen's are.
    matrix: Box<Kkt>,
    x: Vec<f64>,
}

impl<'a> Oracle<'a> {
    /// For the matrices of a turn; `None` if it has none.
    pub(crate) fn new(turn: &'a Turn) -> Option<Self> {
        let matrix = turn.kkt.first()?.clone();
        Some(Self { kkt: &turn.kkt, factor: turn.factor.clone(), matrix, x: vec![0.0; turn.set.n] })
    }
}

impl Contender for Oracle<'_> {
    fn name(&self) -> &'static str {
        "seed form's LDLt, f64"
    }

    fn pass(&mut self, set: &Matrices, pass: &mut Pass) -> Result<(), String> {
        pass.resize(set.count(), set.n);
        for (m, kkt) in self.kkt.iter().enumerate() {
            self.matrix.clone_from(kkt);
            let from = m * set.n;
            for (x, &unknown) in self.x.iter_mut().zip(G11x8::ORDER) {
                *x = set.rhs[from + usize::from(unknown)];
            }
            let start = Instant::now();
            self.factor.factor(black_box(&self.matrix));
            let factored = Instant::now();
            self.factor.solve(black_box(&mut self.x));
            pass.solve_ns[m] = ns(factored);
            pass.factor_ns[m] = (factored - start).as_nanos() as u64;
            for (x, &unknown) in self.x.iter().zip(G11x8::ORDER) {
                pass.x[from + usize::from(unknown)] = *x;
            }
        }
        Ok(())
    }

    fn entries(&self) -> Option<u64> {
        Some(self.factor.entries() as u64)
    }
}
