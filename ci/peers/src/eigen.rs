//! The safe side of `eigen.cpp`; the only place here with unsafe code.
#![allow(unsafe_code, reason = "calls a C++ library")]

use std::ffi::{c_int, c_long, c_void};
use std::ptr::NonNull;

use crate::bench::{Contender, Pass};
use crate::matrices::Matrices;

unsafe extern "C" {
    fn dogleaf_eigen_new(
        method: c_int,
        n: c_int,
        starts: *const c_int,
        rows: *const c_int,
        values: *const f64,
    ) -> *mut c_void;
    fn dogleaf_eigen_run(
        solver: *mut c_void,
        count: c_int,
        entries: c_int,
        n: c_int,
        values: *const f64,
        rhs: *const f64,
        x: *mut f64,
        factor_ns: *mut u64,
        solve_ns: *mut u64,
    ) -> c_int;
    fn dogleaf_eigen_entries(solver: *const c_void) -> c_long;
    fn dogleaf_eigen_free(solver: *mut c_void);
}

/// Which of Eigen's solvers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Method {
    /// `SparseLU` with `COLAMDOrdering`: what the seed's authors used.
    SparseLu = 0,
    /// `SimplicialLDLT` with `AMDOrdering`: the best of Eigen for a quasi-definite matrix.
    SimplicialLdlt = 1,
}

/// One solver whose pattern is analysed.
#[derive(Debug)]
pub(crate) struct Eigen {
    method: Method,
    solver: NonNull<c_void>,
    /// Size and entries that the solver was made for.
    shape: (usize, usize),
}

impl Eigen {
    /// Analyses the pattern of a set.
    ///
    /// # Errors
    ///
    /// Eigen refused the pattern, or it is too big for C's `int`.
    pub(crate) fn new(method: Method, set: &Matrices) -> Result<Self, String> {
        let n = c_int::try_from(set.n).map_err(|e| e.to_string())?;
        let shape = (set.n, set.entries());
        let whole = set.starts.len() == set.n + 1
            && set.starts.last().is_some_and(|e| usize::try_from(*e) == Ok(shape.1));
        let inside = set.rows.iter().all(|r| (0..n).contains(r))
            && set.starts.is_sorted()
            && set.starts.first() == Some(&0);
        if !whole || !inside || set.values.len() < shape.1 {
            return Err("the pattern does not hold together".into());
        }
        // SAFETY: `starts` has n + 1 rising places from 0 to the length of `rows`, every row is below n, and
        // there are as many values; Eigen copies them.
        let solver = unsafe {
            dogleaf_eigen_new(
                method as c_int,
                n,
                set.starts.as_ptr(),
                set.rows.as_ptr(),
                set.values.as_ptr(),
            )
        };
        let solver = NonNull::new(solver)
            .ok_or_else(|| format!("Eigen refused the pattern ({method:?})"))?;
        Ok(Self { method, solver, shape })
    }
}

impl Contender for Eigen {
    fn name(&self) -> &'static str {
        match self.method {
            Method::SparseLu => "Eigen SparseLU, COLAMD",
            Method::SimplicialLdlt => "Eigen SimplicialLDLT, AMD",
        }
    }

    fn pass(&mut self, set: &Matrices, pass: &mut Pass) -> Result<(), String> {
        let (n, entries, count) = (set.n, set.entries(), set.count());
        if (n, entries) != self.shape
            || set.values.len() != count * entries
            || set.rhs.len() != count * n
        {
            return Err("made for another pattern".into());
        }
        pass.resize(count, n);
        let int = |v: usize| c_int::try_from(v).map_err(|e| e.to_string());
        let (c_count, c_entries, c_n) = (int(count)?, int(entries)?, int(n)?);
        // SAFETY: the solver is alive and was made for this size; every array has the length that the
        // three numbers ask for (checked above, and `resize`), and nobody else holds them.
        let done = unsafe {
            dogleaf_eigen_run(
                self.solver.as_ptr(),
                c_count,
                c_entries,
                c_n,
                set.values.as_ptr(),
                set.rhs.as_ptr(),
                pass.x.as_mut_ptr(),
                pass.factor_ns.as_mut_ptr(),
                pass.solve_ns.as_mut_ptr(),
            )
        };
        if done == c_count {
            Ok(())
        } else {
            Err(format!("matrix {done} of {count} could not be factored"))
        }
    }

    fn entries(&self) -> Option<u64> {
        // SAFETY: the solver is alive.
        u64::try_from(unsafe { dogleaf_eigen_entries(self.solver.as_ptr()) }).ok()
    }
}

impl Drop for Eigen {
    fn drop(&mut self) {
        // SAFETY: made by `dogleaf_eigen_new`, freed once.
        unsafe { dogleaf_eigen_free(self.solver.as_ptr()) }
    }
}

#[cfg(test)]
mod tests {
    use super::{Eigen, Method};
    use crate::bench::{Contender, Pass};
    use crate::synthetic::page_turn;

    #[test]
    fn both_methods_solve_every_matrix() {
        let set = page_turn();
        for method in [Method::SparseLu, Method::SimplicialLdlt] {
            let mut pass = Pass::default();
            let mut eigen = Eigen::new(method, &set).expect("the pattern is fine");
            eigen.pass(&set, &mut pass).expect("so are the values");
            assert!(set.residual(&pass.x) < 1e-9, "{method:?}: {}", set.residual(&pass.x));
            assert!(pass.factor_ns.iter().all(|ns| *ns > 0), "{method:?}: the clock stands");
        }
    }

    #[test]
    fn a_broken_pattern_is_refused() {
        let mut set = page_turn();
        set.rows[5] = 100_000;
        assert!(Eigen::new(Method::SparseLu, &set).is_err(), "a row beyond the matrix");
    }

    #[test]
    fn a_singular_matrix_is_an_error() {
        let mut set = page_turn();
        let mut eigen = Eigen::new(Method::SparseLu, &set).expect("the pattern is fine");
        set.values.fill(0.0);
        assert!(eigen.pass(&set, &mut Pass::default()).is_err(), "all zero");
    }
}
