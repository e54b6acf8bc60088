//! Everything that was found, as `cost.json` holds it.

use crate::axes::Config;
use crate::claims::Claim;
use crate::cost::Cost;
use crate::errors::Errors;
use crate::peers::Peers;
use serde::Serialize;

/// One configuration on one scene.
#[derive(Debug, Clone, Serialize)]
pub struct Row {
    /// Where its dials stand.
    #[serde(serialize_with = "shown")]
    pub config: Config,
    /// Fidelities that stand here.
    pub presets: Vec<&'static str>,
    /// Errors.
    pub errors: Errors,
    /// Costs.
    pub cost: Cost,
    /// Nothing safe on this grid is better in cost and in error.
    pub front: bool,
    /// The worst status of a step.
    pub status: &'static str,
}

fn shown<S: serde::Serializer>(config: &Config, s: S) -> Result<S::Ok, S::Error> {
    s.collect_str(config)
}

/// A reference and how well it is known.
#[derive(Debug, Clone, Serialize)]
pub struct Known {
    /// For what: a grid, or all of them.
    pub what: String,
    /// How the two were made.
    pub methods: [String; 2],
    /// How far they are apart, page widths (events: milliseconds).
    pub agreement: f64,
    /// The smallest error of a configuration beside them.
    pub smallest: f64,
    /// The two agree ten times better than that.
    pub converged: bool,
}

/// A scene.
#[derive(Debug, Clone, Serialize)]
pub struct SceneReport {
    /// Its name.
    pub name: &'static str,
    /// What happens in it.
    pub about: &'static str,
    /// Its references.
    pub known: Vec<Known>,
    /// All configurations.
    pub rows: Vec<Row>,
}

/// A grid in the limit of small steps, or at rest.
#[derive(Debug, Clone, Serialize)]
pub struct GridRow {
    /// The grid.
    pub grid: String,
    /// Distance from the limit of no spacing, page widths; nothing where the limit is not known well enough.
    pub space_rms: Option<f64>,
    /// Relative errors of drop over reach beside the heavy elastica, by `Γ`.
    pub droop: Vec<[f64; 2]>,
    /// Cost of a picture of the standard on this grid: instructions, or microseconds.
    pub frame: f64,
    /// Median microseconds of a step.
    pub step_us: f64,
}

/// An observed order of convergence.
#[derive(Debug, Clone, Serialize)]
pub struct Order {
    /// Of what.
    pub what: &'static str,
    /// Sizes and errors.
    pub points: Vec<[f64; 2]>,
    /// The slope.
    pub order: f64,
    /// What is promised.
    pub least: f64,
}

/// Where a fidelity stands.
#[derive(Debug, Clone, Serialize)]
pub struct PresetRow {
    /// Its name.
    pub name: &'static str,
    /// Its dials.
    pub config: String,
    /// Error and cost on the turn.
    pub error: f64,
    /// Cost of a picture.
    pub cost: f64,
    /// On the front.
    pub front: bool,
    /// What beats it.
    pub beaten_by: Option<String>,
}

/// Everything.
#[derive(Debug, Clone, Serialize)]
pub struct Report {
    /// Version of the program.
    pub dogleaf: &'static str,
    /// What it ran on.
    pub machine: String,
    /// What the axis of costs counts.
    pub unit: &'static str,
    /// Everything that takes minutes was left out.
    pub quick: bool,
    /// Scenes.
    pub scenes: Vec<SceneReport>,
    /// Grids.
    pub grids: Vec<GridRow>,
    /// The limit in space.
    pub space: Option<Known>,
    /// Orders.
    pub orders: Vec<Order>,
    /// Fidelities.
    pub presets: Vec<PresetRow>,
    /// The seed's claims.
    pub claims: Vec<Claim>,
    /// Peers, from a file.
    pub peers: Option<Peers>,
    /// What is not here, and why.
    pub omissions: Vec<String>,
}
