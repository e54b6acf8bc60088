//! Faults planted by tests, to see that nothing is lost. Feature `faults`.

use super::Book;
use crate::grid::Grid;
use crate::real::{Real, V3};

/// What shall go wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// The leaf's factorisation yields no numbers, after so many that do.
    Factor {
        /// Those before it.
        after: u32,
    },
    /// The line search finds nothing better, after so many that do.
    Search {
        /// Those before it.
        after: u32,
    },
    /// A coordinate of a node becomes NaN now.
    Nan {
        /// Column and row.
        node: (usize, usize),
        /// Of its velocity; else of its position.
        velocity: bool,
    },
}

impl<R: Real, G: Grid> Book<R, G> {
    /// Plants a fault.
    pub fn plant(&mut self, fault: Fault) {
        match fault {
            Fault::Factor { after } => self.solver.faults.solve_in = Some(after),
            Fault::Search { after } => self.solver.faults.search_in = Some(after),
            Fault::Nan { node: (i, k), velocity } => {
                let field = if velocity { &mut self.leaf.v } else { &mut self.leaf.x };
                let V3([_, y, z]) = field.at(i, k);
                field.set(i, k, V3([R::of(f64::NAN), y, z]));
            }
        }
    }
}
