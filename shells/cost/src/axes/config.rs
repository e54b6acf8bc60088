//! One configuration: where every dial stands.

use super::GridName;
use core::fmt;
use dogleaf_core::scene::{Fidelity, Settings};
use dogleaf_core::seed::SeedSettings;

/// The scalar, and what is done about its rounding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum RealName {
    /// `f32`.
    F32,
    /// `f64`.
    F64,
}

/// Which equations are solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Form {
    /// Condensed, contact inside the solve.
    Ours,
    /// The seed's full KKT matrix; with the constraints' second derivatives or without.
    Seed {
        /// `Σ λ ∇²C` is in the matrix.
        hessian: bool,
    },
}

/// Newton steps that "to tolerance" may take at most.
pub const MOST_NEWTON: u32 = 20;
/// What "to tolerance" means: no coordinate moved further, model units (a page is 12 wide).
pub const TOLERANCE: f64 = 1e-10;
/// The same for `f32`, whose last digit of a page's width is a millionth of a unit.
const TOLERANCE_F32: f64 = 1e-5;

/// Where every dial stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Config {
    /// Nodes.
    pub grid: GridName,
    /// Internal steps a second.
    pub rate: u32,
    /// Newton steps in each; nothing: to tolerance.
    pub newton: Option<u32>,
    /// The scalar.
    pub real: RealName,
    /// Solves with the old factor after each Newton step.
    pub refinements: u32,
    /// The equations.
    pub form: Form,
    /// The line search is on.
    pub search: bool,
    /// Collision passes at most.
    pub passes: u32,
    /// Dual regularisation.
    pub delta: f64,
    /// A mesh is made for every picture.
    pub mesh: bool,
}

impl Config {
    /// [`Fidelity::Standard`] at 11x8 in `f32`: what shells run.
    pub const STANDARD: Self = Self {
        grid: GridName::G11x8,
        rate: 60,
        newton: Some(1),
        real: RealName::F32,
        refinements: 0,
        form: Form::Ours,
        search: true,
        passes: 3,
        delta: 1e-6,
        mesh: false,
    };

    /// What a fidelity means at 11x8.
    pub fn of(fidelity: Fidelity) -> Self {
        let dials = fidelity.settings();
        Self {
            rate: 60 * dials.substeps,
            newton: Some(dials.newton),
            refinements: dials.refinements,
            passes: dials.passes,
            delta: dials.delta,
            search: dials.trials > 0,
            ..Self::STANDARD
        }
    }

    /// Fidelities that stand here; where nothing collides, those that differ in passes only stand together.
    pub fn preset(&self, collides: bool) -> Vec<&'static str> {
        let passes = |own: u32| if collides { own } else { self.passes };
        let here = |f: Fidelity| {
            let own = Self::of(f);
            Self { passes: passes(own.passes), ..own } == *self
        };
        Fidelity::ALL.iter().filter(|(_, f)| here(*f)).map(|(name, _)| *name).collect()
    }

    /// A dial no shell may turn for speed: the mild motion of a plot does not show what it is for. A shell draws sixty
    /// pictures a second, and each wants a step.
    pub fn unsafe_dial(&self) -> bool {
        self.rate < 60
            || !self.search
            || self.delta.to_bits() != Self::STANDARD.delta.to_bits()
            || self.passes == 0
    }

    /// World steps a second, and substeps in each.
    pub fn world(&self) -> (u32, u32) {
        if self.rate < 60 { (self.rate, 1) } else { (60, self.rate / 60) }
    }

    /// The core's dials for one internal step.
    pub fn settings(&self) -> Settings {
        let loose = self.real == RealName::F32;
        Settings {
            substeps: 1,
            newton: self.newton.unwrap_or(MOST_NEWTON),
            tolerance: match self.newton {
                Some(_) => 0.0,
                None if loose => TOLERANCE_F32,
                None => TOLERANCE,
            },
            trials: if self.search { Settings::STANDARD.trials } else { 0 },
            passes: self.passes,
            delta: self.delta,
            refinements: self.refinements,
        }
    }

    /// The oracle's options, where the seed's equations are asked for.
    pub fn seed(&self) -> Option<SeedSettings> {
        let Form::Seed { hessian } = self.form else { return None };
        Some(SeedSettings {
            newton: self.newton.unwrap_or(MOST_NEWTON),
            constraint_hessian: hessian,
            refinements: self.refinements,
            delta: self.delta,
            ..SeedSettings::default()
        })
    }
}

impl fmt::Display for Config {
    /// `11x8 60/s N1 f32`, and what differs from the standard.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let newton = self.newton.map_or_else(|| "Ntol".into(), |n| format!("N{n}"));
        let real = if self.real == RealName::F32 { "f32" } else { "f64" };
        write!(f, "{} {}/s {newton} {real}", self.grid, self.rate)?;
        if self.refinements > 0 {
            write!(f, "+{}", self.refinements)?;
        }
        match self.form {
            Form::Ours => {}
            Form::Seed { hessian: false } => write!(f, " seed")?,
            Form::Seed { hessian: true } => write!(f, " seed+hessian")?,
        }
        if !self.search {
            write!(f, " no-search")?;
        }
        if self.passes != Self::STANDARD.passes {
            write!(f, " P{}", self.passes)?;
        }
        if self.delta.to_bits() != Self::STANDARD.delta.to_bits() {
            write!(f, " delta {:e}", self.delta)?;
        }
        if self.mesh { write!(f, " mesh") } else { Ok(()) }
    }
}

/// Evaluates an expression with types for the scalar and the grid of a configuration.
macro_rules! with_types {
    ($config:expr, $r:ident, $g:ident => $body:expr) => {
        match $config.real {
            $crate::axes::RealName::F32 => {
                type $r = f32;
                $crate::axes::with_grid!($config.grid, $g => $body)
            }
            $crate::axes::RealName::F64 => {
                type $r = f64;
                $crate::axes::with_grid!($config.grid, $g => $body)
            }
        }
    };
}
pub(crate) use with_types;
