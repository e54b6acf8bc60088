//! What the seed leaves open, as options.

/// Options of the seed's step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeedSettings {
    /// Newton steps on Eq. 3. The seed takes one.
    pub newton: u32,
    /// The exact `∇²V`, as in the seed; else its semidefinite part.
    pub exact: bool,
    /// `Σ λ_l ∇²C_l`, which acts from the second Newton step on. The seed leaves it out.
    pub constraint_hessian: bool,
    /// Holds both ends of the binding, as the product does. `C_fix` alone lets the spine turn, and a
    /// spine that turns throws the leaf out of books open near an end.
    pub lock_spine: bool,
    /// Dual regularisation `δ`.
    pub delta: f64,
    /// Refinements of each solution against `K`.
    pub refinements: u32,
}

impl Default for SeedSettings {
    fn default() -> Self {
        Self {
            newton: 1,
            exact: true,
            constraint_hessian: false,
            lock_spine: true,
            delta: 1e-8,
            refinements: 1,
        }
    }
}
