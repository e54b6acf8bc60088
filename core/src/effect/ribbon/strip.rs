//! What a ribbon is made of: lengths, coefficients and limits of one cell, from the spec.

use super::spec::{Bending, Closure, Mass, Resample, RibbonSpec, Root};
use crate::real::Real;

/// Share of the slope difference at which neighbouring rulings meet on a rim.
pub const ROOM: f64 = 0.95;

/// Cells of curvature that the first creases from a clamp stand for.
const CLAMP: [f64; 3] = [3.0 / 8.0, 7.0 / 6.0, 23.0 / 24.0];

/// A straight strip cut into cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip<R> {
    /// Segments.
    pub n: usize,
    /// Length of a cell.
    pub cell: R,
    /// Half the width.
    pub half: R,
    /// `D w / 2L`: what bending a crease across by one radian costs.
    pub stiff: R,
    /// `β`: what a slope of one costs.
    pub slope: R,
    /// What the hinge at the start weighs in units of half of `stiff`; zero where there is none.
    pub hinge: R,
    /// Bends from a clamp on.
    pub clamped: bool,
    /// Largest `|c_j - c_{j+1}|`.
    pub limit: R,
    /// Mass matrix of a cell, and how it changes.
    pub mass: CellMass<R>,
    /// Wunderlich's energy.
    pub wunderlich: bool,
    /// Cubic interpolation.
    pub smooth: bool,
    /// The start may move.
    pub free: bool,
    /// The loop.
    pub closure: Closure,
}

/// `[[a, e], [e, b]] ⊗ [[1, μ], [μ, 1]]`, with `a = even - grow Δc`, `b = even + grow Δc`, in the order
/// `(x_j, y_j), (x_{j+1}, y_{j+1})`; times the areal mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CellMass<R> {
    /// `a` and `b` of a rectangle.
    pub even: R,
    /// `e`.
    pub cross: R,
    /// `μ`.
    pub along: R,
    /// `db/dΔc`.
    pub grow: R,
}

impl<R: Real> Strip<R> {
    /// Nothing.
    pub const ZERO: Self = Self {
        n: 0,
        cell: R::ZERO,
        half: R::ZERO,
        stiff: R::ZERO,
        slope: R::ZERO,
        hinge: R::ZERO,
        clamped: false,
        limit: R::ZERO,
        mass: CellMass { even: R::ZERO, cross: R::ZERO, along: R::ZERO, grow: R::ZERO },
        wunderlich: false,
        smooth: true,
        free: false,
        closure: Closure::Open,
    };

    /// The cells of a checked spec.
    pub fn of(spec: &RibbonSpec) -> Self {
        let (n, w) = (spec.segments as f64, spec.width_m);
        let cell = spec.length_m / n;
        let stiff = 0.5 * spec.rigidity_nm * w / cell;
        let hinge = match (spec.closure, spec.root) {
            (Closure::Open, Root::Clamp) => 2.0 / CLAMP[0],
            (Closure::Ring, _) => 2.0,
            _ => 0.0,
        };
        Self {
            n: spec.segments,
            cell: R::of(cell),
            half: R::of(0.5 * w),
            stiff: R::of(stiff),
            slope: R::of(stiff * spec.regularisation),
            hinge: R::of(hinge),
            clamped: spec.closure == Closure::Open && spec.root == Root::Clamp,
            limit: R::of(ROOM * 2.0 * cell / w),
            mass: CellMass::of(cell, w, spec.areal_mass_gsm * 1e-3, spec.mass),
            wunderlich: spec.bending == Bending::Wunderlich,
            smooth: spec.resample == Resample::Smooth,
            free: spec.root == Root::Free,
            closure: spec.closure,
        }
    }
    /// What bending crease `j` weighs, in units of `stiff`; of the hinge at the start, which has but one cell to be
    /// counted in, in units of half of it.
    ///
    /// Angles add up along the ribbon as a quadrature of its curvature. At a clamp, where curvature is largest, the
    /// trapezoid rule's half a cell errs by `κ' L²/12`; Gregory's weights 3/8, 7/6, 23/24 of a cell do not.
    #[inline]
    pub fn weight(&self, j: usize) -> R {
        match j {
            0 => self.hinge,
            1 if self.clamped => R::of(1.0 / CLAMP[1]),
            2 if self.clamped => R::of(1.0 / CLAMP[2]),
            _ => R::one(),
        }
    }
    /// Length of the whole.
    pub fn length(&self) -> R {
        self.cell * R::of(self.n as f64)
    }
    /// Mass of a cell.
    pub fn cell_mass(&self) -> R {
        let m = &self.mass;
        R::of(4.0) * (m.even + m.cross) * (R::one() + m.along)
    }
}

impl<R: Real> CellMass<R> {
    fn of(cell: f64, w: f64, areal: f64, mass: Mass) -> Self {
        let area = areal * cell * w;
        let (even, cross, along, grow) = match mass {
            Mass::Consistent => (area / 9.0, area / 18.0, 0.5, areal * w * w / 36.0),
            Mass::Lumped => (area / 8.0, area / 8.0, 0.0, 0.0),
        };
        Self { even: R::of(even), cross: R::of(cross), along: R::of(along), grow: R::of(grow) }
    }
}
