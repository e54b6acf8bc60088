//! Which levels every axis has, and the configurations that follow: a full factorial, or one dial at a time.

use super::{Config, Form, GridName, RealName};

/// Levels of every axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Levels {
    /// Grids.
    pub grid: Vec<GridName>,
    /// Newton steps; nothing: to tolerance.
    pub newton: Vec<Option<u32>>,
    /// Steps a second.
    pub rate: Vec<u32>,
    /// Scalars with so many refinements.
    pub real: Vec<(RealName, u32)>,
    /// Equations, the seed's with the constraint Hessian or without.
    pub form: Vec<Form>,
    /// Line search.
    pub search: Vec<bool>,
    /// Collision passes.
    pub passes: Vec<u32>,
    /// Dual regularisation.
    pub delta: Vec<f64>,
    /// Mesh made or not.
    pub mesh: Vec<bool>,
}

/// Names of the axes, as `--axes` takes them.
pub const AXES: [&str; 9] =
    ["grid", "newton", "step", "real", "form", "search", "passes", "delta", "mesh"];

impl Levels {
    /// Everything that is asked of the report.
    pub fn full() -> Self {
        use RealName::{F32, F64};
        Self {
            grid: GridName::ALL.to_vec(),
            newton: vec![Some(1), Some(2), Some(3), Some(5), None],
            rate: vec![30, 60, 120, 240, 480, 960],
            real: vec![(F32, 0), (F32, 1), (F64, 0)],
            form: vec![Form::Ours, Form::Seed { hessian: false }, Form::Seed { hessian: true }],
            search: vec![true, false],
            passes: vec![0, 1, 2, 3],
            delta: vec![1e-4, 1e-5, 1e-6, 1e-7, 1e-8],
            mesh: vec![false, true],
        }
    }

    /// What fits into a minute.
    pub fn quick() -> Self {
        Self {
            grid: vec![GridName::G6x5, GridName::G8x6, GridName::G11x8],
            newton: vec![Some(1), Some(2), None],
            rate: vec![60, 120, 240, 960],
            real: vec![(RealName::F32, 0), (RealName::F32, 1), (RealName::F64, 0)],
            ..Self::full()
        }
    }

    /// Keeps the levels of the named axes; every other axis stands at the standard's.
    pub fn only(&mut self, axes: &[String]) {
        let bare = Self::single();
        let named = |name: &str| axes.iter().any(|a| a == name);
        if !named("grid") {
            self.grid = bare.grid;
        }
        if !named("newton") {
            self.newton = bare.newton;
        }
        if !named("step") {
            self.rate = bare.rate;
        }
        if !named("real") {
            self.real = bare.real;
        }
        if !named("form") {
            self.form = bare.form;
        }
        if !named("search") {
            self.search = bare.search;
        }
        if !named("passes") {
            self.passes = bare.passes;
        }
        if !named("delta") {
            self.delta = bare.delta;
        }
        if !named("mesh") {
            self.mesh = bare.mesh;
        }
    }

    fn single() -> Self {
        let s = Config::STANDARD;
        Self {
            grid: vec![s.grid],
            newton: vec![s.newton],
            rate: vec![s.rate],
            real: vec![(s.real, s.refinements)],
            form: vec![s.form],
            search: vec![s.search],
            passes: vec![s.passes],
            delta: vec![s.delta],
            mesh: vec![s.mesh],
        }
    }

    /// Grid by Newton by step by scalar, all with all; then the other axes one at a time.
    pub fn factorial(&self) -> Vec<Config> {
        let mut all = Vec::new();
        for &grid in &self.grid {
            for &(real, refinements) in &self.real {
                for &newton in &self.newton {
                    for &rate in &self.rate {
                        let dials =
                            Config { grid, rate, newton, real, refinements, ..Config::STANDARD };
                        all.push(dials);
                    }
                }
            }
        }
        all.extend(self.others());
        distinct(all)
    }

    /// Every axis by itself, from the standard.
    pub fn one_at_a_time(&self) -> Vec<Config> {
        let s = Config::STANDARD;
        let mut all = vec![s];
        all.extend(self.grid.iter().map(|&grid| Config { grid, ..s }));
        all.extend(self.newton.iter().map(|&newton| Config { newton, ..s }));
        all.extend(self.rate.iter().map(|&rate| Config { rate, ..s }));
        all.extend(self.real.iter().map(|&(real, refinements)| Config { real, refinements, ..s }));
        all.extend(self.passes.iter().map(|&passes| Config { passes, ..s }));
        all.extend(self.others());
        distinct(all)
    }

    /// What the factorial leaves out: equations, line search, regularisation, mesh.
    fn others(&self) -> Vec<Config> {
        let s = Config::STANDARD;
        let mut all = Vec::new();
        for &form in self.form.iter().filter(|f| **f != Form::Ours) {
            let base = Config { form, real: RealName::F64, refinements: 1, ..s };
            for newton in [Some(1), Some(2)] {
                all.extend([60, 240].map(|rate| Config { newton, rate, ..base }));
            }
        }
        for &search in &self.search {
            all.extend([Some(1), Some(2)].map(|newton| Config { search, newton, ..s }));
        }
        all.extend(self.delta.iter().map(|&delta| Config {
            delta,
            real: RealName::F64,
            newton: None,
            rate: 960,
            ..s
        }));
        all.extend(self.mesh.iter().map(|&mesh| Config { mesh, ..s }));
        all
    }
}

fn distinct(all: Vec<Config>) -> Vec<Config> {
    let mut kept: Vec<Config> = Vec::with_capacity(all.len());
    for config in all {
        if !kept.contains(&config) {
            kept.push(config);
        }
    }
    kept
}
